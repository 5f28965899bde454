"""Figures of manufacture: thickness, slope, sag and curvature of one and of two faces."""

import math

import numpy as np
import pytest
from scipy.interpolate import make_interp_spline

from workbench.analysis.manufacture import (
    Limits,
    exceeded,
    exceeding_points,
    manufacture,
    surface_maps,
)
from workbench.geometry.surface import ControlNet, freeform_nets, sample_faces

HALF_WIDTH = (1.0, 0.8)
RIM = math.hypot(*HALF_WIDTH)


def lens_of(make_scene, exit_face, entrance=None, degree=(3, 3), outline="rectangle"):
    """A lens of faces with given heights z(x, y), by nets of different sizes and degrees."""
    changes = {"version": 2, "lens.half_width": HALF_WIDTH, "lens.control_points": [40, 36]}
    changes |= {"lens.degree": degree, "lens.outline": outline}
    if entrance:
        freeform = {"shape": "freeform", "control_points": [31, 44], "degree": [4, 3]}
        changes["lens.entrance"] = freeform
    lens = make_scene(changes).optic
    shapes, heights = {"lens.front": entrance, "lens.back": exit_face}, {}
    for face, net in freeform_nets(lens).items():
        (x, y), (p, q) = net.positions, net.degree
        knots = [(2 * k - 1) * r for k, r in zip(net.knots, net.half_width, strict=True)]
        values = make_interp_spline(x, shapes[face](x[:, None], y), p, t=knots[0], axis=0).c
        heights[face] = make_interp_spline(y, values.T, q, t=knots[1], axis=0).c.T
    return lens, heights


def ball(radius, pole, sign):
    """A sphere with a pole on the axis; sign +1 bends towards +z: an exit face is hollow."""
    return lambda x, y: pole + sign * (radius - np.sqrt(radius**2 - x**2 - y**2))


def depth_of(radius):
    return radius - math.sqrt(radius**2 - RIM**2)


def test_closed_forms_of_a_hollow_sphere(make_scene):
    found = manufacture(*lens_of(make_scene, ball(4.0, 0.5, 1)))
    assert found.thinnest.value == pytest.approx(0.5, abs=1e-7)
    assert found.thickest.value == pytest.approx(0.5 + depth_of(4.0), abs=1e-7)
    assert found.sag_range == pytest.approx(depth_of(4.0), abs=1e-7)
    angle = math.degrees(math.asin(RIM / 4.0))
    assert found.steepest.value == pytest.approx(angle, abs=1e-4)
    assert found.draft == pytest.approx(90 - angle, abs=1e-4)
    assert found.tightest_concave.value == pytest.approx(4.0, rel=1e-3)
    assert found.tightest_convex.value == math.inf


def test_a_biconvex_lens_has_humps_on_both_faces_and_no_hollows(make_scene):
    found = manufacture(*lens_of(make_scene, ball(5.0, 1.5, -1), ball(3.0, 0.0, 1)))
    depths = [depth_of(radius) for radius in (3.0, 5.0)]
    assert found.thickest.value == pytest.approx(1.5, abs=1e-4)
    assert found.thinnest.value == pytest.approx(1.5 - sum(depths), abs=1e-6)
    for face, radius, depth in zip((found.entrance, found), (3.0, 5.0), depths, strict=True):
        assert face.tightest_convex.value == pytest.approx(radius, rel=2e-3)
        assert face.tightest_concave.value == math.inf
        assert face.sag_range == pytest.approx(depth, abs=1e-4)
        angle = math.degrees(math.asin(RIM / radius))
        assert face.steepest.value == pytest.approx(angle, abs=1e-3)
        assert face.draft == pytest.approx(90 - angle, abs=1e-3)


@pytest.mark.usefixtures("few_parts")
def test_the_thickness_between_parallel_faces_is_bounded_by_their_distance(make_scene):
    """Bounds of each face by itself would allow all of their sag."""

    def wave(z):
        return lambda x, y: z + 0.2 * x**2 - 0.1 * x * y + 0.05 * y**2

    found = manufacture(*lens_of(make_scene, wave(0.3), wave(0.0)))
    for extreme in (found.thinnest, found.thickest):
        assert extreme.value == pytest.approx(0.3, abs=1e-12)
        assert extreme.bound == pytest.approx(0.3, abs=1e-12)
    assert found.sag_range > 0.2


@pytest.fixture
def few_parts(monkeypatch):
    monkeypatch.setattr("workbench.analysis.manufacture._PARTS", 64)


def assert_within_the_bounds(lens, heights, found):
    """No value on a grid is beyond the bounds; gives the maps of the faces."""
    maps = {face: surface_maps(lens, heights, (209, 167), face) for face in heights}
    thickness = maps["lens.back"].thickness
    assert found.thinnest.bound <= np.nanmin(thickness) + 1e-12
    assert found.thickest.bound >= np.nanmax(thickness) - 1e-12
    for face in heights:
        each = found if face == "lens.back" else found.entrance
        assert each.steepest.bound >= np.nanmax(maps[face].slope) - 1e-9
        for extreme, curvature in (
            (each.tightest_concave, maps[face].concave),
            (each.tightest_convex, maps[face].convex),
        ):
            assert extreme.bound * np.nanmax(curvature) <= 1 + 1e-9
    return maps


@pytest.mark.usefixtures("few_parts")
@pytest.mark.parametrize("degree", [(2, 3), (5, 4)])
def test_nothing_is_beyond_the_bounds(make_scene, rng, degree):
    changes = {"lens.control_points": [9, 8], "lens.degree": list(degree)}
    lens = make_scene(changes).optic
    heights = {"lens.back": 0.5 + 0.1 * rng.random((9, 8))}
    found = manufacture(lens, heights)
    (maps,) = assert_within_the_bounds(lens, heights, found).values()
    assert found.tightest_convex.value == pytest.approx(1 / maps.convex.max(), rel=1e-2)
    # Within its places, the extreme is where it is stated to be.
    u = (np.array(found.thickest.place) / lens.half_width + 1) / 2
    there = ControlNet.of(lens).points(u[:1], u[1:]).evaluate(heights["lens.back"])[0]
    assert there.item() == pytest.approx(found.thickest.value)


@pytest.mark.usefixtures("few_parts")
@pytest.mark.parametrize(
    ("outline", "degree"), [("rectangle", (1, 2)), ("rectangle", (3, 3)), ("ellipse", (5, 4))]
)
def test_nothing_between_two_faces_is_beyond_the_bounds(make_scene, rng, outline, degree):
    lens, heights = lens_of(make_scene, ball(5.0, 1.5, -1), ball(3.0, 0.0, 1), degree, outline)
    heights = {face: z + 0.02 * rng.normal(size=z.shape) for face, z in heights.items()}
    found = manufacture(lens, heights)
    assert_within_the_bounds(lens, heights, found)
    assert found.thinnest.value - found.thinnest.bound < (0.02 if "ellipse" in outline else 2e-3)


@pytest.mark.usefixtures("few_parts")
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


@pytest.mark.parametrize("outline", ["rectangle", "ellipse"])
def test_limits_are_exceeded_where_the_bowl_is_steep_deep_or_tight(make_scene, outline):
    """A bowl of radius 2: slopes of 0.3 begin at r = 0.575, 1.3 ball cutters fit everywhere."""
    lens, heights = lens_of(
        make_scene, lambda x, y: 2.6 - np.sqrt(4 - x**2 - y**2), outline=outline
    )
    surfaces = sample_faces(lens, heights, (101, 81))
    x, y, _ = np.moveaxis(surfaces["lens.back"], -1, 0)

    def beyond(**limits):
        return exceeding_points(lens, surfaces, heights, Limits(**limits))["lens.back"]

    limit = math.degrees(math.atan(0.3))
    off = np.hypot(x, y) - 0.3 / math.sqrt(1 + 0.3**2) * 2
    clear = (abs(off) > 0.03) & (outline == "rectangle" or np.hypot(x, y / 0.8) < 0.98)
    np.testing.assert_array_equal(beyond(max_slope=limit)[clear], (off > 0)[clear])
    assert not beyond().any() and not beyond(min_tool_radius=1.3).any()
    assert beyond(min_tool_radius=2.2)[clear].all() and beyond(min_radius=2.2)[clear].all()
    maps = surface_maps(lens, heights, (101, 81))
    thin = exceeded(maps, Limits(min_thickness=0.7))["thickness"]
    np.testing.assert_array_equal(thin, maps.thickness < 0.7)
