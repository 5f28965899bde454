"""Point cloud of a freeform face with its normals, one line x y z nx ny nz per point.

Programs that lay a surface through points guess at its edges. So each point has its normal, out
of the body, and the points go on beyond the edge, on the polynomials that end there. So do those of
an elliptic lens, by as many steps.
"""

from typing import BinaryIO

import numpy as np
from scipy.interpolate import RectBivariateSpline

from workbench.arrays import Array, Mask
from workbench.files.export.design import Design, Deviation
from workbench.files.export.tables import write_table

_MARGIN = 3  # steps beyond the edge, enough for a bicubic spline to forget its end


def _near(design: Design, x: Array, y: Array) -> Mask:
    """Which points are on the lens or a margin beside it."""
    if design.outline.whole:
        return np.ones((len(x), len(y)), dtype=np.bool_)
    x, y = (
        at * (r / (r + _MARGIN * float(at[1] - at[0])))
        for at, r in zip((x, y), design.net.half_width, strict=True)
    )
    return design.outline.contains(x[:, None], y)


def write_points(design: Design, file: BinaryIO) -> Deviation:
    """Write points and normals, and measure a bicubic spline through the points."""
    x, y = design.lattice(_MARGIN)
    z, slope_x, slope_y = design.surface(x, y)
    length = np.sqrt(1 + slope_x**2 + slope_y**2)
    length *= design.outward
    columns = np.broadcast_arrays(
        x[:, None], y, z, -slope_x / length, -slope_y / length, 1 / length
    )
    near = _near(design, x, y)
    written = write_table(
        file,
        [column[near] for column in columns],
        f"# freeform lens: x y z nx ny nz, unit {design.unit}",
        delimiter=" ",
    )
    z[near] = written[:, 2]
    spline = RectBivariateSpline(x, y, z)
    between_x, between_y = (
        (c[_MARGIN : -_MARGIN - 1] + c[_MARGIN + 1 : -_MARGIN]) / 2 for c in (x, y)
    )
    exact = design.surface(between_x, between_y)[0]
    inside = design.outline.contains(between_x[:, None], between_y)
    error = float(np.abs(spline(between_x, between_y) - exact)[inside].max())
    return Deviation(
        "error of a bicubic spline through the points",
        error,
        design.unit,
        f"lengths in {design.unit}",
    )
