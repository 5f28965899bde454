"""Regions: what a hand holds."""

import pytest

from ui.views.region_tool import Grip, grip_at, reshaped
from workbench.scene import RectangleRegion

MARGIN = (0.01, 0.02)


@pytest.mark.parametrize(
    ("place", "corners"),
    [
        ((0.245, 0.0), (1, 2)),
        ((-0.255, 0.1), (3, 0)),
        ((0.1, 0.235), (2, 3)),
        ((0.25, -0.25), (1,)),
        ((0.1, 0.1), ()),
        ((0.25, 0.28), ()),
    ],
)
def test_a_rectangle_is_held_by_sides_and_corners(place, corners):
    grip = grip_at([RectangleRegion(size=(0.5, 0.5))], place, MARGIN)
    assert grip == (Grip(0, corners) if corners else None)


def test_a_side_follows_the_hand_and_stays_on_the_receiver():
    region = RectangleRegion(name="Desk", center=(0.1, 0.0), size=(0.2, 0.4))
    wider = reshaped(region, Grip(0, (1, 2)), (0.2, 0.0), (0.3, 0.1))
    assert (wider.name, wider.center, wider.size) == ("Desk", (0.15, 0.0), (0.3, 0.4))
    widest = reshaped(region, Grip(0, (2,)), (0.2, 0.2), (0.9, 0.8))
    assert widest.outline.max() == 0.5
    widest.check_outline()
    across = reshaped(region, Grip(0, (1, 2)), (0.2, 0.0), (-0.2, 0.0))
    assert across.center == pytest.approx((-0.1, 0.0)) and across.size == pytest.approx((0.2, 0.4))
    assert reshaped(region, Grip(0, (1, 2)), (0.2, 0.0), (0.0, 0.0)) is region
