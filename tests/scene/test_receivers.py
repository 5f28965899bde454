"""Screens anywhere and far fields as parts of the scene."""

import math

import numpy as np
import pytest

from workbench.errors import Refused
from workbench.scene import FarField, Scene, Screen

FAR = {"half_angle": [20.0, 10.0], "pixels": [40, 20]}


@pytest.mark.parametrize(
    "change",
    [
        {"screen.center": [0.5, 0.0]},
        {"screen.tilt": [10.0, 0.0]},
        {"screen": None, "far_field": FAR},
    ],
)
def test_tilted_screens_and_far_fields_need_version_2_and_come_back_from_it(make_scene, change):
    scene = make_scene(change)
    data = scene.to_data()
    assert data["version"] == 2
    assert Scene.from_data(data) == scene


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"screen": None}, "screen: missing; it or far_field is required"),
        ({"far_field": FAR}, "far_field: is given together with a screen; one of them is needed"),
        ({"screen.tilt": [0.0, 120.0]}, "screen.tilt: [0, 120] turns the back of the screen"),
        ({"screen.tilt": [0.0, 180.0]}, "screen.tilt: [0, 180] turns the back of the screen"),
        (
            {"screen.z": 1.5, "screen.tilt": [60.0, 0.0], "screen.center": [0.0, 1.2]},
            "screen.tilt: [60, 0] turns the back of the screen",
        ),
        (
            {"screen.z": 3.0, "screen.half_width": [1.0, 6.0], "screen.tilt": [-25.0, 0.0]},
            "screen.z: 3 puts its lowest edge at z = 0.46",
        ),
        ({"screen.tilt": [0.0, 181.0]}, "screen.tilt[1]: 181.0 is too large; at most 180"),
        ({"screen.center": [1e12, 0.0]}, "screen.center[0]: 1e+12 is too long"),
        (
            {"screen": None, "far_field": {**FAR, "half_angle": [91.0, 10.0]}},
            "far_field.half_angle[0]: 91.0 is too large; at most 90",
        ),
        (
            {"screen": None, "far_field": {**FAR, "center": [0.0, 85.0]}},
            "far_field.half_angle[1]: 10 about 85 goes beyond 90 degrees; at most 5",
        ),
    ],
)
def test_receiver_that_no_light_can_meet_is_refused_in_a_sentence(make_scene, change, sentence):
    with pytest.raises(Refused) as refused:
        make_scene(change)
    assert str(refused.value).startswith(sentence)


def test_pixels_of_a_far_field_cover_the_solid_angle_that_it_has():
    far_field = FarField(half_angle=(60.0, 35.0), center=(20.0, 50.0), pixels=(7, 31))
    sines = math.sin(math.radians(85)) - math.sin(math.radians(15))
    expected = math.radians(120) * sines
    assert far_field.total(np.ones((31, 7))) == pytest.approx(expected, rel=1e-12)
    whole = FarField(half_angle=(90.0, 90.0), pixels=(64, 64))
    assert whole.total(np.ones((64, 64))) == pytest.approx(2 * math.pi, rel=1e-12)


def test_directions_to_places_lead_there():
    screen = Screen(z=5, half_width=(1, 1), center=(1, 2), tilt=(20, -35), pixels=(4, 4))
    u, v = np.array([0.3, -0.9]), np.array([-0.2, 0.8])
    start = np.array([0.1, 0.2]), np.array([0.0, -0.3]), np.array([0.5, 0.4])
    way = np.stack(screen.towards(None, start, u, v), axis=-1)
    to = screen.drawn(None, u, v) - np.stack(start, axis=-1)
    assert np.cross(way, to) == pytest.approx(0, abs=1e-14)
    assert (way * to).sum(axis=-1) == pytest.approx(np.linalg.norm(to, axis=-1))
