"""Status bar of a window: what goes on, progress and remaining time of a run, tasks."""

from PySide6.QtCore import Qt, QTimer
from PySide6.QtWidgets import QLabel, QProgressBar, QStatusBar, QWidget

from ui.document.frame import Frame
from ui.widgets.labels import ElidedLabel
from ui.words import later, tr
from workbench.design.snapshot import Pace

_READ_MS = 6000  # a sentence
_ITERATION = later("iteration {done} of {count}{rate}")
_AT_MOST = later("at most {time} left")


class RunStatus:
    """State at the left of a status bar; iteration, remaining time and tasks at the right."""

    def __init__(self, bar: QStatusBar, shelf: QWidget) -> None:
        self._text = ""  # what goes on
        self._state = ElidedLabel()
        self._read = QTimer(bar, singleShot=True)
        self._read.timeout.connect(lambda: self._state.setText(self._text))
        self._progress = QProgressBar(textVisible=False)
        self._progress.setFixedSize(150, 6)
        self._progress.setAccessibleName(tr("Progress of the design"))
        # Widths of the longest text to be expected, so that nothing jumps while it counts.
        self._iteration = _figure(
            tr("Finished iterations, and the current rate"),
            tr(_ITERATION).format(done="0000", count="0000", rate=", 00.0/s"),
        )
        self._left = _figure(
            tr(
                "Remaining time at the current rate; the automatic method ends sooner without "
                "further gain"
            ),
            tr(_AT_MOST).format(time="00:00"),
        )
        self._of_run = (self._progress, self._iteration, self._left)
        self._pace = Pace()
        # Qt hides other than permanent widgets under the tip of a command, and the rest jumps.
        bar.addPermanentWidget(self._state, 1)
        bar.messageChanged.connect(lambda tip: self._state.setText(tip or self._text))
        for part in (*self._of_run, shelf):
            bar.addPermanentWidget(part)
        self.settle()

    def show_state(self, text: str) -> None:
        """Show a state, in place of any sentence."""
        self._text = text
        self._read.stop()
        self._state.setText(text)

    def go_on(self, text: str) -> None:
        """Show progress, after the reading time of a sentence."""
        self._text = text
        if not self._read.isActive():
            self._state.setText(text)

    def show_briefly(self, sentence: str) -> None:
        """Show a sentence for its reading time."""
        self._state.setText(sentence)
        self._read.start(_READ_MS)

    def show_frame(self, frame: Frame, running: bool) -> None:
        for part in self._of_run:
            part.setVisible(running)
        if not running:
            return
        snapshot = frame.snapshot
        done, all_of_it = snapshot.iteration, snapshot.iterations
        self._progress.setMaximum(max(all_of_it, 1))
        self._progress.setValue(done)
        self._pace.note(snapshot.seconds, done)
        rate, left = self._pace.rate, self._pace.left(all_of_it - done)
        each_second = "" if rate is None else f", {rate:.3g}/s"
        self._iteration.setText(tr(_ITERATION).format(done=done, count=all_of_it, rate=each_second))
        may_stop = frame.session.scene.run.method == "auto"
        words = tr(_AT_MOST) if may_stop else tr("{time} left")
        self._left.setText("" if left is None else words.format(time=clock(left)))

    def settle(self) -> None:
        for part in self._of_run:
            part.hide()


def _figure(tip: str, longest: str) -> QLabel:
    label = QLabel(alignment=Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
    label.setToolTip(tip)
    label.setMinimumWidth(label.fontMetrics().horizontalAdvance(longest))
    return label


def clock(seconds: float) -> str:
    """Format a duration as m:ss or h:mm:ss."""
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02}:{rest:02}" if hours else f"{minutes}:{rest:02}"
