import numpy as np
import pytest

from workbench.analysis.manufacture_bounds import shape_bounds
from workbench.geometry.curvature import local_shape
from workbench.geometry.surface import ControlNet

LINE = np.linspace(0, 1, 301)


def attained(net, heights):
    shape = local_shape(net, heights, LINE, LINE)
    return shape.slope.max(), shape.largest.max(), -shape.smallest.min()


@pytest.mark.parametrize("degree", [(2, 2), (3, 3), (4, 2), (5, 7)])
def test_bounds_hold_and_tighten_with_more_parts(degree, rng):
    net = ControlNet((9, 10), degree, (1.0, 0.7))
    heights = 0.02 * rng.random(net.shape)
    most = attained(net, heights)
    coarse, fine = (np.array(shape_bounds(net, heights, (k, k))) for k in (4, 32))
    assert (fine >= np.array(most) * (1 - 1e-12)).all()
    assert (fine <= coarse).all()
    assert fine == pytest.approx(most, rel=0.07)


def test_steep_slopes_count(rng):
    """Across a steep plane bends are softer than second derivatives say; bounds know it."""
    net = ControlNet((6, 6), (3, 3), (1.0, 1.0))
    x, _ = net.positions
    heights = 2.0 * x[:, None] + 0.05 * rng.random(net.shape)
    slope, hollow, hump = shape_bounds(net, heights, (64, 64))
    most = attained(net, heights)
    assert [slope, hollow, hump] == pytest.approx(most, rel=0.05)
