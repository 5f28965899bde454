"""STL, binary: triangles in single precision. The unit stands in its free header alone."""

from typing import BinaryIO

import numpy as np

from workbench.files.export.design import Design, Deviation
from workbench.files.export.tessellation import Tessellation

_RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def write_stl(design: Design, file: BinaryIO) -> Deviation:
    """Write the closed body.

    Raises
    ------
    Refused
        If the chord error is too small for single precision, or for the number of triangles.
    """
    face = Tessellation.of(design, precision=2.0**-24).rounded(design.in_mesh_unit)
    body = face.body(design.in_mesh_unit)
    records = np.zeros(len(body.triangles), dtype=_RECORD)
    corners = body.vertices[body.triangles]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    records["normal"] = normal / np.linalg.norm(normal, axis=1, keepdims=True)
    records["corners"] = corners
    file.write(f"freeform lens, unit {design.mesh_unit}".encode().ljust(80))
    file.write(np.uint32(len(records)).astype("<u4").tobytes())
    file.write(records.tobytes())
    return face.deviation(design)
