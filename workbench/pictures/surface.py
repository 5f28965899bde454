"""Colours, shading and maps of a freeform face."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np
import numpy.typing as npt
from matplotlib import colormaps
from matplotlib.colors import ListedColormap

from workbench.arrays import Array, Mask
from workbench.geometry.curvature import LocalShape, local_shape
from workbench.geometry.outlines import outline_of
from workbench.geometry.surface import even_counts, freeform_nets
from workbench.pictures import meshes
from workbench.pictures.axes import (
    BEYOND,
    SIGNED,
    UNSIGNED,
    WITHIN,
    Extent,
    Map,
    colour_bar,
    constant_value,
    map_image,
    stable_scale,
)
from workbench.scene import Scene

if TYPE_CHECKING:
    from matplotlib.axes import Axes


FaceColours = Literal["material", "height", "curvature", "limits"]
_HEIGHTS, _JUDGED = "viridis", "within and beyond limits"
colormaps.register(ListedColormap([WITHIN, BEYOND], name=_JUDGED), force=True)
# Degree along u and v of the polynomial that counts as smooth.
_SMOOTH = 8
# Visible slope of the relief, and the part of the face below it.
_VISIBLE_SLOPE, _BELOW_PART = 0.5, 0.95
# Part of the face whose curvature is within the colour scale.
_WITHIN = 0.98


def scale_top(surfaces: Iterable[Array], by: FaceColours) -> float:
    """Return the upper end of the shared colour scale of faces (m_u, m_v, 3).

    For "height": height above the lowest point, scene units. For "curvature": the scale is
    symmetric about zero, 1 / length. 1 where all values are zero.
    """
    if by == "height":
        tops = [float(np.ptp(surface[..., 2])) for surface in surfaces]
    elif by == "curvature":
        tops = [float(np.quantile(np.abs(mean_curvature(each)), _WITHIN)) for each in surfaces]
    else:
        tops = []
    return max(tops, default=1.0) or 1.0


def colour_scale_of(by: FaceColours, top: float, unit: str) -> tuple[str, float, float, str] | None:
    """Return colour map, lowest and highest value, and unit; None for material."""
    if by == "height":
        return _HEIGHTS, 0.0, top, unit
    if by == "limits":
        return _JUDGED, 0.0, 1.0, ""
    return (SIGNED, -top, top, f"1 / {unit}") if by == "curvature" else None


def face_colours(
    surface: Array, by: FaceColours, material: str, top: float, beyond: Mask | None = None
) -> npt.NDArray[np.uint8]:
    """Return RGB colours (m_u * m_v, 3) of a face (m_u, m_v, 3).

    "height" colours by z above the lowest point, "curvature" by the mean curvature: red where the
    face is concave towards +z. Values above ``top`` (see `scale_top`) have the last colour.
    "limits" shows where the mask ``beyond`` (m_u, m_v) is true.
    """
    if by == "material":
        red, green, blue = (int(material[k : k + 2], 16) for k in (1, 3, 5))
        return np.full((surface[..., 0].size, 3), (red, green, blue), dtype=np.uint8)
    if by == "limits":
        part, name = np.zeros(surface.shape[:2]) if beyond is None else 1.0 * beyond, _JUDGED
    elif by == "height":
        height = surface[..., 2] - surface[..., 2].min()
        part, name = height / top, _HEIGHTS
    else:
        part, name = 0.5 + 0.5 * mean_curvature(surface) / top, SIGNED
    return np.asarray(colormaps[name](part, bytes=True)[..., :3].reshape(-1, 3))


def mean_curvature(surface: Array) -> Array:
    """Mean curvature (m_u, m_v) of a face (m_u, m_v, 3), by finite differences."""
    u, v = (np.gradient(surface, axis=axis, edge_order=2) for axis in (0, 1))
    uu, uv = (np.gradient(u, axis=axis, edge_order=2) for axis in (0, 1))
    vv = np.gradient(v, axis=1, edge_order=2)
    normal = meshes.normals(surface).reshape(surface.shape)
    e, f, g = ((second * normal).sum(axis=-1) for second in (uu, uv, vv))
    big_e, big_f, big_g = ((a * b).sum(axis=-1) for a, b in ((u, u), (u, v), (v, v)))
    area = np.maximum(big_e * big_g - big_f**2, np.finfo(float).tiny)
    return np.asarray((e * big_g - 2 * f * big_f + g * big_e) / (2 * area))


def lit_normals(surface: Array, exaggerated: bool) -> Array:
    """Return normals (m_u * m_v, 3) for shading a face (m_u, m_v, 3).

    ``exaggerated`` scales the relief, the deviation from a smooth polynomial, until its slopes are
    visible; a steeper relief stays as it is.
    """
    if not exaggerated:
        return meshes.normals(surface)
    z = surface[..., 2]
    along_u, along_v = (_smooth_along(count) for count in z.shape)
    smooth = along_u @ z @ along_v
    relief = surface.copy()
    relief[..., 2] = z - smooth
    normal = meshes.normals(relief)
    slopes = np.hypot(normal[:, 0], normal[:, 1]) / np.abs(normal[:, 2])
    steep = float(np.quantile(slopes, _BELOW_PART))
    times = max(_VISIBLE_SLOPE / steep, 1.0) if steep > 1e-9 else 1.0
    relief[..., 2] = smooth + times * (z - smooth)
    return meshes.normals(relief)


def _smooth_along(count: int) -> Array:
    powers = np.polynomial.legendre.legvander(np.linspace(-1, 1, count), min(_SMOOTH, count - 1))
    basis = np.linalg.qr(powers)[0]
    return np.asarray(basis @ basis.T)


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


class SurfaceImage(Map):
    """One aspect of a face on axes of the caller; ``values`` (n_y, n_x) are shown.

    The scale begins at zero or is symmetric about it. By default it shows the designed face.
    """

    def __init__(self, axes: "Axes", scene: Scene, aspect: Aspect, face: str = "") -> None:
        face = face or scene.optic.designed_face
        optic = scene.focused_on(face).optic
        self._aspect = aspect
        self._net = freeform_nets(optic)[face]
        count_x, count_y = even_counts(optic.half_width, _PLACES)
        self._u, self._v = ((np.arange(n) + 0.5) / n for n in (count_x, count_y))
        x, y = (2 * self._u - 1) * optic.half_width[0], (2 * self._v - 1) * optic.half_width[1]
        # Nothing is shown beside the lens.
        self._beside = np.where(outline_of(optic).contains(x[:, None], y), 0.0, np.nan)
        self._base = optic.place_of(face, x[:, None], y)
        self._size = max(optic.half_width) ** aspect.length  # of values that are more than rounding
        self.values = np.zeros((count_y, count_x))
        colours = SIGNED if aspect.signed else UNSIGNED[1]
        size = (count_x, count_y)
        self.extent = Extent.around(optic.half_width, scene.unit)
        self.image = map_image(axes, aspect.name, self.extent, size, colours)
        self._scale = 0.0
        unit = aspect.unit.format(scene.unit)
        self.unit = unit.removeprefix("1 ")
        extend = "both" if aspect.signed else "max"
        colour_bar(axes, self.image, f"{aspect.name} ({unit})", extend)

    def update(self, heights: Array) -> None:
        """Show the face with control heights (n_u, n_v)."""
        shape = local_shape(self._net, heights, self._u, self._v)
        found = self._aspect.of(shape._replace(height=shape.height - self._base)) + self._beside
        self.values = np.asarray(found[:, ::-1].T)
        value = constant_value(found, self._size)
        if value is not None:
            self.values = np.where(np.isnan(self.values), np.nan, value)
        self.image.set_data(self.values)
        self._scale = stable_scale(self.values, self._scale)
        self.image.set_clim(-self._scale if self._aspect.signed else 0, self._scale)
