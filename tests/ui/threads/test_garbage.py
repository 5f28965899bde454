"""Cyclic garbage with Qt objects in it is freed in the window's thread, whoever allocates."""

import gc
import threading
import weakref

import pytest
from PySide6.QtCore import QTimer

from ui.threads.garbage import GarbageCollector


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


def test_closing_restores_the_collector_of_python(collector):
    assert not gc.isenabled()
    collector.close()
    assert gc.isenabled()
