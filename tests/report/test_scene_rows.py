import pytest

from workbench.report.scene_rows import scene_rows


def rows(scene):
    return dict(scene_rows(scene))


def test_every_field_has_a_row_with_its_unit(make_scene):
    found = rows(make_scene({"unit": "mm", "run.min_radius": 0.5}))
    assert found["lens.half_width"] == "1 × 1 mm"
    assert found["lens.height_range"] == "-0.3, 0.3 mm"
    assert found["lens.control_points"] == "12 × 10"
    assert found["screen.z"] == "5 mm"
    assert found["filter.alpha"] == "1 per pixel²"
    assert found["target.invert"] == "no"
    assert found["run.min_radius"] == "0.5 mm"
    assert found["unit"] == "mm"
    assert "format" not in found


def leaves(data, path=""):
    if isinstance(data, dict):
        for name, value in data.items():
            yield from leaves(value, f"{path}.{name}" if path else name)
    else:
        yield path


@pytest.mark.parametrize(
    "changes",
    [
        {},
        {"source": {"kind": "point", "position": [0, 0, -5]}},
        {"source": {"kind": "grid", "center": [0, 0, -5], "half_width": [1, 1], "points": [3, 3]}},
        {"run": {"method": "paper", "learning_rate": 0.01}},
        {"lens.outline": "ellipse"},
    ],
)
def test_every_field_of_the_scene_has_a_row(make_scene, changes):
    scene = make_scene(changes)
    wanted = set(leaves(scene.to_data())) - {"format", "version", "run.stages"}
    assert wanted == set(rows(scene))
