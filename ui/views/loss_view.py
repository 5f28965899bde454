"""Loss over iterations or seconds, of this run and of others."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from PySide6.QtGui import QResizeEvent

from ui.views.plot_view import PlotView
from ui.widgets.menu_button import MenuButton, chosen_of
from ui.words import tr
from workbench.pictures.loss import Against, LossCourse, LossPicture, Verified

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from ui.shown.frame import Frame
    from workbench.files.session import Session

_AGAINST: tuple[Against, ...] = ("iterations", "seconds")


class LossView(PlotView):
    """Loss of this run, of runs that it continues, and of others."""

    _HAS_BAR = False
    _picture: LossPicture

    def __init__(self) -> None:
        super().__init__()
        self._runs: tuple[LossCourse, ...] = ()
        self._verified: tuple[Verified, ...] = ()
        self._axes_choice = MenuButton(tr("Axes"), tr("What the loss is drawn against, and how"))
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
        """Show other runs beside this one."""
        self._runs = tuple(runs)
        self._begin_anew()

    def show_verified(self, verified: Sequence[Verified]) -> None:
        """Show checks of lenses of this run."""
        if tuple(verified) != self._verified:
            self._verified = tuple(verified)
            self._ask()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Lay out the legend for another size."""
        super().resizeEvent(event)
        self._ask()

    def _why_empty(self, frame: "Frame | None") -> str:
        if self._runs or (frame is not None and frame.result.losses.size):
            return ""
        return tr("The loss is drawn here while a design runs. Run > Start begins one.")

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
        )
