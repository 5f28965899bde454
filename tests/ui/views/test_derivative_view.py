"""The derivative dock's view: when it computes, of which lens, what it tells."""

import dataclasses
import threading
from types import SimpleNamespace

import numpy as np
import pytest
from PySide6.QtCore import QThread

import workbench.analysis.derivatives
from ui.views.derivative_view import DerivativeView
from workbench.analysis.derivatives import DerivativeMap, irradiance_derivative
from workbench.geometry.faces import FaceArrays
from workbench.powers import written


@pytest.fixture
def frame(session, snapshots):
    """What the view needs of a frame: a lens, lower with each iteration, and its scene."""

    def make(iteration, of=session):
        heights = FaceArrays({"exit": np.full((12, 10), 0.5 - 0.01 * iteration)})
        snapshot = dataclasses.replace(
            snapshots(iteration),
            state=dataclasses.replace(snapshots(iteration).state, heights=heights),
        )
        return SimpleNamespace(session=of, state=snapshot.state)

    return make


@pytest.fixture
def asked(monkeypatch):
    """What the engine was asked for, and in which thread; answers with a map of ones."""
    calls = []

    def stand_in(scene, heights, index, face):
        calls.append((scene, heights, index, QThread.currentThread()))
        n_x, n_y = scene.receiver.pixels
        return DerivativeMap(index, (0.0, 0.0), np.ones((n_y, n_x)), 0.5, 2.0)

    monkeypatch.setattr(workbench.analysis.derivatives, "irradiance_derivative", stand_in)
    return calls


@pytest.fixture
def view(qtbot):
    view = DerivativeView()
    qtbot.addWidget(view)
    return view


@pytest.fixture
def seen(view, show):
    return show(view, 380, 380)


def test_shows_the_map_of_the_middle_point_and_its_sum(seen, frame, session, qtbot):
    seen.show_frame(frame(1))
    assert seen.point.index == (6, 5)
    qtbot.waitUntil(lambda: "changes by" in seen._sum.text(), timeout=20_000)
    scene = session.scene
    wanted = irradiance_derivative(scene, {"exit": np.full((12, 10), 0.49)}, (6, 5))
    qtbot.waitUntil(lambda: not seen.empty)
    shown = seen._image.artists[0].get_array()
    np.testing.assert_allclose(shown.filled(0), wanted.map, atol=1e-12)
    np.testing.assert_array_equal(shown.mask, wanted.map == 0)
    assert f"{written(wanted.sum, digits=2)} per cm," in seen._sum.text()
    assert seen._place.text() == "x = 0.111 cm, y = 0.143 cm"


def test_view_says_that_there_is_no_map_yet(seen, frame, session, monkeypatch, qtbot):
    computing = threading.Event()

    def wait_for_it(scene, heights, index, face):
        assert computing.wait(30)
        return irradiance_derivative(scene, heights, index, face=face)

    monkeypatch.setattr(workbench.analysis.derivatives, "irradiance_derivative", wait_for_it)
    seen.show_frame(frame(1))
    try:
        qtbot.waitUntil(lambda: "no map" in seen._hint.text())
        assert seen.empty
    finally:
        computing.set()
    qtbot.waitUntil(lambda: not seen.empty)


def test_nothing_is_computed_while_hidden(view, frame, asked, show, qtbot):
    view.show_frame(frame(1))
    view.show_frame(frame(2))
    qtbot.wait(400)
    assert not asked
    show(view, 380, 380)
    qtbot.waitUntil(lambda: len(asked) == 1)
    assert asked[0][1]["exit"][0, 0] == 0.48
    view.hide()
    view.show_frame(frame(3))
    qtbot.wait(400)
    assert len(asked) == 1


def test_many_frames_are_one_map_of_the_last(seen, frame, asked, qtbot, qapp):
    seen._rest.setInterval(60_000)  # no frame comes so late that the lens seems to rest
    for iteration in range(4):
        seen.show_frame(frame(iteration))
        qtbot.wait(5)
    assert not asked
    seen._rest.setInterval(10)
    seen.show_frame(frame(4))
    qtbot.waitUntil(lambda: "changes by 0.5 per cm" in seen._sum.text())
    assert [call[1]["exit"][0, 0] for call in asked] == [0.46]
    assert asked[0][3] != qapp.thread()
    assert "0.25 of the total flux" in seen._sum.text()


def test_another_point_is_another_map(seen, frame, asked, qtbot):
    seen.show_frame(frame(1))
    qtbot.waitUntil(lambda: len(asked) == 1)
    seen._boxes[0].setValue(2)
    seen._boxes[1].setValue(7)
    qtbot.waitUntil(lambda: len(asked) == 2)
    assert asked[1][2] == (2, 7)


def test_only_points_of_the_net_can_be_chosen(seen, frame, asked, make_session, qtbot):
    seen.show_frame(frame(1))
    seen._boxes[0].setValue(99)
    assert seen.point.index == (11, 5)
    seen.show_frame(frame(1, of=make_session({"lens.control_points": [7, 10]})))
    assert seen.point.index == (3, 5)
    qtbot.waitUntil(lambda: bool(asked) and asked[-1][2] == (3, 5))


def test_a_refusal_is_shown_and_the_old_map_removed(seen, frame, make_session, qtbot):
    seen.show_frame(frame(1))
    qtbot.waitUntil(lambda: seen._map is not None, timeout=20_000)
    seen.show_frame(frame(1, of=make_session({"filter": {"kind": "box"}})))
    qtbot.waitUntil(lambda: "filter.kind: 'box' counts rays" in seen._sum.text())
    qtbot.waitUntil(lambda: seen._image.artists[0].get_array().count() == 0)
    assert seen._place.text() == ""


def test_defects_are_shown(seen, frame, monkeypatch, qtbot):
    def broken(*_, **__):
        raise ZeroDivisionError("by zero")

    monkeypatch.setattr(workbench.analysis.derivatives, "irradiance_derivative", broken)
    seen.show_frame(frame(1))
    qtbot.waitUntil(lambda: "unexpected ZeroDivisionError: by zero" in seen._sum.text())
