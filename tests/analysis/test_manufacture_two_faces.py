"""Figures of manufacture of lenses of two freeform faces."""

import math

import numpy as np
import pytest
from scipy.interpolate import make_interp_spline

from workbench.analysis.manufacture import manufacture, surface_maps
from workbench.geometry.surface import freeform_nets

HALF_WIDTH = (1.0, 0.8)


@pytest.fixture
def lens_of(make_scene):
    """A lens of faces with given heights z(x, y), by nets of different sizes and degrees."""

    def make(entrance, exit_face, degree=(3, 3), outline="rectangle"):
        freeform = {"shape": "freeform", "control_points": [31, 44], "degree": [4, 3]}
        lens = make_scene(
            {
                "version": 2,
                "lens.half_width": HALF_WIDTH,
                "lens.control_points": [40, 36],
                "lens.degree": degree,
                "lens.outline": outline,
                "lens.entrance": freeform,
            }
        ).optic
        heights = {}
        for (face, net), z in zip(freeform_nets(lens).items(), (entrance, exit_face), strict=True):
            (x, y), (p, q) = net.positions, net.degree
            knots = [(2 * k - 1) * r for k, r in zip(net.knots, net.half_width, strict=True)]
            values = make_interp_spline(x, z(x[:, None], y), p, t=knots[0], axis=0).c
            heights[face] = make_interp_spline(y, values.T, q, t=knots[1], axis=0).c.T
        return lens, heights

    return make


def ball(radius, pole, sign):
    """A sphere with a pole on the axis; sign +1 bends towards +z."""
    return lambda x, y: pole + sign * (radius - np.sqrt(radius**2 - x**2 - y**2))


def test_a_biconvex_lens_has_humps_on_both_faces_and_no_hollows(lens_of):
    lens, heights = lens_of(ball(3.0, 0.0, 1), ball(5.0, 1.5, -1))
    found = manufacture(lens, heights)
    rim = math.hypot(*HALF_WIDTH)
    depths = [radius - math.sqrt(radius**2 - rim**2) for radius in (3.0, 5.0)]
    assert found.thickest.value == pytest.approx(1.5, abs=1e-4)
    assert found.thinnest.value == pytest.approx(1.5 - sum(depths), abs=1e-6)
    for face, radius, depth in zip((found.entrance, found), (3.0, 5.0), depths, strict=True):
        assert face.tightest_convex.value == pytest.approx(radius, rel=2e-3)
        assert face.tightest_concave.value == math.inf
        assert face.sag_range == pytest.approx(depth, abs=1e-4)
        angle = math.degrees(math.asin(rim / radius))
        assert face.steepest.value == pytest.approx(angle, abs=1e-3)
        assert face.draft == pytest.approx(90 - angle, abs=1e-3)


def test_the_thickness_between_parallel_faces_is_bounded_by_their_distance(lens_of):
    """Bounds of each face by itself would allow all of their sag."""

    def wave(z):
        return lambda x, y: z + 0.2 * x**2 - 0.1 * x * y + 0.05 * y**2

    found = manufacture(*lens_of(wave(0.0), wave(0.3)))
    for extreme in (found.thinnest, found.thickest):
        assert extreme.value == pytest.approx(0.3, abs=1e-12)
        assert extreme.bound == pytest.approx(0.3, abs=1e-12)
    assert found.sag_range > 0.2


@pytest.mark.parametrize("degree", [(1, 2), (3, 3), (5, 4)])
@pytest.mark.parametrize("outline", ["rectangle", "ellipse"])
def test_nothing_is_beyond_the_bounds(lens_of, rng, degree, outline):
    lens, heights = lens_of(ball(3.0, 0.0, 1), ball(5.0, 1.5, -1), degree, outline)
    heights = {face: z + 0.02 * rng.normal(size=z.shape) for face, z in heights.items()}
    found = manufacture(lens, heights)
    maps = {face: surface_maps(lens, heights, (409, 367), face) for face in heights}
    thickness = maps["lens.back"].thickness
    assert found.thinnest.bound <= np.nanmin(thickness) + 1e-12
    assert found.thickest.bound >= np.nanmax(thickness) - 1e-12
    assert found.thinnest.value - found.thinnest.bound < (0.02 if "ellipse" in outline else 2e-3)
    for face, each in (("lens.back", found), ("lens.front", found.entrance)):
        assert each.steepest.bound >= np.nanmax(maps[face].slope) - 1e-9
        for extreme, curvature in (
            (each.tightest_concave, maps[face].concave),
            (each.tightest_convex, maps[face].convex),
        ):
            assert extreme.bound * np.nanmax(curvature) <= 1 + 1e-9
