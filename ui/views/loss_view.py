"""The loss over iterations or seconds, of this run and of others."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from PySide6.QtWidgets import QCheckBox, QComboBox, QHBoxLayout, QWidget

from ui.views.plot_view import PlotView
from workbench.pictures.loss import Against, Course, LossPicture, Verified

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from ui.frame import Frame
    from workbench.files.session import Session

_AGAINST: tuple[Against, ...] = ("iterations", "seconds")


class LossView(PlotView):
    """Loss of this run and of those that it continues, and of runs to compare it with."""

    _HAS_BAR = False
    _NOTHING = "The loss is drawn here as soon as a design runs. Run > Start begins one."
    _picture: LossPicture

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._runs: tuple[Course, ...] = ()
        self._verified: tuple[Verified, ...] = ()
        self._against = QComboBox()
        self._against.addItems([f"Against {name}" for name in _AGAINST])
        self._against.setToolTip("What the loss is drawn against")
        self._against.setAccessibleName("Loss against")
        self._against.currentIndexChanged.connect(self._begin_anew)
        self._logarithmic = (
            _box("log x", "Logarithmic x axis: the first steps take as much room as the last"),
            _box("log y", "Logarithmic y axis: the same part of an improvement looks the same"),
        )
        self._logarithmic[1].setChecked(True)
        row = QHBoxLayout()
        row.setContentsMargins(6, 4, 6, 0)
        row.addWidget(self._against)
        for box in self._logarithmic:
            row.addWidget(box)
            box.toggled.connect(self._begin_anew)
        row.addStretch(1)
        self._box.insertLayout(0, row)

    def show_runs(self, runs: Sequence[Course]) -> None:
        """Show other runs beside this one."""
        self._runs = tuple(runs)
        self._begin_anew()

    def show_verified(self, verified: Sequence[Verified]) -> None:
        """Show what checks said of lenses of this run."""
        self._verified = tuple(verified)
        self._ask()

    def _is_empty(self, frame: "Frame | None") -> bool:
        return (frame is None or not frame.losses.size) and not self._runs

    def _begin(self, axes: "Axes", session: "Session") -> "Sequence[Artist]":
        against = _AGAINST[self._against.currentIndex()]
        log_x, log_y = (box.isChecked() for box in self._logarithmic)
        self._picture = LossPicture(axes, against, (log_x, log_y))
        self._picture.compare(self._runs)
        return self._picture.artists

    def _change(self, frame: "Frame") -> bool:
        ahead = frame.snapshot.iterations - frame.snapshot.iteration
        return self._picture.update(
            frame.losses,
            frame.losses.size + ahead,
            frame.stage_starts,
            frame.times,
            self._verified,
        )


def _box(name: str, tip: str) -> QCheckBox:
    box = QCheckBox(name)
    box.setToolTip(tip)
    return box
