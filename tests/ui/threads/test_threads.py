"""Threads of the window."""

import gc
import threading
import weakref

import pytest
from PySide6.QtCore import QTimer

from ui.background import Background, GarbageCollector
from ui.unexpected_errors import UnexpectedErrors
from workbench.defects import file
from workbench.errors import RunFailed


@pytest.fixture
def logged(qapp):
    unexpected, lines = UnexpectedErrors(), []
    unexpected.logged.connect(lines.append)
    yield lines
    unexpected.close()
    unexpected.deleteLater()


def divided_by_nothing(task):
    return 1 / 0


def without_light(task):
    raise RunFailed("no light")


@pytest.fixture
def failure_of(qtbot, qapp):
    """The sentence that work in a thread fails with."""

    def fail(work):
        background, failures = Background("export", qapp), []
        background.failed.connect(failures.append)
        background.begin(work)
        qtbot.waitUntil(lambda: bool(failures))
        background.deleteLater()
        return failures

    return fail


def test_a_refusal_is_a_sentence_and_no_defect(failure_of, logged):
    assert failure_of(without_light) == ["no light"]
    assert not logged


def test_a_defect_in_a_thread_is_shown_logged_and_written(failure_of, logged, capsys):
    assert failure_of(divided_by_nothing) == [
        "The export failed: unexpected ZeroDivisionError: division by zero "
        f"(details are in {file()})"
    ]
    (details,) = logged
    for text in (details, file().read_text(), capsys.readouterr().err):
        assert "Traceback" in text and "in divided_by_nothing" in text


@pytest.fixture
def collector(qapp):
    """The only one; that of the other tests comes back afterwards."""
    enabled = gc.isenabled()
    collector = GarbageCollector(qapp)
    yield collector
    collector.close()
    collector.deleteLater()
    if not enabled:
        gc.disable()


class Holder:
    """Holds a running timer and, in a circle, itself."""

    def __init__(self, deleted_in):
        self.itself = self
        self.timer = QTimer()
        self.timer.start(3)
        weakref.finalize(self, lambda: deleted_in.append(threading.current_thread()))


def allocate(until):
    """Make garbage until an event is set, as a run does in its thread."""
    while not until.is_set():
        for _ in range(2000):
            circle = []
            circle.append(circle)
        until.wait(0.001)


def test_a_working_thread_deletes_no_timer_of_the_window(collector, qtbot):
    deleted_in, enough = [], threading.Event()
    worker = threading.Thread(target=allocate, args=(enough,))
    worker.start()
    try:
        for _ in range(20):
            Holder(deleted_in)
            qtbot.wait(5)
        qtbot.waitUntil(lambda: len(deleted_in) == 20)
    finally:
        enough.set()
        worker.join()
    assert set(deleted_in) == {threading.main_thread()}
