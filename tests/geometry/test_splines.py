"""B-splines: basis and bounds."""

from itertools import product

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.interpolate import BSpline

from workbench.geometry.basis import (
    basis_matrix,
    clamped_knots,
    greville,
    insertion_matrix,
)
from workbench.geometry.curvature import derivative_range
from workbench.geometry.surface import ControlNet

DEGREES = range(1, 8)


def net_sizes(degree):
    return (degree + 1, degree + 2, degree + 6, 40)


@pytest.mark.parametrize("degree", DEGREES)
def test_basis_and_derivatives_agree_with_scipy(degree, rng):
    for count in net_sizes(degree):
        knots = clamped_knots(count, degree)
        u = np.concatenate([[0.0, 1.0], np.unique(knots), rng.random(200)])
        for order in range(degree + 1):
            theirs = BSpline(knots, np.eye(count), degree)(u, nu=order)
            ours = basis_matrix(knots, degree, u, order)
            assert np.abs(ours - theirs).max() <= 1e-12 * max(1, np.abs(theirs).max())
        assert not basis_matrix(knots, degree, u, degree + 1).any()


@pytest.mark.parametrize("degree", DEGREES)
def test_basis_is_a_partition_of_unity_clamped_at_both_ends(degree, rng):
    for count in net_sizes(degree):
        knots = clamped_knots(count, degree)
        matrix = basis_matrix(knots, degree, np.concatenate([[0.0], rng.random(100), [1.0]]))
        assert np.abs(matrix.sum(axis=1) - 1).max() < 1e-14
        assert matrix.min() >= 0
        assert matrix[0, 0] == 1 and matrix[-1, -1] == 1


@pytest.mark.parametrize("degree", DEGREES)
def test_greville_abscissae_make_the_spline_the_identity(degree, rng):
    for count in net_sizes(degree):
        knots = clamped_knots(count, degree)
        u = rng.random(100)
        assert np.abs(basis_matrix(knots, degree, u) @ greville(knots, degree) - u).max() < 1e-14


@given(
    degree=st.integers(1, 7),
    extra=st.integers(0, 12),
    inserted=st.lists(st.floats(0.001, 0.999), min_size=1, max_size=12),
    seed=st.integers(0, 99),
)
def test_knot_insertion_leaves_the_spline_alone(degree, extra, inserted, seed):
    rng = np.random.default_rng(seed)
    coarse = clamped_knots(degree + 1 + extra, degree)
    fine = np.sort(np.concatenate([coarse, inserted]))
    heights = rng.normal(size=degree + 1 + extra)
    u = np.concatenate([[0.0, 1.0], rng.random(64)])
    before = BSpline(coarse, heights, degree)(u)
    after = BSpline(fine, insertion_matrix(coarse, fine, degree) @ heights, degree)(u)
    assert np.abs(after - before).max() < 1e-12


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


def dense(net, heights, order, parts):
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
    return values.reshape(m_x, samples, m_y, samples).transpose(0, 2, 1, 3).reshape(m_x, m_y, -1)


@pytest.mark.parametrize("shape, degree", NETS)
def test_values_stay_within_the_bounds(rng, shape, degree):
    net = ControlNet(shape, degree, (1.5, 0.7))
    heights = rng.normal(size=shape)
    for order, parts in product(ORDERS, [(1, 1), (3, 2)]):
        low, high = derivative_range(net, heights, order, parts)
        values = dense(net, heights, order, parts)
        slack = 1e-11 * (1 + np.abs(values).max())
        assert low.shape == values.shape[:2]
        assert (low <= values.min(axis=2) + slack).all(), (order, parts)
        assert (high >= values.max(axis=2) - slack).all(), (order, parts)
