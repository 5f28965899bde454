"""Sources whose light stands in a file."""

import pytest

from workbench.errors import Refused

LAMP = {"kind": "photometric", "file": "lamp.ies", "position": [0.0, 0.0, -3.0]}


@pytest.mark.parametrize(
    ("source", "said"),
    [
        ({"file": "lamp.txt"}, "source.file: 'lamp.txt' is none of these: .ies, .ldt"),
        ({"file": ""}, "source.file: '' is empty"),
        ({"position": [0, 0, 1]}, r"source.position\[2\]: 1 is not before the entrance face"),
        ({"position": [0, 0, -1e15]}, r"source.position\[2\]: 1e\+15 before the entrance face is"),
        ({"rotation": [0, 0]}, "source.rotation"),
        ({"rotation": [0, 0, 1000]}, r"source.rotation\[2\]: 1000 is too large"),
        ({"rays": 0}, "source.rays: 0 is too small"),
    ],
)
def test_impossible_measured_source_is_refused(make_scene, source, said):
    with pytest.raises(Refused, match=f"^{said}"):
        make_scene({"source": LAMP | source})


def test_another_unit_keeps_the_lamp_and_moves_it(make_scene):
    scene = make_scene({"source": LAMP | {"rotation": [5.0, 0.0, 0.0]}})

    source = scene.in_unit("mm").source

    assert source.position == (0, 0, -30)
    assert source.rotation == (5, 0, 0)
    assert source.unit == "mm" and scene.source.unit == "cm"


def test_files_are_named_by_their_fields_and_can_be_renamed(make_scene):
    stage = {"iterations": 2, "source": LAMP | {"file": "other.ldt"}}
    scene = make_scene({"source": LAMP, "run.stages": [stage], "target": {"image": "a.png"}})

    names = dict(scene.files())
    assert names == {
        "source.file": "lamp.ies",
        "target.image": "a.png",
        "run.stages[0].source.file": "other.ldt",
    }
    moved = scene.with_files({field: f"/there/{name}" for field, name in names.items()})
    assert dict(moved.files())["run.stages[0].source.file"] == "/there/other.ldt"
    assert moved.source.file == "/there/lamp.ies"
    assert scene.with_files({}) == scene
