"""Mesh formats: STL, OBJ, PLY, 3MF, glTF."""

import json
import struct
from typing import BinaryIO
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

import numpy as np

from workbench.files.export.design import METRES, Design, Deviation
from workbench.files.export.tessellation import Tessellation, TriangleBody

_PLY_HEADER = """ply
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
_PLY_FACE = np.dtype([("count", "u1"), ("vertices", "<i4", 3)])
_STL_RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
_3MF_UNITS = {"mm": "millimeter", "cm": "centimeter", "m": "meter", "inch": "inch"}
_XML = '<?xml version="1.0" encoding="UTF-8"?>\n'
_TYPES = f"""{_XML}<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
"""
_RELATIONS = f"""{_XML}<Relationships \
xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/3dmodel.model" Id="rel0" \
Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
"""
_BEGIN = f"""{_XML}<model unit="{{unit}}" xml:lang="en-US" \
xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
<metadata name="Title">freeform lens</metadata>
<metadata name="Application">freeform-lens-workbench</metadata>
<resources>
<object id="1" type="model" name="freeform lens">
<mesh>
<vertices>
"""
_MIDDLE = "</vertices>\n<triangles>\n"
_END = """</triangles>
</mesh>
</object>
</resources>
<build>
<item objectid="1"/>
</build>
</model>
"""
_FLOAT, _UNSIGNED_INT = 5126, 5125
_VERTICES, _INDICES = 34962, 34963  # targets of buffer views


def write_obj(design: Design, file: BinaryIO) -> Deviation:
    """Write the closed body as Wavefront OBJ, as text with all digits."""
    face = Tessellation.of(design)
    body = face.body(design.in_mesh_unit)
    file.write(f"# freeform lens, unit {design.mesh_unit}\n".encode())
    file.writelines(f"v {x!r} {y!r} {z!r}\n".encode() for x, y, z in body.vertices.tolist())
    file.writelines(f"f {a} {b} {c}\n".encode() for a, b, c in (body.triangles + 1).tolist())
    return face.deviation(design, design.mesh_unit)


def write_ply(design: Design, file: BinaryIO) -> Deviation:
    """Write the closed body as binary PLY, in double precision."""
    face = Tessellation.of(design)
    body = face.body(design.in_mesh_unit)
    header = _PLY_HEADER.format(
        unit=design.mesh_unit, vertices=len(body.vertices), faces=len(body.triangles)
    )
    faces = np.zeros(len(body.triangles), dtype=_PLY_FACE)
    faces["count"] = 3
    faces["vertices"] = body.triangles
    file.write(header.encode())
    file.write(body.vertices.astype("<f8").tobytes())
    file.write(faces.tobytes())
    return face.deviation(design, design.mesh_unit)


def write_stl(design: Design, file: BinaryIO) -> Deviation:
    """Write the closed body as binary STL, in single precision; the header names the unit.

    Raise Refused if the chord error is too small for single precision or the number of triangles.
    """
    face = Tessellation.of(design, precision=2.0**-24).rounded(design.in_mesh_unit)
    body = face.body(design.in_mesh_unit)
    records = np.zeros(len(body.triangles), dtype=_STL_RECORD)
    corners = body.vertices[body.triangles]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    records["normal"] = normal / np.linalg.norm(normal, axis=1, keepdims=True)
    records["corners"] = corners
    file.write(f"freeform lens, unit {design.mesh_unit}".encode().ljust(80))
    file.write(np.uint32(len(records)).astype("<u4").tobytes())
    file.write(records.tobytes())
    return face.deviation(design, design.mesh_unit)


def write_3mf(design: Design, file: BinaryIO) -> Deviation:
    """Write the closed body as 3MF, a zip with XML that states its unit (3MF Core 1.3).

    Times of the zip's entries are fixed: the same lens gives the same file.
    """
    face = Tessellation.of(design)
    body = face.body(design.in_mesh_unit)
    with ZipFile(file, "w") as package:
        package.writestr(zip_entry("[Content_Types].xml"), _TYPES)
        package.writestr(zip_entry("_rels/.rels"), _RELATIONS)
        with package.open(zip_entry("3D/3dmodel.model"), "w") as model:
            model.write(_BEGIN.format(unit=_3MF_UNITS[design.mesh_unit]).encode())
            model.writelines(
                f'<vertex x="{x!r}" y="{y!r}" z="{z!r}"/>\n'.encode()
                for x, y, z in body.vertices.tolist()
            )
            model.write(_MIDDLE.encode())
            model.writelines(
                f'<triangle v1="{a}" v2="{b}" v3="{c}"/>\n'.encode()
                for a, b, c in body.triangles.tolist()
            )
            model.write(_END.encode())
    return face.deviation(design, design.mesh_unit)


def zip_entry(name: str) -> ZipInfo:
    """Entry of a zip with a fixed time: the same content gives the same file."""
    entry = ZipInfo(name)
    entry.compress_type = ZIP_DEFLATED
    return entry


def write_glb(design: Design, file: BinaryIO) -> Deviation:
    """Write the closed body as binary glTF 2.0, in single precision.

    The format's unit is the metre: the node of the mesh scales the scene's unit. Its axes are those
    of the scene, right-handed with y up. Raise Refused if the chord error is too small for single
    precision or the number of triangles.
    """
    face = Tessellation.of(design, precision=2.0**-24).rounded()
    body = face.body()
    vertices = body.vertices.astype("<f4").tobytes()
    triangles = body.triangles.astype("<u4").tobytes()
    data = json.dumps(_gltf_scene(design, body, len(vertices), len(triangles))).encode()
    data += b" " * (-len(data) % 4)
    size = 12 + 8 + len(data) + 8 + len(vertices) + len(triangles)
    file.write(struct.pack("<4sII", b"glTF", 2, size))
    file.write(struct.pack("<I4s", len(data), b"JSON") + data)
    file.write(struct.pack("<I4s", len(vertices) + len(triangles), b"BIN\0"))
    file.write(vertices + triangles)
    return face.deviation(design, "m")


def _gltf_scene(
    design: Design, body: TriangleBody, vertices: int, triangles: int
) -> dict[str, object]:
    metres = METRES[design.unit]
    return {
        "asset": {"version": "2.0", "generator": "freeform-lens-workbench"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"name": "freeform lens", "mesh": 0, "scale": [metres] * 3}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "mode": 4}]}],
        "accessors": [
            {
                "bufferView": 0,
                "componentType": _FLOAT,
                "count": len(body.vertices),
                "type": "VEC3",
                "min": np.min(body.vertices, axis=0).tolist(),
                "max": np.max(body.vertices, axis=0).tolist(),
            },
            {
                "bufferView": 1,
                "componentType": _UNSIGNED_INT,
                "count": body.triangles.size,
                "type": "SCALAR",
            },
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": vertices, "target": _VERTICES},
            {"buffer": 0, "byteOffset": vertices, "byteLength": triangles, "target": _INDICES},
        ],
        "buffers": [{"byteLength": vertices + triangles}],
    }
