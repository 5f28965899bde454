"""Half widths of files are full sizes in the form: entered, stated, refused and undone as such."""

import json

import pytest

from tests.ui.hands import choose, editor, enter, field_row, row
from workbench.files.session import read_session

WIDTH = "elements[0].half_width"


def test_a_full_size_is_half_of_it_in_the_file(forms, document, qtbot, tmp_path):
    assert row(forms, WIDTH).label.text() == "Size"
    assert editor(forms, f"{WIDTH}[0]").text() == "2"
    enter(qtbot, forms, f"{WIDTH}[0]", "0.7")
    enter(qtbot, forms, f"{WIDTH}[1]", "9 mm")
    assert document.session.scene.optic.half_width == (0.35, 0.45)
    assert document.undo_stack.undoText() == "lens size 2 × 2 → 0.7 × 0.9 cm"
    file = tmp_path / "sized.freeform"
    document.save(file)
    kept = json.loads(read_session(file).scene.to_json())
    assert kept["elements"][0]["half_width"] == [0.35, 0.45]
    assert editor(forms, f"{WIDTH}[0]").text() == "0.7"
    choose(forms, "unit", "mm")
    assert [editor(forms, f"{WIDTH}[{k}]").text() for k in (0, 1)] == ["7", "9"]


@pytest.mark.parametrize(
    ("path", "text", "reason"),
    [
        (f"{WIDTH}[0]", "-3", "-3.0 is too small; must be greater than 0"),
        (f"{WIDTH}[0]", "1e7", "1e+07 cannot be computed with; from 2e-06 to 2e+06"),
        (
            f"{WIDTH}[1]",
            "0.0001",
            "0.0001 makes the element slimmer than 1000 to 1; at least 0.002",
        ),
        ("images[0].receiver.half_width[0]", "4e9", "4e+09 is too long beside a width of 2"),
    ],
)
def test_a_refused_size_is_quoted_in_full(forms, document, qtbot, path, text, reason):
    received = []
    forms.message.connect(received.append)
    enter(qtbot, forms, path, text)
    assert reason in field_row(forms, path).refusal
    assert reason in received[0] and "half" not in received[0]
    assert reason in forms.refusals[0]
    assert editor(forms, path).text() == text


def test_full_angles_are_refused_as_such(forms, document, qtbot):
    choose(forms, "images[0].receiver.kind", "far_field")
    enter(qtbot, forms, "images[0].receiver.half_angle[0]", "170")
    assert document.session.scene.receiver.half_angle[0] == 85
    enter(qtbot, forms, "images[0].receiver.center[0]", "20")
    assert "170 about 20 goes beyond 90 degrees; at most 140" in (
        row(forms, "images[0].receiver.half_angle").refusal
    )
    assert "to 180." in row(forms, "images[0].receiver.half_angle").toolTip()
