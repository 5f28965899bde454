"""Start-up: errors that nobody expected, and libraries loaded in the background."""

import sys
import threading

import pytest
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QWidget

from ui import windows
from ui.background import Background
from ui.unexpected_errors import UnexpectedErrors
from workbench.analysis import kernels


@pytest.fixture
def unexpected(qapp):
    hooks = sys.excepthook, threading.excepthook
    unexpected = UnexpectedErrors()
    yield unexpected
    unexpected.close()
    unexpected.deleteLater()
    assert (sys.excepthook, threading.excepthook) == hooks


@pytest.fixture
def received(unexpected):
    received = []
    unexpected.happened.connect(lambda sentence, details: received.append((sentence, details)))
    return received


def fail(text="odd"):
    raise ValueError(text)


def meet(kind=ValueError, text="odd"):
    """An error as it reaches the hook, raised in one place."""
    try:
        raise kind(text)
    except kind as error:
        sys.excepthook(kind, error, error.__traceback__)


def test_an_error_is_shown_with_all_that_a_report_needs(received, capsys):
    meet()
    ((sentence, details),) = received
    assert "ValueError: odd" in sentence and "Save your work" in sentence
    assert "Traceback" in details and "test_startup.py" in details
    assert "Workbench" in details and "Qt 6" in details
    assert "ValueError: odd" in capsys.readouterr().err


def test_a_kind_of_error_is_shown_once_and_printed_each_time(received, capsys):
    for text in ("one", "two"):
        meet(text=text)
    meet(KeyError)
    assert len(received) == 2
    assert "one" in received[0][0] and "KeyError" in received[1][0]
    assert capsys.readouterr().err.count("Traceback") == 3


@pytest.mark.qt_no_exception_capture
def test_slots_handlers_and_threads_may_fail_and_the_loop_goes_on(received, qtbot, capsys):
    class Odd(QWidget):
        def paintEvent(self, event):
            raise RuntimeError("painting")

    odd = Odd()
    qtbot.addWidget(odd)
    thread = threading.Thread(target=fail, args=("thread",))
    after = []
    QTimer.singleShot(0, lambda: fail("slot"))
    QTimer.singleShot(0, thread.start)
    QTimer.singleShot(50, lambda: after.append(True))
    odd.show()
    qtbot.waitUntil(lambda: bool(after) and len(received) == 2)  # both of fail are of one kind
    thread.join()
    assert any("painting" in sentence for sentence, _ in received)


@pytest.fixture
def warmed_up(qtbot, monkeypatch):
    """Imports modules, and gives what was compiled and what was reported."""

    def do(modules):
        compiled, received = [], []
        monkeypatch.setattr(windows, "_SLOW", modules)
        monkeypatch.setattr(kernels, "compile_all", lambda goes_on: compiled.append(goes_on()))
        loading = Background("start", None)
        loading.progressed.connect(lambda *_: received.append("imported"))
        loading.failed.connect(received.append)
        loading.begin(windows.warm_up)
        qtbot.waitUntil(lambda: not loading.running)
        loading.close()
        return compiled, received

    return do


def test_kernels_are_made_ready_after_the_libraries(warmed_up):
    assert warmed_up(("json",)) == ([True], ["imported"])


def test_a_library_that_cannot_be_imported_is_reported_and_the_window_is_built(warmed_up):
    compiled, (first, sentence) = warmed_up(("no_such_library",))
    assert compiled == [] and first == "imported"
    assert "unexpected ModuleNotFoundError: No module named 'no_such_library'" in sentence
