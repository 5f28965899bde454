"""Colours and shading of a freeform face in the 3D view.

The relief (deviation from a smooth polynomial) may be shaded as if it were much higher; the points
of the face do not move.
"""

from collections.abc import Iterable
from typing import Literal

import numpy as np
import numpy.typing as npt
from matplotlib import colormaps

from workbench.arrays import Array
from workbench.pictures import meshes
from workbench.pictures.axes import SIGNED

FaceColours = Literal["material", "height", "curvature"]
_HEIGHTS = "viridis"
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
    return (SIGNED, -top, top, f"1 / {unit}") if by == "curvature" else None


def face_colours(
    surface: Array, by: FaceColours, material: str, top: float
) -> npt.NDArray[np.uint8]:
    """Return RGB colours (m_u * m_v, 3) of a face (m_u, m_v, 3).

    "height" colours by z above the lowest point, "curvature" by the mean curvature: red where the
    face is concave towards +z. Values above ``top`` (see `scale_top`) have the last colour.
    """
    if by == "material":
        red, green, blue = (int(material[k : k + 2], 16) for k in (1, 3, 5))
        return np.full((surface[..., 0].size, 3), (red, green, blue), dtype=np.uint8)
    if by == "height":
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
