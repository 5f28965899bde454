"""Values between cells, and the places where they are as wanted."""

import numpy as np
import pytest
from scipy.ndimage import map_coordinates

from workbench.design.transport.between import between, whence

CELLS = 160
# Light of so much of each half, up to the middle of a cell, goes eight times as far as before.
_DARK, _STRETCH = 17 / CELLS, 8.0
_BRIGHT = (1 - _DARK * _STRETCH) / (1 - _DARK)


@pytest.fixture
def own():
    """Numbers of cells along both axes."""
    return tuple(np.indices((CELLS, CELLS), np.float64))


def _in_cells(part):
    """Places from -1 to 1 over all cells, counted in cells."""
    return ((part + 1) * CELLS - 1) / 2


def test_values_between_cells_are_linear_and_the_nearest_beyond_them(rng):
    values = rng.random((30, 41))
    at = rng.uniform(-4, 34, (150, 90)), rng.uniform(-4, 45, (150, 90))
    expected = map_coordinates(values, at, order=1, mode="nearest")
    assert between(values, at) == pytest.approx(expected, abs=1e-12)


def test_values_of_a_transposed_array_are_found_at_places_of_another_shape():
    values = np.arange(12.0).reshape(4, 3).T
    found = between(values, (np.array([0.5, 2.0]), np.array([1, 3])))
    assert found == pytest.approx([3.5, 11.0])


def test_places_are_found_where_values_are_as_wanted(own, rng):
    x, y = own
    to = x + 6 * np.sin(y / 20) + 4 * np.sin(x / 10), y + 5 * np.sin(x / 30)
    wanted = rng.uniform(20, CELLS - 20, (2, 50, 70))
    at = whence(to, wanted, wanted)
    assert [between(each, at) for each in to] == pytest.approx(wanted, abs=2e-3)


def test_light_spread_over_many_times_its_area_is_found(own):
    even = np.stack([2 * (place + 0.5) / CELLS - 1 for place in own])
    rim, size = _DARK * _STRETCH, np.abs(even)
    places = np.sign(even) * np.where(size < _DARK, _STRETCH * size, rim + _BRIGHT * (size - _DARK))
    back = np.where(size < rim, size / _STRETCH, _DARK + (size - rim) / _BRIGHT)
    found = whence(_in_cells(places), own, own)
    off = np.abs(np.stack(found) - _in_cells(np.sign(even) * back)).max(0)
    known = (back < 1 - 1 / CELLS).all(0)  # beyond the last light the nearest counts
    assert off[known].mean() < 0.02
    assert all(((place >= -0.5) & (place <= CELLS - 0.5)).all() for place in found)
