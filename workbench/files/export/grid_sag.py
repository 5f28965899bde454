"""Grid Sag file of OpticStudio (.dat): sag, slopes and cross derivative on a grid.

Knots of the B-spline are points of the grid. For degrees 2 and 3 the bicubic interpolation between
these is therefore the B-spline itself, rim included. A face of degree 1 has edges, which only a
linear interpolation keeps. Sag is height over that at the vertex x = y = 0, so the thickness of the
lens in OpticStudio is the one at its vertex. A freeform entrance face is a surface of its own, with
a file of its own. Points of which no neighbouring cell holds any of an elliptic lens are flagged as
without data.
"""

from typing import BinaryIO

import numpy as np
from scipy.interpolate import CubicHermiteSpline

from workbench.arrays import Array
from workbench.files.export.design import Design, Deviation
from workbench.files.export.tables import write_table

_UNIT_FLAG = {"mm": 0, "cm": 1, "inch": 2, "m": 3}


def write_grid_sag(design: Design, file: BinaryIO) -> Deviation:
    """Write the grid, and measure the bicubic interpolation between its points.

    The first line tells the numbers of points, their distances, the unit and the decentre; then
    come the points in rows along x, from (−x, +y) on.
    """
    x, y = design.lattice()
    basis = design.basis(x, y)
    z, slope_x, slope_y = basis.evaluate(design.heights)
    twist = basis.slope_x @ design.heights @ basis.slope_y
    vertex = design.surface(np.zeros(1), np.zeros(1))[0].item()
    no_data = _without_data(design, x, y)
    columns = [_in_rows(c) for c in (z - vertex, slope_x, slope_y, twist, no_data)]
    step_x, step_y = (float(c[-1] - c[0]) / (len(c) - 1) for c in (x, y))
    header = f"{len(x)} {len(y)} {step_x!r} {step_y!r} {_UNIT_FLAG[design.unit]} 0 0"
    written = write_table(file, columns, header, delimiter=" ", newline="\r\n")

    sag, along_x, along_y, cross = written.T[:4].reshape(4, len(y), len(x))[:, ::-1]
    between_x, between_y = ((c[1:] + c[:-1]) / 2 for c in (x, y))
    values = CubicHermiteSpline(x, sag, along_x, axis=1)(between_x)
    slopes = CubicHermiteSpline(x, along_y, cross, axis=1)(between_x)
    found = CubicHermiteSpline(y, values, slopes)(between_y)
    exact = design.surface(between_x, between_y)[0].T - vertex
    error = float(np.abs(found - exact).max())
    return Deviation(
        "error of the bicubic interpolation",
        error,
        design.unit,
        f"thickness at the vertex {_thickness(design):.10g} {design.unit}",
    )


def _thickness(design: Design) -> float:
    """That of the lens at its vertex."""
    z, *other = (face.surface(np.zeros(1), np.zeros(1))[0].item() for face in design.faces)
    return abs(z - (other[0] if other else design.flat_z))


def _without_data(design: Design, x: Array, y: Array) -> Array:
    """1 for points of which no neighbouring cell has a share of the lens, else 0."""
    glass = design.outline.area_inside((x[:-1, None], x[1:, None]), (y[:-1], y[1:])) > 0
    around = np.pad(glass, 1)
    near = around[1:, 1:] | around[:-1, 1:] | around[1:, :-1] | around[:-1, :-1]
    return np.where(near, 0.0, 1.0)


def _in_rows(values: Array) -> Array:
    """Values of shape (m_x, m_y) one after the other, along x first, from the largest y down."""
    return values[:, ::-1].T.ravel()
