"""TickLabels at axes and colour bars, and the power of ten that they are multiples of."""

import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator

from workbench.pictures.axes import Extent, colour_bar, map_image, set_tick_labels
from workbench.pictures.figure_data import shown_data


@pytest.fixture
def image():
    """A map with a colour bar."""
    axes = Figure().subplots()
    image = map_image(axes, "height", Extent.around((1.0, 1.0), "mm"), (2, 2), "gray")
    colour_bar(axes, image, "height (mm)", "both")
    return image


def axis_texts(low, high, places):
    axes = Figure().subplots()
    axes.set_xlim(low, high)
    axes.xaxis.set_major_locator(FixedLocator(places))
    set_tick_labels(axes, "x")
    axes.figure.draw_without_rendering()
    return [text.get_text() for text in axes.get_xticklabels()]


def test_numbers_have_as_many_decimals_as_one_of_them_needs():
    assert axis_texts(0, 3, [0, 1, 2, 3]) == ["0", "1", "2", "3"]
    assert axis_texts(-1, 1, [-1, -0.5, 0, 0.5, 1]) == ["−1.0", "−0.5", "0.0", "0.5", "1.0"]
    assert axis_texts(0, 0.0573, [0.05]) == ["0.05"]  # alone, too
    assert axis_texts(100_000, 100_001, [100_000.25, 100_000.5]) == ["100.00025", "100.00050"]


def test_axes_have_a_power_too_and_files_of_numbers_have_none():
    axes = Figure().subplots()
    image = map_image(axes, "height", Extent.around((0.004, 0.004), "m"), (2, 2), "gray")
    colour_bar(axes, image, "height (m)", "both")
    image.set_data(np.full((2, 2), 3e-5))
    image.set_clim(0, 4e-5)
    axes.figure.draw_without_rendering()
    assert axes.get_xlabel() == "x (10⁻³ m)"
    assert "−2" in {text.get_text() for text in axes.get_xticklabels()}
    x, y, height = shown_data(axes.figure)
    assert [each.name for each in (x, y, height)] == ["x [m]", "y [m]", "height [m]"]
    assert height.values == pytest.approx(3e-5)
    assert np.abs(x.values).max() == pytest.approx(0.002)
