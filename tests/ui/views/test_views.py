"""The views in a window: what they draw, when, and what they leave alone."""

import dataclasses

import numpy as np
import pytest
from PySide6.QtWidgets import QMainWindow

from tests.accounts import account_of
from ui.views.light_images import ErrorView, IrradianceView
from ui.views.light_view import LightView
from ui.views.loss_strip import LossStrip
from ui.views.scene_view import SceneView
from workbench.geometry.faces import FaceArrays
from workbench.optics.account import Account

PLOTS = [IrradianceView, ErrorView]
VIEWS = [*PLOTS, LossStrip]


@pytest.fixture
def frame(session, frames):
    """A frame of some iteration with an uneven image of its own."""

    def make(iteration, of=session):
        n_x, n_y = of.scene.receiver.pixels
        return frames(
            iteration,
            of,
            irradiance=np.linspace(0, 0.1 * (1 + iteration), n_x * n_y).reshape(n_y, n_x),
            heights=FaceArrays({"lens.back": np.full(of.scene.optic.net_shape, 0.5)}),
        )

    return make


@pytest.fixture
def draws(monkeypatch):
    """Counts how often each view draws."""
    counts = {}
    for kind in (*VIEWS, LightView, SceneView):
        original = kind._draw

        def counted(self, *args, kind=kind, original=original):
            counts[kind] = counts.get(kind, 0) + 1
            original(self, *args)

        monkeypatch.setattr(kind, "_draw", counted)
    return counts


def grabbed(widget):
    image = widget.grab().toImage()
    data = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine())
    return data[:, : 4 * image.width()].reshape(image.height(), image.width(), 4)[..., :3].copy()


@pytest.mark.parametrize("kind", VIEWS)
def test_view_draws_the_latest_frame(kind, session, frame, draws, show, qtbot):
    view = kind()
    view.show_design(session)
    show(view, 380, 260)
    qtbot.waitUntil(lambda: draws.get(kind) == 1)
    empty = grabbed(view)
    for iteration in (1, 2, 3):
        view.show_frame(frame(iteration))
    qtbot.waitUntil(lambda: draws[kind] == 2)
    assert (grabbed(view) != empty).any()
    qtbot.wait(100)
    assert draws[kind] == 2  # three frames at once are one drawing


# In three dimensions.


@pytest.fixture
def scene_view(display, qtbot):
    view = SceneView()
    window = QMainWindow()
    qtbot.addWidget(window, before_close_func=lambda _: view.close_plotter())
    window.setCentralWidget(view)
    window.resize(480, 320)
    yield view  # the window lives as long


def test_the_light_account_adds_up(frame, show, qtbot):
    view = show(LightView(), 380, 260)
    one = frame(1)

    def show_account(account):
        state = dataclasses.replace(one.snapshot.state, account=account)
        snapshot = dataclasses.replace(one.snapshot, state=state)
        view.show_frame(dataclasses.replace(one, snapshot=snapshot))

    show_account(account_of(2.0, 1.0, 0.5, 0.1, 0.06, 0.0, 0.3, 0.04))
    qtbot.waitUntil(lambda: view.texts()["All parts"] == "100.00 %")
    assert view.texts() == {
        "On the screen": "50.00 %",
        "Missed the screen": "25.00 %",
        "Missed the lens": "5.00 %",
        "Out of the side": "3.00 %",
        "Totally reflected": "0.00 %",
        "Reflected on entry": "15.00 %",
        "Reflected on exit": "2.00 %",
        "All parts": "100.00 %",
    }
    show_account(
        Account(0.5, {"off_screen": 0.2, "missed_lens@dome": 0.2, "fresnel_exit@cover": 0.1})
    )
    qtbot.waitUntil(lambda: len(view.texts()) == 5)
    assert view.texts() == {
        "On the screen": "50.00 %",
        "Missed the screen": "20.00 %",
        "Missed the lens (dome)": "20.00 %",
        "Reflected on exit (cover)": "10.00 %",
        "All parts": "100.00 %",
    }


@pytest.mark.parametrize("kind", PLOTS)
def test_a_design_without_a_frame_is_not_shown_as_the_one_before(kind, session, frame, show, qtbot):
    view = kind()
    view.show_design(session)
    show(view, 380, 260)
    qtbot.waitUntil(lambda: view._shown is session)
    assert view.empty and view._hint.text()
    empty = grabbed(view._canvas)
    view.show_frame(frame(3))
    qtbot.waitUntil(lambda: not view.empty)
    assert not view._hint.text() and (grabbed(view._canvas) != empty).any()
    view.show_nothing(session)
    qtbot.waitUntil(lambda: view.empty)
    view._hint.setText("")
    blank = grabbed(view._canvas)[1:-1, 1:-1]  # without the frame of the keyboard's focus
    assert (blank == blank[-1, -1]).mean() > 0.98  # all but a button in a corner
