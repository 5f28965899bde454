import numpy as np
import pytest
from scipy.interpolate import RectBivariateSpline

from workbench.files.export.tables import write_grid_sag

pytestmark = pytest.mark.usefixtures("small_grids")


def load(path):
    """Numbers of points, steps, unit flag; columns of shape (n_y, n_x) with row 0 at +y."""
    head, *lines = path.read_bytes().decode("ascii").split("\r\n")
    n_x, n_y, step_x, step_y, unit, x_0, y_0 = head.split()
    assert (x_0, y_0) == ("0", "0")
    assert lines[-1] == ""
    columns = np.array([line.split() for line in lines[:-1]], dtype=float).T
    n_x, n_y = int(n_x), int(n_y)
    return (n_x, n_y), (float(step_x), float(step_y)), int(unit), columns.reshape(5, n_y, n_x)


def test_rows_run_along_x_from_minus_x_plus_y(make_design, write):
    x, y = make_design().net.positions
    design = make_design(heights=0.5 + 0.1 * x[:, None] + 0.02 * y)
    path, _ = write(write_grid_sag, design, "lens.dat")
    _, (step_x, step_y), _, (sag, slope_x, slope_y, twist, _) = load(path)
    assert sag[0, 0] == pytest.approx(-0.1 + 0.02 * 0.7, abs=1e-14)
    assert sag[0, 1] - sag[0, 0] == pytest.approx(0.1 * step_x, abs=1e-14)
    assert sag[1, 0] - sag[0, 0] == pytest.approx(-0.02 * step_y, abs=1e-14)
    assert slope_x == pytest.approx(0.1, abs=1e-13)
    assert slope_y == pytest.approx(0.02, abs=1e-13)
    assert twist == pytest.approx(0.0, abs=1e-12)


def test_slopes_and_cross_derivative(make_design, write):
    path, _ = write(write_grid_sag, make_design(), "lens.dat")
    (n_x, n_y), (step_x, step_y), _, columns = load(path)
    sag, slope_x, slope_y, twist, _ = columns[:, ::-1].swapaxes(1, 2)  # x first, both ascending
    x, y = np.arange(n_x) * step_x - 1.0, np.arange(n_y) * step_y - 0.7
    spline = RectBivariateSpline(x, y, sag)
    middle = np.s_[8:-8, 8:-8]  # which the ends of scipy's spline do not reach
    for found, order in ((slope_x, (1, 0)), (slope_y, (0, 1)), (twist, (1, 1))):
        assert found[middle] == pytest.approx(spline(x, y, *order)[middle], abs=1e-4)


@pytest.mark.parametrize("degree", [(2, 2), (2, 3), (3, 3)])
def test_exact_for_degrees_2_and_3(make_design, write, degree):
    _, deviation = write(write_grid_sag, make_design({"lens.degree": degree}), "lens.dat")
    assert deviation.size < 1e-14
