"""What others make of the files: the face fitted anew and traced anew, edges included."""

import numpy as np
import pytest
from scipy.interpolate import RectBivariateSpline, make_interp_spline

from workbench.analysis.metrics import relative_l2
from workbench.analysis.validation import validate
from workbench.design.run import run
from workbench.design.snapshot import History
from workbench.files.export.design import Design
from workbench.files.export.tables import write_grid_sag, write_points
from workbench.geometry.surface import ControlNet
from workbench.targets import load_target

RAYS = 400_000


@pytest.fixture
def design(make_scene, tmp_path):
    """A top hat after a short run, and its target."""
    scene = make_scene(
        {"lens.half_width": [1.0, 0.8], "lens.control_points": [20, 18], "run.iterations": 25}
    )
    target = load_target(scene, tmp_path)
    history = History()
    for snapshot in run(scene, target):
        history.add(snapshot)
    return Design(scene, history.result()), target


def fitted(scene, spline, shape):
    """A lens of another net through a spline, and its control heights."""
    lens = scene.optic.shaped(control_points=shape)
    net = ControlNet.of(lens)
    (x, y), (p, q) = net.positions, net.degree
    knots = [(2 * k - 1) * r for k, r in zip(net.knots, net.half_width, strict=True)]
    heights = make_interp_spline(x, spline(x, y), p, t=knots[0], axis=0).c
    heights = make_interp_spline(y, heights.T, q, t=knots[1], axis=0).c.T
    return scene.with_optic(lens), heights


def check(design, target, spline, shape):
    scene, heights = fitted(design.scene, spline, shape)
    before = validate(design.scene, target, {"lens.back": design.heights}, RAYS)
    after = validate(scene, target, {"lens.back": heights}, RAYS)
    # The run has found a lens: it is not the flat one that is compared.
    assert before.relative_l2 < 0.5
    for name in ("relative_l2", "relative_l2_corrected"):
        assert getattr(after, name) == pytest.approx(getattr(before, name), rel=0.01)
    # Light of the edges lands where it did, not only as well as it did.
    assert relative_l2(after.irradiance, before.irradiance) < 0.01
    r_x, r_y = design.net.half_width
    rim_x, rim_y = np.linspace(-r_x, r_x, 301), np.linspace(-r_y, r_y, 301)
    for x, y in ((rim_x, [-r_y, r_y]), ([-r_x, r_x], rim_y)):
        _, *slopes = design.surface(np.asarray(x), np.asarray(y))
        for order, slope in zip([(1, 0), (0, 1)], slopes, strict=True):
            assert spline(x, y, *order) == pytest.approx(slope, abs=1e-4)


def refit(design, target, write, shape):
    path, _ = write(write_points, design, "lens.xyz")
    points = np.loadtxt(path)
    x, y = np.unique(points[:, 0]), np.unique(points[:, 1])
    spline = RectBivariateSpline(x, y, points[:, 2].reshape(len(x), len(y)))
    check(design, target, spline, shape)

    path, _ = write(write_grid_sag, design, "lens.dat")
    n_x, n_y, step_x, step_y = np.loadtxt(path, max_rows=1)[:4]
    sag = np.loadtxt(path, skiprows=1)[:, 0].reshape(int(n_y), int(n_x))[::-1].T
    x, y = ((np.arange(n) - (n - 1) / 2) * step for n, step in ((n_x, step_x), (n_y, step_y)))
    thickness = design.surface(np.zeros(1), np.zeros(1))[0]
    check(design, target, RectBivariateSpline(x, y, sag + thickness), shape)


def test_splines_fitted_to_the_files_give_the_same_image(design, write):
    refit(*design, write, shape=(71, 65))  # knots elsewhere
