"""Losses of a lens, and a net that is left to the program."""

import json

import pytest

from workbench.errors import Refused
from workbench.scene import AutoNet, Scene


def test_auto_is_read_and_written_as_version_2(make_scene):
    scene = make_scene({"lens.control_points": "auto"})
    assert scene.optic.control_points == AutoNet()
    data = json.loads(scene.to_json())
    assert (data["version"], data["lens"]["control_points"]) == (2, "auto")
    assert Scene.from_data(data) == Scene.from_data(scene.to_data())


def test_files_do_not_hold_what_was_chosen(make_scene):
    chosen = make_scene({"lens.control_points": "auto"}).with_net((48, 40))
    assert chosen.optic.net_shape == (48, 40)
    assert chosen.to_data()["lens"]["control_points"] == "auto"
    assert chosen.with_net(None).optic.known_shape is None


def test_settled_scenes_have_the_numbers_that_were_chosen(make_scene):
    scene = make_scene({"lens.control_points": "auto"})
    settled = scene.with_net((48, 40)).settled()
    assert settled == make_scene({"lens.control_points": [48, 40]})
    assert settled.to_data()["version"] == 1


@pytest.mark.parametrize(
    ("value", "message"),
    [
        ("fine", "lens.control_points: 'fine': two whole numbers or 'auto' are needed"),
        (["auto", 8], "lens.control_points[0]: 'auto' is not a whole number"),
        ([3, 8], "lens.control_points[0]: 3 is too few for degree 3; at least 4"),
        (8, "lens.control_points: 8 is not a list"),
    ],
)
def test_other_values_are_refused(make_scene, value, message):
    with pytest.raises(Refused) as refused:
        make_scene({"lens.control_points": value})
    assert str(refused.value).startswith(message)


def read(data, version, **lens):
    given = {key: value for key, value in data["lens"].items() if key not in lens} | lens
    return Scene.from_data(data | {"version": version, "lens": given})


class TestVersions:
    def test_a_file_of_version_1_means_schlick_and_is_written_as_it_was(self, scene_data):
        scene = read(scene_data, 1)
        assert scene.optic.reflection == "schlick"
        written = scene.to_data()
        assert written["version"] == 1
        assert not {"reflection", "coating", "absorption"} & written["lens"].keys()


@pytest.mark.parametrize(
    ("lens", "path", "said"),
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
def test_impossible_loss_is_refused_with_its_path(scene_data, lens, path, said):
    with pytest.raises(Refused) as refused:
        read(scene_data, 2, **lens)
    assert refused.value.path == path
    assert said in refused.value.reason
