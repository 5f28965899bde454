"""Values of a scene by their paths, elements and faces named."""

import pytest

from workbench.errors import Refused
from workbench.scene import Scene
from workbench.scene.paths import value_at, with_values


@pytest.fixture
def mirror_scene(scene_data):
    del scene_data["lens"]
    scene_data |= {
        "version": 2,
        "mirror": {"half_width": [1, 1], "control_points": [8, 9]},
        "screen": {"z": -5, "half_width": [1, 1], "pixels": [32, 32]},
    }
    return Scene.from_data(scene_data)


@pytest.mark.parametrize(
    ("path", "value"),
    [
        ("run.seed", 0),
        ("lens.thickness", 0.5),
        ("elements[0].thickness", 0.5),
        ("lens.back.control_points", (12, 10)),
        ("elements[0].back.control_points[1]", 10),
        ("lens.faces[1].degree[0]", 3),
        ("lens.front.shape", "plane"),
        ("images[0].receiver.position[2]", 5.0),
        ("lens.back.colour", None),
        ("lens.position[3]", None),
        ("elements[1].back.degree", None),
        ("run.seed.x", None),
    ],
)
def test_a_value_is_found(make_scene, path, value):
    assert value_at(make_scene(), path) == value


def test_a_path_leads_through_plain_data_and_parts_alike(make_scene):
    scene = make_scene()
    path = "elements[0].faces[1].degree[0]"
    assert value_at(scene.to_data(), path) == value_at(scene, path) == 3
    assert value_at(scene.optic, "faces[1].degree[0]") == 3


def test_the_face_of_a_mirror_has_a_path(mirror_scene):
    assert value_at(mirror_scene, "mirror.face.control_points") == (8, 9)
    found = with_values(mirror_scene, {"mirror.face.control_points": 20})
    assert found.optic.control_points == (20, 20)


def test_fields_change_and_the_rest_stays(make_scene):
    scene = make_scene()
    changes = {
        "lens.back.control_points": (20, 16),
        "run.seed": 4,
        "images[0].receiver.position[2]": 7,
    }
    found = with_values(scene, changes)
    assert found.optic.control_points == (20, 16)
    assert (found.run.seed, found.receiver.z) == (4, 7)
    assert found.source == scene.source and found.target == scene.target


def test_a_part_is_replaced_as_a_whole(make_scene):
    face = {"shape": "bspline", "control_points": [6, 7], "height_range": [-0.1, 0.1]}
    found = with_values(make_scene(), {"lens.front": face, "run": {"method": "paper"}})
    assert found.optic.entrance.control_points == (6, 7)
    assert (found.run.method, found.run.iterations) == ("paper", 300)


def test_one_number_stands_for_each(make_scene):
    found = with_values(make_scene(), {"lens.back.control_points": 20})
    assert found.optic.control_points == (20, 20)


def test_one_number_stands_for_both_of_an_automatic_net(make_scene):
    scene = make_scene({"lens.control_points": "auto"})
    found = with_values(scene, {"lens.back.control_points": 20})
    assert found.optic.control_points == (20, 20)


def test_one_of_several(make_scene):
    scene = make_scene({"source": {"kind": "point", "position": [0, 0, -5]}})
    assert with_values(scene, {"source.position[2]": -8}).source.position == (0, 0, -8)
    assert with_values(scene, {"filter.size[1]": 5}).filter.size == (3, 5)


def test_defaults_follow_the_changed_field(scene_data):
    for name in ("base", "height_range", "min_thickness"):
        del scene_data["lens"][name]
    del scene_data["filter"], scene_data["run"]
    changes = {"lens.half_width": 2.0, "filter.size[0]": 7, "run.iterations": 9}
    found = with_values(Scene.from_data(scene_data), changes)
    assert found.optic.min_thickness == pytest.approx(0.1)
    assert found.optic.height_range is None  # which follows from the task
    assert found.filter.size == (7, 3)
    assert found.run.iterations == 9


@pytest.mark.parametrize(
    ("path", "value", "reason"),
    [
        ("lens.colour", 1, "elements[0].colour: unknown field"),
        ("lens.back.degree.x", 1, "lens.back.degree.x: unknown field"),
        ("lens[0]", 1, "lens[0]: unknown field"),
        ("screen.z", 1, "screen: no field and no element of this scene; fields: elements, filter"),
        ("elements[1].thickness", 1, "elements[1].thickness: unknown field"),
        ("lens.half_width[2]", 1, "lens.half_width[2]: there are only 2 of them; 0 to 1"),
        ("regions[0]", 1, "regions[0]: there is none of them"),
        ("run.seed", "x", "run.seed: 'x' is not a whole number"),
        ("lens.back.control_points", 3, "elements[0].faces[1].control_points[0]: 3 is too few"),
        ("lens.half_width.a.b", 1, "lens.half_width.a.b: unknown field"),
        ("lens..thickness", 1, "lens..thickness: no path of a field"),
    ],
)
def test_refusals_name_the_field(make_scene, path, value, reason):
    with pytest.raises(Refused) as refused:
        with_values(make_scene(), {path: value})
    assert str(refused.value).startswith(reason)


def test_two_values_of_one_field_are_refused(make_scene):
    with pytest.raises(Refused, match="given twice"):
        with_values(make_scene(), {"lens.thickness": 0.4, "elements[0].thickness": 0.6})
