"""Where rays meet faces that are straight between cells."""

import numpy as np
import pytest

from workbench.design.transport.meeting import met

CELL = 0.1, 0.05


@pytest.fixture
def middles():
    """Middles of 20 × 40 cells."""
    x, y = np.indices((20, 40), np.float64)
    return (x - 9.5) * CELL[0], (y - 19.5) * CELL[1]


def test_rays_meet_a_plane_that_leans_where_lines_do(middles, rng):
    x, y = middles
    face = 0.3 + 0.4 * x - 0.2 * y, np.full_like(x, 0.4), np.full_like(x, -0.2)
    place, rise = rng.uniform(-0.3, 0.3, (2, 30, 50)), rng.uniform(-0.5, 0.5, (2, 30, 50))
    height, slope_x, slope_y = met(face, CELL, place, rise)
    z = (0.3 + 0.4 * place[0] - 0.2 * place[1]) / (1 - 0.4 * rise[0] + 0.2 * rise[1])
    assert height == pytest.approx(z, abs=1e-12)
    assert slope_x == pytest.approx(0.4) and slope_y == pytest.approx(-0.2)


def test_rays_meet_a_bowl_within_a_hundredth_of_a_cell(middles, rng):
    x, y = middles
    face = 0.2 * x**2 + 0.3 * y**2, 0.4 * x, 0.6 * y
    place, rise = rng.uniform(-0.6, 0.6, (2, 40, 40)), rng.uniform(-0.8, 0.8, (2, 40, 40))
    height, slope_x, slope_y = met(face, CELL, place, rise)
    at_x, at_y = (p + r * height for p, r in zip(place, rise, strict=True))
    assert height == pytest.approx(0.2 * at_x**2 + 0.3 * at_y**2, abs=1e-3)
    assert slope_x == pytest.approx(0.4 * at_x, abs=1e-2)
    assert slope_y == pytest.approx(0.6 * at_y, abs=1e-2)
