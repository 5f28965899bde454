import math

import numpy as np
import pytest
from scipy.interpolate import make_interp_spline

from workbench.analysis.manufacture import manufacture, surface_maps
from workbench.geometry.surface import ControlNet


def lens_of(make_scene, height, changes=None):
    """A lens and the control heights that interpolate a height function."""
    changes = {"lens.control_points": [40, 36], "lens.half_width": [1.0, 0.8]} | (changes or {})
    lens = make_scene(changes).optic
    net = ControlNet.of(lens)
    (x, y), (p, q) = net.positions, net.degree
    knots = [(2 * k - 1) * r for k, r in zip(net.knots, net.half_width, strict=True)]
    values = make_interp_spline(x, height(x[:, None], y), p, t=knots[0], axis=0).c
    return lens, {"lens.back": make_interp_spline(y, values.T, q, t=knots[1], axis=0).c.T}


def ball(radius, sign):
    """A sphere of which (0, 0, 0.5) is a pole; sign +1 is hollow."""
    return lambda x, y: 0.5 + sign * (radius - np.sqrt(radius**2 - x**2 - y**2))


class TestSpheres:
    RIM = math.hypot(1.0, 0.8)

    @pytest.mark.parametrize("sign", [1, -1])
    def test_closed_forms(self, make_scene, sign):
        radius = 4.0
        found = manufacture(*lens_of(make_scene, ball(radius, sign)))
        depth = radius - math.sqrt(radius**2 - self.RIM**2)
        ends = sorted([0.5, 0.5 + sign * depth])
        assert found.thinnest.value == pytest.approx(ends[0], abs=1e-7)
        assert found.thickest.value == pytest.approx(ends[1], abs=1e-7)
        assert found.sag_range == pytest.approx(depth, abs=1e-7)
        angle = math.degrees(math.asin(self.RIM / radius))
        assert found.steepest.value == pytest.approx(angle, abs=1e-4)
        assert found.draft == pytest.approx(90 - angle, abs=1e-4)
        tightest, other = found.tightest_concave, found.tightest_convex
        if sign < 0:
            tightest, other = other, tightest
        assert tightest.value == pytest.approx(radius, rel=1e-3)
        assert other.value == math.inf


@pytest.mark.parametrize("degree", [(2, 3), (3, 3), (5, 4)])
def test_nothing_is_beyond_the_bounds(make_scene, rng, degree):
    changes = {"lens.control_points": [9, 8], "lens.degree": list(degree)}
    lens = make_scene(changes).optic
    heights = {"lens.back": 0.5 + 0.1 * rng.random((9, 8))}
    found = manufacture(lens, heights)
    maps = surface_maps(lens, heights, (617, 587))
    slack = 1e-12
    assert found.thinnest.bound <= maps.thickness.min() + slack
    assert found.thickest.bound >= maps.thickness.max() - slack
    assert found.steepest.bound >= maps.slope.max() - 1e-9
    assert 1 / found.tightest_concave.bound >= maps.concave.max() - 1e-9
    assert 1 / found.tightest_convex.bound >= maps.convex.max() - 1e-9
    assert found.tightest_convex.value == pytest.approx(1 / maps.convex.max(), rel=1e-3)
    # Within its places, the extreme is where it is stated to be.
    u = (np.array(found.thickest.place) / lens.half_width + 1) / 2
    there = ControlNet.of(lens).points(u[:1], u[1:]).evaluate(heights["lens.back"])[0]
    assert there.item() == pytest.approx(found.thickest.value)


def test_an_elliptic_lens_is_judged_inside_its_outline_alone(make_scene):
    """Wild heights at a corner of the bounding rectangle are not of the lens."""
    flat = make_scene({"lens.control_points": [32, 32]}).optic
    heights = np.full((32, 32), 0.5)
    heights[:4, :4] = 3.0
    heights[-3:, -3:] = -2.0
    assert manufacture(flat, {"lens.back": heights}).thickest.value > 2
    found = manufacture(flat.model_copy(update={"outline": "ellipse"}), {"lens.back": heights})
    for extreme in (found.thinnest, found.thickest):
        assert extreme.value == pytest.approx(0.5)
        assert extreme.bound == pytest.approx(0.5)
    assert found.steepest.bound == pytest.approx(0)
    assert found.tightest_concave.bound == found.tightest_convex.bound == math.inf
