"""How fast surface and light follow a hand in the real window. Figures are printed, not asserted.

64 × 64 control points, 256 × 256 rays, 256 × 256 pixels, all docks of a fresh window.
"""

import time

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPointF, Qt, QTimer
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication

pytestmark = [pytest.mark.slow, pytest.mark.usefixtures("kernels")]

_SECONDS = 10.0
_MOVE_MS = 16  # between movements of the mouse


@pytest.fixture
def window(display, open_window, make_session):
    session = make_session(
        {
            "lens.control_points": [64, 64],
            "source.rays": [256, 256],
            "screen.pixels": [256, 256],
            "target": {"builtin": "flame"},
        }
    )
    window = open_window(session, "flame")
    window.resize(1280, 800)
    window.build()
    return window


class Watch:
    """Counts the drawings of a view, and how long after its height was asked for each came."""

    def __init__(self, view, asked):
        self.latencies = []
        original = view._draw

        def draw(session, frame):
            original(session, frame)
            at = asked.pop(float(frame.state.heights["exit"].max()), None)
            if at is not None:
                self.latencies.append(time.perf_counter() - at)

        view._draw = draw

    def report(self, name):
        median, p95 = 1000 * np.quantile(self.latencies, [0.5, 0.95])
        rate = len(self.latencies) / _SECONDS
        return f"{name}: {rate:.1f} frames/s, {median:.0f} ms after the hand (95 %: {p95:.0f} ms)"


@pytest.mark.timeout(0)
def test_the_lens_follows_a_drag_at_a_steady_rate(window, latency_probe, qtbot, capsys):
    view, irradiance = window.loaded.views.scene, window.loaded.views.docked["irradiance"]
    qtbot.waitUntil(lambda: view.frame is not None and view.lens is not None, timeout=60_000)
    window.commands["sculpt"].trigger()
    qtbot.waitUntil(lambda: view.nets.picture._shown and not view._to_draw, timeout=60_000)
    asked = [{}, {}]  # when, by the largest height; one for each view
    watched = [Watch(each, when) for each, when in zip((view, irradiance), asked, strict=True)]

    def note(heights, settled):
        for when in asked:
            when[float(heights.max())] = time.perf_counter()

    window.loaded.tools._tools["sculpt"].shaped.connect(note)
    ((x, y),) = view.sight.pixels(view.nets.picture.places[32, 32][None])
    place = QPointF(x, view._plotter.height() - 1 - y)

    def send(kind, button, buttons):
        at = view._plotter.mapToGlobal(place)
        event = QMouseEvent(kind, place, at, button, buttons, Qt.KeyboardModifier.ShiftModifier)
        QApplication.sendEvent(view._plotter, event)

    left, none = Qt.MouseButton.LeftButton, Qt.MouseButton.NoButton
    send(QEvent.Type.MouseButtonPress, left, left)

    def move():
        nonlocal place
        place = place + QPointF(0.4, 0.0)  # finely, along z
        send(QEvent.Type.MouseMove, none, left)

    hand = QTimer(interval=_MOVE_MS)
    hand.timeout.connect(move)
    hand.start()
    latency_probe.start()
    spent = time.process_time()
    qtbot.wait(int(1000 * _SECONDS))
    spent = time.process_time() - spent
    latency_probe.stop()
    hand.stop()
    send(QEvent.Type.MouseButtonRelease, left, none)
    qtbot.waitUntil(lambda: window.document.session.result is not None, timeout=60_000)
    assert window.document.undo_stack.count() == 1
    assert all(watch.latencies for watch in watched)
    lines = [watch.report(name) for watch, name in zip(watched, ("3D", "image"), strict=True)]
    lines.append(f"all threads: {1000 * spent / len(watched[0].latencies):.0f} ms a 3D frame")
    with capsys.disabled():
        print("", *lines, latency_probe.report("event loop"), sep="\n", end="")
