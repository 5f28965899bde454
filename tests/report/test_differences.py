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
