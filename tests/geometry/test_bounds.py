import numpy as np
import pytest
from scipy.interpolate import BSpline, NdBSpline

from workbench.geometry.curvature import derivative_range
from workbench.geometry.surface import ControlNet

NETS = [((9, 7), (3, 3)), ((6, 8), (1, 2)), ((12, 9), (7, 4)), ((4, 4), (3, 3)), ((5, 2), (2, 1))]
ORDERS = [(0, 0), (1, 0), (0, 1), (1, 1), (2, 0), (0, 2)]


def derivative(net, heights, order, x, y):
    """The derivative by scipy; one-sided at knots, from the right."""
    knots = [(2 * k - 1) * r for k, r in zip(net.knots, net.half_width, strict=True)]
    values = heights
    for axis, at in ((0, x), (1, y)):
        spline = BSpline(knots[axis], values, net.degree[axis], axis=axis)
        nu = order[axis]
        values = spline(at, nu=nu)
    return values


@pytest.mark.parametrize("shape, degree", NETS)
@pytest.mark.parametrize("order", ORDERS)
class TestRange:
    def dense(self, net, heights, order, parts):
        """Values at places all over each part: [part_x, part_y, sample]."""
        samples = 9
        at = []
        for n, p, r, k in zip(net.shape, net.degree, net.half_width, parts, strict=True):
            cells = (n - p) * k
            within = np.linspace(1e-12, 1 - 1e-12, samples)  # both ends, but in no other part
            places = (np.arange(cells)[:, None] + within) / cells
            at.append((2 * places.ravel() - 1) * r)
        values = derivative(net, heights, order, *at)
        m_x, m_y = (len(a) // samples for a in at)
        return (
            values.reshape(m_x, samples, m_y, samples).transpose(0, 2, 1, 3).reshape(m_x, m_y, -1)
        )

    @pytest.mark.parametrize("parts", [(1, 1), (3, 2)])
    def test_values_stay_within_the_bounds(self, rng, shape, degree, order, parts):
        net = ControlNet(shape, degree, (1.5, 0.7))
        heights = rng.normal(size=shape)
        low, high = derivative_range(net, heights, order, parts)
        values = self.dense(net, heights, order, parts)
        slack = 1e-11 * (1 + np.abs(values).max())
        assert low.shape == values.shape[:2]
        assert (low <= values.min(axis=2) + slack).all()
        assert (high >= values.max(axis=2) - slack).all()


def test_reference_agrees_with_the_tensor_spline(rng):
    net = ControlNet((9, 7), (3, 3), (1.5, 0.7))
    heights = rng.normal(size=(9, 7))
    knots = [(2 * k - 1) * r for k, r in zip(net.knots, net.half_width, strict=True)]
    x, y = np.linspace(-1.4, 1.4, 5), np.linspace(-0.6, 0.6, 4)
    places = np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1)
    tensor = NdBSpline(tuple(knots), heights, 3)(places, nu=(1, 1))
    assert derivative(net, heights, (1, 1), x, y) == pytest.approx(tensor)
