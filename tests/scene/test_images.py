"""Scenes that ask for several images."""

import numpy as np
import pytest

from tests.scenes import changed
from workbench.design.task import begin, with_file, with_task
from workbench.errors import Refused
from workbench.scene import Scene

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


def test_a_scene_of_several_images_is_written_and_read_back(several):
    data = several.to_data()
    assert [image["weight"] for image in data["images"]] == [1.0, 2.0]
    assert Scene.from_data(data) == several


def test_all_lengths_of_further_images_are_converted(several):
    screen = several.in_unit("mm").images[1].receiver
    assert screen.z == pytest.approx(60)
    assert screen.half_width == pytest.approx((15, 10))


def test_each_image_is_a_scene_of_its_own(several):
    first, second = several.single
    assert first.receiver == several.receiver
    assert first.target == several.target
    assert second.receiver == several.images[1].receiver
    assert second.target == several.images[1].target
    assert len(first.images) == len(second.images) == 1
    assert second.optic == several.optic


def test_a_scene_of_one_image_is_its_only_one(make_scene):
    scene = make_scene()
    assert scene.single == (scene,)
    assert scene.single[0] is scene


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


def test_too_many_images_are_refused():
    with pytest.raises(Refused, match="further_images: 9 are given; at most 8"):
        Scene.from_data(changed({"further_images": [SECOND] * 9}))


def test_an_image_in_the_far_field_is_possible(make_scene):
    field = {"far_field": {"half_angle": [20, 20], "pixels": [16, 16]}, "target": SECOND["target"]}
    scene = make_scene({"further_images": [field]})
    assert scene.receivers[1].called == "far field"
    assert scene.in_unit("mm").receivers[1] == scene.receivers[1]


def test_targets_of_further_images_are_drawn_with_the_task(several, tmp_path):
    session = begin(several, tmp_path)
    _, second = session.scene.wanted(session.target)
    assert second.target.shape == (32, 24)
    assert second.weight == 2.0
    alone = begin(several.single[1], tmp_path)
    np.testing.assert_array_equal(second.target, alone.target)


def test_a_target_that_was_not_drawn_is_refused(several):
    with pytest.raises(Refused, match=r"images\[1\].target: has yet to be drawn"):
        several.wanted(np.ones((32, 32)))


def test_a_drawn_target_stays_through_conversions_and_edits_beside_it(several, tmp_path):
    session = begin(several, tmp_path)
    drawn = session.scene.images[1].wanted
    assert session.in_unit("mm").scene.images[1].wanted is drawn
    edited = with_task(session, Scene.from_data(several.to_data() | {"unit": "cm"}), tmp_path)
    assert edited.scene.images[1].wanted is drawn


def test_another_target_is_drawn_anew_and_makes_another_task(several, tmp_path):
    session = begin(several, tmp_path)
    data = several.to_data()
    data["images"][1]["target"]["invert"] = True
    edited = with_task(session, Scene.from_data(data), tmp_path)
    assert edited.scene != session.scene
    before, after = (s.scene.images[1].wanted for s in (session, edited))
    assert not np.array_equal(before, after)


def test_an_image_file_is_read_anew_when_asked(make_scene, tmp_path):
    file = tmp_path / "wanted.npy"
    np.save(file, np.ones((8, 8)))
    image = {**SECOND, "target": {"image": str(file)}}
    session = begin(make_scene({"further_images": [image]}), tmp_path)
    np.save(file, np.eye(8))
    kept = with_task(session, session.scene, tmp_path)
    anew = with_file(session, tmp_path)
    before, after = (s.scene.images[1].wanted for s in (kept, anew))
    np.testing.assert_array_equal(before, session.scene.images[1].wanted)
    assert not np.array_equal(before, after)
    assert anew.scene != session.scene


def test_all_images_have_the_same_regions(make_scene):
    scene = make_scene({"further_images": [SECOND], "regions": [{"name": "Desk"}]})
    first, second = scene.single
    assert [region.name for region in first.regions] == ["Desk"]
    assert second.regions == first.regions
