"""Sources whose light stands in a file."""

import numpy as np
import pytest

from workbench.errors import Refused
from workbench.scene import Scene

LAMP = {"kind": "photometric", "file": "lamp.ies", "position": [0.0, 0.0, -3.0]}


def test_a_photometric_file_needs_version_2(make_scene):
    scene = make_scene({"source": LAMP})

    assert scene.to_data()["source"]["rotation"] == [0, 0, 0]
    assert Scene.from_data(scene.to_data()) == scene


@pytest.mark.parametrize(
    ("source", "stated"),
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
def test_impossible_measured_source_is_refused(make_scene, source, stated):
    with pytest.raises(Refused, match=f"^{stated}"):
        make_scene({"source": LAMP | source})


def test_turns_follow_each_other_about_x_y_and_z(make_scene):
    turned = make_scene({"source": LAMP | {"rotation": [90.0, 0.0, 90.0]}}).source.matrix

    assert np.allclose(turned @ [0, 0, 1], [1, 0, 0])  # to −y, then to +x
    assert np.allclose(turned @ [1, 0, 0], [0, 1, 0])


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
        "images[0].target.image": "a.png",
        "run.stages[0].source.file": "other.ldt",
    }
    moved = scene.with_files({field: f"/there/{name}" for field, name in names.items()})
    assert dict(moved.files())["run.stages[0].source.file"] == "/there/other.ldt"
    assert moved.source.file == "/there/lamp.ies"
    assert scene.with_files({}) == scene


def test_carried_file_content_does_not_change_equality_of_scenes(make_scene):
    scene = make_scene({"source": LAMP})

    carrying = scene.carrying({"lamp.ies": b"light"})

    assert carrying.light_files == {"lamp.ies": b"light"}
    assert scene.light_files == {"lamp.ies": None}
    assert carrying == scene
    assert carrying.in_unit("mm").light_files == {"lamp.ies": b"light"}
    assert carrying.with_optic(scene.optic).light_files == {"lamp.ies": b"light"}


def test_a_new_photometric_source_needs_a_file_first(make_scene):
    scene = make_scene()
    field = next(field for field in Scene.fields() if field.name == "source")
    kind = next(part for part in field.parts if part.__name__ == "PhotometricSource")
    kinds = next(mark for mark in field.marks if hasattr(mark, "exchanged"))

    assert kinds.exchanged(scene.source, kind, scene) is None
