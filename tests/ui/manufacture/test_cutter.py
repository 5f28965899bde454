"""How a face is cut, asked in the window, with the verdict before anything is written."""

import threading
from functools import partial
from pathlib import Path

import pytest
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication, QToolButton

from tests.ui.hands import fill
from ui.manufacture.cutter import CutterDialog, ask_options
from ui.manufacture.option_fields import OptionDialog, OptionFields, keep_options
from workbench.files.export.formats import GCODE, format_of
from workbench.files.export.options import PLAIN, Chosen, Cutting, Drawing

COARSE = Cutting(tool_radius=0.2, scallop=0.002)


@pytest.fixture
def open_dialog(designed, qtbot, window):
    shown = []

    def make(cutting=COARSE):
        found = CutterDialog(designed, cutting, window)
        shown.append(found)
        qtbot.addWidget(found)
        with qtbot.waitExposed(found):
            found.show()
        return found

    yield make
    for each in shown:
        each.reject()


@pytest.fixture
def dialog(open_dialog):
    return open_dialog()


@pytest.fixture
def fields(qtbot):
    found = OptionFields("cm", PLAIN)
    qtbot.addWidget(found)
    found.show()
    return found


@pytest.fixture
def held(monkeypatch):
    """Plans that do not end, and what becomes of them."""
    left = threading.Event()

    def endless(*_):
        try:
            while True:
                yield 0.4
        finally:
            left.set()

    monkeypatch.setattr("workbench.files.export.cut_plan.planning", endless)
    return left


def answer(act, when=lambda dialog: True, kind=CutterDialog):
    """Do something to the dialog that is about to open, as soon as it is ready for that."""

    def now():
        shown = [w for w in QApplication.topLevelWidgets() if isinstance(w, kind)]
        if shown and shown[-1].isVisible() and when(shown[-1]):
            act(shown[-1])
        else:
            QTimer.singleShot(50, now)

    QTimer.singleShot(50, now)


def fits(dialog):
    return dialog.write.isEnabled()


def enter(qtbot, fields, name, text):
    """Type into a field; gives its row."""
    row = fields.row(name)
    fill(qtbot, row.editors[name], text)
    return row


class TestFields:
    def test_they_take_units(self, fields, qtbot):
        for name, text in (
            ("tool_radius", "1.5 mm"),
            ("scallop", "20 µm"),
            ("feed", "900"),
            ("plunge_feed", "90"),
            ("spindle_speed", "12000"),
            ("dwell", "2.5"),
        ):
            enter(qtbot, fields, name, text)
        fields.row("negative").box.click()
        assert fields.options == Cutting(
            tool_radius=0.15,
            scallop=0.002,
            feed=900,
            plunge_feed=90,
            spindle_speed=12_000,
            dwell=2.5,
            negative=True,
        )

    def test_an_empty_field_is_the_default(self, fields, qtbot):
        for name in ("tool_radius", "feed"):
            enter(qtbot, fields, name, "7")
            enter(qtbot, fields, name, "")
        assert fields.options == PLAIN
        placeholders = [fields.row(n).editors[n].placeholderText() for n in ("scallop", "feed")]
        assert placeholders == ["automatic", "600"]

    def test_impossible_input_is_refused_with_what_is_allowed(self, fields, qtbot):
        for name, text, why in (
            ("rim", "-1", "-1; a length of 0 or more"),
            ("feed", "x", "'x' is not a number"),
            ("spindle_speed", "0", "0 rpm; from 1 to 200,000 rpm"),
        ):
            row = enter(qtbot, fields, name, text)
            assert why in row.refusal and fields.refused and fields.options == PLAIN


def test_the_verdict_comes_before_the_cut_can_be_written(dialog, qtbot):
    assert not dialog.write.isEnabled() and dialog.state.text().startswith("Simulating the cut: ")
    qtbot.waitUntil(lambda: fits(dialog))
    assert "The cutter fits. Radius 0.2 cm" in dialog.state.text()
    assert "Nothing is cut too deep; up to 0.0019 cm of material remains" in dialog.state.text()


def test_a_cutter_that_does_not_fit_cannot_write_and_one_that_fits_is_offered(
    open_dialog, qtbot, monkeypatch
):
    monkeypatch.setattr("workbench.files.export.cut_plan._EXCESS", -1.0)
    dialog = open_dialog(Cutting(tool_radius=0.9, scallop=0.002))
    qtbot.waitUntil(dialog.fit.isVisible)
    assert "a ball cutter of 0.9 cm does not fit: it leaves" in dialog.state.text()
    assert not dialog.write.isEnabled() and not dialog.look.isEnabled()
    dialog.accept()
    assert dialog.isVisible()
    monkeypatch.undo()
    dialog.fit.click()
    qtbot.waitUntil(lambda: fits(dialog))
    assert dialog.plan.cutting.tool_radius == float(
        dialog.fields.row("tool_radius").editors["tool_radius"].text()
    )


def test_a_simulation_shows_its_progress_and_ends_with_the_dialog(held, open_dialog, qtbot):
    dialog = open_dialog()
    qtbot.waitUntil(lambda: dialog.state.text() == "Simulating the cut: 40 %")
    dialog.reject()
    qtbot.waitUntil(held.is_set)
    assert dialog.plan is None


def test_the_last_answer_is_what_the_next_begins_with(designed, window, settings):
    keep_options(settings, "cm", COARSE)
    ask = partial(ask_options, window, settings)
    answer(lambda dialog: (dialog.fields.enter(feed=700.0), answer(CutterDialog.accept, fits)))
    plan = ask(designed, GCODE).plan
    assert plan.cutting == Cutting(tool_radius=0.2, scallop=0.002, feed=700.0)
    answer(lambda dialog: dialog.reject())
    assert ask(designed, GCODE) is None
    answer(CutterDialog.accept, fits)
    assert ask(designed, GCODE).plan.cutting == plan.cutting


def test_other_formats_ask_for_their_options_and_keep_them(designed, window, settings):
    ask = partial(ask_options, window, settings)
    assert ask(designed, format_of(Path("a.step"))) == Chosen()

    def fill_in(dialog):
        cutting, drawing = dialog.fields
        cutting.enter(dialect="fanuc")
        drawing.enter(form_tolerance=-1.0)
        dialog.accept()
        assert dialog.isVisible() and drawing.refused
        drawing.enter(form_tolerance=2e-4)
        dialog.accept()

    package = format_of(Path("a.zip"))
    answer(fill_in, kind=OptionDialog)
    expected = (Cutting(dialect="fanuc"), Drawing(form_tolerance=2e-4))
    assert ask(designed, package) == Chosen(expected)
    answer(lambda dialog: dialog.reject(), kind=OptionDialog)
    assert ask(designed, package) is None
    answer(OptionDialog.accept, kind=OptionDialog)
    assert ask(designed, format_of(Path("a.pdf"))) == Chosen(expected[1:])


def test_rows_that_mean_nothing_are_hidden(fields):
    assert not fields.row("step_down").isVisible() and not fields.row("program").isVisible()
    fields.enter(roughing="flat")
    fields.enter(dialect="fanuc")
    assert fields.row("step_down").isVisible() and fields.row("program").isVisible()


def test_the_pane_and_the_menu_lead_to_g_code(
    display, open_window, designed, settings, qtbot, tmp_path
):
    keep_options(settings, designed.scene.unit, Cutting(tool_radius=0.3, scallop=0.003))
    window = open_window(designed)
    window.build()
    written = tmp_path / "lens.nc"
    window.exporter._dialogs.to_save = lambda *_: written
    window.panes.show("manufacture")
    pane = window.loaded.manufacture
    answer(CutterDialog.accept, fits)
    buttons = {b.defaultAction(): b for b in pane.findChildren(QToolButton)}
    assert {window.commands["export"], window.commands["report"]} <= buttons.keys()
    buttons[window.commands["cut"]].click()
    qtbot.waitUntil(lambda: not window.exporter.background.busy)
    assert "ball cutter: radius 3.0000)" in written.read_text()
    assert str(written) in window.messages.text
    assert window.commands["cut"].isEnabled()
