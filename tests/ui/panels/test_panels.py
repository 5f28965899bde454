from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QApplication, QPushButton, QWidget

from tests.ui.hands import choose, editor, enter, field_row, fill, row, rows
from ui.panels.picture_dialog import PictureDialog
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
    enter(qtbot, forms, "images[0].receiver.position[2]", "7.25")
    assert document.session.scene.receiver.z == 7.25
    assert document.undo_stack.undoText() == "receiver position 0, 0, 5 → 0, 0, 7.25 cm"


def test_both_widths_are_one_step_that_says_what_they_were(forms, document, qtbot):
    for axis, text in ((0, "40"), (1, "50"), (0, "50")):
        enter(qtbot, forms, f"images[0].receiver.half_width[{axis}]", text)
    assert document.undo_stack.count() == 1
    assert document.undo_stack.undoText() == "receiver size 2 → 50 cm"
    enter(qtbot, forms, "images[0].receiver.half_width[0]", "30")
    assert document.undo_stack.undoText() == "receiver size 2 × 2 → 30 × 50 cm"
    enter(qtbot, forms, "elements[0].faces[1].height_range[1]", "0.4")
    assert (
        document.undo_stack.undoText()
        == "lens back face from the base -0.3 to 0.3 → -0.3 to 0.4 cm"
    )
    document.undo_stack.undo()
    document.undo_stack.undo()
    assert document.session.scene.receiver.half_width == (1.0, 1.0)


def test_a_number_may_be_worked_out_and_have_a_unit(forms, document, qtbot):
    for path, text, value in (
        ("images[0].receiver.position[2]", "15/2", 7.5),
        ("images[0].receiver.position[2]", "3 in - 6.2 mm", 7),
        ("elements[0].min_thickness", "300 um", 0.03),
        ("run.iterations", "2*128", 256),
        ("elements[0].faces[1].control_points[1]", "(30 + 2)/2", 16),
    ):
        before = document.session
        enter(qtbot, forms, path, text)
        assert editor(forms, path).text() == f"{value}"
        assert not forms.refused and document.session is not before


def test_a_unit_that_was_typed_keeps_its_meaning_when_the_unit_changes(forms, document, qtbot):
    enter(qtbot, forms, "images[0].receiver.position[2]", "1 mm")  # within the lens
    choose(forms, "unit", "mm")
    enter(qtbot, forms, "elements[0].faces[1].height_range[1]", "-4.1")
    enter(qtbot, forms, "elements[0].min_thickness", "0")
    assert forms.refused and document.session.scene.receiver.z == 50
    choose(forms, "unit", "m")
    assert editor(forms, "images[0].receiver.position[2]").text() == "1 mm"


def test_a_refusal_stands_beside_its_field(forms, document, qtbot):
    session = document.session
    for path, text, reason in (
        ("images[0].receiver.position[2]", "far", "'far' is not a number"),
        ("images[0].receiver.position[2]", "0.1", "may touch the lens"),
        ("images[0].receiver.position[2]", "3 in - 0.62", "give both a unit"),
        ("run.seed", "3 mm", "'mm' is not known here; no unit"),
        ("elements[0].half_width[1]", "-1", "must be greater than 0"),
        ("elements[0].faces[1].control_points[0]", "3", "3 is too few for degree 3; at least 4"),
        ("elements[0].faces[1].control_points[0]", "6.5", "is not a whole number"),
        ("elements[0].faces[1].height_range[0]", "1", "low before high"),
        ("filter.size[0]", "4", "4 is even"),
        ("images[0].target.radius", "2", "at most 1"),
    ):
        enter(qtbot, forms, path, text)
        assert document.session is session
        assert editor(forms, path).text() == text  # as typed, until it is corrected
        field = field_row(forms, path)
        assert reason in field.refusal
        assert field._refusal.isVisible()
        assert forms.refused
        forms.revert_all()


def test_a_spectrum_is_typed_as_one_line_refused_and_left_out(forms, document, qtbot):
    field = row(forms, "source.spectrum").editor
    fill(qtbot, field, "0.45, 1; 0.6, 3")
    assert document.session.scene.source.spectrum == ((0.45, 1.0), (0.6, 3.0))
    fill(qtbot, field, "0.45, 0; 0.6, 0")
    assert "all parts of the flux are 0" in row(forms, "source.spectrum").refusal
    fill(qtbot, field, "")
    assert document.session.scene.source.spectrum is None
    assert not row(forms, "source.spectrum").refusal


def test_two_values_that_only_fit_together_are_taken_together(forms, document, qtbot):
    enter(qtbot, forms, "elements[0].faces[1].degree[0]", "7")
    assert "6 is too few for degree 7" in row(forms, "elements[0].faces[1].control_points").refusal
    assert "6 is too few for degree 7" in row(forms, "elements[0].faces[1].degree").refusal
    enter(qtbot, forms, "elements[0].faces[1].control_points[0]", "9")
    lens = document.session.scene.optic
    assert (lens.degree, lens.control_points) == ((7, 3), (9, 6))
    assert not forms.refused


def test_undo_shows_the_earlier_values_and_drops_what_was_refused(forms, document, qtbot):
    enter(qtbot, forms, "images[0].receiver.position[2]", "7")
    enter(qtbot, forms, "run.seed", "x")
    document.undo_stack.undo()
    assert editor(forms, "images[0].receiver.position[2]").text() == "5"
    assert editor(forms, "run.seed").text() == "0"
    assert not forms.refused


def test_the_wheel_changes_no_choice(forms, document):
    chooser = row(forms, "unit").chooser
    where, down = QPointF(5, 5), QPoint(0, -120)
    wheel = QWheelEvent(
        where,
        chooser.mapToGlobal(where),
        QPoint(),
        down,
        Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(chooser, wheel)
    assert chooser.currentData() == "cm"


def test_another_unit_converts_all_lengths(forms, document, qtbot):
    before = document.session
    choose(forms, "unit", "mm")
    scene = document.session.scene
    assert (scene.unit, scene.receiver.z, scene.optic.half_width) == ("mm", 50, (10, 10))
    assert scene == before.scene.in_unit("mm")
    assert document.session.target is before.target
    assert row(forms, "images[0].receiver.position")._unit.text() == "mm"
    assert editor(forms, "images[0].receiver.position[2]").text() == "50"
    assert document.undo_stack.undoText() == "change of unit"
    document.undo_stack.undo()
    assert document.session is before


def test_a_custom_index_begins_with_that_of_the_material_in_the_light(forms, document, qtbot):
    choose(forms, "elements[0].material", "N-BK7")
    assert document.session.scene.elements[0].material == "N-BK7"
    enter(qtbot, forms, "source.wavelength_um", "0.4861")
    assert row(forms, "elements[0].material")._unit.text() == "n = 1.52238"
    choose(forms, "elements[0].material", "index")
    assert document.session.scene.elements[0].material.index == pytest.approx(1.52238, abs=1e-5)
    assert row(forms, "elements[0].material.index").isVisible()


def test_an_image_is_chosen_from_a_dialog(forms, document, tmp_path):
    image = tmp_path / "target.png"
    Image.fromarray(np.eye(8, dtype=np.uint8) * 255).save(image)
    forms.file_asked.connect(lambda where: forms.choose_image(image, where))
    choose(forms, "images[0].target.builtin", "image")
    assert document.session.scene.target.image == str(image)
    assert row(forms, "images[0].target.image").editor.text() == str(image)


def test_a_picture_is_cropped_in_a_dialog_and_turned(forms, document, tmp_path, monkeypatch):
    image = tmp_path / "target.png"
    buttons = [b for b in forms.findChildren(QPushButton) if b.text() in ("Crop and tone…", "Turn")]
    assert not any(button.isVisible() for button in buttons)
    Image.fromarray(np.eye(8, dtype=np.uint8) * 255).save(image)
    forms.choose_image(image)

    def crop(dialog):
        dialog.view.show_crop((0.5, 0.25, 0.0, 0.0))
        dialog.histogram.moved.emit("gamma", 2.0)
        return True

    monkeypatch.setattr(PictureDialog, "exec", crop)
    for button in buttons:
        button.click()
    target = document.session.scene.target
    assert target.crop == (0.5, 0.25, 0.0, 0.0) and target.turn == "right"
    assert target.gamma == 2
    document.undo_stack.undo()
    document.undo_stack.undo()
    assert document.session.scene.target.crop == (0.0,) * 4
    assert not document.session.scene.target.has_levels


def test_a_file_that_is_no_image_is_refused_and_marks_no_field(forms, document, tmp_path):
    image, text = tmp_path / "target.png", tmp_path / "notes.txt"
    Image.fromarray(np.eye(8, dtype=np.uint8) * 255).save(image)
    text.write_text("no image")
    received = []
    forms.file_refused.connect(received.append)
    for count, first in enumerate((None, image)):
        if first is not None:
            forms.choose_image(first)
        forms.choose_image(text)
        assert "notes.txt" in received[count]
        assert not forms.refused and not any(each.refusal for each in rows(forms))
        assert document.undo_stack.count() == count
    assert row(forms, "images[0].target.image").editor.text() == str(image)


def test_edits_during_a_run_wait_for_its_end(forms, document, qtbot):
    session, received = document.session, []
    forms.postponed.connect(received.append)
    document.in_run = True
    enter(qtbot, forms, "images[0].receiver.position[2]", "7")
    choose(forms, "source.kind", "point")
    enter(qtbot, forms, "source.position[2]", "-9")  # a field of the source to come
    assert document.session is session
    assert (
        editor(forms, "images[0].receiver.position[2]").text() == "7" and forms.postponed_edits == 3
    )
    assert "change of receiver position" in received[0] and "source kind" in received[-1]
    document.in_run = False
    forms.make_postponed_edits()
    scene = document.session.scene
    assert (scene.receiver.z, scene.source.position[2]) == (7, -9)
    assert document.undo_stack.count() == 3 and forms.postponed_edits == 0


def test_everything_fits_into_its_narrowest_width(forms):
    forms.resize(forms.minimumWidth(), 700)
    for kind in ("point", "grid", "collimated"):
        choose(forms, "source.kind", kind)
        for field in filter(QWidget.isVisible, rows(forms)):
            right = field.mapTo(forms, QPoint(field.width(), 0)).x()
            assert right <= forms.viewport().width(), field.path


def test_another_source_stands_before_the_lens(forms, document):
    choose(forms, "source.kind", "point")
    source = document.session.scene.source
    assert (source.kind, source.position) == ("point", (0, 0, -5))
    choose(forms, "source.emission", "lambertian")
    choose(forms, "source.kind", "grid")
    source = document.session.scene.source
    assert (source.kind, source.position, source.half_width) == ("grid", (0, 0, -5), (0.5, 0.5))
    assert source.emission == "lambertian"  # what both have is kept
    choose(forms, "source.kind", "collimated")
    assert document.session.scene.source.kind == "collimated"
    assert document.undo_stack.undoText() == "change of source kind"


def test_each_source_has_its_fields_once(forms, document):
    choose(forms, "run.method", "paper")
    for kind in ("point", "grid", "collimated"):
        choose(forms, "source.kind", kind)
        source = document.session.scene.source
        shown = [each for each in rows(forms) if each.isVisible()]
        names = [each.path.split(".")[1] for each in shown if each.path.startswith("source.")]
        assert sorted(names) == sorted(type(source).model_fields)


def test_the_thumbnail_has_the_aspect_of_the_screen(forms, document):
    data, thumbnail = document.session.scene.to_data(), forms._target._thumbnail
    for half_width, pixels, aspect in (
        ([1, 1], [12, 10], 1),
        ([2, 1], [8, 8], 2),
        ([1, 4], [8, 8], 0.25),
    ):
        data["images"][0]["receiver"] |= {"half_width": half_width, "pixels": pixels}
        document.edit(Scene.from_data(data), "receiver", "receiver")
        place = thumbnail.place
        assert place.width() / place.height() == pytest.approx(aspect, rel=0.05)
        assert thumbnail.rect().contains(place)
        assert place.height() == thumbnail.height() or place.width() == thumbnail.width()


def test_the_height_range_is_automatic_or_a_persons_own(forms, document, qtbot):
    assert row(forms, "elements[0].faces[1].height_range").chooser.currentText() == "Own limits"
    choose(forms, "elements[0].faces[1].height_range", "automatic")
    assert document.session.scene.optic.height_range is None
    assert [
        each.isVisible() for each in rows(forms) if each.path == "elements[0].faces[1].height_range"
    ] == [
        True,
        False,  # no numbers
    ]
    choose(forms, "elements[0].faces[1].height_range", "own")
    assert document.session.scene.optic.height_range == (-0.3, 0.3)
    enter(qtbot, forms, "elements[0].faces[1].height_range[1]", "0.4")
    assert document.session.scene.optic.height_range == (-0.3, 0.4)
