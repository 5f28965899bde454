"""Irradiance or radiant intensity, and its signed error, as images with axes.

Error = irradiance − target at equal flux, positive where there is too much flux. Pictures show it
at the flux that arrives; `signed_error` is at a flux of 1.

Irradiance and target share one scale that follows the brightest target pixel at the arriving flux:
where the image is right, both have the same colour, whatever the efficiency.
"""

import math
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt
from matplotlib import colormaps
from matplotlib.colors import Colormap, LogNorm, Normalize

from workbench.arrays import Array
from workbench.measured.lamps import light_unit
from workbench.messages import Message
from workbench.pictures.axes import (
    AS_SEEN,
    SIGNED,
    UNSIGNED,
    Extent,
    Map,
    colour_bar,
    map_image,
    round_scale,
    stable_scale,
)
from workbench.pictures.contours import Contours
from workbench.scene import Scene
from workbench.scene.image import as_viewed, inverted

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_LIGHT, _LEVELS = UNSIGNED[0], 4096
_HEADROOM = 1.15  # of the irradiance scale above the brightest target pixel
_DECADES = 1e3  # range of a logarithmic scale
_ROUNDING = 1e-9
_STEPS = 4  # of the scale per factor 2 of flux: the scale must not change at every update
_UNAFFECTED = "#a8a8a8"  # unlike the colours of gain and loss and the white between them


def target_irradiance(scene: Scene, target: npt.NDArray[Any], flux: float = 1.0) -> Array:
    """Return the target (n_y, n_x) as irradiance with a given total flux.

    `scene`: gives the size of a pixel; `target` (n_y, n_x): non-negative; an image of zeros stays
    zero; `flux`: total flux. Returns (n_y, n_x): flux per area.
    """
    peak = float(target.max())
    if not peak > 0:
        return np.zeros(target.shape)
    ratios = target / peak  # first: sums of tiny or huge values would under- or overflow
    return np.asarray(ratios * (flux / scene.receiver.total(ratios)), dtype=np.float64)


def signed_error(scene: Scene, target: npt.NDArray[Any], irradiance: Array) -> Array:
    """Return irradiance minus target (n_y, n_x), both at a total flux of 1; flux per area."""
    return target_irradiance(scene, irradiance) - target_irradiance(scene, target)


def shown_error(scene: Scene, target: npt.NDArray[Any], irradiance: Array) -> Array:
    """Return irradiance minus target at the arriving flux, in the scene's `LightUnit`.

    That is the difference of the two images shown beside it. At a flux of 1 the error of a lens
    with an efficiency of 11 % would be nine times as large. Without any flux both have a flux of 1.
    """
    flux = scene.receiver.total(irradiance) or 1.0
    return signed_error(scene, target, irradiance) * (light_unit(scene).density * flux)


def full_scale(scene: Scene, target: npt.NDArray[Any], flux: float = 1.0) -> float:
    """Return the upper end of the irradiance scale, which follows the target.

    It follows the flux in steps of 19 %, so that colours do not change at every update.
    """
    step = math.ceil(_STEPS * math.log2(flux) - _ROUNDING) if flux > 0 else 0
    return _HEADROOM * float(target_irradiance(scene, target).max()) * math.pow(2.0, step / _STEPS)


def colours_for(scene: Scene) -> str:
    """Return the colour map that shows the light of a scene best.

    Pictures are shown as they are seen; other light, and light in lux, so that small differences
    are seen.
    """
    pictures = any(image.target.file for image in scene.images)
    return AS_SEEN if pictures and not suits_contours(scene) else _LIGHT


def suits_contours(scene: Scene) -> bool:
    """Return whether lines of equal light help to read an image: where it is in lux or candela."""
    return light_unit(scene).lumens is not None


def is_lighting(scene: Scene, target: npt.NDArray[Any]) -> bool:
    """Return whether an image is judged by its lux or uniformity, rather than as a picture."""
    from workbench.analysis.regions import even_area  # late: takes long to import

    return suits_contours(scene) or even_area(target) is not None


def to_colours(irradiance: Array, top: float, colours: str) -> npt.NDArray[np.uint8]:
    """Return colours (n_y, n_x, 3) of an irradiance (n_y, n_x) on a scale from 0 to ``top``."""
    levels = np.clip(irradiance * ((_LEVELS - 1) / top), 0, _LEVELS - 1).astype(np.uint16)
    return _table(colours)[levels]


class IrradianceImage(Map):
    """Irradiance on axes of the caller.

    ``values`` (n_y, n_x) is the shown image in the scene's `LightUnit`; ``outlined``: whether
    lines of equal light are drawn from the next update on.
    """

    values: Array

    def __init__(
        self, axes: "Axes", scene: Scene, target: npt.NDArray[Any], name: str = ""
    ) -> None:
        self._scene, self._target, unit = scene, target, light_unit(scene)
        self._density, self.unit = unit.density, unit.words
        self.extent = Extent.of_receiver(scene)
        self.image = receiver_map(axes, name or scene.receiver.density, scene, _LIGHT)
        self.set_colours("")
        self._contours = Contours(axes, self.extent)
        self.outlined = False
        self._logarithmic = False
        self._top = self._density * full_scale(scene, target)
        self.image.set_clim(0, self._top)
        colour_bar(axes, self.image, self.unit, extend="max")

    def update(self, irradiance: Array) -> None:
        """Show an image (n_y, n_x)."""
        self.values = irradiance * self._density
        self.image.set_data(as_viewed(self._scene, self.values))
        flux = self._scene.receiver.total(irradiance)
        top = self._density * full_scale(self._scene, self._target, flux)
        if top != self._top:
            self._top = top
            self.set_logarithmic(self._logarithmic)
        if self.outlined:
            self._contours.show(self.values, top)

    def set_colours(self, name: str) -> None:
        """Set one of the colour maps `UNSIGNED`, or that for the scene; the whole figure changes.

        `name`: empty for that of the scene, see `colours_for`.
        """
        name = name or colours_for(self._scene)
        dark = colormaps[name](0.0)  # also for zero, which has no logarithm
        self.image.set_cmap(colormaps[name].with_extremes(bad=dark))

    def set_logarithmic(self, logarithmic: bool) -> None:
        """Set a logarithmic scale over three decades, or a linear one."""
        self._logarithmic = logarithmic
        even, decades = Normalize(0, self._top), LogNorm(self._top / _DECADES, self._top)
        self.image.set_norm(decades if logarithmic else even)


class ErrorImage(Map):
    """Signed error on axes of the caller.

    The scale is symmetric about zero and one of 1, 2, 5, 10, ... It changes only when the errors
    exceed it or fill less than a third of it. ``values`` (n_y, n_x) is the shown image in the
    scene's `LightUnit`.
    """

    values: Array

    def __init__(self, axes: "Axes", scene: Scene, target: npt.NDArray[Any]) -> None:
        self._scene = scene
        self._target = target
        unit = light_unit(scene)
        self.extent, self.unit = Extent.of_receiver(scene), unit.words
        self.image = receiver_map(axes, Message("error"), scene, SIGNED)
        self._scale = round_scale(unit.density * full_scale(scene, target))
        self.image.set_clim(-self._scale, self._scale)
        colour_bar(axes, self.image, self.unit, extend="both")

    def update(self, irradiance: Array) -> None:
        """Show the error of an irradiance (n_y, n_x)."""
        self.values = shown_error(self._scene, self._target, irradiance)
        self.image.set_data(as_viewed(self._scene, self.values))
        self._scale = stable_scale(self.values, self._scale)
        self.image.set_clim(-self._scale, self._scale)


def receiver_map(axes: "Axes", name: str, scene: Scene, colours: str | Colormap) -> Any:
    """Return an image of zeros on the receiver's axes, as its viewer sees them; see `map_image`.

    Its data are those of the receiver's pixels `as_viewed`.
    """
    extent = Extent.of_receiver(scene)
    if inverted(scene):
        left, right, bottom, top = extent.bounds
        extent = extent._replace(bounds=(right, left, bottom, top))
    return map_image(axes, name, extent, scene.receiver.pixels, colours)


@cache  # matplotlib takes a millisecond
def _table(name: str) -> npt.NDArray[np.uint8]:
    return np.asarray(colormaps[name](np.linspace(0, 1, _LEVELS), bytes=True)[:, :3])


class DerivativeImage(Map):
    """Map of a derivative on axes of the caller.

    ``values`` (n_y, n_x) are shown, in the scene's `LightUnit` per length.

    The scale is symmetric about zero. Pixels that the control point does not reach are grey.
    """

    values: Array

    def __init__(self, axes: "Axes", scene: Scene) -> None:
        colours = colormaps[SIGNED].with_extremes(bad=_UNAFFECTED)
        self.image = receiver_map(axes, "derivative", scene, colours)
        unit = light_unit(scene)
        self._scene, self._density = scene, unit.density
        self.extent, self.unit = Extent.of_receiver(scene), f"{unit.words} / {scene.unit}"
        colour_bar(axes, self.image, self.unit, extend="neither")
        self.update(None)

    def update(self, derivative: Array | None) -> None:
        """Show a derivative (n_y, n_x), flux per area and length; None shows zeros."""
        if derivative is None:
            derivative = np.zeros(self.image.get_array().shape)
        self.values = derivative * self._density
        self.image.set_data(np.ma.masked_equal(as_viewed(self._scene, self.values), 0))
        scale = float(np.abs(self.values).max()) or 1.0
        self.image.set_clim(-scale, scale)


class PhotoImage(Map):
    """A predicted photo on axes of the caller, as its viewer sees it; it has no ``values``."""

    def __init__(self, axes: "Axes", scene: Scene) -> None:
        self.extent = Extent.of_receiver(scene)
        self.image = receiver_map(axes, "photo", scene, UNSIGNED[-1])

    def update(self, colours: npt.NDArray[np.uint8]) -> None:
        """Show colours (n_y, n_x, 3), as the viewer sees them."""
        self.image.set_data(colours)
