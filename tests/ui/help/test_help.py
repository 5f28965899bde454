"""The manual and the coach marks."""

import re

import pytest
from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QTextBrowser

from resources.manual_pages import pages
from ui.commands.command_search import CommandPalette
from ui.commands.table import COMMANDS
from ui.dialogs.coach import MARKS, CoachMarks
from ui.dialogs.help import Manual


@pytest.fixture
def manual(window, qtbot):
    qtbot.keyClick(window, Qt.Key.Key_F1)
    dialog = window.findChild(Manual)
    qtbot.waitUntil(dialog.isVisible)
    yield dialog
    dialog.reject()


def listed(manual):
    rows = (manual._list.item(row) for row in range(manual._list.count()))
    return [row.text() for row in rows if not row.isHidden()]


def title(manual):
    return manual.findChild(QTextBrowser).toPlainText().partition("\n")[0]


def test_each_page_is_listed_and_shows_its_title_and_tables(manual):
    assert listed(manual) == [page.title for page in pages()]
    document = manual.findChild(QTextBrowser).document()
    for row, page in enumerate(pages()):
        manual._list.setCurrentRow(row)
        assert title(manual) == page.title
        code = "".join(re.findall("```.*?```", page.text, re.DOTALL))
        assert document.toPlainText().count("**") == code.count("**")
        frames = document.rootFrame().childFrames()
        tables = [frame.columns() for frame in frames if hasattr(frame, "columns")]
        lines = page.text.splitlines()
        assert tables == [line.count("|") - 1 for line in lines if line.startswith("|---")]


class TestSearch:
    @pytest.fixture
    def field(self, manual):
        manual._search.setFocus()
        return manual._search

    def test_lists_pages_that_hold_all_words_and_marks_them(self, manual, field, qtbot):
        qtbot.keyClicks(field, "tolerances mould")
        assert listed(manual) == [page.title for page in pages() if page.holds("tolerances mould")]
        assert len(listed(manual)) < len(pages())
        assert title(manual) == listed(manual)[0]
        marks = manual.findChild(QTextBrowser).extraSelections()
        assert len(marks) == len(manual._places)
        words = {place.selectedText().lower() for place in manual._places}
        assert words == {"tolerances", "mould"}

    def test_return_goes_through_all_places_and_pages_and_begins_again(self, manual, field, qtbot):
        qtbot.keyClicks(field, "mitsuba")
        browser = manual.findChild(QTextBrowser)
        wanted = sum(page.text.lower().count("mitsuba") for page in pages())
        places = set()
        for _ in range(wanted + 5):
            places.add((manual._list.currentRow(), browser.textCursor().position()))
            qtbot.keyClick(field, Qt.Key.Key_Return)
        assert len({row for row, _ in places}) == len(listed(manual)) > 1
        shown = 0
        for row in {row for row, _ in places}:
            manual._list.setCurrentRow(row)
            shown += len(browser.extraSelections())
        assert len(places) == shown


def test_words_that_no_page_has_are_stated_to_be_on_none(manual, qtbot):
    qtbot.keyClicks(manual._search, "xyzzy")
    assert listed(manual) == []
    assert manual._nothing.isVisible()
    assert manual._nothing.text() == "No page found: xyzzy"
    manual._search.clear()
    assert not manual._nothing.isVisible()


@pytest.fixture
def marks(window, qtbot):
    window.commands["tour"].trigger()
    marks = window.findChild(CoachMarks)
    qtbot.waitUntil(marks.isVisible)
    return marks


def test_coach_marks_are_gone_through_by_keyboard(window, marks, qtbot):
    gone, titles = [], []
    marks.destroyed.connect(lambda: gone.append(True))
    for number in range(len(MARKS)):
        titles.append(marks.title)
        qtbot.waitUntil(marks.on.hasFocus)
        assert marks.on.text() == ("&Next" if number + 1 < len(MARKS) else "&Done")
        qtbot.keyClick(marks.on, Qt.Key.Key_Return)
    assert titles == [title for title, _ in MARKS]
    qtbot.waitUntil(lambda: bool(gone))
    assert window.findChild(CoachMarks) is None


def test_a_mark_leaves_its_place_free_and_follows_it(window, marks, qtbot):
    form = window.panes.place("design")
    for width in (1200, 1000):
        window.resize(width, 700)
        inside = QRect(form.mapTo(window, QPoint()), form.size())
        qtbot.waitUntil(lambda inside=inside: not inside.intersects(marks.geometry()))
        assert window.rect().contains(marks.geometry())
    qtbot.keyClick(marks, Qt.Key.Key_Escape)
    assert not marks.isVisible()


def test_coach_marks_come_once_without_being_asked_for(window, settings):
    window.start_page.begun.emit()
    window.findChild(CoachMarks).end()
    window.start_page.begun.emit()
    assert window.help._marks is None
    window.commands["tour"].trigger()
    assert window.help._marks is not None


def test_all_shortcuts_are_listed_and_found_by_name_or_key(window, qtbot):
    qtbot.keyClick(window, Qt.Key.Key_F1, Qt.KeyboardModifier.ControlModifier)
    dialog = window.findChild(CommandPalette)
    keys = {row.text(1) for row in dialog._items()}
    wanted = {QKeySequence(c.shortcut).toString() for c in COMMANDS.values() if c.shortcut}
    assert wanted <= keys and "" not in keys
    for typed, found in (("contin", "Run → Continue"), ("shift+f5", "Run → Continue")):
        dialog._field.clear()
        qtbot.keyClicks(dialog._field, typed)
        assert [row.text(0) for row in dialog._items()] == [found]
    dialog.close()
