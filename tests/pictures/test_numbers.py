"""TickLabels at axes and colour bars, and the power of ten that they are multiples of."""

import numpy as np
import pytest
from matplotlib.colors import LogNorm, Normalize
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator

from workbench.pictures.axes import Extent, colour_bar, map_image, set_tick_labels, show_constant
from workbench.pictures.figure_data import shown_data


@pytest.fixture
def image():
    """A map with a colour bar."""
    axes = Figure().subplots()
    image = map_image(axes, "height", Extent.around((1.0, 1.0), "mm"), (2, 2), "gray")
    colour_bar(axes, image, "height (mm)", "both")
    return image


def bar_texts(image):
    image.figure.draw_without_rendering()
    axis = image.colorbar.ax.yaxis
    low, high = axis.get_view_interval()
    places = zip(axis.get_majorticklocs(), axis.get_ticklabels(), strict=True)
    return [text.get_text() for at, text in places if low <= at <= high]


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


def test_rounding_makes_neither_decimals_nor_a_negative_zero():
    assert axis_texts(-1, 1, [-1e-17, 0.1 + 0.2]) == ["0.0", "0.3"]


def test_the_bar_follows_its_scale(image):
    image.set_clim(-5e-5, 5e-5)
    assert image.colorbar.ax.get_ylabel() == "height (10⁻⁶ mm)"
    assert {"−40", "−20", "0", "20", "40"} <= {*bar_texts(image)}
    image.set_clim(-5, 5)
    assert image.colorbar.ax.get_ylabel() == "height (mm)"
    assert {"−4", "0", "4"} <= {*bar_texts(image)}


def test_a_logarithmic_bar_has_its_own_powers_and_an_even_one_after_it_ours(image):
    for _ in range(2):
        image.set_norm(LogNorm(1e-8, 1e-5))
        assert image.colorbar.ax.get_ylabel() == "height (mm)"
        image.set_norm(Normalize(0, 4e-5))
        assert image.colorbar.ax.get_ylabel() == "height (10⁻⁶ mm)"
        assert bar_texts(image) == ["0", "5", "10", "15", "20", "25", "30", "35", "40"]


def test_one_value_is_a_multiple_of_its_power():
    axes = Figure().subplots()
    image = map_image(axes, "height", Extent.around((1.0, 1.0), "mm"), (2, 2), "gray")
    show_constant(image, 1.25e-5, "1 / mm")
    assert bar_texts(image) == ["12.5"]
    assert image.colorbar.ax.get_ylabel() == "10⁻⁶ / mm, constant"


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
