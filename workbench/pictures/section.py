"""Irradiance and target along a line across the screen."""

from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from workbench.pictures.images import full_scale, pixel_at, target_irradiance
from workbench.scene import Scene

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

Array = npt.NDArray[np.float64]

_FONT = 8
_HEADROOM = 1.4  # above the scale of the images, for bright spots and the legend
_LIGHT, _WISH = "#2f86d1", "#d9822b"  # told apart also by those who see no red or no green


class SectionCurves:
    """Irradiance and target through one place of the screen, on axes that the caller owns.

    The target has the flux of the irradiance on the screen, so that the curves compare in shape.

    Parameters
    ----------
    axes : matplotlib.axes.Axes
        Empty axes.
    scene : Scene
        Gives the screen.
    target : ndarray, shape (n_y, n_x)
        Wished image.
    along : str
        "x" or "y".

    Attributes
    ----------
    artists : list of matplotlib.artist.Artist
        What `update` changes; the caller may blit them.
    """

    def __init__(self, axes: "Axes", scene: Scene, target: npt.NDArray[Any], along: str) -> None:
        self._scene = scene
        self._along = along
        self._wish = target_irradiance(scene, target)
        axis = "xy".index(along)
        r, n = scene.screen.half_width[axis], scene.screen.pixels[axis]
        self._middles = (np.arange(n) + 0.5) * (2 * r / n) - r  # of pixels
        axes.set_xlim(-r, r)
        axes.set_ylim(0, _HEADROOM * full_scale(scene, target))
        axes.set_xlabel(f"{along} ({scene.unit})", fontsize=_FONT, labelpad=2)
        axes.set_ylabel(f"flux / {scene.unit}²", fontsize=_FONT, labelpad=2)
        axes.tick_params(labelsize=_FONT)
        axes.locator_params(nbins=5)
        axes.grid(visible=True, linewidth=0.6, alpha=0.35)
        (wish,) = axes.plot([], [], color=_WISH, linewidth=1.2, linestyle="--", label="target")
        (light,) = axes.plot([], [], color=_LIGHT, linewidth=1.4, label="irradiance")
        self._wish_line, self._light_line = wish, light
        axes.legend(loc="upper right", fontsize=_FONT, frameon=False, labelcolor="linecolor")
        self.artists: list[Artist] = [wish, light]

    def update(self, irradiance: Array, x: float, y: float) -> None:
        """Show another image, shape (n_y, n_x), along the line through (x, y) on the screen."""
        pixel = pixel_at(self._scene, x, y)
        if pixel is None:
            return
        flux = float(irradiance.sum()) * self._scene.screen.pixel_area
        self._light_line.set_data(self._middles, self._line(irradiance, *pixel))
        self._wish_line.set_data(self._middles, flux * self._line(self._wish, *pixel))

    def _line(self, image: Array, row: int, column: int) -> Array:
        return image[row] if self._along == "x" else image[::-1, column]  # y from below
