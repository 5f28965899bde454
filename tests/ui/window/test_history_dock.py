"""The list of steps: by mouse and keyboard, also when there are a thousand."""

from PySide6.QtCore import Qt

from tests.ui.hands import move_screen
from ui.document.undo_steps import UndoSteps

STEPS = 300


def test_hundreds_of_steps_are_listed_and_gone_through_by_keyboard(window, qtbot, monkeypatch):
    # Neither forms that show each of them nor the account of memory are tried here.
    window.document.blockSignals(True)
    monkeypatch.setattr(UndoSteps, "_forget_oldest", lambda self: None)
    for number in range(STEPS):
        move_screen(window.document, 6 + number, f"screen at {6 + number}")
    window.document.blockSignals(False)
    window.commands["go_history"].trigger()
    history, document = window.workspace.history, window.document
    qtbot.waitUntil(history.hasFocus)
    assert history.model().rowCount() == STEPS + 1  # and the beginning
    assert history.currentIndex().row() == STEPS
    qtbot.waitUntil(lambda: history.visualRect(history.currentIndex()).isValid())
    assert history.viewport().rect().intersects(history.visualRect(history.currentIndex()))
    qtbot.keyClick(history, Qt.Key.Key_Up)
    assert document.session.scene.receiver.z == 6 + STEPS - 2
    qtbot.keyClick(history, Qt.Key.Key_Home)
    assert document.session.scene.receiver.z == 5 and history.currentIndex().row() == 0
    qtbot.keyClick(history, Qt.Key.Key_End)
    assert document.session.scene.receiver.z == 6 + STEPS - 1
