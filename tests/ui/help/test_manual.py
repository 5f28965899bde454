"""The manual beside the window: its pages, their pictures, and the search in all of them."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QTextBrowser

from resources.manual_pages import pages
from ui.help.manual import Manual


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
        assert "**" not in document.toPlainText()
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


def test_words_that_no_page_has_are_said_to_be_on_none(manual, qtbot):
    qtbot.keyClicks(manual._search, "xyzzy")
    assert listed(manual) == []
    assert manual._nothing.isVisible()
    assert manual._nothing.text() == "No page has all of this: xyzzy"
    manual._search.clear()
    assert not manual._nothing.isVisible()
