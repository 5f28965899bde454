"""B-splines against scipy, and the identities that make them useful."""

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
