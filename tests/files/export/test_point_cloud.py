import numpy as np
import pytest
from scipy.interpolate import RectBivariateSpline

from workbench.files.export.tables import write_points

pytestmark = pytest.mark.usefixtures("small_grids")


def load(path):
    points = np.loadtxt(path)
    x, y = np.unique(points[:, 0]), np.unique(points[:, 1])
    return x, y, points.reshape(len(x), len(y), 6)


def test_points_lie_on_the_face_and_go_on_beyond_its_edge(make_design, write):
    design = make_design()
    path, deviation = write(write_points, design, "lens.xyz")
    assert deviation.unit == "cm"
    assert deviation.size < 1e-9
    assert path.read_text().startswith("# freeform lens: x y z nx ny nz, unit cm\n")
    x, y, points = load(path)
    for places, r in ((x, 1.0), (y, 0.7)):
        step = places[1] - places[0]
        assert np.diff(places) == pytest.approx(step)
        assert places[3] == pytest.approx(-r, abs=1e-14)
        assert places[-4] == pytest.approx(r, abs=1e-14)
    inside = points[3:-3, 3:-3]
    assert inside[..., 2] == pytest.approx(design.surface(x[3:-3], y[3:-3])[0], abs=1e-13)


def test_normals(make_design, write):
    design = make_design()
    path, _ = write(write_points, design, "lens.xyz")
    x, y, points = load(path)
    normal = points[..., 3:]
    assert np.linalg.norm(normal, axis=2) == pytest.approx(1, abs=1e-13)
    assert (normal[..., 2] > 0).all()
    spline = RectBivariateSpline(x, y, points[..., 2])
    for axis, order in enumerate([(1, 0), (0, 1)]):
        slope = spline(x, y, *order)
        # Beyond the edge and all: smooth enough for a spline that knows of no edge there.
        assert -normal[..., axis] / normal[..., 2] == pytest.approx(slope, abs=1e-6)
