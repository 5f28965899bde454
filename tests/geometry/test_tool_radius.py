import math

import numpy as np
import pytest

from tests.analysis.test_manufacture import ball, lens_of
from workbench.analysis.manufacture import manufacture
from workbench.geometry.ball_cutter import GridFace, blocked_radius

RADIUS = 4.0


def test_a_hollow_sphere_takes_a_cutter_of_its_own_radius(make_scene):
    found = manufacture(*lens_of(make_scene, ball(RADIUS, 1))).tool_radius
    assert found.value == pytest.approx(RADIUS, rel=1e-3)
    assert 0.7 * RADIUS < found.bound <= found.value


@pytest.mark.parametrize("height", [ball(RADIUS, -1), lambda x, y: 0.5 + 0.1 * x + 0 * y])
def test_any_cutter_fits_on_humps_and_planes(make_scene, height):
    assert manufacture(*lens_of(make_scene, height)).tool_radius.value == math.inf


def test_each_face_is_seen_from_outside(make_scene):
    """The same height function is a hollow of the exit face and a hump of the entrance face."""
    changes = {"version": 2, "lens.entrance": {"shape": "freeform", "control_points": [40, 36]}}
    lens, heights = lens_of(make_scene, ball(RADIUS, 1), changes)
    found = manufacture(lens, heights | {"entrance": heights["exit"] - 0.4})
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


def profile(z, slope, x):
    """A profile as a face that is the same along y."""
    y = np.linspace(0, 0.1, 3)
    fields = (np.broadcast_to(each[:, None], (len(x), 3)) for each in (z, slope, 0 * x))
    return GridFace(x, y, *fields)


def test_a_wall_far_away_is_in_the_way_of_a_large_ball():
    """Floor and wall are flat: by curvature any ball would fit. Beside the wall there is none."""
    x = np.linspace(0, 2, 101)
    wall = x > 1
    face = profile(np.where(wall, 3 * (x - 1), 0.0), np.where(wall, 3.0, 0.0), x)
    radius, _ = blocked_radius(face, 100.0)
    # The floor's last place and the wall's first are the tightest pair: a step apart, three high.
    assert radius == pytest.approx((1 + 3**2) * x[1] / (2 * 3))
    assert blocked_radius(face, 1e-3) is None
