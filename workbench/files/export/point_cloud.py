"""Point cloud of the exit face with its normals, one line x y z nx ny nz per point.

Programs that lay a surface through points guess at its edges. So each point has its normal, and
the points go on beyond the edge, on the polynomials that end there.
"""

from typing import BinaryIO

import numpy as np
from scipy.interpolate import RectBivariateSpline

from workbench.files.export.design import Design, Deviation
from workbench.files.export.tables import write_table

_MARGIN = 3  # steps beyond the edge, enough for a bicubic spline to forget its end


def write_points(design: Design, file: BinaryIO) -> Deviation:
    """Write points and normals, and measure a bicubic spline through the points."""
    x, y = design.lattice(_MARGIN)
    z, slope_x, slope_y = design.surface(x, y)
    length = np.sqrt(1 + slope_x**2 + slope_y**2)
    columns = np.broadcast_arrays(
        x[:, None], y, z, -slope_x / length, -slope_y / length, 1 / length
    )
    written = write_table(
        file,
        [column.ravel() for column in columns],
        f"# freeform lens: x y z nx ny nz, unit {design.unit}",
        delimiter=" ",
    )
    spline = RectBivariateSpline(x, y, written[:, 2].reshape(z.shape))
    between_x, between_y = (
        (c[_MARGIN : -_MARGIN - 1] + c[_MARGIN + 1 : -_MARGIN]) / 2 for c in (x, y)
    )
    exact = design.surface(between_x, between_y)[0]
    error = float(np.abs(spline(between_x, between_y) - exact).max())
    return Deviation(
        "error of a bicubic spline through the points",
        error,
        design.unit,
        f"lengths in {design.unit}",
    )
