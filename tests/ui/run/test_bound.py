"""The bound of the open design, in the status bar."""

import re

import pytest
from PySide6.QtCore import QObject

from ui.run.bound import BoundOfDesign

GRID = {"kind": "grid", "center": [0, 0, -4], "half_width": [0.3, 0.3], "points": [50, 50]}


@pytest.fixture
def said():
    return []


@pytest.fixture
def bound(document, said, qapp):
    parent = QObject()
    bound = BoundOfDesign(document, parent)
    bound.figures_changed.connect(lambda *words: said.append(words))
    bound.follow(document.session)
    yield bound
    bound.close()


def test_bound_of_an_edited_source_is_said(bound, said, document, make_scene, qtbot):
    assert said == [("", "")]
    document.edit(make_scene({"source": GRID}), "source", "")
    qtbot.waitUntil(lambda: said[-1] != ("", ""), timeout=30_000)
    short, sentence = said[-1]
    assert sentence.startswith("There can be no lens of this size below ")
    least, allowed = (float(part) for part in re.findall(r"([\d.]+) %", sentence))
    assert "with a source half as wide" in sentence and 0 < allowed < least
    assert short == f"at best {least:g} %"
    document.undo_stack.undo()
    assert said[-1] == ("", "")
