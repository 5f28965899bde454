"""A run that cannot begin says which field is refused, until it is corrected."""

from tests.ui.hands import enter


def test_the_field_is_named_until_it_is_corrected(window, qtbot):
    begun = []
    enter(qtbot, window.forms, "screen.z", "0.1")
    window.early.begin(lambda: begun.append(1))
    assert window.messages.text.startswith("Screen at z: 0.1 may touch the lens")
    assert "Correct it, or press Esc" in window.messages.text and not begun
    enter(qtbot, window.forms, "screen.z", "6")
    assert window.messages.text == ""
    window.early.begin(lambda: begun.append(1))
    assert begun == [1]
