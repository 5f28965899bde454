"""Further images in the form: listed, added, moved, edited, refused, undone."""

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QListWidget, QToolButton

from tests.ui.hands import choose, enter
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
