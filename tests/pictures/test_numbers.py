"""TickLabels at axes and colour bars, and the power of ten that they are multiples of."""

import numpy as np
import pytest
from matplotlib.figure import Figure

from workbench.pictures.axes import Extent, colour_bar, map_image
from workbench.pictures.figure_data import shown_data


@pytest.fixture
def image():
    """A map with a colour bar."""
    axes = Figure().subplots()
    image = map_image(axes, "height", Extent.around((1.0, 1.0), "mm"), (2, 2), "gray")
    colour_bar(axes, image, "height (mm)", "both")
    return image


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
