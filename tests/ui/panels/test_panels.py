from pathlib import Path

import pytest
from PySide6.QtCore import QPoint

from tests.ui.hands import choose, editor, enter, field_row, row, rows
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
            "source": {"kind": "collimated", "rays": [16, 16]},
            "screen": {"z": 5, "half_width": [1, 1], "pixels": [12, 10]},
            "target": {"builtin": "tophat", "blur": 1.0},
        }
    )
    return Session(scene, load_target(scene, Path()))


def test_a_number_is_entered_with_return(forms, document, qtbot):
    enter(qtbot, forms, "screen.z", "7.25")
    assert document.session.scene.receiver.z == 7.25
    assert document.undo_stack.undoText() == "screen at z 5 → 7.25 cm"


@pytest.mark.parametrize(
    ("path", "text", "value"),
    [
        ("screen.z", "70 mm", 7),
        ("screen.z", "15/2", 7.5),
        ("screen.z", "7,5", 7.5),
        ("screen.z", "3 in - 0.62", None),
        ("screen.z", "3 in - 6.2 mm", 7),
        ("lens.min_thickness", "300 um", 0.03),
        ("run.iterations", "2*128", 256),
        ("lens.control_points[1]", "(30 + 2)/2", 16),
    ],
)
def test_a_number_may_be_worked_out_and_have_a_unit(forms, document, qtbot, path, text, value):
    before = document.session
    enter(qtbot, forms, path, text)
    if value is None:
        assert document.session is before
        assert "give both a unit" in row(forms, path).refusal
    else:
        assert editor(forms, path).text() == f"{value}"
        assert not forms.refused and document.session is not before


@pytest.mark.parametrize(
    ("path", "text", "reason"),
    [
        ("screen.z", "far", "'far' is not a number"),
        ("screen.z", "0.1", "may touch the lens"),
        ("screen.z", "nan", "'nan' is not a number"),
        ("screen.z", "1e999", "too large"),
        ("screen.z", "5 kg", "'kg' is not known here; mm, cm, m, inch"),
        ("screen.z", "1,000", "1,000 may be 1.000 or 1000"),
        ("screen.z", "5/0", "divides by zero"),
        ("run.seed", "3 mm", "'mm' is not known here; no unit"),
        ("lens.half_width[1]", "-1", "must be greater than 0"),
        ("lens.control_points[0]", "3", "3 is too few for degree 3; at least 4"),
        ("lens.control_points[0]", "6.5", "is not a whole number"),
        ("lens.height_range[0]", "1", "low before high"),
        ("filter.size[0]", "4", "4 is even"),
        ("run.seed", "", "'' is not a number; a number is needed"),
        ("target.radius", "2", "at most 1"),
    ],
)
def test_a_refusal_stands_beside_its_field(forms, document, qtbot, path, text, reason):
    session = document.session
    enter(qtbot, forms, path, text)
    assert document.session is session
    assert editor(forms, path).text() == text  # as typed, until it is corrected
    field = field_row(forms, path)
    assert reason in field.refusal
    assert field._refusal.isVisible()
    assert forms.refused


def test_another_unit_converts_all_lengths(forms, document, qtbot):
    before = document.session
    choose(forms, "unit", "mm")
    scene = document.session.scene
    assert (scene.unit, scene.receiver.z, scene.optic.half_width) == ("mm", 50, (10, 10))
    assert scene == before.scene.in_unit("mm")
    assert document.session.target is before.target
    assert row(forms, "screen.z")._unit.text() == "mm"
    assert editor(forms, "screen.z").text() == "50"
    assert document.undo_stack.undoText() == "change of unit"
    document.undo_stack.undo()
    assert document.session is before


def test_edits_during_a_run_wait_for_its_end(forms, document, qtbot):
    session, received = document.session, []
    forms.postponed.connect(received.append)
    forms.set_running(True)
    enter(qtbot, forms, "screen.z", "7")
    choose(forms, "source.kind", "point")
    enter(qtbot, forms, "source.position[2]", "-9")  # a field of the source to come
    assert document.session is session
    assert editor(forms, "screen.z").text() == "7" and forms.postponed_edits == 3
    assert "change of screen at z" in received[0] and "source kind" in received[-1]
    forms.set_running(False)
    forms.make_postponed_edits()
    scene = document.session.scene
    assert (scene.receiver.z, scene.source.position[2]) == (7, -9)
    assert document.undo_stack.count() == 3 and forms.postponed_edits == 0


@pytest.mark.parametrize("kind", ["collimated", "point", "grid"])
def test_everything_fits_into_its_narrowest_width(forms, kind):
    choose(forms, "source.kind", kind)
    forms.resize(forms.minimumWidth(), 700)
    for panel in forms.panels:
        for field in panel.rows:
            if field.isVisible():
                right = field.mapTo(forms, QPoint(field.width(), 0)).x()
                assert right <= forms.viewport().width(), field.path


def test_the_height_range_is_automatic_or_a_persons_own(forms, document, qtbot):
    assert row(forms, "lens.height_range").chooser.currentText() == "Own limits"
    choose(forms, "lens.height_range", "automatic")
    assert document.session.scene.optic.height_range is None
    assert [each.isVisible() for each in rows(forms) if each.path == "lens.height_range"] == [
        True,
        False,  # no numbers
    ]
    choose(forms, "lens.height_range", "own")
    assert document.session.scene.optic.height_range == (-0.3, 0.3)
    enter(qtbot, forms, "lens.height_range[1]", "0.4")
    assert document.session.scene.optic.height_range == (-0.3, 0.4)
