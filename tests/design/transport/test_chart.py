"""Coordinates of places by the slopes that their light needs."""

import numpy as np
import pytest

from workbench.design.transport.chart import Chart
from workbench.design.transport.view import ReceiverView

CELLS = 64


@pytest.fixture
def view(make_scene):
    """Of a screen whose coordinates go from -1 to 1."""
    return ReceiverView.of(
        make_scene({"lens.half_width": [1.0, 1.0], "screen.half_width": [1.0, 1.0]})
    )


def _slopes_for(cell, to):
    """Slopes that are even in the third power of a place, and differ along the lens besides."""
    x, y = ((2 * c + 1) / CELLS - 1 for c in cell)
    u, v = to
    return u + 0.2 * u**3 - 0.4 * x, v + 0.1 * u - 0.4 * y


def test_a_chart_has_places_by_their_slopes_and_finds_them_again(view):
    wanted = np.full((CELLS, CELLS), CELLS**-2.0)
    begins = ReceiverView.grid(CELLS)
    chart = Chart.of(view, wanted, _slopes_for, begins)
    u, v = view.seen(CELLS)
    # What is linear in the place that light comes from, here that of the cell itself, is left out.
    for found, needed in ((chart.x, u + 0.2 * u**3), (chart.y, v + 0.1 * u)):
        inner = (slice(4, -4), slice(4, -4))
        known = np.column_stack([f[inner].ravel() for f in (needed, u, v, np.ones_like(u))])
        parts = np.linalg.lstsq(known, found[inner].ravel())[0]
        assert np.abs(known @ parts - found[inner].ravel()).max() < 0.1  # of a cell
    assert chart.places(_Identity(chart)) == pytest.approx(np.stack([u, v]), abs=1e-3)


class _Identity:
    """A transport that brings light to the middle of each cell of a view."""

    def __init__(self, chart):
        self._chart = chart

    def map(self):
        return self._chart.x, self._chart.y


def test_transport_in_a_chart_keeps_all_light(view):
    wanted = np.random.default_rng(1).random((CELLS, CELLS))
    wanted /= wanted.sum()
    chart = Chart.of(view, wanted, _slopes_for, ReceiverView.grid(CELLS))
    even = np.full((CELLS, CELLS), CELLS**-2.0)
    transport = chart.transport(even, wanted)
    u, v = chart.places(transport)
    inside = (np.abs(u) <= 1.02) & (np.abs(v) <= 1.02)
    assert inside.all()
    # Even light over even noise goes nearly where it is.
    x, y = view.seen(CELLS)
    assert np.hypot(u - x, v - y).mean() < 0.1
