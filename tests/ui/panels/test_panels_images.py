"""Further images in the form: listed, added, moved, edited, refused, undone."""

import numpy as np
import pytest
from PIL import Image
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QListWidget, QToolButton

from tests.ui.hands import choose, enter, field_row, rows
from ui.document.document import Document
from ui.panels.images import ImagesPanel
from ui.panels.target import is_image_file, of_image
from workbench.scene import BallTarget, FurtherImage


@pytest.fixture
def begin(make_session, open_forms):
    """Opens the forms of a scene."""

    def opened_with(changes=None):
        document = Document(make_session(changes or {}), "imaged")
        forms = open_forms(document)
        document.setParent(forms)
        return document, forms

    return opened_with


def images(document):
    return document.session.scene.further_images


def panel(forms):
    return forms.findChild(ImagesPanel)


def click(qtbot, forms, text):
    button = next(b for b in panel(forms).findChildren(QToolButton) if b.text() == text)
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)


def listed(forms):
    found = panel(forms).findChild(QListWidget)
    return [found.item(at).text() for at in range(found.count())]


def test_an_image_is_added_farther_away_and_its_target_is_drawn(begin, qtbot):
    document, forms = begin()
    first = document.session.scene
    click(qtbot, forms, "Add")
    (image,) = images(document)
    assert image.screen.z > first.receiver.z
    assert image.target == first.target
    np.testing.assert_array_equal(image.wanted, document.session.target)
    assert listed(forms) == [f"1.  z = {image.screen.z:.6g}, top hat, weight 1"]
    document.undo_stack.undo()
    assert listed(forms) == []
    assert not images(document)


def test_an_image_added_during_a_run_is_shown_and_waits_for_its_end(begin, qtbot):
    document, forms = begin({"lens.control_points": "auto"})
    forms.set_running(True)
    click(qtbot, forms, "Add")
    assert not images(document) and len(listed(forms)) == 1
    forms.set_running(False)
    forms.make_postponed_edits()
    (image,) = images(document)
    np.testing.assert_array_equal(image.wanted, document.session.target)


def test_place_weight_and_target_of_the_chosen_image_are_edited(begin, qtbot):
    document, forms = begin()
    click(qtbot, forms, "Add")
    click(qtbot, forms, "Add")
    panel(forms).findChild(QListWidget).setCurrentRow(0)
    enter(qtbot, forms, "further_images[0].weight", "2.5")
    enter(qtbot, forms, "further_images[0].screen.z", "7")
    choose(forms, "further_images[0].target.builtin", "ball")
    one, two = images(document)
    assert (one.weight, one.receiver.z, one.target.builtin) == (2.5, 7.0, "ball")
    assert (two.weight, two.target.builtin) == (1.0, "tophat")
    assert not np.array_equal(one.wanted, two.wanted)


def test_the_form_has_a_row_for_every_field_of_an_image(begin, qtbot):
    _, forms = begin()
    click(qtbot, forms, "Add")
    shown = {each.path for each in rows(forms)}
    wanted = {"further_images[0].weight", "further_images[0].screen"}
    for field in FurtherImage.fields():
        for kind in field.parts:
            wanted |= {f"further_images[0].{field.name}.{own.name}" for own in kind.fields()}
    assert wanted - shown == set()


def test_an_image_may_be_in_the_far_field(begin, qtbot):
    document, forms = begin()
    click(qtbot, forms, "Add")
    choose(forms, "further_images[0].screen", "far_field")
    (image,) = images(document)
    assert image.screen is None
    assert image.receiver.called == "far field"


def test_an_impossible_place_is_refused_beside_its_field(begin, qtbot):
    document, forms = begin()
    click(qtbot, forms, "Add")
    before = images(document)
    enter(qtbot, forms, "further_images[0].screen.z", "0.1")
    assert "may touch the lens" in field_row(forms, "further_images[0].screen.z").refusal
    assert images(document) == before


def test_images_are_moved_and_removed(begin, qtbot):
    document, forms = begin()
    click(qtbot, forms, "Add")
    click(qtbot, forms, "Add")
    near, far = images(document)
    click(qtbot, forms, "Up")
    assert images(document) == (far, near)
    click(qtbot, forms, "Remove")
    assert images(document) == (near,)


def test_a_chosen_file_is_for_the_panel_that_asked(begin, qtbot, tmp_path):
    document, forms = begin()
    click(qtbot, forms, "Add")
    np.save(tmp_path / "wanted.npy", np.eye(8) + 0.1)
    forms.image_asked.connect(lambda: forms.choose_image(tmp_path / "wanted.npy"))
    choose(forms, "further_images[0].target.builtin", "image")
    assert images(document)[0].target.file == str(tmp_path / "wanted.npy")
    assert document.session.scene.target.file is None
    forms.choose_image(tmp_path / "wanted.npy")  # dropped on the window
    assert document.session.scene.target.file == str(tmp_path / "wanted.npy")


def test_a_picture_of_a_further_image_counts_as_a_monitor_shows_it(begin, qtbot, tmp_path):
    document, forms = begin()
    click(qtbot, forms, "Add")
    Image.fromarray(np.full((8, 8), 90, np.uint8)).save(tmp_path / "wanted.png")
    forms.image_asked.connect(lambda: forms.choose_image(tmp_path / "wanted.png"))
    choose(forms, "further_images[0].target.builtin", "image")
    assert images(document)[0].target.tone == "srgb"


@pytest.mark.parametrize(
    ("name", "tone"),
    [("a.EXR", "linear"), ("a.hdr", "linear"), ("a.npy", "linear"), ("a.heic", "srgb")],
)
def test_files_of_light_are_taken_as_stored(tmp_path, name, tone):
    assert of_image(tmp_path / name, BallTarget())["tone"] == tone
    assert is_image_file(tmp_path / name)
