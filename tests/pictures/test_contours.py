"""Lines of equal light."""

import numpy as np
import pytest
from matplotlib.figure import Figure

from workbench.pictures.axes import Extent
from workbench.pictures.contours import Contours

EXTENT = Extent((-2.0, 2.0, -1.0, 1.0), "cm")


@pytest.fixture
def axes():
    return Figure().subplots()


@pytest.mark.parametrize("shape", [(100, 200), (300, 700)])
def test_lines_of_a_ramp_stand_where_its_values_are(axes, shape):
    x = -2 + 4 * (np.arange(shape[1]) + 0.5) / shape[1]
    Contours(axes, EXTENT).show(np.broadcast_to(x + 2, shape), 4.0)
    found = {float(text.get_text()): line.get_xdata() for text, line in both(axes)}
    assert sorted(found) == [1.0, 2.0, 3.0]
    for value, places in found.items():
        assert places == pytest.approx(value - 2, abs=1e-9)


def test_a_line_about_a_bright_spot_has_its_radius(axes):
    y, x = np.mgrid[1:-1:200j, -2:2:400j]
    Contours(axes, EXTENT).show(1 - np.hypot(x, y), 1.0)
    for text, line in both(axes):
        radius = np.hypot(*line.get_data())
        assert radius == pytest.approx(1 - float(text.get_text()), abs=0.02)


def test_numbers_are_those_of_the_colour_bar(axes):
    Contours(axes, EXTENT).show(np.linspace(0, 4e-6, 50)[:, None] * np.ones(50), 4e-6)
    assert {text.get_text() for text, _ in both(axes)} == {"1", "2", "3"}


def test_lines_follow_the_image_and_can_be_removed(axes):
    contours = Contours(axes, EXTENT)
    for _ in range(3):
        contours.show(np.linspace(0, 1, 50)[:, None] * np.ones(50), 1.0)
    count = len(axes.lines)
    assert count == len(axes.texts) > 2
    contours.clear()
    assert not axes.lines and not axes.texts


def test_a_row_of_pixels_has_no_lines(axes):
    Contours(axes, EXTENT).show(np.linspace(0, 1, 50)[None, :], 1.0)
    assert not axes.lines


def both(axes):
    return list(zip(axes.texts, axes.lines, strict=True))


def test_noise_is_one_artist_a_level_without_rings_around_single_cells(axes, rng):
    noise = rng.random((192, 192))
    noise[:96] = 0.0
    noise[40, 60] = 1.0
    Contours(axes, EXTENT).show(noise, 1.0)
    assert len(axes.lines) == len(axes.texts) == 4
    drawn = np.concatenate([line.get_ydata() for line in axes.lines])
    assert np.isnan(drawn).sum() > 50 and np.nanmax(drawn) < 0.1
