"""Ray file: where the rays of the source cross the screen's plane, in which direction.

Rays to a far field, which has no plane, are written where they are some way behind the lens.
"""

from typing import BinaryIO

from workbench.files.export.design import Design, Deviation
from workbench.files.export.leaving import traced
from workbench.files.export.tables import rounding, write_table


def write_rays(design: Design, file: BinaryIO) -> Deviation:
    """Trace the scene's rays in float64 and write a line for each that gets to the receiver.

    Position and direction cosines there, and flux; that of all lines is the flux on the screen
    and beside it.
    """
    path, arrival = traced(design)
    arrives = (arrival.rays.flux > 0) & arrival.column.isfinite() & arrival.row.isfinite()
    ends = path.ends(arrival.rays)
    x, y, z, flux, *direction = (
        part.expand(arrives.shape)[arrives].numpy()
        for part in (*ends, arrival.rays.flux, *arrival.rays.direction)
    )
    unit = design.unit
    header = f"x [{unit}],y [{unit}],z [{unit}],cos x,cos y,cos z,flux"
    written = write_table(file, [x, y, z, *direction, flux], header, delimiter=",")
    return Deviation("rounding", max(rounding(written, 0, x), rounding(written, 1, y)), unit)
