"""Control points that are left to the program, in scenes and their files."""

import json

import pytest

from workbench.errors import Refused
from workbench.scene import AutoNet, Scene, SplineFace


def test_auto_is_read_and_written(make_scene):
    scene = make_scene({"lens.control_points": "auto"})
    assert scene.optic.control_points == AutoNet()
    data = json.loads(scene.to_json())
    assert data["elements"][0]["faces"][1]["control_points"] == "auto"
    assert Scene.from_data(data) == Scene.from_data(scene.to_data())


def test_files_do_not_hold_what_was_chosen(make_scene):
    chosen = make_scene({"lens.control_points": "auto"}).with_net((48, 40))
    assert chosen.optic.net_shape == (48, 40)
    assert chosen.to_data()["elements"][0]["faces"][1]["control_points"] == "auto"
    assert chosen.with_net(None).optic.known_shape is None


def test_numbers_are_no_choice_that_could_be_changed(make_scene):
    scene = make_scene()
    assert scene.with_net((48, 40)) is scene


def test_settled_scenes_have_the_numbers_that_were_chosen(make_scene):
    scene = make_scene({"lens.control_points": "auto"})
    settled = scene.with_net((48, 40)).settled()
    assert settled == make_scene({"lens.control_points": [48, 40]})


def test_a_net_that_is_not_chosen_yet_has_no_numbers(make_scene):
    lens = make_scene({"lens.control_points": "auto"}).optic
    with pytest.raises(Refused, match=r"faces\[1\]\.control_points: 'auto' needs a target"):
        _ = lens.net_shape


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


def test_a_choice_is_checked_against_the_degree(make_scene):
    scene = make_scene({"lens.control_points": "auto", "lens.degree": [7, 3]})
    with pytest.raises(Refused, match="6 is too few for degree 7"):
        scene.with_net((6, 6))


def test_a_mesh_is_checked_with_the_chosen_net(make_scene):
    mesh = {"method": "mesh", "subdivisions": [16, 16]}
    source = {"kind": "point", "position": [0, 0, -5], "intersection": mesh}
    scene = make_scene({"lens.control_points": "auto", "source": source})
    with pytest.raises(Refused, match=r"source\.intersection\.subdivisions"):
        scene.with_net((1024, 1024))


def test_the_schema_allows_numbers_and_auto():
    stated = SplineFace.model_json_schema()["properties"]["control_points"]
    numbers, auto = stated["anyOf"]
    assert auto == {"const": "auto"} and numbers["maxItems"] == 2
    (field,) = (field for field in SplineFace.fields() if field.name == "control_points")
    assert field.auto and not field.optional and field.count == 2
    assert field.limits == "From 2 to 2048."


def test_the_lens_remarks_what_was_chosen(make_scene):
    scene = make_scene({"lens.control_points": "auto"})
    assert "control_points" not in scene.optic.spline.remarks()
    chosen = scene.with_net((48, 40)).optic.spline
    assert chosen.remarks()["control_points"] == "48 × 40"
