"""The picture that a design keeps of its target: without its file, and beside a changed one."""

import numpy as np
import pytest
from PIL import Image
from PySide6.QtCore import Qt

from tests.ui.hands import enter, row
from workbench.design import picture
from workbench.design.task import begin
from workbench.files.session import write_session

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
    enter(qtbot, window.forms, "target.padding", "0.2")
    enter(qtbot, window.forms, "target.blur", "1")
    session = window.document.session
    assert (session.scene.target.padding, session.scene.target.blur) == (0.2, 1)
    assert session.target.sum() < before.sum() and not window.forms.refused


def test_what_a_picture_says_of_itself_is_mentioned(window, make_scene, tmp_path):
    Image.fromarray(np.kron(LETTER, np.ones((1, 3000), np.uint8))).save(tmp_path / "wide.png")
    (tmp_path / "scene.json").write_text(make_scene({"target": {"image": "wide.png"}}).to_json())
    assert window.files.open(tmp_path / "scene.json")
    assert "wide.png' has 9000 × 3 pixels and is reduced to 4500 × 2" in window.messages.text


def test_a_changed_file_is_read_again_on_request(window, saved, image, qtbot):
    Image.fromarray(255 - LETTER).save(image)
    assert window.files.open(saved)
    before = window.document.session
    assert "letter.png has changed. The design keeps" in window.messages.text
    qtbot.mouseClick(window.messages.buttons[0], Qt.MouseButton.LeftButton)
    after = window.document.session
    assert after.scene == before.scene
    assert after.picture == image.read_bytes()
    assert np.abs(after.target - before.target).max() > 0.9
    assert window.messages.text == ""
    window.document.undo_stack.undo()
    assert window.document.session is before


def test_a_changed_file_is_reported_at_the_next_edit_of_the_target(window, saved, image, qtbot):
    window.files.open(saved)
    Image.fromarray(255 - LETTER).save(image)
    enter(qtbot, window.forms, "screen.z", "7")
    assert window.messages.text == ""
    enter(qtbot, window.forms, "target.padding", "0.2")
    assert "letter.png has changed" in window.messages.text


def test_the_same_image_chosen_again_is_read_again(window, saved, image):
    window.files.open(saved)
    before = window.document.session
    Image.fromarray(255 - LETTER).save(image)
    window.forms.choose_image(image)
    assert window.document.session.picture == image.read_bytes() != before.picture
    image.unlink()
    window.forms.choose_image(image)
    assert "is not an existing file" in row(window.forms, "target.image").refusal


def test_an_image_too_large_to_keep_is_reported(window, image, monkeypatch):
    monkeypatch.setattr(picture, "LARGEST_PICTURE", image.stat().st_size - 1)
    window.forms.choose_image(image)
    assert window.document.session.picture is None
    assert "does not keep" in window.messages.text and str(image) in window.messages.text
