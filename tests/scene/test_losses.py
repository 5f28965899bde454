"""Fields of losses: versions of files, and what is refused."""

import json

import pytest

from workbench.errors import Refused
from workbench.scene import Scene


def read(data, version, **lens):
    given = {key: value for key, value in data["lens"].items() if key not in lens} | lens
    return Scene.from_data(data | {"version": version, "lens": given})


class TestVersions:
    def test_a_file_of_version_1_means_schlick(self, scene_data):
        scene = read(scene_data, 1)
        assert scene.optic.reflection == "schlick"
        assert scene.to_data()["elements"][0]["reflection"] == "schlick"

    def test_a_file_of_version_2_means_fresnel_if_it_does_not_say(self, scene_data):
        scene = read(scene_data, 2)
        assert scene.optic.reflection == "fresnel"
        assert scene.to_data()["elements"][0]["reflection"] == "fresnel"

    @pytest.mark.parametrize("reflection", ["fresnel", "schlick", "none"])
    def test_a_file_of_version_2_means_what_it_says(self, scene_data, reflection):
        scene = read(scene_data, 2, reflection=reflection)
        assert scene.optic.reflection == reflection
        assert Scene.from_json(scene.to_json()) == scene

    def test_coating_and_absorption_come_back(self, scene_data):
        scene = read(scene_data, 2, coating=[0.0, 0.02], absorption=0.003)
        assert Scene.from_json(scene.to_json()) == scene


def test_absorption_is_per_length(scene_data):
    scene = read(scene_data, 2, absorption=0.5).in_unit("mm")
    assert scene.optic.absorption == pytest.approx(0.05)
    assert scene.optic.half_width == (10, 10)


@pytest.mark.parametrize(
    ("lens", "path", "stated"),
    [
        ({"reflection": "mirror"}, "lens.reflection", "'fresnel', 'schlick' or 'none'"),
        ({"coating": [0.1, 1.0]}, "lens.coating[1]", "1.0"),
        ({"coating": [-0.1, 0.0]}, "lens.coating[0]", "-0.1"),
        ({"coating": [0.1]}, "lens.coating[1]", "missing"),
        ({"coating": 0.01}, "lens.coating", "a list"),
        ({"absorption": -1e-9}, "lens.absorption", "-1e-09"),
        ({"absorption": "clear"}, "lens.absorption", "clear"),
        ({"absorption": 30.0}, "lens.absorption", "at most 27.6"),
    ],
)
def test_impossible_loss_is_refused_with_its_path(scene_data, lens, path, stated):
    with pytest.raises(Refused) as refused:
        read(scene_data, 2, **lens)
    assert refused.value.path == path
    assert stated in refused.value.reason


@pytest.mark.parametrize("number", ["NaN", "Infinity"])
def test_numbers_that_are_none_are_refused(scene_data, number):
    text = json.dumps(scene_data).replace('"degree"', f'"absorption": {number}, "degree"')
    with pytest.raises(Refused):
        Scene.from_json(text)
