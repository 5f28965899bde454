"""Mass that is carried along a map."""

import numpy as np
import pytest

from workbench.design.transport.push import push


@pytest.mark.parametrize(("fewest", "wave"), [(1, 0.01), (6, 0.005)])
def test_even_light_stays_even_where_cells_come_nearer_to_each_other(fewest, wave):
    """Uncut cells 0.9 apart make waves of more than the first part, cut ones of less than both."""
    cells = np.arange(100.0)
    x, y = np.meshgrid(0.9 * cells + 5, cells, indexing="ij")
    light = push(np.ones((100, 100)), x, y, fewest)
    assert light.sum() == pytest.approx(100**2)
    inner = light[10:90, 10:90] * 0.9
    off = np.abs(inner - 1).max()
    assert off > wave if fewest == 1 else off < wave
