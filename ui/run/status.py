"""How a sentence and figures share a status bar."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QObject, Qt, QTimer
from PySide6.QtWidgets import QLabel, QProgressBar, QStatusBar, QWidget

from ui.widgets.labels import OUTDATED, ElidedLabel
from ui.words import later, tr
from workbench.design.snapshot import Pace
from workbench.powers import written

if TYPE_CHECKING:
    from ui.document.frame import Frame

_GAP = 8  # pixels between two things in a status bar, at most


class StatusLayout(QObject):
    """Shares a status bar between a sentence and figures.

    If the sentence does not fit, figures lose their minimum width, then the least important are
    hidden.
    """

    def __init__(
        self, bar: QStatusBar, figures: Sequence[QLabel], least_important: Sequence[QLabel]
    ) -> None:
        super().__init__(bar)
        self._bar = bar
        self._widths = {figure: figure.minimumWidth() for figure in figures}
        self._least_important = least_important
        bar.installEventFilter(self)

    def share(self) -> None:
        if self._bar.currentMessage():
            return
        for figure, width in self._widths.items():
            figure.setMinimumWidth(width)
            figure.show()
        if self._fits:
            return
        for figure in self._widths:
            figure.setMinimumWidth(0)
            figure.setVisible(bool(figure.text()))
        for figure in self._least_important:
            if self._fits:
                return
            figure.hide()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Resize:
            self.share()
        return super().eventFilter(watched, event)

    @property
    def _fits(self) -> bool:
        layout = self._bar.layout()
        assert layout is not None  # a status bar has one as soon as it holds something
        held = self._bar.findChildren(QWidget, options=Qt.FindChildOption.FindDirectChildrenOnly)
        margins = layout.contentsMargins()
        needed = margins.left() + margins.right()
        for each in held:
            if not each.isHidden():
                wanted = max(each.sizeHint().width(), each.minimumWidth())
                needed += min(wanted, each.maximumWidth()) + _GAP
        return needed <= self._bar.width()


_READ_MS = 6000  # a sentence
_ITERATION = later("iteration {done} of {count}{rate}")
_LIGHT = later("Error {error} · light {place} {shares}")
_VERIFIED = later("Verified error {error} · light {place} {shares}")
_LOSS = later("loss {loss}")
_WIDE_LOSS = written(1.234e-9)
_ELAPSED = later("{time} elapsed")
_AT_MOST = later("at most {time} left")


class RunStatus:
    """State at the left of a status bar; progress and figures at the right."""

    def __init__(self, bar: QStatusBar) -> None:
        self._text = ""  # what goes on
        self._state = ElidedLabel()
        self._read = QTimer(bar)
        self._read.setSingleShot(True)
        self._read.timeout.connect(lambda: self._show_text(self._text))
        bar.addWidget(self._state, 1)
        self._progress = _progress(bar)
        self._outdated = _passing(bar, tr(OUTDATED), tr("Outdated:"))
        # Widths of the longest text to be expected, so that nothing jumps while it counts.
        self._iteration = _figure(
            bar,
            tr("Finished iterations, and the current rate"),
            tr(_ITERATION).format(done="0000", count="0000", rate=", 00.0/s"),
        )
        self._check = _passing(bar, tr("The independent check of this run, or of this design"))
        self._of_run = self._of_check = ""  # of checks: a run's own, and one asked for
        self._light = _figure(
            bar,
            tr(
                "Relative L2 error of the image, by the independent check once that is done, else "
                "as the optimiser computes it, and the fraction of the flux on the receiver"
            ),
            tr(_VERIFIED).format(error="00.0 %", place=tr("in the far field"), shares="000.0 %"),
        )
        self._loss = _figure(
            bar, tr("Loss that the optimiser minimises"), tr(_LOSS).format(loss=_WIDE_LOSS)
        )
        self._elapsed = _figure(bar, tr("Run time"), tr(_ELAPSED).format(time="00:00"))
        self._left = _figure(
            bar,
            tr(
                "Remaining time at the current rate; the automatic method ends sooner without "
                "further gain"
            ),
            tr(_AT_MOST).format(time="00:00"),
        )
        self._pace = Pace()
        self._layout = StatusLayout(
            bar,
            (self._iteration, self._light, self._loss, self._elapsed, self._left),
            (self._loss, self._elapsed, self._iteration),
        )

    @property
    def text(self) -> str:
        return self._state.text()

    def show_state(self, text: str) -> None:
        """Show a state, in place of any sentence."""
        self._text = text
        self._read.stop()
        self._show_text(text)

    def go_on(self, text: str) -> None:
        """Show progress, after the reading time of a sentence."""
        self._text = text
        if not self._read.isActive():
            self._show_text(text)

    def show_briefly(self, sentence: str) -> None:
        """Show a sentence for its reading time."""
        self._show_text(sentence)
        self._read.start(_READ_MS)

    def show_frame(self, frame: "Frame", running: bool, verified: str = "") -> None:
        """Show a frame; ``verified`` is the error of its lens by a check, if there was one."""
        snapshot = frame.snapshot
        done, all_of_it = snapshot.iteration, snapshot.iterations
        self._progress.setVisible(running)
        self._progress.setMaximum(max(all_of_it, 1))
        self._progress.setValue(done)
        counting = running or done > 0
        rate, left = None, None
        if running:
            self._pace.note(snapshot.seconds, done)
            rate, left = self._pace.rate, self._pace.left(all_of_it - done)
        each_second = "" if rate is None else f", {rate:.3g}/s"
        self._iteration.setText(
            tr(_ITERATION).format(done=done, count=all_of_it, rate=each_second) if counting else ""
        )
        self._loss.setText(tr(_LOSS).format(loss=written(snapshot.state.loss)))
        scene = frame.session.scene
        landed = _landed(frame)
        self._light.setText(
            tr(_VERIFIED if verified else _LIGHT).format(
                error=verified or _error(frame),
                place=tr(scene.receiver.place),
                shares=", ".join(landed),
            )
        )
        self._elapsed.setText(tr(_ELAPSED).format(time=clock(snapshot.seconds)) if counting else "")
        may_stop = scene.run.method == "auto"
        words = tr(_AT_MOST) if may_stop else tr("{time} left")
        self._left.setText("" if left is None else words.format(time=clock(left)))
        self._layout.share()

    def show_check_of_run(self, text: str) -> None:
        self._of_run = text
        self._show_check()

    def show_check(self, text: str) -> None:
        """Show the check that was asked for in place of the run's own."""
        self._of_check = text
        self._show_check()

    def show_nothing(self) -> None:
        for figure in (self._iteration, self._loss, self._light, self._elapsed, self._left):
            figure.clear()
        self._layout.share()

    def show_outdated(self, outdated: bool) -> None:
        for figure in (self._iteration, self._loss, self._light, self._elapsed, self._check):
            figure.setEnabled(not outdated)
        self._outdated.setVisible(outdated)
        self._layout.share()

    def settle(self) -> None:
        self._progress.hide()
        self._left.clear()
        self._layout.share()

    def _show_check(self) -> None:
        text = self._of_check or self._of_run
        self._check.setText(text)
        self._check.setVisible(bool(text))
        self._layout.share()

    def _show_text(self, text: str) -> None:
        self._state.setText(text)
        self._layout.share()


def _progress(bar: QStatusBar) -> QProgressBar:
    progress = QProgressBar()
    progress.setFixedWidth(150)
    progress.setTextVisible(False)
    progress.setAccessibleName(tr("Progress of the design"))
    progress.hide()
    bar.addPermanentWidget(progress)
    return progress


def _figure(bar: QStatusBar, tip: str, longest: str) -> QLabel:
    label = _label(bar, tip)
    label.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
    width = label.fontMetrics().horizontalAdvance(longest)
    label.setMinimumWidth(width + label.contentsMargins().left())
    return label


def _passing(bar: QStatusBar, tip: str, text: str = "") -> QLabel:
    label = _label(bar, f"<p>{tip}</p>")
    label.setText(text)
    label.hide()
    return label


def _label(bar: QStatusBar, tip: str) -> QLabel:
    label = QLabel()
    label.setToolTip(tip)
    label.setContentsMargins(label.fontMetrics().averageCharWidth(), 0, 0, 0)
    bar.addPermanentWidget(label)
    return label


def _landed(frame: "Frame") -> list[str]:
    from workbench.measured.lamps import light_unit  # late: takes long to import

    unit = light_unit(frame.session.scene)
    shares = [light.account.efficiency for light in frame.snapshot.state.lights]
    words = ((f"{100 * share:.1f} %", unit.flux_in_words(share)) for share in shares)
    return [" = ".join(filter(None, each)) for each in words]


def _error(frame: "Frame") -> str:
    """The error of all images together, and of each of several."""
    from workbench.design.loss import relative_error  # late: takes long to import
    from workbench.extended.bound import percent

    count = len(frame.session.scene.images)
    alone = [frame.of_image(number) for number in range(count)] if count > 1 else []
    errors = [percent(relative_error(f.snapshot.state, f.session.target)) for f in (frame, *alone)]
    return f"{errors[0]} ({', '.join(errors[1:])})" if alone else errors[0]


def clock(seconds: float) -> str:
    """Format a duration as m:ss or h:mm:ss."""
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02}:{rest:02}" if hours else f"{minutes}:{rest:02}"
