"""Sources whose light stands in a file, in the forms."""

from pathlib import Path

import pytest

from tests.lamps import crooked_lamp
from tests.ui.hands import choose, editor, enter, row
from workbench.files.session import Session
from workbench.scene import Scene
from workbench.targets import load_target


@pytest.fixture
def session():
    scene = Scene.from_data(
        {
            "unit": "cm",
            "lens": {"half_width": [1, 1], "refractive_index": 1.5, "control_points": [6, 6]}
            | {"height_range": [-0.3, 0.3]},
            "source": {"kind": "point", "position": [0, 0, -4]},
            "screen": {"z": 5, "half_width": [1, 1], "pixels": [12, 10]},
            "target": {"builtin": "tophat", "blur": 1.0},
        }
    )
    return Session(scene, load_target(scene, Path()))


def test_a_file_of_light_is_chosen_from_a_dialog(forms, document, qtbot, tmp_path):
    lamp = Path(crooked_lamp(tmp_path)["file"])
    asked = []
    forms.file_asked.connect(lambda where: asked.append(where) or forms.choose_light(lamp))

    choose(forms, "source.kind", "photometric")

    assert asked == ["source"]
    source = document.session.scene.source
    assert (source.kind, source.file, source.position) == ("photometric", str(lamp), (0, 0, -4))
    assert row(forms, "source.file").editor.text() == str(lamp)
    enter(qtbot, forms, "source.rotation[0]", "30")
    assert document.session.scene.source.rotation == (30, 0, 0)
    assert document.session.scene.light_files[str(lamp)] is not None
    assert editor(forms, "source.position[2]").text() == "-4"
