"""Receivers, further images and regions of a scene."""

import math

import numpy as np
import pytest

from tests.scenes import changed
from workbench.design.task import begin
from workbench.errors import Refused
from workbench.scene import FarField, Scene, Screen

SECOND = {
    "screen": {"z": 6.0, "half_width": [1.5, 1.0], "pixels": [24, 32]},
    "target": {"builtin": "ball"},
    "weight": 2.0,
}


@pytest.fixture
def several(make_scene):
    return make_scene({"further_images": [SECOND]})


def refused(changes):
    with pytest.raises(Refused) as found:
        Scene.from_data(changed({"further_images": [{**SECOND, **changes}]}))
    return str(found.value)


def test_a_scene_of_several_images_is_written_as_version_2_and_read_back(several):
    data = several.to_data()
    assert data["version"] == 2
    assert data["further_images"][0]["weight"] == 2.0
    assert Scene.from_data(data) == several


def test_each_image_is_a_scene_of_its_own(several):
    first, second = several.single
    assert first.receiver == several.receiver
    assert first.target == several.target
    assert second.receiver == several.further_images[0].screen
    assert second.target == several.further_images[0].target
    assert not first.further_images
    assert not second.further_images
    assert second.optic is several.optic


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"weight": 0}, "further_images[0].weight: 0 is too small; must be greater than 0"),
        ({"screen": None}, "further_images[0].screen: missing; it or far_field is required"),
        (
            {"far_field": {"half_angle": [10, 10], "pixels": [8, 8]}},
            "further_images[0].far_field: is given together with a screen; one of them is needed",
        ),
        ({"target": {"builtin": "cat"}}, "further_images[0].target.builtin: 'cat' is not"),
        (
            {"screen": {**SECOND["screen"], "z": 0.6}},
            "further_images[0].screen.z: 0.6 may touch the lens",
        ),
        (
            {"screen": {**SECOND["screen"], "half_width": [1e12, 1]}},
            "further_images[0].screen.half_width[0]: 1e+12 is too long",
        ),
    ],
)
def test_an_impossible_image_is_refused_by_its_path(changes, sentence):
    assert refused(changes).startswith(sentence)


def test_targets_of_further_images_are_drawn_with_the_task(several, tmp_path):
    session = begin(several, tmp_path)
    _, second = session.scene.images(session.target)
    assert second.target.shape == (32, 24)
    assert second.weight == 2.0
    alone = begin(several.single[1], tmp_path)
    np.testing.assert_array_equal(second.target, alone.target)


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


DESK = {"name": "Desk", "shape": "rectangle", "center": [0.1, -0.2], "size": [0.5, 0.25]}


SPOT = {"name": "Spot", "shape": "ellipse", "size": [0.5, 0.25]}


ARROW = {"name": "Arrow", "shape": "polygon", "corners": [[-0.5, -0.5], [0.5, -0.5], [0, 0.5]]}


def with_regions(*regions):
    return Scene.from_data(changed({"regions": list(regions)}))


def test_regions_are_written_as_they_are_read():
    scene = with_regions(DESK, SPOT, ARROW)
    assert Scene.from_data(scene.to_data()) == scene
    assert scene.needed_version == 2
    assert scene.to_data()["regions"][0] == DESK


@pytest.mark.parametrize(
    ("region", "path", "reason"),
    [
        ({**DESK, "size": [0.9, 0.1]}, "size[0]", "at most 0.8 there"),
        ({**DESK, "center": [0.7, 0]}, "center[0]", "at most 0.5"),
        ({**DESK, "shape": "star"}, "", "'star' is not available"),
        ({**ARROW, "corners": [[0, 0], [0.5, 0]]}, "corners", "at least 3"),
        ({**ARROW, "corners": [[0, 0], [0.2, 0], [0.4, 0]]}, "corners", "have no area"),
        (
            {**ARROW, "corners": [[-0.5, -0.5], [0.5, 0.5], [0.5, -0.5], [-0.5, 0.4]]},
            "corners",
            "make sides that cross",
        ),
    ],
)
def test_impossible_regions_are_refused(region, path, reason):
    with pytest.raises(Refused, match=reason) as refused:
        with_regions(SPOT, region)
    assert refused.value.path.startswith(f"regions[1].{path}".rstrip("."))
