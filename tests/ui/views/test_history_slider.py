"""The course of a run: kept within bounds, looked back at, gone on from; and the list of steps."""

from types import SimpleNamespace

import numpy as np
import pytest
from PySide6.QtCore import Qt

from ui.document.frame import iterations_before

pytestmark = pytest.mark.usefixtures("kernels")


def frame(at, size=1000):
    state = SimpleNamespace(heights={"lens.back": np.zeros(0)}, irradiance=np.zeros(0), further=())
    paths = SimpleNamespace(points=np.zeros(0), weight=np.zeros(0))
    losses = np.broadcast_to(0.0, at)  # of any length, without memory of its own
    surfaces = {"lens.back": np.zeros(size // 8)}
    result = SimpleNamespace(losses=losses, iterations=at)
    return SimpleNamespace(result=result, surfaces=surfaces, state=state, paths=paths)


def kept(history):
    return [iterations_before(each) for each in history.frames]


@pytest.fixture
def window(display, window, as_seen_run):
    window.build()
    window.loaded.control.runner._generate = as_seen_run(window.loaded.control.runner, 12)
    return window


@pytest.fixture
def designed(window, qtbot):
    """The window after a run, of which at least the first and last moment are kept."""
    with qtbot.waitSignal(window.loaded.control.ended, timeout=60_000):
        window.commands["start"].trigger()
        assert not window.loaded.views.history_slider._slider.isEnabled()
    qtbot.waitUntil(lambda: window.loaded.views.history_slider.isVisible())
    return window


def test_the_slider_shows_an_earlier_lens(designed, qtbot):
    history_slider, loss = (
        designed.loaded.views.history_slider,
        designed.loaded.views.around["irradiance"],
    )
    frames = designed.loaded.control.history.frames
    qtbot.wait(300)  # the preview of the result comes after the run
    history_slider._slider.setFocus()
    qtbot.keyClick(history_slider._slider, Qt.Key.Key_Home)
    qtbot.waitUntil(lambda: loss._frame is frames[0])
    assert history_slider._text.text() == f"iteration {iterations_before(frames[0])}"
    assert designed.document.session.result.iterations == 12


def test_the_design_goes_on_from_an_earlier_lens(designed, qtbot):
    history_slider, first = (
        designed.loaded.views.history_slider,
        designed.loaded.control.history.frames[0],
    )
    history_slider._slider.setValue(0)
    with qtbot.waitSignal(designed.loaded.control.ended, timeout=60_000):
        qtbot.mouseClick(history_slider._button, Qt.MouseButton.LeftButton)
        np.testing.assert_array_equal(
            designed.document.session.result.state.heights["lens.back"],
            first.snapshot.state.heights["lens.back"],
        )
    stack = designed.document.undo_stack
    texts = [stack.text(k) for k in range(stack.count())]
    assert texts == ["design run", f"return to iteration {iterations_before(first)}", "design run"]
    assert designed.document.session.result.iterations == iterations_before(first) + 12
    assert (
        iterations_before(designed.loaded.control.history.frames[-1])
        == iterations_before(first) + 12
    )


def test_undoing_a_run_removes_its_course_and_redoing_restores_it(designed, qtbot):
    views, history = designed.loaded.views, designed.loaded.control.history
    qtbot.waitUntil(lambda: views.loss._verified != ())
    frames, verified = list(history.frames), views.loss._verified
    assert designed.status._light.text().startswith("Verified error")
    designed.commands["undo"].trigger()
    assert not views.history_slider.isVisible() and views.loss._verified == ()
    designed.loaded.control._preview.stop()  # which shows the lens before the run
    qtbot.waitUntil(lambda: not designed.status._outdated.isHidden())
    designed.commands["redo"].trigger()
    assert designed.status._outdated.isHidden()
    assert views.history_slider.isVisible() and list(history.frames) == frames
    assert views.loss._verified == verified
