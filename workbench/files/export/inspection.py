"""Inspection points of a freeform face, for a coordinate measuring machine."""

from typing import BinaryIO, NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.files.export.design import Design, Deviation
from workbench.files.export.options import Drawing
from workbench.files.export.tables import rounding, write_table

_WITHIN = 0.9  # of the square that is mapped onto the outline


class Inspection(NamedTuple):
    """Points of a face: number by number along y, then along x; scene units."""

    place: Array  # (m, 3): x and y from the axis of the part, z from the other side at the axis
    normal: Array  # (m, 3): unit normals that point out of the part

    @classmethod
    def of(cls, design: Design) -> "Inspection":
        """Return the points of a design's face."""
        count = design.chosen(Drawing).inspection_points
        line = np.linspace(-_WITHIN, _WITHIN, count)
        x, y, z, p, q = design.net.over(design.outline, line, line, design.heights)
        length = design.outward * np.sqrt(1 + p**2 + q**2)
        place = np.stack([x, y, z - other_side(design)], axis=-1)
        normal = np.stack([-p / length, -q / length, 1 / length], axis=-1)
        return cls(place.reshape(-1, 3), normal.reshape(-1, 3))


def other_side(design: Design) -> float:
    """Return z of the other side of the part at its axis."""
    others = [face for face in design.faces if face.face != design.face]
    if not others:
        return design.flat_z
    return float(others[0].surface(np.zeros(1), np.zeros(1))[0].item())


def write_inspection(design: Design, file: BinaryIO) -> Deviation:
    """Write the points as a table with their normals, in mm."""
    mm, points = 1e3 * design.metres, Inspection.of(design)
    place = mm * points.place
    header = (
        "# inspection points of the freeform face: x and y from the axis of the part, z from its "
        "other side at the axis; normals point out of the part\n"
        "number,x [mm],y [mm],z [mm],nx,ny,nz"
    )
    columns = np.arange(1.0, len(place) + 1), *np.round(place, 6).T, *points.normal.T
    written = write_table(file, columns, header, ",")
    off = max(rounding(written, axis + 1, place[:, axis]) for axis in range(3))
    note = f"{len(place)} points, lengths in mm"
    return Deviation("rounding", off / mm, design.unit, note)
