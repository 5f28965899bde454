"""How a freeform face looks in three dimensions: of its material, by its height or its curvature.

Its relief, which is what a smooth surface does not have, may be lit as if it were much higher. The
face itself stays where it is, so that rays still meet it.
"""

from collections.abc import Iterable
from typing import Literal

import numpy as np
import numpy.typing as npt
from matplotlib import colormaps

from workbench.arrays import Array
from workbench.pictures import shapes
from workbench.pictures.maps import SIGNED

FaceColours = Literal["material", "height", "curvature"]

_HEIGHTS = "viridis"
# Degree along u and along v of what counts as smooth.
_SMOOTH = 8
# Slopes that are seen well, and the part of the face on which the relief's are below it.
_SEEN, _MOSTLY = 0.5, 0.95
# Part of the face whose curvature the scale of colours has to reach; the rest is beyond it.
_WITHIN = 0.98


def top_of(surfaces: Iterable[Array], by: FaceColours) -> float:
    """The end of the scale of colours that faces share.

    Parameters
    ----------
    surfaces : iterable of ndarray, shape (m_u, m_v, 3)
        Points of each face, u along x and v along y.
    by : str
        See `face_colours`.

    Returns
    -------
    float
        Of heights above the lowest place of a face, scene units, from 0; of mean curvatures, per
        length, from as much below 0. 1 where there is none.
    """
    if by == "height":
        tops = [float(np.ptp(surface[..., 2])) for surface in surfaces]
    elif by == "curvature":
        tops = [float(np.quantile(np.abs(mean_curvature(each)), _WITHIN)) for each in surfaces]
    else:
        tops = []
    return max(tops, default=1.0) or 1.0


def scale_of(by: FaceColours, top: float, unit: str) -> tuple[str, float, float, str] | None:
    """Colours of `face_colours` by their name, the lowest and highest value, and their unit."""
    if by == "height":
        return _HEIGHTS, 0.0, top, unit
    return (SIGNED, -top, top, f"1 / {unit}") if by == "curvature" else None


def face_colours(
    surface: Array, by: FaceColours, material: str, top: float
) -> npt.NDArray[np.uint8]:
    """Colours of a face.

    Parameters
    ----------
    surface : ndarray, shape (m_u, m_v, 3)
        Points, u along x and v along y.
    by : str
        "height": how far the points are along z, from dark to bright; "curvature": red where the
        face is bowl-shaped towards +z, blue where it is a hump; "material".
    material : str
        The colour of that.
    top : float
        End of the scale, see `top_of`; values beyond it have the last colour.

    Returns
    -------
    ndarray of uint8, shape (m_u * m_v, 3)
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
    """Mean of the principal curvatures of a grid of points, by differences of neighbours.

    Parameters
    ----------
    surface : ndarray, shape (m_u, m_v, 3)
        Points, u along x and v along y.

    Returns
    -------
    ndarray, shape (m_u, m_v)
        Positive where the face is bowl-shaped towards +z.

    Examples
    --------
    A bowl of radius 4:

    >>> x, y = np.meshgrid(*2 * [np.linspace(-1, 1, 65)], indexing="ij")
    >>> bowl = np.stack([x, y, 4 - np.sqrt(16 - x**2 - y**2)], axis=-1)
    >>> mean_curvature(bowl)[20, 32].round(3).item()
    0.25
    """
    u, v = (np.gradient(surface, axis=axis, edge_order=2) for axis in (0, 1))
    uu, uv = (np.gradient(u, axis=axis, edge_order=2) for axis in (0, 1))
    vv = np.gradient(v, axis=1, edge_order=2)
    normal = shapes.normals(surface).reshape(surface.shape)
    e, f, g = ((second * normal).sum(axis=-1) for second in (uu, uv, vv))
    big_e, big_f, big_g = ((a * b).sum(axis=-1) for a, b in ((u, u), (u, v), (v, v)))
    area = np.maximum(big_e * big_g - big_f**2, np.finfo(float).tiny)
    return np.asarray((e * big_g - 2 * f * big_f + g * big_e) / (2 * area))


def lit_normals(surface: Array, exaggerated: bool) -> Array:
    """Normals by which a face is lit.

    Parameters
    ----------
    surface : ndarray, shape (m_u, m_v, 3)
        Points, u along x and v along y.
    exaggerated : bool
        Raise the relief, all that the nearest polynomial of some degree does not have, until its
        slopes are seen well. One that is steeper stays as it is.

    Returns
    -------
    ndarray, shape (m_u * m_v, 3)
    """
    if not exaggerated:
        return shapes.normals(surface)
    z = surface[..., 2]
    along_u, along_v = (_smooth_along(count) for count in z.shape)
    smooth = along_u @ z @ along_v
    relief = surface.copy()
    relief[..., 2] = z - smooth
    normal = shapes.normals(relief)
    slopes = np.hypot(normal[:, 0], normal[:, 1]) / np.abs(normal[:, 2])
    steep = float(np.quantile(slopes, _MOSTLY))
    times = max(_SEEN / steep, 1.0) if steep > 1e-9 else 1.0
    relief[..., 2] = smooth + times * (z - smooth)
    return shapes.normals(relief)


def _smooth_along(count: int) -> Array:
    """Projects so many values onto polynomials; a symmetric matrix."""
    powers = np.polynomial.legendre.legvander(np.linspace(-1, 1, count), min(_SMOOTH, count - 1))
    basis = np.linalg.qr(powers)[0]
    return np.asarray(basis @ basis.T)
