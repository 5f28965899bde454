"""Ink and paper of figures, and colours of values about zero on either ground."""

import numpy as np
import pytest
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure

from workbench.pictures.axes import SIGNED, paint

DARK, LIGHT = "#323232", "#efefef"


@pytest.fixture
def axes():
    return Figure().add_subplot()


def colour(image, value):
    return np.array(image.to_rgba(value)[:3])


def test_values_about_zero_are_dark_at_zero_on_a_dark_ground_and_bright_beyond(axes):
    image = axes.imshow(np.zeros((2, 2)), cmap=SIGNED, vmin=-1, vmax=1)
    white = colour(image, 0.0)
    paint(axes.figure, "white", DARK)
    np.testing.assert_allclose(colour(image, 0.0), to_rgb(DARK), atol=0.01)
    low, high = colour(image, -1.0), colour(image, 1.0)
    assert min(low.mean(), high.mean()) > 0.6
    assert low[2] > low[0] and high[0] > high[2]  # blue and red, as on a light ground
    paint(axes.figure, "black", LIGHT)
    np.testing.assert_array_equal(colour(image, 0.0), white)
    assert white.min() > 0.9


def test_colours_of_nothing_and_of_light_stay(axes):
    image = axes.imshow(np.ma.masked_all((2, 2)), cmap=SIGNED, vmin=-1, vmax=1)
    image.set_cmap(image.get_cmap().with_extremes(bad="#a8a8a8"))
    light = axes.imshow(np.zeros((2, 2)), cmap="inferno")
    paint(axes.figure, "white", DARK)
    assert image.get_cmap().get_bad()[:3] == pytest.approx(to_rgb("#a8a8a8"))
    assert light.get_cmap().name == "inferno"
