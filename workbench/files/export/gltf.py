"""glTF 2.0, binary (.glb): the closed body in single precision.

The format's unit is the metre, so the node that holds the mesh scales the scene's unit to it. Its
axes are those of the scene: right-handed with y up.
"""

import json
import struct
from typing import BinaryIO

import numpy as np

from workbench.files.export.design import METRES, Design, Deviation
from workbench.files.export.tessellation import Tessellation, TriangleBody

_FLOAT, _UNSIGNED_INT = 5126, 5125
_VERTICES, _INDICES = 34962, 34963  # what a buffer view is for


def write_glb(design: Design, file: BinaryIO) -> Deviation:
    """Write the closed body.

    Raises
    ------
    Refused
        If the chord error is too small for single precision, or for the number of triangles.
    """
    face = Tessellation.of(design, precision=2.0**-24).rounded()
    body = face.body()
    vertices = body.vertices.astype("<f4").tobytes()
    triangles = body.triangles.astype("<u4").tobytes()
    data = json.dumps(_scene(design, body, len(vertices), len(triangles))).encode()
    data += b" " * (-len(data) % 4)
    size = 12 + 8 + len(data) + 8 + len(vertices) + len(triangles)
    file.write(struct.pack("<4sII", b"glTF", 2, size))
    file.write(struct.pack("<I4s", len(data), b"JSON") + data)
    file.write(struct.pack("<I4s", len(vertices) + len(triangles), b"BIN\0"))
    file.write(vertices + triangles)
    return Deviation("chord error", face.chord_error(design), design.unit, "lengths in m")


def _scene(design: Design, body: TriangleBody, vertices: int, triangles: int) -> dict[str, object]:
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
