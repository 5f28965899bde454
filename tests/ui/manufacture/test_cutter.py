"""How a face is cut, asked in the window."""

import pytest
from PySide6.QtCore import Qt, QTimer
from PySide6.QtWidgets import QApplication, QPushButton

from tests.ui.hands import fill
from ui.manufacture.cutter import AskCutting, CutterDialog
from workbench.files.export.cutting import PLAIN, Cutting


@pytest.fixture
def dialog(designed, qtbot, window):
    found = CutterDialog(designed, PLAIN, window)
    qtbot.addWidget(found)
    with qtbot.waitExposed(found):
        found.show()
    yield found
    found.reject()


def answer(act):
    """Do something to the dialog that is about to open."""

    def now():
        act(next(w for w in QApplication.topLevelWidgets() if isinstance(w, CutterDialog)))

    QTimer.singleShot(300, now)


def test_empty_fields_leave_it_to_the_program(dialog):
    assert dialog.cutting() == PLAIN


def test_fields_take_units(dialog, qtbot):
    fill(qtbot, dialog.fields["tool_radius"], "1.5 mm", key=None)  # the scene is in cm
    fill(qtbot, dialog.fields["scallop"], "20 µm", key=None)
    fill(qtbot, dialog.fields["feed"], "900", key=None)
    dialog.mould.click()
    assert dialog.cutting() == Cutting(0.15, 0.002, feed=900.0, negative=True)


@pytest.mark.parametrize(
    ("name", "text", "why"),
    [("tool_radius", "0", "above 0"), ("rim", "-1", "above 0"), ("feed", "x", "not a number")],
)
def test_impossible_input_is_reported_and_the_dialog_stays(dialog, qtbot, name, text, why):
    fill(qtbot, dialog.fields[name], text, key=None)
    dialog.write.click()
    assert why in dialog.found.text() and dialog.isVisible()


def test_ridges_and_both_errors_are_shown(dialog, qtbot, monkeypatch):
    monkeypatch.setattr("ui.manufacture.cutter.RAYS", 20_000)
    fill(qtbot, dialog.fields["tool_radius"], "0.2", key=None)
    fill(qtbot, dialog.fields["scallop"], "0.002", key=None)
    dialog.look.click()
    assert not dialog.look.isEnabled()
    qtbot.waitUntil(dialog.look.isEnabled)
    assert "Radius 0.2 cm" in dialog.found.text()
    assert "Nothing is cut too deep; up to 0.0019 cm of material is left" in dialog.found.text()
    assert "Error as cut" in dialog.found.text() and "as designed" in dialog.found.text()


def test_the_keyboard_is_back_at_the_button_after_a_simulation(dialog, qtbot, monkeypatch):
    monkeypatch.setattr("ui.manufacture.cutter.RAYS", 20_000)
    fill(qtbot, dialog.fields["scallop"], "0.002", key=None)
    with qtbot.waitActive(dialog):
        dialog.activateWindow()
    dialog.look.setFocus()
    qtbot.waitUntil(dialog.look.hasFocus)
    qtbot.keyClick(dialog.look, Qt.Key.Key_Space)
    assert not dialog.look.hasFocus()
    qtbot.waitUntil(dialog.look.isEnabled)
    assert dialog.look.hasFocus()


def test_closing_leaves_the_trace_of_a_cut(dialog, qtbot, monkeypatch):
    begun, left = [], []

    def endless(*_):
        begun.append(True)
        try:
            while True:
                yield 0.0
        finally:
            left.append(True)

    monkeypatch.setattr("workbench.analysis.cut_lens.tracing_cut", endless)
    fill(qtbot, dialog.fields["scallop"], "0.002", key=None)
    dialog.look.click()
    qtbot.waitUntil(lambda: bool(begun) and "Tracing" in dialog.found.text())
    dialog.reject()  # waits for the thread
    assert left and not dialog._background.running


def test_the_last_answer_is_what_the_next_begins_with(designed, window):
    ask = AskCutting(window)
    answer(lambda dialog: (dialog.fields["tool_radius"].setText("0.3"), dialog._accept()))
    assert ask(designed) == Cutting(0.3)
    answer(lambda dialog: dialog.reject())
    assert ask(designed) is None
    answer(lambda dialog: dialog._accept())
    assert ask(designed) == Cutting(0.3)


def test_the_pane_and_the_menu_lead_to_g_code(display, open_window, designed, qtbot, tmp_path):
    window = open_window(designed)
    window.build()
    written = tmp_path / "lens.nc"
    window.exporter._dialogs.to_save = lambda *_: written
    window.workspace.show_dock("manufacture")
    pane = window.loaded.production.manufacture
    answer(lambda dialog: (dialog.fields["tool_radius"].setText("0.3"), dialog._accept()))
    button = next(b for b in pane.findChildren(QPushButton) if b.text() == "Ball cutter…")
    button.click()
    qtbot.waitUntil(lambda: not window.exporter._background.busy)
    assert "ball cutter of radius 3.0000" in written.read_text()
    assert str(written) in window.messages.text
    assert window.commands["cut"].isEnabled()
