"""Steps that can be taken back: all of them, until they hold too much memory."""

import gc
import weakref
from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QObject

from tests.accounts import result_of
from ui.document.undo_steps import UndoSteps
from workbench.files.session import KeptRun

MEGABYTE = 1 << 20


def lens(megabytes=1):
    return result_of(np.zeros((4, 4)), np.zeros(megabytes * MEGABYTE // 8))


class Walk:
    """A stack, the session it stands at, and the one it began with."""

    def __init__(self, session, owner, budget):
        self.now = self.first = session
        self.shown = []
        self.steps = UndoSteps(self.show, owner, budget)

    def show(self, session):
        self.now = session
        self.shown.append(session)

    def go(self, text, key="", **changes):
        self.steps.take(self.now, replace(self.now, **changes), text, key)
        return self.now

    @property
    def texts(self):
        return [self.steps.text(number) for number in range(self.steps.count())]


@pytest.fixture
def walk(qapp, session):
    owner = QObject()
    yield Walk(session, owner, 5 * MEGABYTE)
    owner.deleteLater()


def test_small_steps_are_all_kept(walk):
    for number in range(250):
        walk.go(f"{number}", view={"number": number})
    assert walk.steps.count() == 250
    for _ in range(250):
        walk.steps.undo()
    assert walk.now is walk.first


def test_a_step_costs_what_only_the_session_before_it_holds(walk):
    walk.go("run", result=lens(2))
    assert walk.steps.cost < MEGABYTE  # the lens is needed anyway
    result = walk.now.result
    walk.go("keep", runs=(KeptRun("a", walk.now.scene, walk.now.target, result),))
    walk.go("drop", result=None)
    assert walk.steps.cost < MEGABYTE  # the kept run still has it
    walk.go("delete", runs=())
    assert walk.steps.cost == pytest.approx(2 * MEGABYTE, abs=MEGABYTE / 8)


def test_the_oldest_steps_are_dropped_beyond_the_memory_limit(walk):
    forgotten = []
    walk.steps.forgot.connect(forgotten.append)
    sessions = [walk.go(f"run {number}", result=lens()) for number in range(12)]
    assert sum(forgotten) == 8
    assert walk.steps.cost <= 5 * MEGABYTE
    assert walk.texts == [f"run {number}" for number in (8, 9, 10, 11)]
    assert walk.steps.index() == 4 and not walk.steps.isClean()
    assert walk.shown == sessions  # nothing else was shown on the way
    for number in (10, 9, 8, 7):
        walk.steps.undo()
        assert walk.now is sessions[number]
    assert not walk.steps.canUndo()
    for number in (8, 9, 10, 11):
        walk.steps.redo()
        assert walk.now is sessions[number]


def test_the_saved_step_stays_clean_until_it_is_dropped(walk):
    for number in range(4):
        walk.go(f"run {number}", result=lens())
    walk.steps.setClean()
    for number in range(4, 8):
        walk.go(f"run {number}", result=lens())
    assert walk.texts == [f"run {number}" for number in (4, 5, 6, 7)]
    assert not walk.steps.isClean()
    for _ in range(4):
        walk.steps.undo()
    assert walk.steps.isClean()
    for _ in range(4):
        walk.steps.redo()
    walk.go("run 8", result=lens())
    for _ in range(4):
        walk.steps.undo()
    assert not walk.steps.canUndo() and not walk.steps.isClean()


def test_merged_undo_steps_release_arrays(walk):
    passed = weakref.ref(walk.go("drag", "drag 1", result=lens()))
    walk.go("drag", "drag 1", result=lens())
    walk.shown.clear()
    gc.collect()
    assert walk.steps.count() == 1
    assert passed() is None


def test_an_amended_step_leads_to_the_other_session_and_stays_one_step(walk, session):
    walk.go("edit", start=None)
    better = replace(walk.now, result=lens())
    walk.steps.amend(better)
    assert walk.texts == ["edit"]
    walk.steps.undo()
    assert walk.now is session
    walk.steps.redo()
    assert walk.now is better
