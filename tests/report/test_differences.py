"""In which fields two scenes differ."""

from workbench.report.scene_rows import differences


def test_scenes_differ_where_their_values_do(make_scene):
    one = make_scene()
    other = make_scene({"screen.z": 6.5, "target": {"builtin": "ball"}, "run.seed": 3})
    found = dict(differences(one, other))
    assert found["Run · Seed"] == ("0", "3")
    assert [values for title, values in found.items() if title.startswith("Screen")] == [
        ("5 cm", "6.5 cm")
    ]
    assert all(title.startswith(("Run", "Screen", "Target")) for title in found)
    assert differences(one, one) == ()


def test_a_field_of_one_scene_alone_is_told(make_scene):
    one, other = make_scene(), make_scene({"run.min_radius": 0.5})
    (only,) = differences(one, other)
    assert only.values == ("–", "0.5 cm")
    assert differences(other, one)[0].values == ("0.5 cm", "–")


def test_fields_that_the_older_of_two_files_leaves_out_are_no_difference(make_scene):
    one = make_scene()
    other = make_scene({"target": {"builtin": "rectangle"}})
    assert (one.needed_version, other.needed_version) == (1, 2)
    assert all(title.startswith("Target") for title, _ in differences(one, other))


def test_lengths_in_another_unit_are_no_difference(make_scene):
    one = make_scene()
    assert dict(differences(one, one.in_unit("mm"))) == {"Unit": ("cm", "mm")}
