"""Elements in the form: listed, added, duplicated, moved, edited, refused, undone."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QListWidget, QToolButton

from tests.ui.hands import choose, enter, field_row, fill, row, rows
from ui.document.document import Document
from ui.panels.elements import ElementsPanel
from ui.panels.fields import Row
from workbench.files.session import Session
from workbench.scene import Lens, Mirror, Scene


@pytest.fixture
def begin(make_session, open_forms):
    """Opens the forms of a scene."""

    def opened_with(changes=None):
        document = Document(make_session(changes or {}), "train")
        forms = open_forms(document)
        document.setParent(forms)
        return document, forms

    return opened_with


def mirrored(**parts):
    return Scene.from_data(
        {
            **parts,
            "mirror": {"half_width": [1.0, 1.0], "control_points": [8, 8]},
            "source": {"kind": "collimated"},
            "screen": {"z": -5.0, "half_width": [1.0, 1.0], "pixels": [16, 16]},
            "target": {"builtin": "tophat"},
        }
    )


@pytest.fixture
def begin_mirror(open_forms, session):
    """Opens the forms of a scene with a mirror."""

    def opened_with(**parts):
        document = Document(Session(mirrored(**parts), session.target[:16, :16] + 1.0), "mirror")
        forms = open_forms(document)
        document.setParent(forms)
        return document, forms

    return opened_with


def panel(forms):
    return forms.findChild(ElementsPanel)


def test_a_part_is_shown_with_its_first_field_marked(make_session, open_forms, qtbot):
    data = make_session({}).scene.to_data()
    second = data["elements"][0] | {"name": "plate", "position": [0, 0, 2], "thickness": 0.2}
    second |= {"faces": [{"shape": "plane"}, {"shape": "plane"}], "min_thickness": 0.1}
    session = make_session({})
    scene = Scene.from_data(data | {"elements": [data["elements"][0], second]})
    forms = open_forms(Document(Session(scene, session.target), "train"))
    panel(forms).unfold(False)
    forms.search.setText("no such field")
    for part in ("elements[1]", "elements[0]", "images[0].receiver"):
        forms.show_part(part)
        first = QApplication.focusWidget()
        while not isinstance(first, Row):
            first = first.parentWidget()
        assert first.path.startswith(f"{part}.") and not first.visibleRegion().isEmpty()
        assert first.label.property("marked")
        qtbot.waitUntil(lambda row=first: not row.label.property("marked"))
    assert panel(forms).current == 0


def click(qtbot, forms, text):
    button = next(b for b in panel(forms).findChildren(QToolButton) if b.text() == text)
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)


def the_list(forms):
    return panel(forms).findChild(QListWidget)


def listed(forms):
    found = the_list(forms)
    return [found.item(at).text() for at in range(found.count())]


def elements(document):
    return document.session.scene.elements


def names(document):
    return [element.name for element in elements(document)]


def test_a_lens_of_fixed_shape_is_added_behind_the_others(begin, qtbot):
    document, forms = begin()
    (first,) = elements(document)
    click(qtbot, forms, "Add lens")
    assert elements(document)[0] == first
    added = elements(document)[1]
    assert (added.name, added.half_width, added.designed) == ("lens-2", first.half_width, False)
    assert [face.shape for face in added.faces] == ["plane", "conic"]
    assert added.position[2] > first.position[2] + first.thickness
    assert listed(forms) == [
        "1.  lens, designed, z = 0 cm",
        f"2.  lens-2: lens, z = {added.position[2]:g} cm",
    ]
    assert document.session.scene.designed_number == 0
    document.undo_stack.undo()
    assert elements(document) == (first,)


def test_the_added_lens_is_chosen_and_its_faces_are_edited(begin, qtbot):
    document, forms = begin()
    click(qtbot, forms, "Add lens")
    enter(qtbot, forms, "elements[1].faces[1].radius", "-8")
    fill(qtbot, row(forms, "elements[1].faces[1].coefficients").editor, "0.001; -2e-5")
    choose(forms, "elements[1].faces[0].shape", "conic")
    front, back = elements(document)[1].faces
    assert (back.radius, back.coefficients) == (-8.0, (0.001, -2e-5))
    assert document.undo_stack.undoText() == "change of lens-2 front face"
    assert front.radius > 10
    assert row(forms, "elements[1].faces[1].coefficients").editor.text() == "0.001; -2e-05"
    fill(qtbot, row(forms, "elements[1].faces[1].coefficients").editor, "")
    assert elements(document)[1].faces[1].coefficients == ()


def test_a_diffuser_is_added_and_its_scatter_chosen(begin, qtbot):
    document, forms = begin()
    click(qtbot, forms, "Add diffuser")
    added = elements(document)[1]
    assert (added.kind, added.half_width) == ("diffuser", elements(document)[0].half_width)
    enter(qtbot, forms, "elements[1].scatter.sigma", "8")
    assert elements(document)[1].scatter.sigma == 8
    choose(forms, "elements[1].scatter.kind", "lambertian")
    assert elements(document)[1].scatter.kind == "lambertian"
    choose(forms, "elements[1].scatter.kind", "gaussian")
    assert elements(document)[1].scatter.sigma == 5
    click(qtbot, forms, "Add lens")
    assert "behind the diffuser" in row(forms, "elements").refusal


def test_an_element_that_no_train_can_have_is_refused_below_the_list(begin, qtbot):
    document, forms = begin()
    click(qtbot, forms, "Add mirror")
    assert names(document) == ["lens"]
    assert "may touch the element mirror" in row(forms, "elements").refusal
    assert forms.revert_latest()
    click(qtbot, forms, "Add lens")
    assert names(document) == ["lens", "lens-2"] and not forms.refused


def test_a_duplicate_stands_behind_the_last_element_under_another_name(begin, qtbot):
    document, forms = begin()
    click(qtbot, forms, "Add lens")
    enter(qtbot, forms, "elements[1].thickness", "0.75")
    click(qtbot, forms, "Duplicate")
    _, original, copy = elements(document)
    assert names(document) == ["lens", "lens-2", "lens-3"]
    assert (copy.thickness, copy.faces) == (original.thickness, original.faces)
    assert copy.position[2] >= original.position[2] + 0.75
    assert the_list(forms).currentRow() == 2
    assert document.undo_stack.undoText() == "copy of element 2"


def test_elements_are_moved_and_removed(begin, qtbot):
    document, forms = begin()
    click(qtbot, forms, "Add lens")
    before = elements(document)
    click(qtbot, forms, "Up")
    assert not forms.refused
    assert names(document) == ["lens-2", "lens"]
    assert document.session.scene.designed_number == 1
    assert elements(document)[0].front_z == before[0].front_z
    assert elements(document)[1].highest == pytest.approx(before[1].highest)
    assert the_list(forms).currentRow() == 0
    enter(qtbot, forms, "elements[0].thickness", "0.4")
    assert elements(document)[0].thickness == 0.4
    document.undo_stack.undo()
    document.undo_stack.undo()
    assert names(document) == ["lens", "lens-2"]
    assert the_list(forms).currentRow() == 1  # the same element is chosen
    click(qtbot, forms, "Remove")
    assert names(document) == ["lens"]
    assert the_list(forms).currentRow() == 0


def test_the_element_that_is_designed_is_chosen_at_first(make_scene, session, open_forms):
    scene = make_scene()
    dome = Lens(
        kind="lens",
        name="dome",
        position=(0.0, 0.0, -3.0),
        half_width=(1.0, 1.0),
        material="PMMA",
        thickness=1.0,
        faces=({"shape": "plane"}, {"shape": "plane"}),
    )
    scene = scene.model_copy(update={"elements": (dome, *scene.elements)})
    document = Document(Session(scene, session.target), "dome")
    forms = open_forms(document)
    document.setParent(forms)
    assert the_list(forms).currentRow() == 1
    assert field_row(forms, "elements[1].thickness").isVisible()


def test_the_last_designed_face_stays(begin, qtbot):
    document, forms = begin()
    before = elements(document)
    choose(forms, "elements[0].faces[1].shape", "plane")
    assert "no face is designed" in row(forms, "elements[0].faces[1].shape").refusal
    forms.revert_all()
    choose(forms, "elements[0].faces[0].shape", "bspline")
    choose(forms, "elements[0].faces[1].shape", "conic")
    assert "needs a B-spline back face" in row(forms, "elements[0].faces[1].shape").refusal
    assert elements(document)[0].faces[1] == before[0].faces[1]


def test_a_name_is_unique_and_has_no_spaces(begin, qtbot):
    document, forms = begin()
    click(qtbot, forms, "Add lens")
    name = row(forms, "elements[1].name")
    fill(qtbot, name.editor, "lens")
    assert "is the name of another element" in name.refusal
    fill(qtbot, name.editor, "a b")
    assert "letters, digits, - and _" in name.refusal
    fill(qtbot, name.editor, "dome")
    assert names(document) == ["lens", "dome"]
    assert row(forms, "elements[1].half_width").name == "Dome size"


def test_rows_of_both_faces_have_names_of_their_own(begin):
    _, forms = begin({"lens.entrance": {"shape": "freeform"}})
    row(forms, "elements[0].tilt")
    shown = [
        each.name for each in rows(forms) if each.path.startswith("elements") and each.isVisible()
    ]
    assert "Lens front face degree" in shown and "Lens back face degree" in shown
    assert len(shown) == len(set(shown))


def test_a_lens_becomes_a_mirror_where_the_receiver_lets_it(begin, qtbot):
    document, forms = begin()
    face = elements(document)[0].faces[1]
    choose(forms, "elements[0].kind", "mirror")
    assert "may touch the mirror" in row(forms, "images[0].receiver.position").refusal
    enter(qtbot, forms, "images[0].receiver.position[2]", "-6")
    (mirror,) = elements(document)
    assert isinstance(mirror, Mirror)
    assert (mirror.name, mirror.half_width, mirror.face) == ("lens", (1.0, 1.0), face)
    assert not forms.refused


def test_a_scene_with_a_mirror_shows_its_fields(begin_mirror):
    _, forms = begin_mirror()
    assert listed(forms) == ["1.  mirror, designed, z = 0 mm"]
    assert row(forms, "elements[0].reflectance").isVisible()
    assert row(forms, "elements[0].face.shape").chooser.currentText() == "B-spline"
    assert not row(forms, "elements[0].material", visible=False).isVisible()


def test_a_stage_without_a_net_of_its_own_shows_that_of_the_mirror(begin_mirror):
    _, forms = begin_mirror(run={"iterations": 9, "stages": [{"iterations": 3}]})
    net = row(forms, "run.stages[0].control_points").editors.values()
    assert [(e.text(), e.placeholderText()) for e in net] == [("", "8"), ("", "8")]


def test_control_heights_of_a_file_are_asked_for_with_fixed_faces(begin, qtbot):
    document, forms = begin()
    choose(forms, "elements[0].faces[0].shape", "bspline")
    assert not row(forms, "elements[0].faces[0].heights", visible=False).isVisible()
    row(forms, "elements[0].faces[0].fixed").box.click()
    assert elements(document)[0].faces[0].fixed
    assert row(forms, "elements[0].faces[0].heights").isVisible()


def test_a_choice_for_a_part_that_went_while_its_list_was_open_is_left_out(begin):
    document, forms = begin()
    choose(forms, "elements[0].faces[0].shape", "bspline")
    kinds = row(forms, "elements[0].faces[0].base.shape").chooser
    document.undo_stack.undo()
    before = document.session.scene
    kinds.setCurrentIndex(kinds.findData("sphere"))
    kinds.activated.emit(kinds.currentIndex())
    assert document.session.scene == before and not document.undo_stack.canUndo()
