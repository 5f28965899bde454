"""Images in the form: listed, added, duplicated, moved, edited, refused, undone."""

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QListWidget, QToolButton

from tests.ui.hands import choose, enter, row
from ui.document.document import Document
from ui.panels.images import ImagesPanel


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
    return document.session.scene.images[1:]


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
    assert image.receiver.z > first.receiver.z
    assert image.target == first.target
    np.testing.assert_array_equal(image.wanted, document.session.target)
    first_line = "1.  z = 5, top hat, weight 1"
    assert listed(forms) == [first_line, f"2.  z = {image.receiver.z:.6g}, top hat, weight 1"]
    document.undo_stack.undo()
    assert listed(forms) == [first_line]
    assert not images(document)


def test_place_weight_and_target_of_the_chosen_image_are_edited(begin, qtbot):
    document, forms = begin()
    click(qtbot, forms, "Add")
    click(qtbot, forms, "Add")
    panel(forms).findChild(QListWidget).setCurrentRow(1)
    enter(qtbot, forms, "images[1].weight", "2.5")
    enter(qtbot, forms, "images[1].receiver.position[2]", "7")
    choose(forms, "images[1].target.builtin", "ball")
    one, two = images(document)
    assert (one.weight, one.receiver.z, one.target.builtin) == (2.5, 7.0, "ball")
    assert (two.weight, two.target.builtin) == (1.0, "tophat")
    assert not np.array_equal(one.wanted, two.wanted)


def test_an_image_may_be_in_the_far_field(begin, qtbot):
    document, forms = begin()
    click(qtbot, forms, "Add")
    choose(forms, "images[1].receiver.kind", "far_field")
    (image,) = images(document)
    assert image.receiver.called == "far field"


def test_images_are_moved_and_removed(begin, qtbot):
    document, forms = begin()
    click(qtbot, forms, "Add")
    click(qtbot, forms, "Add")
    near, far = images(document)
    click(qtbot, forms, "Up")
    assert images(document) == (far, near)
    click(qtbot, forms, "Remove")
    assert images(document) == (near,)


def test_another_image_can_become_the_first_one(begin, qtbot):
    document, forms = begin()
    click(qtbot, forms, "Add")
    choose(forms, "images[1].target.builtin", "ball")
    near, far = document.session.scene.images
    ball = far.wanted
    click(qtbot, forms, "Up")
    scene = document.session.scene
    assert (scene.target.builtin, scene.receiver.z) == ("ball", far.receiver.z)
    np.testing.assert_array_equal(document.session.target, ball)
    click(qtbot, forms, "Remove")
    (only,) = document.session.scene.images
    assert (only.target, only.receiver) == (near.target, near.receiver)
    document.undo_stack.undo()
    document.undo_stack.undo()
    assert document.session.scene.images == (near, far)


def test_the_weight_of_the_first_image_counts_beside_others(begin, qtbot):
    document, forms = begin()
    assert not row(forms, "images[0].weight", visible=False).isVisible()
    click(qtbot, forms, "Duplicate")
    first, second = document.session.scene.images
    assert first == second
    panel(forms).findChild(QListWidget).setCurrentRow(0)
    enter(qtbot, forms, "images[0].weight", "3")
    assert [image.weight for image in document.session.scene.images] == [3.0, 1.0]


def test_the_last_image_cannot_be_removed(begin, qtbot):
    document, forms = begin()
    click(qtbot, forms, "Remove")
    assert len(document.session.scene.images) == 1
    assert "at least 1" in row(forms, "images").refusal
