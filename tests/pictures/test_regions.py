"""Marks of regions over an image."""

import numpy as np
import pytest
from matplotlib.figure import Figure

from tests.scenes import changed
from workbench.pictures.regions import RegionMarks
from workbench.scene import Scene


@pytest.fixture
def axes():
    return Figure().add_subplot()


def scene_with(*regions):
    return Scene.from_data(changed({"regions": list(regions)}))


def test_outlines_are_in_coordinates_of_the_screen(axes):
    desk = {"name": "Desk", "center": [0.25, 0], "size": [0.5, 0.25]}
    RegionMarks(axes, scene_with(desk))
    (outline,), (text,) = axes.lines, axes.texts
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
    (text,) = axes.texts
    assert text.get_text() == "Left 49.2 %\nU₀ 0.51"
