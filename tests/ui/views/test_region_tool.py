"""Regions marked on an image by the mouse."""

import math

import pytest
from PySide6.QtCore import QPoint, Qt

from workbench.scene import PolygonRegion, RectangleRegion

pytestmark = pytest.mark.usefixtures("display")

_LEFT = Qt.MouseButton.LeftButton


class Hand:
    """A mouse over the irradiance of a window."""

    def __init__(self, window, qtbot):
        self.window, self._qtbot = window, qtbot
        self.view = window.loaded.views.around["irradiance"]
        self.canvas, self.link = self.view._canvas, window.loaded.views.shared

    def at(self, x, y):
        at = self.canvas.position_of(x, y)
        return QPoint(math.floor(at.x()), math.floor(at.y()))

    def drag(self, *places):
        first, *others = (self.at(*place) for place in places)
        self._qtbot.mousePress(self.canvas, _LEFT, pos=first)
        for place in others:
            self._qtbot.mouseMove(self.canvas, place)
        self._qtbot.waitUntil(lambda: bool(self.link.now.draft))
        self._qtbot.mouseRelease(self.canvas, _LEFT, pos=others[-1])

    def click(self, *place):
        self._qtbot.mouseClick(self.canvas, _LEFT, pos=self.at(*place))

    def key(self, key):
        self._qtbot.keyClick(self.canvas, key)

    @property
    def regions(self):
        return self.window.document.session.scene.regions


@pytest.fixture
def hand(window, qtbot):
    window.build()
    window.commands["go_irradiance"].trigger()
    view = window.loaded.views.around["irradiance"]
    qtbot.waitUntil(lambda: not view.empty)
    window.commands["mark_region"].trigger()
    return Hand(window, qtbot)


def test_a_drag_marks_a_rectangle_as_one_step(hand):
    hand.drag((-0.5, -0.5), (0.0, 0.2), (0.5, 0.25))
    (region,) = hand.regions
    assert isinstance(region, RectangleRegion) and region.name == "Region 1"
    assert region.center == pytest.approx((0.0, -0.0625), abs=0.01)
    assert region.size == pytest.approx((0.5, 0.375), abs=0.01)
    assert hand.window.document.undo_stack.undoText() == "new region"
    hand.window.commands["undo"].trigger()
    assert hand.regions == ()


def test_clicks_mark_a_polygon(hand):
    for place in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5)):
        hand.click(*place)
    assert hand.regions == () and len(hand.link.now.draft) == 4  # closed
    hand.key(Qt.Key.Key_Return)
    (region,) = hand.regions
    assert isinstance(region, PolygonRegion) and len(region.corners) == 3
    assert region.corners[2] == pytest.approx((0.25, 0.25), abs=0.01)
    assert hand.link.now.draft == ()


def test_sides_that_cross_are_refused_in_words(hand):
    for place in ((-0.5, -0.5), (0.5, 0.5), (0.5, -0.5), (-0.5, 0.2)):
        hand.click(*place)
    hand.key(Qt.Key.Key_Return)
    assert hand.regions == ()
    assert "sides that cross" in hand.window.messages.text
