"""Wavefront OBJ: the closed body as text, with every digit."""

from typing import BinaryIO

from workbench.files.export.design import Design, Deviation
from workbench.files.export.tessellation import Tessellation


def write_obj(design: Design, file: BinaryIO) -> Deviation:
    """Write the closed body.

    Raises
    ------
    Refused
        If the chord error takes too many triangles.
    """
    face = Tessellation.of(design)
    body = face.body(design.in_mesh_unit)
    file.write(f"# freeform lens, unit {design.mesh_unit}\n".encode())
    file.writelines(f"v {x!r} {y!r} {z!r}\n".encode() for x, y, z in body.vertices.tolist())
    file.writelines(f"f {a} {b} {c}\n".encode() for a, b, c in (body.triangles + 1).tolist())
    return face.deviation(design)
