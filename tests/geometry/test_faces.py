"""Faces: arrays, bodies, curvature and the largest ball that fits."""

import math
import pickle

import numpy as np
import pytest

from tests.analysis.test_manufacture import ball, lens_of
from workbench.analysis.manufacture import manufacture
from workbench.errors import Refused
from workbench.geometry.ball_cutter import GridFace, blocked_places, blocked_radius
from workbench.geometry.basis import basis_matrix, greville
from workbench.geometry.body import check_body
from workbench.geometry.curvature import local_shape
from workbench.geometry.faces import FaceArrays
from workbench.geometry.surface import ControlNet


@pytest.fixture
def plate():
    """Control heights of a plate of 0.5 over the entrance face at 0; the screen is at 5."""
    return np.full((12, 10), 0.5)


@pytest.mark.parametrize("height", [-9.8, 0.0, 1e-12, 5.0, 4000.0])
def test_a_face_that_touches_or_passes_another_is_refused(make_scene, plate, height):
    with pytest.raises(Refused, match="no body of glass") as refused:
        check_body(make_scene(), {"lens.back": np.full_like(plate, height)})
    assert f"z = {height:.5g} cm at x = " in str(refused.value)


def test_the_refusal_names_the_place(make_scene, plate):
    plate[11, 9] = -0.2  # the face passes through its corners
    with pytest.raises(Refused) as refused:
        check_body(make_scene(), {"lens.back": plate})
    assert str(refused.value) == (
        "lens: its exit face is at z = -0.2 cm at x = 1, y = 1, not above the entrance face at "
        "z = 0: that is no body of glass"
    )


def test_the_face_counts_and_not_its_control_points(make_scene, plate):
    plate[5, 5] = -0.2  # which the face does not come near
    check_body(make_scene(), {"lens.back": plate})
    plate[5, 5] = -2.0
    with pytest.raises(Refused, match="no body"):
        check_body(make_scene(), {"lens.back": plate})


HALF = (1.0, 0.8)


SIDE = np.linspace(0, 1, 31)


X, Y = np.meshgrid((2 * SIDE - 1) * HALF[0], (2 * SIDE - 1) * HALF[1], indexing="ij")


def shape_of(height, count=(40, 36), degree=(5, 4)):
    """Shape of the face that interpolates a height function."""
    net = ControlNet(count, degree, HALF)
    into_x, into_y = (
        np.linalg.inv(basis_matrix(knots, p, greville(knots, p)))
        for knots, p in zip(net.knots, degree, strict=True)
    )
    x, y = net.positions
    heights = into_x @ height(x[:, None], y[None, :]) @ into_y.T
    return local_shape(net, heights, SIDE, SIDE)


@pytest.mark.parametrize("degree", [(2, 2), (3, 3), (2, 5)])
def test_a_quadric_is_exact(degree):
    """z = a x² + b x y + c y² is in the spline space itself."""
    a, b, c = 0.3, -0.2, 0.1
    found = shape_of(lambda x, y: 0.5 + a * x**2 + b * x * y + c * y**2, (9, 8), degree)
    p, q = 2 * a * X + b * Y, b * X + 2 * c * Y
    stretch = 1 + p**2 + q**2
    mean = ((1 + q**2) * 2 * a - 2 * p * q * b + (1 + p**2) * 2 * c) / (2 * stretch**1.5)
    gaussian = (4 * a * c - b**2) / stretch**2
    np.testing.assert_allclose(found.height, 0.5 + a * X**2 + b * X * Y + c * Y**2, rtol=1e-12)
    np.testing.assert_allclose(found.slope, np.hypot(p, q), atol=1e-11)
    np.testing.assert_allclose(found.mean, mean, rtol=1e-9)
    np.testing.assert_allclose(found.gaussian, gaussian, rtol=1e-9)
    np.testing.assert_allclose(found.smallest + found.largest, 2 * mean, rtol=1e-9)
    np.testing.assert_allclose(found.smallest * found.largest, gaussian, rtol=1e-9)
    assert (found.smallest <= found.largest).all()


def test_a_cylinder_across_the_axes():
    radius, cos, sin = 3.0, np.cos(np.pi / 6), 0.5
    found = shape_of(lambda x, y: 4 - np.sqrt(radius**2 - (cos * x + sin * y) ** 2))
    np.testing.assert_allclose(found.largest, 1 / radius, rtol=1e-5)
    np.testing.assert_allclose(found.smallest, 0, atol=1e-5)
    np.testing.assert_allclose(found.gaussian, 0, atol=1e-5)
    np.testing.assert_allclose(found.mean, 0.5 / radius, rtol=1e-5)


def test_arrays_of_faces_are_read_only():
    given = np.zeros((4, 5))
    arrays = FaceArrays({"lens.back": given})
    given[0, 0] = 1
    assert arrays["lens.back"][0, 0] == 0
    with pytest.raises(ValueError, match="read-only"):
        arrays["lens.back"][0, 0] = 1
    with pytest.raises(TypeError):
        arrays["lens.back"] = given


def test_equal_are_those_of_the_same_faces_and_values():
    one = FaceArrays({"lens.back": np.zeros((4, 5)), "lens.front": np.ones((3, 3))})
    same = FaceArrays({"lens.front": np.ones((3, 3)), "lens.back": np.zeros((4, 5))})
    assert one == same and hash(one) == hash(same)
    assert one != FaceArrays({"lens.back": np.zeros((4, 5))})
    assert one != FaceArrays({**one, "lens.front": np.zeros((3, 3))})
    assert one != FaceArrays({**one, "lens.back": np.zeros((5, 4))})
    assert one != {"lens.back": np.zeros((4, 5))}
    assert not FaceArrays({})


def test_other_processes_get_the_same_arrays():
    arrays = FaceArrays({"lens.back": np.arange(20.0).reshape(4, 5)})
    again = pickle.loads(pickle.dumps(arrays))
    assert again == arrays and not again["lens.back"].flags.writeable


RADIUS = 4.0


def test_a_hollow_sphere_takes_a_cutter_of_its_own_radius(make_scene):
    found = manufacture(*lens_of(make_scene, ball(RADIUS, 0.5, 1))).tool_radius
    assert found.value == pytest.approx(RADIUS, rel=1e-3)
    assert 0.7 * RADIUS < found.bound <= found.value


@pytest.mark.parametrize("height", [ball(RADIUS, 0.5, -1), lambda x, y: 0.5 + 0.1 * x + 0 * y])
def test_any_cutter_fits_on_humps_and_planes(make_scene, height):
    assert manufacture(*lens_of(make_scene, height)).tool_radius.value == math.inf


def test_each_face_is_seen_from_outside(make_scene):
    """The same height function is a hollow of the exit face and a hump of the entrance face."""
    hollow, hump = ball(RADIUS, 0.5, 1), ball(RADIUS, 0.1, 1)
    found = manufacture(*lens_of(make_scene, hollow, entrance=hump))
    assert found.tool_radius.value == pytest.approx(RADIUS, rel=1e-3)
    assert found.entrance.tool_radius.value == math.inf


def lowered(x, z, radius):
    """How much a ball leaves that is lowered onto a profile everywhere: no slopes are used."""
    apart = x[:, None] - x
    cap = np.where(np.abs(apart) <= radius, np.sqrt((radius**2 - apart**2).clip(0)), -np.inf)
    middle = (z + cap).max(axis=1)
    return ((middle[:, None] - cap).min(axis=0) - z).max()


def test_tool_radius_is_that_of_the_largest_ball_that_fits_into_a_groove(make_scene):
    """A groove with steep sides."""
    lens, heights = lens_of(make_scene, lambda x, y: 0.5 - 0.3 * np.exp(-((x / 0.3) ** 2)) + 0 * y)
    found = manufacture(lens, heights).tool_radius
    x = np.linspace(-1, 1, 2001)
    z = 0.5 - 0.3 * np.exp(-((x / 0.3) ** 2))
    assert lowered(x, z, 0.9 * found.value) < 3e-5
    assert lowered(x, z, 1.2 * found.value) > 3e-4
    assert found.place[0] == pytest.approx(0, abs=0.01)


def profile(z, slope, x, rows=3):
    """A profile as a face that is the same along y."""
    y = np.linspace(0, 0.1, rows)
    fields = (np.broadcast_to(each[:, None], (len(x), rows)) for each in (z, slope, 0 * x))
    return GridFace(x, y, *fields)


def test_a_wall_far_away_is_in_the_way_of_a_large_ball():
    """Ground and wall are flat: by curvature any ball would fit. Beside the wall there is none."""
    x = np.linspace(0, 2, 101)
    wall = x > 1
    face = profile(np.where(wall, 3 * (x - 1), 0.0), np.where(wall, 3.0, 0.0), x)
    radius, _ = blocked_radius(face, 100.0)
    # The ground's last place and the wall's first are the tightest pair: a step apart, three high.
    assert radius == pytest.approx((1 + 3**2) * x[1] / (2 * 3))
    assert blocked_radius(face, 1e-3) is None


def test_a_ball_is_blocked_on_the_ground_near_a_wall_and_nowhere_else():
    """Beside a wall at 45° a ball of radius R touches the ground from R tan(22.5°) on."""
    x = np.linspace(0, 2, 201)
    wall = x > 1
    face = profile(np.where(wall, x - 1, 0.0), np.where(wall, 1.0, 0.0), x, rows=33)
    radius = 0.8
    blocked = blocked_places(face, radius)[:, 0]
    foot = 1 - radius * np.tan(np.pi / 8)
    assert blocked[(x > foot + 0.05) & ~wall].all()
    assert not blocked[x < foot - 0.05].any()
