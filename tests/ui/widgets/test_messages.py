"""Notices: several at once, some of which fade; warnings stay."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QVBoxLayout, QWidget

from ui.widgets import messages as module
from ui.widgets.messages import Messages


@pytest.fixture
def messages(show, qtbot, monkeypatch):
    monkeypatch.setattr(module, "_READ_MS", 150)
    monkeypatch.setattr(module, "_LETTER_MS", 0)
    monkeypatch.setattr(module, "_FADE_MS", 20)
    around, messages = QWidget(), Messages()
    QVBoxLayout(around).addWidget(messages)
    show(around, 500, 400)
    around.activateWindow()
    yield messages  # its window lives as long


def texts(messages):
    return [notice.text for notice in messages.notices]


def test_a_success_fades_and_a_warning_and_a_question_stay(messages, qtbot):
    messages.warn("no light")
    messages.note("Use it?", ("Use", lambda: None))
    messages.note("a hint")
    messages.done("written")
    assert texts(messages) == ["no light", "Use it?", "written"]  # at most three
    qtbot.waitUntil(lambda: texts(messages) == ["no light", "Use it?"])
    qtbot.wait(400)
    assert texts(messages) == ["no light", "Use it?"]


def test_nothing_fades_under_the_keyboard(messages, qtbot):
    messages.done("written", ("Open folder", lambda: None))
    messages.buttons[0].setFocus()
    qtbot.waitUntil(messages.buttons[0].hasFocus)
    qtbot.wait(400)
    assert texts(messages) == ["written"]
    QApplication.focusWidget().clearFocus()
    qtbot.waitUntil(lambda: messages.notices == [] and messages.isHidden())


def test_an_answer_closes_its_notice_and_another_of_the_same_words_replaces_it(messages, qtbot):
    taken = []
    messages.note("Use it?", ("Use", lambda: taken.append(texts(messages))))
    messages.warn("no light")
    messages.note("Use it?", ("Use", lambda: taken.append(texts(messages))))
    assert texts(messages) == ["no light", "Use it?"]
    qtbot.mouseClick(messages.buttons[0], Qt.MouseButton.LeftButton)
    assert taken == [["no light"]] and texts(messages) == ["no light"]


def test_a_run_clears_all_but_what_is_done(messages):
    messages.warn("no light")
    messages.done("written")
    messages.make_way()
    assert texts(messages) == ["written"]
    messages.withdraw("written")
    assert not messages.isVisible()
