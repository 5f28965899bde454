"""Points, faces and lines of the drawn lens, as plain arrays.

Cells are flat lists as pyvista expects them: (n, i_1, ..., i_n, n, ...).
"""

import numpy as np
import numpy.typing as npt

from workbench.arrays import Array, Mask

Cells = npt.NDArray[np.int64]

_STRAIGHT = -0.7  # cosine of the angle between the two sides of a corner of a grid


def quads(rows: int, columns: int) -> Cells:
    """Faces of a grid of points in row-major order."""
    index = np.arange(rows * columns).reshape(rows, columns)
    corners = [index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]]
    return np.stack([np.full_like(corners[0], 4), *corners], axis=-1).ravel()


def polylines(lines: list[Cells]) -> Cells:
    """Lines through the given point indices."""
    return np.concatenate([np.append(line.size, line) for line in lines])


def net_lines(rows: int, columns: int, fields: int) -> Cells:
    """Isoparametric lines of a grid of points, ``fields`` + 1 along each axis, rim included."""
    index = np.arange(rows * columns).reshape(rows, columns)
    along = [index[i] for i in np.linspace(0, rows - 1, fields + 1).round().astype(int)]
    across = [index[:, j] for j in np.linspace(0, columns - 1, fields + 1).round().astype(int)]
    return polylines(along + across)


def grid_lines(shown: Mask) -> Cells:
    """Lines of a grid of points along rows and columns, through the shown points only."""
    index = np.arange(shown.size).reshape(shown.shape)
    lines = [*map(_shown_part, index, shown), *map(_shown_part, index.T, shown.T)]
    return polylines([line for line in lines if len(line) > 1])


def _shown_part(line: Cells, shown: Mask) -> Cells:
    return line[shown]


def normals(surface: Array) -> Array:
    """Return unit normals (m_u * m_v, 3), towards +z, of a grid of points (m_u, m_v, 3)."""
    along_u, along_v = np.gradient(surface, axis=0), np.gradient(surface, axis=1)
    across = np.cross(along_u, along_v)
    across /= np.linalg.norm(across, axis=-1, keepdims=True)
    for i, j in ((0, 0), (0, -1), (-1, 0), (-1, -1)):
        # Where the rim goes straight on, both ways are along it: the next point inside decides.
        if along_u[i, j] @ along_v[i, j] < _STRAIGHT * np.sqrt(
            np.square(along_u[i, j]).sum() * np.square(along_v[i, j]).sum()
        ):
            across[i, j] = across[1 if i == 0 else -2, 1 if j == 0 else -2]
    return np.asarray(across.reshape(-1, 3))


def wall_points(surface: Array, other_z: npt.ArrayLike) -> Array:
    """Return points (4 * (m_u + m_v), 3) of the four side walls, between two faces.

    For each wall: the rim of ``surface`` (m_u, m_v, 3), then the same points at ``other_z``.
    """
    other = surface.copy()
    other[..., 2] = other_z
    sides = [(side[:, 0], side[-1], side[::-1, -1], side[0, ::-1]) for side in (surface, other)]
    return np.concatenate([rim for both in zip(*sides, strict=True) for rim in both])


def wall_faces(m_u: int, m_v: int, straight: bool = True, flat: bool = True) -> Cells:
    """Faces between the `wall_points` of each wall, and of the other face if it is flat."""
    faces, feet, first = [], [], 0
    for count in (m_u, m_v, m_u, m_v):
        wall = quads(2, count).reshape(-1, 5)
        wall[:, 1:] += first
        faces.append(wall)
        feet.append(first + np.arange(count, count + 1 if straight else 2 * count - 1))
        first += 2 * count
    entrance = np.concatenate(feet)[::-1]  # seen from below, against the light
    closing = [[len(entrance)], entrance] if flat else []
    return np.concatenate([*(face.ravel() for face in faces), *closing])


def wall_lines(m_u: int, m_v: int, straight: bool = True, flat: bool = True) -> Cells:
    """Outline of the lens through its `wall_points`."""
    lines, first = [], 0
    for count in (m_u, m_v, m_u, m_v):
        rim = np.arange(first, first + count)
        lines += [rim, (rim[[0, -1]] if straight and flat else rim) + count]
        if straight:
            lines.append(np.array([first, first + count]))
        first += 2 * count
    return polylines(lines)


def starting_at(start: Array, entrance: Array, z: float) -> Array:
    """Move ray starts (n, 3) before the plane ``z`` onto it, along the line to ``entrance``."""
    rise = entrance[:, 2] - start[:, 2]
    passed = ((z - start[:, 2]) / rise).clip(0)
    return start + passed[:, None] * (entrance - start)


def rim_places(rows: int, columns: int) -> Cells:
    """Point indices of the border of a grid in row-major order, ordered as in `rim`."""
    index = np.arange(rows * columns, dtype=float).reshape(rows, columns)
    return rim(index).astype(np.int64)


def rim(points: Array) -> Array:
    """Border of a grid of points (m, n, 3), closed."""
    around = [points[:-1, 0], points[-1, :-1], points[:0:-1, -1], points[0, ::-1]]
    return np.concatenate(around)
