"""Surfaces on other nets: exact where the net allows, nearest where it does not."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench.geometry.approximation import deviation, nearest_finer, project
from workbench.geometry.surface import ControlNet

HALF_WIDTH = (1.5, 0.7)


def net(*shape, degree=(3, 3)):
    return ControlNet(shape, degree, HALF_WIDTH)


def spans(coarse, factor):
    """The net that divides each span of another one."""
    shape = [factor * (n - p) + p for n, p in zip(coarse.shape, coarse.degree, strict=True)]
    return ControlNet(tuple(shape), coarse.degree, HALF_WIDTH)


def fine_values(surface, heights, count=301):
    t = np.linspace(0, 1, count)
    return surface.grid(t, t).evaluate(heights)[0]


@given(
    degree=st.tuples(st.integers(1, 7), st.integers(1, 7)),
    extra=st.tuples(st.integers(0, 9), st.integers(0, 9)),
    factor=st.integers(2, 4),
    seed=st.integers(0, 99),
)
def test_a_finer_net_holds_the_surface_exactly_by_either_way(degree, extra, factor, seed):
    coarse = net(*(p + 1 + more for p, more in zip(degree, extra, strict=True)), degree=degree)
    fine = spans(coarse, factor)
    assert fine.contains(coarse)
    heights = np.random.default_rng(seed).normal(size=coarse.shape)
    refined = coarse.refine(heights, fine)
    assert deviation(coarse, heights, fine, refined) < 1e-11
    assert np.abs(project(coarse, heights, fine) - refined).max() < 1e-7  # degree 7: 2 of 16 digits
    # And back: what the coarse net can hold comes out as it was.
    assert np.abs(project(fine, refined, coarse) - heights).max() < 1e-7


def test_only_nets_that_divide_spans_contain_each_other(rng):
    coarse = net(64, 40)
    assert net(125, 77).contains(coarse) and net(64, 40).contains(coarse)
    assert net(64, 77).contains(coarse)
    assert not net(128, 80).contains(coarse)
    assert not net(32, 40).contains(coarse)
    assert not net(125, 77, degree=(3, 2)).contains(coarse)
    # The same knots, and yet another space.
    assert not net(8, 8, degree=(4, 4)).contains(net(7, 7))


def test_the_deviation_is_the_largest_there_is(rng):
    fine, coarse = net(23, 17), net(9, 8)
    heights = rng.normal(size=fine.shape)
    found = project(fine, heights, coarse)
    dense = np.abs(fine_values(fine, heights, 1201) - fine_values(coarse, found, 1201)).max()
    assert deviation(fine, heights, coarse, found) == pytest.approx(dense, rel=0.05)


def test_the_nearest_net_that_holds_the_surface():
    coarse = net(64, 40)  # 61 and 37 spans
    assert nearest_finer(coarse, (128, 128), 1024) == (125, 114)
    assert nearest_finer(coarse, (64, 10), 1024) == (64, 40)
    assert nearest_finer(coarse, (1024, 1024), 1024) == (979, 1002)
    for wanted in ((70, 200), (300, 41)):
        assert net(*nearest_finer(coarse, wanted, 1024)).contains(coarse)
