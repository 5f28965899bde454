"""Regions: what a hand holds, and marks over the image."""

import numpy as np
import pytest
from matplotlib.figure import Figure

from tests.scenes import changed
from ui.views.region_tool import Grip, RegionMarks, grip_at, reshaped
from workbench.scene import RectangleRegion, Scene

MARGIN = (0.01, 0.02)


@pytest.mark.parametrize(
    ("place", "sides"),
    [
        ((0.245, 0.0), (1,)),
        ((-0.255, 0.1), (0,)),
        ((0.1, 0.235), (3,)),
        ((0.25, -0.25), (1, 2)),
        ((0.1, 0.1), ()),
        ((0.25, 0.28), ()),
    ],
)
def test_a_rectangle_is_held_by_sides_and_corners(place, sides):
    grip = grip_at([RectangleRegion(size=(0.5, 0.5))], place, MARGIN)
    assert grip == (Grip(0, sides=sides) if sides else None)


def test_a_side_follows_the_hand_and_stays_on_the_receiver():
    region = RectangleRegion(name="Desk", center=(0.1, 0.0), size=(0.2, 0.4))
    wider = reshaped(region, Grip(0, sides=(1,)), (0.2, 0.0), (0.3, 0.1))
    assert (wider.name, wider.center, wider.size) == ("Desk", (0.15, 0.0), (0.3, 0.4))
    widest = reshaped(region, Grip(0, sides=(1, 3)), (0.2, 0.2), (0.9, 0.8))
    assert widest.outline.max() == 0.5
    widest.check_outline()
    across = reshaped(region, Grip(0, sides=(1,)), (0.2, 0.0), (-0.2, 0.0))
    assert across.center == pytest.approx((-0.1, 0.0)) and across.size == pytest.approx((0.2, 0.4))
    assert reshaped(region, Grip(0, sides=(1,)), (0.2, 0.0), (0.0, 0.0)) is region


@pytest.fixture
def axes():
    return Figure().add_subplot()


def scene_with(*regions):
    return Scene.from_data(changed({"regions": list(regions)}))


def test_outlines_are_in_coordinates_of_the_screen(axes):
    desk = {"name": "Desk", "center": [0.25, 0], "size": [0.5, 0.25]}
    outline, text = RegionMarks(axes, scene_with(desk)).artists
    assert text.get_text() == "Desk"
    corners = outline.get_xydata()
    np.testing.assert_array_equal(corners[0], corners[-1])
    np.testing.assert_allclose(corners.min(axis=0), [0, -0.25])
    np.testing.assert_allclose(corners.max(axis=0), [1, 0.25])


def test_each_region_says_its_share_and_how_even_it_is(axes):
    marks = RegionMarks(axes, scene_with({"name": "Left", "center": [-0.25, 0], "size": [0.5, 1]}))
    irradiance = np.full((32, 32), 0.25)
    irradiance[0] = 0.125
    marks.show_light(irradiance)
    _, text = marks.artists
    assert text.get_text() == "Left 49.2 %\nleast / mean 0.51"
