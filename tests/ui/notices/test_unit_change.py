"""What becomes of a designed lens when the unit changes, and the offer to keep the numbers."""

import pytest
from PySide6.QtCore import Qt

from tests.ui.hands import choose


@pytest.fixture
def window(open_window, designed):
    return open_window(designed)


def test_the_lens_is_converted_and_stays_the_result(window, designed):
    choose(window.forms, "unit", "mm")
    session = window.document.session
    assert session.scene.receiver.z == 50
    assert session.result.state.heights["lens.back"] == pytest.approx(
        10 * designed.result.state.heights["lens.back"]
    )
    assert session.result.state.loss == designed.result.state.loss
    assert window.messages.text == "All lengths were converted: 1 cm = 10 mm."
    window.document.undo_stack.undo()
    assert window.document.session is designed
    assert window.messages.text == ""


def test_the_numbers_are_kept_on_request(window, designed, qtbot):
    choose(window.forms, "unit", "mm")
    qtbot.mouseClick(window.messages.buttons[0], Qt.MouseButton.LeftButton)
    session = window.document.session
    assert (session.scene.unit, session.scene.receiver.z) == ("mm", 5)
    assert session.result is designed.result  # the same numbers are the same task
    assert window.messages.text == ""
    window.document.undo_stack.undo()
    assert window.document.session.scene.receiver.z == 50
    window.document.undo_stack.undo()
    assert window.document.session is designed
