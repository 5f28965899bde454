"""How far the design is, in the status bar."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel, QProgressBar, QStatusBar

from workbench.design.snapshot import Snapshot


class RunStatus:
    """What goes on at the left of a status bar; progress bar and figures at the right.

    Parameters
    ----------
    bar : QStatusBar
        Gets them.
    """

    def __init__(self, bar: QStatusBar) -> None:
        self._state = QLabel()
        bar.addWidget(self._state)
        self._progress = QProgressBar()
        self._progress.setFixedWidth(150)
        self._progress.setTextVisible(False)
        self._progress.setAccessibleName("Progress of the design")
        self._progress.hide()
        bar.addPermanentWidget(self._progress)
        # Widths of the longest text to be expected, so that nothing jumps while it counts.
        self._iteration = _figure(bar, "Iterations done", "iteration 0000 of 0000")
        self._loss = _figure(bar, "How far the image is from the target", "loss 0.000e-00")
        self._check = QLabel()
        self._check.setToolTip(
            "<p>Relative L2 error of the image, ± its standard error, and the part of the light "
            "on the screen, by an independent trace with rays that the design never saw</p>"
        )
        self._check.hide()
        bar.addPermanentWidget(self._check)
        self._light = _figure(
            bar, "Part of the light that lands on the screen", "on screen 000.0 %"
        )
        self._elapsed = _figure(bar, "Run time", "00:00 elapsed")
        self._left = _figure(bar, "Time left if all iterations are used", "00:00 left")

    def show_state(self, text: str) -> None:
        """Say what goes on."""
        self._state.setText(text)

    def show_snapshot(self, snapshot: Snapshot, running: bool) -> None:
        """Show the figures of a lens; progress only while it is being designed."""
        done, all_of_it = snapshot.iteration, snapshot.iterations
        self._progress.setVisible(running)
        self._progress.setMaximum(max(all_of_it, 1))
        self._progress.setValue(done)
        counting = running or done > 0
        self._iteration.setText(f"iteration {done} of {all_of_it}" if counting else "")
        self._loss.setText(f"loss {snapshot.loss:.3e}")
        self._light.setText(f"on screen {100 * snapshot.ledger.efficiency:.1f} %")
        self._elapsed.setText(f"{clock(snapshot.seconds)} elapsed" if counting else "")
        left = snapshot.seconds / done * (all_of_it - done) if done else None
        self._left.setText(f"{clock(left)} left" if running and left is not None else "")

    def show_check(self, figures: str) -> None:
        """Show what a check says of the lens on show; empty for nothing."""
        self._check.setText(figures)
        self._check.setVisible(bool(figures))

    def show_nothing(self) -> None:
        """There is no lens to show figures of."""
        for figure in (self._iteration, self._loss, self._light, self._elapsed, self._left):
            figure.clear()

    def settle(self) -> None:
        """The run has ended: nothing is in progress any more."""
        self._progress.hide()
        self._left.clear()


def _figure(bar: QStatusBar, tip: str, longest: str) -> QLabel:
    label = QLabel()
    label.setToolTip(tip)
    label.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
    label.setMinimumWidth(label.fontMetrics().horizontalAdvance(longest))
    bar.addPermanentWidget(label)
    return label


def clock(seconds: float) -> str:
    """Minutes and seconds, with hours before them where there are any."""
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02}:{rest:02}" if hours else f"{minutes}:{rest:02}"
