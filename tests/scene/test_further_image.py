"""Scenes that ask for several images."""

import numpy as np
import pytest

from tests.scenes import changed
from workbench.design.task import begin
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
