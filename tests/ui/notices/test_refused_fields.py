"""A run that cannot begin says which field is refused, until it is corrected."""

from PySide6.QtCore import Qt

from tests.ui.hands import editor, enter


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


def test_next_refused_field_is_named_after_a_correction(window, qtbot):
    enter(qtbot, window.forms, "images[0].receiver.position[2]", "far")
    enter(qtbot, window.forms, "run.seed", "x")
    window.early.begin(lambda: None)
    assert window.messages.text.startswith("Receiver position: 'far' is not a number")
    assert "(1 more refused)" in window.messages.text
    enter(qtbot, window.forms, "images[0].receiver.position[2]", "6")
    assert window.messages.text.startswith("Run seed: 'x' is not a number")
    qtbot.keyClick(editor(window.forms, "run.seed"), Qt.Key.Key_Escape)
    assert window.messages.text == ""
