"""Triangle meshes by STL, binary and as text: their vertices, by smooth parts of the mesh."""

import re

import numpy as np

from workbench.arrays import Array, Index
from workbench.measured.surfaces.points import LEAST_POINTS, MOST_POINTS, MeasuredSurface
from workbench.messages import Message
from workbench.units import WRITTEN

_HEADER, _RECORD = 84, np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")])
_VERTEX = re.compile(rb"vertex\s+(\S+)\s+(\S+)\s+(\S+)")
_UNIT = re.compile(rb"unit[\s:=]+([a-z]+)", re.IGNORECASE)
_EDGE = np.cos(np.radians(40))  # neighbouring triangles of one face have a larger cosine
_SMALL = 0.05  # patches with a smaller part of the vertices are walls and rims


def read_stl(content: bytes) -> MeasuredSurface:
    """Read a mesh; raise ValueError if it is invalid."""
    corners = _binary(content)
    if corners is None:
        corners = _text(content)
    if not np.isfinite(corners).all():
        raise ValueError(Message("a vertex of it has a value that is no finite number"))
    vertices, index = np.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
    found = _patches(vertices, index.reshape(-1, 3))
    large = max(map(len, found), default=0)
    kept = tuple(each for each in found if len(each) >= max(LEAST_POINTS, _SMALL * large))
    if not kept:
        raise ValueError(
            Message("no smooth part of its mesh has {least} vertices", least=LEAST_POINTS)
        )
    unit = match[1].decode().lower() if (match := _UNIT.search(content[:_HEADER])) else None
    return MeasuredSurface(kept, unit if unit in WRITTEN else None)


def _binary(content: bytes) -> Array | None:
    """Corners (triangles, 3, 3) of a binary file; None for another file."""
    if len(content) < _HEADER:
        return None
    count = int(np.frombuffer(content, "<u4", 1, _HEADER - 4)[0])
    needed = _HEADER + count * _RECORD.itemsize
    if content.startswith(b"solid") and len(content) != needed:
        return None
    if len(content) < needed:
        raise ValueError(Message("it is cut off"))
    _check(count)
    return np.frombuffer(content, _RECORD, count, _HEADER)["corners"].astype(np.float64)


def _text(content: bytes) -> Array:
    found = _VERTEX.findall(content)
    _check(len(found) // 3)
    try:
        numbers = np.array(found).astype(np.float64)
    except ValueError:
        raise ValueError(Message("a vertex of it has a value that is no finite number")) from None
    if len(found) % 3:
        raise ValueError(Message("it is cut off"))
    return numbers.reshape(-1, 3, 3)


def _check(triangles: int) -> None:
    if not 0 < triangles <= MOST_POINTS:
        raise ValueError(
            Message(
                "it has {count} triangles; 1 to {most} million are possible",
                count=triangles,
                most=MOST_POINTS // 10**6,
            )
        )


def _patches(vertices: Array, triangles: Index) -> list[Array]:
    """Vertices of each part of a mesh within which neighbouring triangles have no edge between."""
    from scipy.sparse import csr_array  # slow import
    from scipy.sparse.csgraph import connected_components

    ends = vertices[triangles]
    normals = np.cross(ends[:, 1] - ends[:, 0], ends[:, 2] - ends[:, 0])
    size = np.linalg.norm(normals, axis=1)
    triangles, normals = triangles[size > 0], normals[size > 0] / size[size > 0, None]
    sides = np.sort(np.concatenate([triangles[:, pair] for pair in ([0, 1], [1, 2], [2, 0])]))
    owners = np.tile(np.arange(len(triangles)), 3)
    order = np.lexsort((sides[:, 1], sides[:, 0]))
    sides, owners = sides[order], owners[order]
    one, other = owners[:-1], owners[1:]
    smooth = (sides[:-1] == sides[1:]).all(axis=1)
    smooth &= (normals[one] * normals[other]).sum(axis=1) > _EDGE
    joined = (np.ones(smooth.sum(), np.int8), (one[smooth], other[smooth]))
    count, labels = connected_components(csr_array(joined, shape=(len(triangles),) * 2), False)
    return [vertices[np.unique(triangles[labels == k])] for k in _largest(labels, count)]


def _largest(labels: Index, count: int) -> Index:
    """Labels of parts that can have enough vertices, the largest first."""
    sizes = np.bincount(labels, minlength=count)
    order = np.argsort(-sizes, kind="stable")
    return np.asarray(order[sizes[order] >= LEAST_POINTS // 3])
