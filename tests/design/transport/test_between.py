"""Values between cells, and the places where they are as wanted."""

import numpy as np
import pytest
from scipy.ndimage import map_coordinates

from workbench.design.transport.between import between, whence

CELLS = 160
# Light of so much of each half, up to the middle of a cell, goes eight times as far as before.
_DARK, _STRETCH = 17 / CELLS, 8.0


@pytest.fixture
def own():
    """Numbers of cells along both axes."""
    return tuple(np.indices((CELLS, CELLS), np.float64))


def test_values_between_cells_are_linear_and_the_nearest_beyond_them(rng):
    values = rng.random((30, 41))
    at = rng.uniform(-4, 34, (150, 90)), rng.uniform(-4, 45, (150, 90))
    expected = map_coordinates(values, at, order=1, mode="nearest")
    assert between(values, at) == pytest.approx(expected, abs=1e-12)


def test_places_are_found_where_values_are_as_wanted(own, rng):
    x, y = own
    to = x + 6 * np.sin(y / 20) + 4 * np.sin(x / 10), y + 5 * np.sin(x / 30)
    wanted = rng.uniform(20, CELLS - 20, (2, 50, 70))
    at = whence(to, wanted, wanted)
    assert [between(each, at) for each in to] == pytest.approx(wanted, abs=2e-3)
