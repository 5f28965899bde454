"""The error of the image against the distance of the screen."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from workbench.pictures.maps import even_ticks
from workbench.scene import Scene

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_FONT = 8
_ERROR, _SCREEN, _MARK = "#2f86d1", "#8a8f98", "#d9822b"


class FocusCurve:
    """A curve on axes that the caller owns.

    Parameters
    ----------
    axes : matplotlib.axes.Axes
        Empty axes.
    scene : Scene
        Its screen is marked.
    ends : tuple[float, float]
        z where the axes begin and end.

    Attributes
    ----------
    mark : matplotlib.lines.Line2D
        Marks the distance on show; the caller may blit it.
    """

    def __init__(self, axes: "Axes", scene: Scene, ends: tuple[float, float]) -> None:
        self._axes = axes
        axes.axvline(scene.receiver.plane_z, color=_SCREEN, linestyle=":", linewidth=1)
        (self._curve,) = axes.plot([], [], "o-", color=_ERROR, markersize=3, linewidth=1.2)
        self.mark = axes.axvline(scene.receiver.plane_z, color=_MARK, linewidth=1)
        self._shown: Sequence[tuple[float, float]] = ()
        axes.set_xlim(*ends)
        axes.set_ylim(0, 1)
        axes.set_xlabel(f"z of the screen ({scene.unit})", fontsize=_FONT, labelpad=2)
        axes.set_ylabel("error (%)", fontsize=_FONT, labelpad=2)
        axes.tick_params(labelsize=_FONT)
        even_ticks(axes)
        axes.grid(visible=True, linewidth=0.6, alpha=0.35)

    def update(self, errors: Sequence[tuple[float, float]], z: float) -> bool:
        """Show other errors, and mark a distance.

        Parameters
        ----------
        errors : sequence of (float, float)
            z of a screen and the relative L2 error there, in the order of z.
        z : float
            The distance on show.

        Returns
        -------
        bool
            Whether more than the mark changed, so that the whole figure has to be drawn.
        """
        self.mark.set_xdata([z, z])
        if tuple(errors) == self._shown:
            return False
        self._shown = tuple(errors)
        self._curve.set_data([at for at, _ in errors], [100 * error for _, error in errors])
        self._axes.set_ylim(0, 110 * max((error for _, error in errors), default=0.01) or 1)
        return True
