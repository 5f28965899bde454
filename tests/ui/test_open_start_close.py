"""The whole life of a window, again and again; the leak check looks at what remains."""

import pytest

from tests.ui.leftovers import left_behind, living
from ui.document.document import Document
from ui.main_window import MainWindow

pytestmark = pytest.mark.usefixtures("kernels")

TIMES = 50


def open_start_close(session, settings, qtbot):
    window = MainWindow(Document(session, "top hat"), settings)
    window.show()
    window.build()
    with qtbot.waitSignal(window.loaded.control.runner.frame_ready):
        window.start()
    window.discard_and_close()
    assert not window.isVisible()
    assert window.loaded is None
    window.deleteLater()


def test_a_window_leaves_nothing_behind(display, qtbot, session, settings):
    before = living()
    for _ in range(3):
        open_start_close(session, settings, qtbot)
        assert not left_behind(before)


@pytest.mark.slow
@pytest.mark.timeout(0)
def test_fifty_windows_leave_nothing_behind(display, qtbot, session, settings):
    before = living()
    for _ in range(TIMES):
        open_start_close(session, settings, qtbot)
        assert not left_behind(before)
