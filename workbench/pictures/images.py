"""Irradiance and signed error as images with axes in scene units.

The error compares irradiance and target at the same total flux: both are scaled so that the flux
on the screen is 1, then error = irradiance − target, in flux per area. It is positive where too
much light falls.
"""

import math
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt
from matplotlib import colormaps
from matplotlib.colors import Colormap, LogNorm, Normalize

from workbench.scene import Scene

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

Array = npt.NDArray[np.float64]

LIGHT = "inferno"
ERROR = "RdBu_r"
_HEADROOM = 1.15  # of the irradiance scale above the brightest target pixel
_DECADES = 1e3  # that a logarithmic scale spans
_FONT = 8


def target_irradiance(scene: Scene, target: npt.NDArray[Any]) -> Array:
    """The target as irradiance with a total flux of 1 on the screen.

    Parameters
    ----------
    scene : Scene
        Gives the size of a pixel.
    target : ndarray, shape (n_y, n_x)
        Wished image, non-negative; an image without any light stays black.

    Returns
    -------
    ndarray, shape (n_y, n_x)
        Flux per area.
    """
    flux = float(target.sum()) * scene.screen.pixel_area
    return np.asarray(target / flux if flux > 0 else np.zeros(target.shape), dtype=np.float64)


def signed_error(scene: Scene, target: npt.NDArray[Any], irradiance: Array) -> Array:
    """Irradiance minus target, both at a total flux of 1 on the screen.

    Parameters
    ----------
    scene : Scene
        Gives the size of a pixel.
    target, irradiance : ndarray, shape (n_y, n_x)
        Wished and obtained image.

    Returns
    -------
    ndarray, shape (n_y, n_x)
        Flux per area, positive where too much light falls.
    """
    return target_irradiance(scene, irradiance) - target_irradiance(scene, target)


def full_scale(scene: Scene, target: npt.NDArray[Any]) -> float:
    """Upper end of the irradiance scale: it follows the target, so colours keep their meaning."""
    return _HEADROOM * float(target_irradiance(scene, target).max())


def to_colours(irradiance: Array, top: float) -> npt.NDArray[np.uint8]:
    """Colours of an irradiance image on the scale from 0 to ``top``.

    Parameters
    ----------
    irradiance : ndarray, shape (n_y, n_x)
        Flux per area.
    top : float
        Upper end of the scale.

    Returns
    -------
    ndarray of uint8, shape (n_y, n_x, 3)
    """
    levels = np.clip(irradiance * (255 / top), 0, 255).astype(np.uint8)
    return _table(LIGHT)[levels]


def pixel_at(scene: Scene, x: float, y: float) -> tuple[int, int] | None:
    """Row and column of the pixel at a place on the screen; None beside the screen."""
    n_x, n_y = scene.screen.pixels
    column, row = (math.floor(at) for at in scene.screen.to_pixels(x, y))
    return (row, column) if 0 <= row < n_y and 0 <= column < n_x else None


def round_scale(largest: float) -> float:
    """The next of ... 0.1, 0.2, 0.5, 1, 2, 5 ... that is not below ``largest``."""
    if not largest > 0:
        return 1.0
    decade = 10.0 ** math.floor(math.log10(largest))
    return next(step * decade for step in (1, 2, 5, 10, 20) if step * decade >= largest)


class IrradianceImage:
    """Irradiance on axes that the caller owns.

    Attributes
    ----------
    artists : list of matplotlib.artist.Artist
        What `update` changes; the caller may blit them.
    """

    def __init__(self, axes: "Axes", scene: Scene, target: npt.NDArray[Any]) -> None:
        dark = colormaps[LIGHT](0.0)  # also for no light at all, which has no logarithm
        self._image = screen_image(axes, scene, colormaps[LIGHT].with_extremes(bad=dark))
        self._top = full_scale(scene, target)
        self._image.set_clim(0, self._top)
        colour_bar(axes, self._image, scene, extend="max")
        self.artists: list[Artist] = [self._image]

    def update(self, irradiance: Array) -> bool:
        """Show another image, shape (n_y, n_x).

        Returns
        -------
        bool
            Whether more than `artists` changed, so that the whole figure has to be drawn.
        """
        self._image.set_data(irradiance)
        return False

    def set_logarithmic(self, logarithmic: bool) -> None:
        """Colour by the logarithm, over three decades, or evenly; the whole figure changes."""
        even, decades = Normalize(0, self._top), LogNorm(self._top / _DECADES, self._top)
        self._image.set_norm(decades if logarithmic else even)


class ErrorImage:
    """Signed error on axes that the caller owns.

    The scale is symmetric about zero. It is one of 1, 2, 5, 10, ... and changes only when the
    errors leave it or fill less than a third of it.

    Attributes
    ----------
    artists : list of matplotlib.artist.Artist
        What `update` changes; the caller may blit them.
    """

    def __init__(self, axes: "Axes", scene: Scene, target: npt.NDArray[Any]) -> None:
        self._scene = scene
        self._target = target
        self._image = screen_image(axes, scene, ERROR)
        self._scale = round_scale(full_scale(scene, target))
        self._image.set_clim(-self._scale, self._scale)
        colour_bar(axes, self._image, scene, extend="both")
        self.artists: list[Artist] = [self._image]

    def update(self, irradiance: Array) -> bool:
        """Show the error of another irradiance image, shape (n_y, n_x).

        Returns
        -------
        bool
            Whether more than `artists` changed, so that the whole figure has to be drawn.
        """
        error = signed_error(self._scene, self._target, irradiance)
        self._image.set_data(error)
        # A few bright pixels at an edge must not hide the rest.
        largest = float(np.quantile(np.abs(error), 0.995))
        if self._scale / 3 <= largest <= self._scale:
            return False
        scale = round_scale(largest)
        if scale == self._scale:
            return False
        self._scale = scale
        self._image.set_clim(-scale, scale)
        return True


def screen_image(axes: "Axes", scene: Scene, colours: str | Colormap) -> Any:
    """An image of zeros on the screen's axes, in scene units."""
    (r_x, r_y), (n_x, n_y) = scene.screen.half_width, scene.screen.pixels
    image = axes.imshow(
        np.zeros((n_y, n_x)),
        cmap=colours,
        extent=(-r_x, r_x, -r_y, r_y),
        origin="upper",
        interpolation="nearest",
    )
    axes.set_xlabel(f"x ({scene.unit})", fontsize=_FONT, labelpad=2)
    axes.set_ylabel(f"y ({scene.unit})", fontsize=_FONT, labelpad=2)
    axes.tick_params(labelsize=_FONT)
    axes.locator_params(axis="x", nbins=4)  # labels beside each other need more room
    axes.locator_params(axis="y", nbins=5)
    return image


def colour_bar(axes: "Axes", image: Any, scene: Scene, extend: str, per: str = "") -> None:
    """The scale of an image of flux per area, or of that per something else."""
    # Beside the image itself, not beside the slot that the image may not fill.
    beside = axes.inset_axes((1.05, 0.0, 0.055, 1.0))
    bar = axes.figure.colorbar(image, cax=beside, extend=extend)
    bar.set_label(f"flux / {scene.unit}²{per}", fontsize=_FONT)
    bar.ax.tick_params(labelsize=_FONT)
    bar.outline.set_linewidth(0.6)


def _table(name: str) -> npt.NDArray[np.uint8]:
    return np.asarray(colormaps[name](np.arange(256), bytes=True)[:, :3])
