"""The light of a lens by cells."""

import math
from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

from tests.analysis.lenses import followed, net_of
from workbench.analysis.cells.lattice import CellLattice
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.train import OpticalTrain

PLATE = (1 - 0.04) ** 2


def flux_of(scene, heights, cells, lifted=None, threads=None, pose=None):
    """Part of the emitted flux in each pixel."""
    train = OpticalTrain.of(scene, {"lens.back": heights}, 1, 0, pose or Pose(), [scene.receiver])
    return followed(CellLattice(scene, train, cells, lifted).tracing(threads))


def distance(image, exact):
    return float(np.linalg.norm(image - exact) / np.linalg.norm(exact))


def smooth(scene):
    """Control heights of a lens that bends light evenly, without loss."""
    return net_of(scene, lambda x, y: 0.5 - 0.1 * x**2 - 0.05 * y**2 + 0.04 * np.sin(x + 2 * y))


class TestPlate:
    def test_uniform_light_with_an_outline_within_pixels(self, make_scene):
        scene = make_scene({"screen.half_width": [1.37, 1.21], "screen.pixels": [10, 12]})
        image = flux_of(scene, np.full((12, 10), 0.5), (7, 5))
        shares = []
        for r, n in zip((1.37, 1.21), (10, 12), strict=True):
            ends = np.linspace(-r, r, n + 1).clip(-1, 1)
            shares.append(np.diff(ends) / 2)
        assert image == pytest.approx(PLATE * np.outer(shares[1], shares[0]), abs=1e-14)
        assert image.sum() == pytest.approx(PLATE, rel=1e-12)


class TestParabolicCylinder:
    """z = 0.5 − c x², whose light on a column of pixels is an integral."""

    def deflection(self, c, x):
        slope = -2 * c * x
        tilt = math.atan(slope)
        return math.tan(math.asin(1.5 * math.sin(tilt)) - tilt)

    def passed(self, c, x):
        tilt = math.atan(abs(2 * c * x))
        refracted = math.asin(1.5 * math.sin(tilt))
        return 0.96 * (0.96 - 0.96 * (1 - math.cos(refracted)) ** 5)

    def where(self, c, x):
        return x + self.deflection(c, x) * (5 - 0.5 + c * x * x)

    def test_columns(self, make_scene):
        c = 0.1
        scene = make_scene({"screen.half_width": [0.7, 1.2], "screen.pixels": [31, 4]})
        heights = net_of(scene, lambda x, y: 0.5 - c * x**2 + 0 * y)
        assert self.where(c, 1.0) > 0.3  # no fold: the map is monotonous
        ends = []
        for column in np.linspace(-0.7, 0.7, 32):
            inside = abs(column) < self.where(c, 1.0)
            ends.append(
                brentq(lambda x, to=column: self.where(c, x) - to, -1, 1)
                if inside
                else math.copysign(1.0, column)
            )
        expected = [
            quad(lambda x: self.passed(c, x) / 2, a, b, epsabs=1e-14)[0] for a, b in pairwise(ends)
        ]
        image = flux_of(scene, heights, (1024, 16)).sum(axis=0)
        assert image == pytest.approx(np.array(expected), abs=1e-6 * max(expected))

    @pytest.mark.parametrize("cells", [(16, 16), (61, 40)])
    def test_a_fold_keeps_all_light(self, make_scene, cells):
        c = 0.2
        scene = make_scene({"screen.half_width": [1.2, 1.2], "screen.pixels": [200, 200]})
        heights = net_of(scene, lambda x, y: 0.5 - c * x**2 + 0 * y)
        assert self.where(c, 0.5) > max(0.01, self.where(c, 1.0))  # light turns back in between
        x = np.linspace(-1, 1, cells[0] + 1)
        share = np.array([self.passed(c, place) for place in x])
        expected = (share[1:] + share[:-1]).sum() / 2 / cells[0]
        image = flux_of(scene, heights, cells)
        assert image.sum() == pytest.approx(expected, rel=1e-12)
        assert image.min() > -1e-15


def test_the_error_falls_with_the_square_of_the_cells_and_faster_when_lifted(make_scene):
    scene = make_scene({"screen.half_width": [0.8, 0.8], "screen.pixels": [8, 8]})
    heights = smooth(scene)
    exact = flux_of(scene, heights, (1152, 1152))
    plain, lifted = (
        [distance(flux_of(scene, heights, (n, n), (on, on)), exact) for n in (36, 72, 144)]
        for on in (False, True)
    )
    for errors, least, most in ((plain, 3.5, 4.5), (lifted, 5, 9)):
        for coarse, fine in pairwise(errors):
            assert least < coarse / fine < most
    assert lifted[2] < plain[2] / 5 < 1e-5
