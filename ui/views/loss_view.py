"""Loss of runs, and the slider over the history of a run."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import QSignalBlocker, QSize, Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QSlider, QWidget

from ui.document.frame import iterations_before
from ui.views.plot_view import PlotView
from ui.views.shared_view import SharedView
from ui.widgets.controls import MenuButton, chosen_of, filled
from ui.words import tr
from workbench.pictures.loss import Against, LossCourse, LossPicture, Verified

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from ui.document.frame import Frame
    from workbench.files.session import Session


class HistorySlider(QWidget):
    """Slider to earlier iterations; hidden until there are some."""

    frame_chosen = Signal(object)
    continued = Signal(object)

    def __init__(self) -> None:
        super().__init__()
        self._frames: Sequence[Frame] = ()
        self._slider = QSlider(Qt.Orientation.Horizontal)
        self._slider.setAccessibleName(tr("Iteration of the run"))
        self._slider.setToolTip(tr("Show the design at an earlier iteration of the run"))
        self._slider.valueChanged.connect(self._show_chosen)
        self._slider.setMinimumWidth(4 * self._slider.sizeHint().height())
        self._text = QLabel()
        self._text.setMinimumWidth(
            self._text.fontMetrics().horizontalAdvance(
                tr("iteration {number}").format(number="00000")
            )
        )
        self._button = QPushButton(tr("Continue from here"))
        self._button.setToolTip(
            tr(
                "Restore the design of this iteration and continue from it; Undo restores the "
                "later one"
            )
        )
        self._button.clicked.connect(lambda: self.continued.emit(self._frame))
        self._row = filled(
            QHBoxLayout(self), (self._slider, 1), self._text, self._button, margins=(8, 0, 8, 4)
        )
        self.hide()

    def show_frames(self, frames: "Sequence[Frame]") -> None:
        self._frames = frames
        with QSignalBlocker(self._slider):
            self._slider.setMaximum(max(0, len(frames) - 1))
            self._slider.setValue(len(frames) - 1)
        self.setVisible(len(frames) > 1)
        self._show_iteration()

    def allow(self, resting: bool, go_on: bool) -> None:
        self._slider.setEnabled(resting)
        self._button.setEnabled(go_on)

    def minimumSizeHint(self) -> QSize:
        whole = super().minimumSizeHint()
        return whole if self._text.isHidden() else whole - QSize(self._text_width, 0)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        least = self.minimumSizeHint().width()
        self._text.setVisible(self.width() >= least + self._text_width)

    @property
    def _text_width(self) -> int:
        text = max(self._text.minimumWidth(), self._text.minimumSizeHint().width())
        return text + self._row.spacing()

    @property
    def _frame(self) -> "Frame":
        return self._frames[self._slider.value()]

    def _show_chosen(self) -> None:
        self._show_iteration()
        self.frame_chosen.emit(self._frame)

    def _show_iteration(self) -> None:
        self._text.setText(
            tr("iteration {number}").format(number=iterations_before(self._frame))
            if self._frames
            else ""
        )


_AGAINST: tuple[Against, ...] = ("iterations", "seconds")


class LossView(PlotView):
    """Loss of this run, of runs that it continues, and of others."""

    _picture: LossPicture

    def __init__(self, shared: SharedView | None = None) -> None:
        super().__init__(shared)
        self._runs: tuple[LossCourse, ...] = ()
        self._verified: tuple[Verified, ...] = ()
        self._axes_choice = MenuButton(tr("Axes"), tr("Axes of the plot"))
        self._against = self._axes_choice.add_choice(
            [tr("Against iterations"), tr("Against seconds")]
        )
        self._logarithmic = (
            self._axes_choice.add_toggle(tr("Logarithmic x"), on=False),
            self._axes_choice.add_toggle(tr("Logarithmic y"), on=True),
        )
        self._axes_choice.chosen.connect(self._begin_anew)
        self._add_in_corner(self._axes_choice)

    def show_runs(self, runs: Sequence[LossCourse]) -> None:
        self._runs = tuple(runs)
        self._begin_anew()

    def show_verified(self, verified: Sequence[Verified]) -> None:
        if tuple(verified) != self._verified:
            self._verified = tuple(verified)
            self._ask()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._ask()

    def _why_empty(self, frame: "Frame | None") -> str:
        if self._runs or (frame is not None and frame.result.losses.size):
            return ""
        return tr("The loss of a run is plotted here. Run > Start starts a run.")

    def _begin(self, axes: "Axes", session: "Session") -> "Sequence[Artist]":
        against = _AGAINST[chosen_of(self._against)]
        log_x, log_y = (action.isChecked() for action in self._logarithmic)
        self._picture = LossPicture(axes, against, (log_x, log_y))
        self._picture.compare(self._runs)
        return self._picture.artists

    def _change(self, frame: "Frame") -> bool:
        ahead = frame.snapshot.iterations - frame.snapshot.iteration
        return self._picture.update(
            frame.result.losses,
            frame.result.losses.size + ahead,
            frame.result.stage_starts,
            frame.result.times(),
            self._verified,
            frame.state.loss,
        )
