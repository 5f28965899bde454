"""Values on grids of cells twice and half as large."""

import numpy as np
import pytest

from workbench.design.transport.halves import doubled, halved


def test_larger_cells_hold_the_mass_of_their_parts(rng):
    mass = rng.random((6, 4))
    assert halved(mass)[2, 1] == pytest.approx(mass[4:6, 2:4].sum())
    assert halved(mass).sum() == pytest.approx(mass.sum())


def test_smaller_cells_have_the_values_of_a_plane_to_its_rim():
    x, y = np.indices((5, 7))
    finer_x, finer_y = (np.indices((10, 14)) - 0.5) / 2  # in the larger cells
    assert doubled(3.0 * x - 2.0 * y + 1) == pytest.approx(3 * finer_x - 2 * finer_y + 1)
