"""Maps of a face: height over the base, slope, curvatures."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from workbench.arrays import Array
from workbench.geometry.curvature import LocalShape, local_shape
from workbench.geometry.outlines import outline_of
from workbench.geometry.surface import even_counts, freeform_nets
from workbench.pictures.axes import (
    SIGNED,
    UNSIGNED,
    Extent,
    UpdatedPicture,
    colour_bar,
    constant_value,
    map_image,
    stable_scale,
)
from workbench.scene import Scene

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_PLACES = 192  # along the longer side


@dataclass(frozen=True)
class Aspect:
    """A quantity to show of a face.

    ``unit`` has {} for the unit of lengths, ``length`` is that unit's exponent, ``of`` computes the
    values, and ``signed`` says whether they have both signs.
    """

    name: str
    tip: str
    unit: str
    length: int
    of: Callable[[LocalShape], Array]
    signed: bool = True


_HOLLOW = "positive where the face is concave, negative where it is convex"

ASPECTS = (
    Aspect(
        "height",
        "Deviation along z from the base, or of the entrance face from its place",
        "{}",
        1,
        lambda s: s.height,
    ),
    Aspect(
        "slope",
        "Angle between the face and a plane across the axis",
        "°",
        0,
        lambda s: np.degrees(np.arctan(s.slope)),
        signed=False,
    ),
    Aspect(
        "mean curvature",
        f"Mean of the principal curvatures, {_HOLLOW}",
        "1 / {}",
        -1,
        lambda s: s.mean,
    ),
    Aspect(
        "Gaussian curvature",
        "Product of the principal curvatures: positive in a bowl and on a hump, negative on a "
        "saddle, zero where the face is bent in one direction only",
        "1 / {}²",
        -2,
        lambda s: s.gaussian,
    ),
    Aspect(
        "largest curvature",
        f"Larger principal curvature, {_HOLLOW}; one over the smallest concave radius",
        "1 / {}",
        -1,
        lambda s: s.largest,
    ),
    Aspect(
        "smallest curvature",
        f"Smaller principal curvature, {_HOLLOW}; one over the smallest convex radius",
        "1 / {}",
        -1,
        lambda s: s.smallest,
    ),
)
"""What can be shown of a face."""


class SurfaceImage(UpdatedPicture):
    """One aspect of a face on axes of the caller; ``values`` (n_y, n_x) are shown.

    The scale begins at zero or is symmetric about it. By default it shows the designed face.
    """

    def __init__(self, axes: "Axes", scene: Scene, aspect: Aspect, face: str = "") -> None:
        optic = scene.optic
        self._aspect = aspect
        self._net = freeform_nets(optic)[face or optic.designed_face]
        count_x, count_y = even_counts(optic.half_width, _PLACES)
        self._u, self._v = ((np.arange(n) + 0.5) / n for n in (count_x, count_y))
        x, y = (2 * self._u - 1) * optic.half_width[0], (2 * self._v - 1) * optic.half_width[1]
        # Nothing is shown beside the lens.
        self._beside = np.where(outline_of(optic).contains(x[:, None], y), 0.0, np.nan)
        self._base = optic.place_of(face or optic.designed_face, x[:, None], y)
        self._size = max(optic.half_width) ** aspect.length  # of values that are more than rounding
        self.values = np.zeros((count_y, count_x))
        colours = SIGNED if aspect.signed else UNSIGNED[1]
        size = (count_x, count_y)
        extent = Extent.around(optic.half_width, scene.unit)
        self._image = map_image(axes, aspect.name, extent, size, colours)
        self._scale = 0.0
        unit = aspect.unit.format(scene.unit)
        extend = "both" if aspect.signed else "max"
        colour_bar(axes, self._image, f"{aspect.name} ({unit})", extend)
        self.artists = [self._image]

    def update(self, heights: Array) -> bool:
        """Show the face with control heights (n_u, n_v); return whether the scale changed."""
        shape = local_shape(self._net, heights, self._u, self._v)
        found = self._aspect.of(shape._replace(height=shape.height - self._base)) + self._beside
        self.values = np.asarray(found[:, ::-1].T)
        value = constant_value(found, self._size)
        if value is not None:
            self.values = np.where(np.isnan(self.values), np.nan, value)
        self._image.set_data(self.values)
        scale = stable_scale(self.values, self._scale)
        if scale == self._scale:
            return False
        self._scale = scale
        self._image.set_clim(-scale if self._aspect.signed else 0, scale)
        return True
