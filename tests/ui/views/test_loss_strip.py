"""The loss of a run: its curve shows earlier lenses, of which the design goes on."""

from types import SimpleNamespace

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt

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
        assert not window.loaded.views.loss.curve.isEnabled()
    assert window.panes.strip.isVisible()  # the run has led to Design
    return window


def test_the_curve_shows_an_earlier_lens(designed, qtbot):
    strip, image = designed.loaded.views.loss, designed.loaded.views.around["irradiance"]
    frames = designed.loaded.control.history.frames
    assert strip._button.isHidden()  # the last lens is shown
    strip.curve.setFocus()
    qtbot.keyClick(strip.curve, Qt.Key.Key_Home)
    assert image._frame is frames[0]
    qtbot.wait(300)  # no preview of the result, which follows a run, takes its place
    first = f"iteration {iterations_before(frames[0])}"
    qtbot.waitUntil(lambda: strip._words.text().endswith(first))
    assert image._frame is frames[0]
    assert strip.curve.losses.size == 13 and strip._button.isVisible()  # the curve stays
    assert designed.document.session.result.iterations == 12


def test_the_design_goes_on_from_an_earlier_lens(designed, qtbot):
    strip, first = designed.loaded.views.loss, designed.loaded.control.history.frames[0]
    strip.curve.setValue(0)
    with qtbot.waitSignal(designed.loaded.control.ended, timeout=60_000):
        qtbot.mouseClick(strip._button, Qt.MouseButton.LeftButton)
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
    curve, history = designed.loaded.views.loss.curve, designed.loaded.control.history
    qtbot.waitUntil(lambda: curve.verified != ())
    frames, verified = list(history.frames), curve.verified
    designed.commands["undo"].trigger()
    assert len(curve.at) == 0 and curve.verified == ()
    designed.loaded.control._preview.stop()  # which shows the lens before the run
    qtbot.waitUntil(lambda: designed.loaded.views.loss.outdated)
    designed.commands["redo"].trigger()
    assert not designed.loaded.views.loss.outdated
    assert len(curve.at) == len(frames) and list(history.frames) == frames
    assert curve.verified == verified


def test_a_drag_along_the_curve_goes_to_the_iteration_under_the_pointer(designed, qtbot):
    curve = designed.loaded.views.loss.curve
    qtbot.waitUntil(lambda: curve.length == 12 and curve.isEnabled())
    place, at = curve._place, list(curve.at)

    def point(iteration):
        return QPoint(round(place.left() + place.width() * iteration / 12), 40)

    qtbot.mousePress(curve, Qt.MouseButton.LeftButton, pos=point(12))
    for number in reversed(range(len(at))):
        qtbot.mouseMove(curve, point(at[number]))
        qtbot.waitUntil(lambda number=number: curve.value() == number)
    qtbot.mouseRelease(curve, Qt.MouseButton.LeftButton, pos=point(at[0]))
    assert curve.value() == 0
