"""Irradiance or radiant intensity, and target, along a line across the receiver."""

import math
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import numpy.typing as npt

from workbench.arrays import Array
from workbench.measured.lamps import light_unit
from workbench.messages import Message
from workbench.pictures.axes import FONT, Extent, label_curves, set_round_ticks
from workbench.pictures.images import full_scale, target_irradiance
from workbench.scene import Scene

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Place = tuple[float, float]

_HEADROOM = 1.4  # above the scale of the images, for bright spots and the legend
_LIGHT, _TARGET = "#2f86d1", "#d9822b"  # distinguishable without red or green


class Cut(NamedTuple):
    """Points along a straight line across the receiver."""

    name: str  # label of the coordinate along the line
    ends: tuple[float, float]  # first and last coordinate, in units of the receiver
    along: Array  # (m,), coordinates of the points
    # (m,), the same points in pixels from the middle of the first pixel.
    rows: Array
    columns: Array


def cut_through(scene: Scene, along: str, place: Place) -> Cut:
    """Return the row or column of pixels, along "x" or "y", through a point."""
    receiver, extent = scene.receiver, Extent.of_receiver(scene)
    axis = "xy".index(along)
    low, high = receiver.bounds[2 * axis : 2 * axis + 2]
    r, n = receiver.half_extent[axis], receiver.pixels[axis]
    column, row = (math.floor(at) for at in receiver.to_pixels(*place))
    middles = np.linspace(low + r / n, high - r / n, n)  # of pixels
    name = f"{extent.label(axis)} at {extent.in_words(1 - axis, place[1 - axis])}"
    if along == "x":
        return Cut(name, (low, high), middles, np.full(n, float(row)), np.arange(0.0, n))
    return Cut(name, (low, high), middles, np.arange(n - 1.0, -1, -1), np.full(n, float(column)))


def cut_between(scene: Scene, start: Place, end: Place) -> Cut:
    """Return the line between two points, about one point per pixel."""
    (x_0, y_0), (x_1, y_1) = start, end
    length = math.hypot(x_1 - x_0, y_1 - y_0)
    (first_x, first_y), (last_x, last_y) = (scene.receiver.to_pixels(*p) for p in (start, end))
    count = 1 + max(1, math.ceil(math.hypot(last_x - first_x, last_y - first_y)))
    part = np.linspace(0, 1, count)
    return Cut(
        f"{Message('distance')} ({Extent.of_receiver(scene).unit})",
        (0.0, length),
        part * length,
        first_y + part * (last_y - first_y) - 0.5,
        first_x + part * (last_x - first_x) - 0.5,
    )


def values_along(image: Array, cut: Cut) -> Array:
    """Return values (m,) of an image (n_y, n_x) along a cut, by bilinear interpolation."""
    rows, columns = (
        np.clip(at, 0, n - 1) for at, n in zip((cut.rows, cut.columns), image.shape, strict=True)
    )
    i, j = (
        np.minimum(at.astype(int), max(n - 2, 0))
        for at, n in zip((rows, columns), image.shape, strict=True)
    )
    below, right = np.minimum(i + 1, image.shape[0] - 1), np.minimum(j + 1, image.shape[1] - 1)
    down, across = rows - i, columns - j
    upper = (1 - across) * image[i, j] + across * image[i, right]
    lower = (1 - across) * image[below, j] + across * image[below, right]
    return np.asarray((1 - down) * upper + down * lower)


class SectionCurves:
    """Irradiance and target along a line across the receiver, on axes of the caller.

    The target has the flux of the irradiance, so that the curves compare in shape.
    """

    def __init__(self, axes: "Axes", scene: Scene, target: npt.NDArray[Any]) -> None:
        self._axes = axes
        self._scene, self._picture = scene, target
        self._target = target_irradiance(scene, target)
        self._unit = light_unit(scene)
        label_curves(axes, "", self._unit.words)
        set_round_ticks(axes)
        # Dashes over the line of the light: where both are the same, both are seen.
        (self.wanted,) = axes.plot(
            [],
            [],
            color=_TARGET,
            linewidth=1.2,
            linestyle="--",
            label=Message("target"),
            zorder=3,
        )
        (self.light,) = axes.plot([], [], color=_LIGHT, linewidth=1.4, label=scene.receiver.density)
        axes.legend(
            loc="upper right",
            fontsize=FONT,
            frameon=False,
            labelcolor="linecolor",
            handlelength=1.5,
            labelspacing=0.2,
        )

    def update(self, irradiance: Array, cut: Cut) -> None:
        """Show an image (n_y, n_x) along a cut."""
        flux, factor = self._scene.receiver.total(irradiance), self._unit.density
        self.light.set_data(cut.along, factor * values_along(irradiance, cut))
        self.wanted.set_data(cut.along, factor * flux * values_along(self._target, cut))
        top = factor * _HEADROOM * full_scale(self._scene, self._picture, flux)
        self._axes.set_xlabel(cut.name, fontsize=FONT, labelpad=2)
        self._axes.set_ylim(0, top)
        self._axes.set_xlim(*cut.ends)
