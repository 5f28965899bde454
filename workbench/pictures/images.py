"""Irradiance, or intensity in the far field, and signed error as images with axes.

The error compares irradiance and target at the same total flux, in flux per area or solid angle:
error = irradiance − target. It is positive where too much light falls. Pictures show it with the
flux that arrives, `signed_error` is at a flux of 1.

Light and target are drawn on one scale, which ends above the brightest place of a target that has
as much light as arrives: where an image is right, both have the same colours, however much light
is lost on the way.
"""

import math
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt
from matplotlib import colormaps
from matplotlib.colors import Colormap, LogNorm, Normalize

from workbench.arrays import Array
from workbench.measured.light_unit import light_unit
from workbench.pictures.maps import (
    SIGNED,
    UNSIGNED,
    Extent,
    colour_bar,
    map_image,
    round_scale,
    settled_scale,
)
from workbench.pictures.updated import UpdatedPicture
from workbench.scene import Scene

if TYPE_CHECKING:
    from matplotlib.axes import Axes

LIGHT = UNSIGNED[0]
_HEADROOM = 1.15  # of the irradiance scale above the brightest target pixel
_DECADES = 1e3  # that a logarithmic scale spans
_ROUNDING = 1e-9
_STEPS = 4  # of a scale while the light that arrives halves: it shall not change all the time


def target_irradiance(scene: Scene, target: npt.NDArray[Any], flux: float = 1.0) -> Array:
    """The target as irradiance with a total flux on the screen.

    Parameters
    ----------
    scene : Scene
        Gives the size of a pixel.
    target : ndarray, shape (n_y, n_x)
        Target image, non-negative; an image without any light stays black.
    flux : float
        All light of it.

    Returns
    -------
    ndarray, shape (n_y, n_x)
        Flux per area.
    """
    peak = float(target.max())
    if not peak > 0:
        return np.zeros(target.shape)
    ratios = target / peak  # first, so that neither tiny nor huge images lose their sum
    return np.asarray(ratios * (flux / scene.receiver.total(ratios)), dtype=np.float64)


def signed_error(scene: Scene, target: npt.NDArray[Any], irradiance: Array) -> Array:
    """Irradiance minus target, both at a total flux of 1 on the screen.

    Parameters
    ----------
    scene : Scene
        Gives the size of a pixel.
    target, irradiance : ndarray, shape (n_y, n_x)
        Target and obtained image.

    Returns
    -------
    ndarray, shape (n_y, n_x)
        Flux per area, positive where too much light falls.
    """
    return target_irradiance(scene, irradiance) - target_irradiance(scene, target)


def shown_error(scene: Scene, target: npt.NDArray[Any], irradiance: Array) -> Array:
    """Irradiance minus target with the flux that arrives, in the scene's `LightUnit`.

    So it is the difference of the two pictures beside it, however much light is lost on the way. At
    a flux of 1 the error of a torch, of whose light 11 % arrive, would be nine times what
    both differ by. Where no light arrives, target and error have a flux of 1.
    """
    flux = scene.receiver.total(irradiance) or 1.0
    return signed_error(scene, target, irradiance) * (light_unit(scene).density * flux)


def full_scale(scene: Scene, target: npt.NDArray[Any], flux: float = 1.0) -> float:
    """Upper end of the irradiance scale: it follows the target, so colours keep their meaning.

    Parameters
    ----------
    scene : Scene
        Gives the size of a pixel.
    target : ndarray, shape (n_y, n_x)
        Target image.
    flux : float
        Light that arrives. The scale follows it in steps of 19 %; no light is drawn as all of it.
    """
    step = math.ceil(_STEPS * math.log2(flux) - _ROUNDING) if flux > 0 else 0
    return _HEADROOM * float(target_irradiance(scene, target).max()) * math.pow(2.0, step / _STEPS)


def to_colours(irradiance: Array, top: float, colours: str = LIGHT) -> npt.NDArray[np.uint8]:
    """Colours of an irradiance image on the scale from 0 to ``top``.

    Parameters
    ----------
    irradiance : ndarray, shape (n_y, n_x)
        Flux per area.
    top : float
        Upper end of the scale.
    colours : str
        One of `UNSIGNED`.

    Returns
    -------
    ndarray of uint8, shape (n_y, n_x, 3)
    """
    levels = np.clip(irradiance * (255 / top), 0, 255).astype(np.uint8)
    return _table(colours)[levels]


class IrradianceImage(UpdatedPicture):
    """Irradiance on axes that the caller owns.

    Parameters
    ----------
    axes : matplotlib.axes.Axes
        Empty axes.
    scene : Scene
        Gives the screen.
    target : ndarray, shape (n_y, n_x)
        Target image; gives the scale.
    name : str
        What the image is called; by default, what is on the receiver.

    Attributes
    ----------
    values : ndarray, shape (n_y, n_x)
        What is shown, in the scene's `LightUnit`.
    """

    values: Array

    def __init__(
        self,
        axes: "Axes",
        scene: Scene,
        target: npt.NDArray[Any],
        name: str = "",
    ) -> None:
        self._scene, self._target, self._unit = scene, target, light_unit(scene)
        self._image = receiver_map(axes, name or scene.receiver.density, scene, LIGHT)
        self.set_colours(LIGHT)
        self._logarithmic = False
        self._top = self._unit.density * full_scale(scene, target)
        self._image.set_clim(0, self._top)
        colour_bar(axes, self._image, self._unit.words, extend="max")
        self.artists = [self._image]

    def update(self, irradiance: Array) -> bool:
        """Show another image, shape (n_y, n_x)."""
        factor = self._unit.density
        self.values = irradiance * factor
        self._image.set_data(self.values)
        flux = self._scene.receiver.total(irradiance)
        top = factor * full_scale(self._scene, self._target, flux)
        if top == self._top:
            return False
        self._top = top
        self.set_logarithmic(self._logarithmic)
        return True

    def set_colours(self, name: str) -> None:
        """Take other colours, one of `UNSIGNED`; the whole figure changes."""
        dark = colormaps[name](0.0)  # also for no light at all, which has no logarithm
        self._image.set_cmap(colormaps[name].with_extremes(bad=dark))

    def set_logarithmic(self, logarithmic: bool) -> None:
        """Colour by the logarithm, over three decades, or evenly; the whole figure changes."""
        self._logarithmic = logarithmic
        even, decades = Normalize(0, self._top), LogNorm(self._top / _DECADES, self._top)
        self._image.set_norm(decades if logarithmic else even)


class ErrorImage(UpdatedPicture):
    """Signed error on axes that the caller owns.

    The scale is symmetric about zero. It is one of 1, 2, 5, 10, ... and changes only when the
    errors leave it or fill less than a third of it.

    Attributes
    ----------
    values : ndarray, shape (n_y, n_x)
        What is shown, in the scene's `LightUnit`.
    """

    values: Array

    def __init__(self, axes: "Axes", scene: Scene, target: npt.NDArray[Any]) -> None:
        self._scene = scene
        self._target = target
        unit = light_unit(scene)
        self._image = receiver_map(axes, "error", scene, SIGNED)
        self._scale = round_scale(unit.density * full_scale(scene, target))
        self._image.set_clim(-self._scale, self._scale)
        colour_bar(axes, self._image, unit.words, extend="both")
        self.artists = [self._image]

    def update(self, irradiance: Array) -> bool:
        """Show the error of another irradiance image, shape (n_y, n_x)."""
        self.values = shown_error(self._scene, self._target, irradiance)
        self._image.set_data(self.values)
        scale = settled_scale(self.values, self._scale)
        if scale == self._scale:
            return False
        self._scale = scale
        self._image.set_clim(-scale, scale)
        return True


def receiver_map(axes: "Axes", name: str, scene: Scene, colours: str | Colormap) -> Any:
    """An image of zeros on the receiver's axes; see `map_image`."""
    return map_image(axes, name, Extent.of_receiver(scene), scene.receiver.pixels, colours)


def _table(name: str) -> npt.NDArray[np.uint8]:
    return np.asarray(colormaps[name](np.arange(256), bytes=True)[:, :3])
