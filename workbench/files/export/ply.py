"""PLY, binary: the closed body in double precision."""

from typing import BinaryIO

import numpy as np

from workbench.files.export.design import Design, Deviation
from workbench.files.export.tessellation import Tessellation

_HEADER = """ply
format binary_little_endian 1.0
comment freeform lens, unit {unit}
element vertex {vertices}
property double x
property double y
property double z
element face {faces}
property list uchar int vertex_indices
end_header
"""
_FACE = np.dtype([("count", "u1"), ("vertices", "<i4", 3)])


def write_ply(design: Design, file: BinaryIO) -> Deviation:
    """Write the closed body.

    Raises
    ------
    Refused
        If the chord error takes too many triangles.
    """
    face = Tessellation.of(design)
    body = face.body(design.in_mesh_unit)
    header = _HEADER.format(
        unit=design.mesh_unit, vertices=len(body.vertices), faces=len(body.triangles)
    )
    faces = np.zeros(len(body.triangles), dtype=_FACE)
    faces["count"] = 3
    faces["vertices"] = body.triangles
    file.write(header.encode())
    file.write(body.vertices.astype("<f8").tobytes())
    file.write(faces.tobytes())
    return face.deviation(design)
