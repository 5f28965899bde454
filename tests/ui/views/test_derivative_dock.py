"""The dock in the real window: hidden at first, one of two tabs when shown, closed with it."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt

from tests.ui.hands import open_example
from workbench.analysis.derivatives import irradiance_derivative

pytestmark = pytest.mark.usefixtures("kernels")


@pytest.fixture
def window(display, open_window, designed):
    window = open_window(designed)
    window.build()
    return window


def test_the_dock_shows_the_designed_lens(window, session, qtbot):
    view, other = (window.loaded.views.around[name] for name in ("derivative", "target"))
    assert not view.isVisible() and other.isVisible()
    window.commands["go_derivative"].trigger()
    qtbot.waitUntil(lambda: view._answer is not None, timeout=60_000)
    assert view.isVisible() and not other.isVisible()
    wanted = irradiance_derivative(
        session.scene, {"lens.back": np.full((12, 10), 0.497)}, view.point.index
    )
    np.testing.assert_allclose(view._answer.map, wanted.map, atol=1e-12)


def seen_at(window, index):
    """Where a control point is seen in the 3D view, as Qt counts."""
    view = window.loaded.views.scene
    renderer = view._plotter.renderer
    renderer.SetWorldPoint(*view.nets.picture.places(index), 1.0)
    renderer.WorldToDisplay()
    x, y, _ = renderer.GetDisplayPoint()
    scale = view.devicePixelRatioF()
    return QPoint(round(x / scale), view._plotter.height() - 1 - round(y / scale))


@pytest.fixture
def picking(window, qtbot):
    """The window with its derivative dock open and the control points shown."""
    window.commands["go_derivative"].trigger()
    view, derivative = window.loaded.views.scene, window.loaded.views.derivative
    qtbot.waitUntil(
        lambda: view.nets.picture is not None and view.nets.picture._marked == (6, 5),
        timeout=60_000,
    )
    return view, derivative


def test_a_click_in_the_3d_scene_chooses_the_control_point(window, picking, qtbot):
    view, derivative = picking
    for index in ((0, 0), (2, 7)):
        qtbot.mouseClick(view._plotter, Qt.MouseButton.LeftButton, pos=seen_at(window, index))
        assert derivative.point.index == index
        qtbot.waitUntil(lambda at=index: view.nets.picture._marked == at)
    qtbot.waitUntil(lambda: derivative._answer is not None and derivative._answer.index == (2, 7))


def test_an_example_of_a_map_shows_the_dock(window, qtbot):
    window.document.undo_stack.setClean()
    open_example(window, "derivative-degree3-filter3")
    view = window.loaded.views.derivative
    qtbot.waitUntil(view.isVisible)
    qtbot.waitUntil(lambda: view.point.index == (4, 4), timeout=60_000)
    open_example(window, "tophat")
    assert view.isVisible()
