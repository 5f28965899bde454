"""Notices of the window: refused fields, and the picture that a design keeps."""

import numpy as np
import pytest
from PIL import Image
from PySide6.QtCore import Qt

from tests.ui.hands import enter, row
from workbench.design.task import begin
from workbench.files.session import write_session


def test_the_field_is_named_until_it_is_corrected(window, qtbot):
    begun = []
    enter(qtbot, window.forms, "images[0].receiver.position[2]", "0.1")
    window.early.begin(lambda: begun.append(1))
    assert window.messages.text.startswith("Receiver position: 0.1 may touch the lens")
    assert "Correct it, or press Esc" in window.messages.text and not begun
    enter(qtbot, window.forms, "images[0].receiver.position[2]", "6")
    assert window.messages.text == ""
    window.early.begin(lambda: begun.append(1))
    assert begun == [1]


LETTER = np.array([[255, 255, 0], [255, 0, 0], [255, 0, 0]], dtype=np.uint8)


@pytest.fixture
def image(tmp_path):
    path = tmp_path / "letter.png"
    Image.fromarray(LETTER).save(path)
    return path


@pytest.fixture
def saved(make_scene, image, tmp_path):
    """A saved design of that image."""
    path = tmp_path / "letter.freeform"
    write_session(begin(make_scene({"target": {"image": str(image)}}), tmp_path), path)
    return path


def test_a_design_with_a_missing_image_can_be_padded_and_blurred(window, saved, image, qtbot):
    image.unlink()
    assert window.files.open(saved)
    assert window.messages.text == ""
    before = window.document.session.target
    enter(qtbot, window.forms, "images[0].target.padding", "0.2")
    enter(qtbot, window.forms, "images[0].target.blur", "1")
    session = window.document.session
    assert (session.scene.target.padding, session.scene.target.blur) == (0.2, 1)
    assert session.target.sum() < before.sum() and not window.forms.refused


def test_a_changed_file_is_read_again_on_request(window, saved, image, qtbot):
    Image.fromarray(255 - LETTER).save(image)
    assert window.files.open(saved)
    before = window.document.session
    assert "letter.png has changed on disk. The design keeps" in window.messages.text
    qtbot.mouseClick(window.messages.buttons[0], Qt.MouseButton.LeftButton)
    after = window.document.session
    assert after.scene == before.scene
    assert after.picture == image.read_bytes()
    assert np.abs(after.target - before.target).max() > 0.9
    assert window.messages.text == ""
    window.document.undo_stack.undo()
    assert window.document.session is before


def test_the_same_image_chosen_again_is_read_again(window, saved, image):
    window.files.open(saved)
    before = window.document.session
    Image.fromarray(255 - LETTER).save(image)
    window.forms.choose_image(image)
    assert window.document.session.picture == image.read_bytes() != before.picture
    image.unlink()
    window.forms.choose_image(image)
    assert "is not an existing file" in row(window.forms, "images[0].target.image").refusal
