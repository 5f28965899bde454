"""When the two traces of the check, or a run and the check, contradict each other."""

import numpy as np
import pytest

from workbench.analysis.agreement import Agreement, RandomShare, run_apart
from workbench.analysis.scatter import CorrectedDistance


def share(values, rays=1_000_000):
    return RandomShare.of(float(np.mean(values)), values, rays)


def agreement(share, expected, distance, bound=1e-3, off=0.0):
    return Agreement(expected, off, share, bound, distance)


@pytest.fixture
def batches(rng):
    return 0.6 + 1e-3 * rng.normal(size=16)


@pytest.fixture
def same(rng):
    """The distance of two equal images."""
    return CorrectedDistance.of(1e-4 * rng.normal(size=16))


def test_chance_alone_is_no_contradiction(rng, same):
    """Of 20,000 checks whose rays scatter around the cells, none gives an alarm."""
    found = (share(0.6 + 1e-3 * row) for row in rng.normal(size=(20_000, 16)))
    assert not any(each.off(0.6, 0.0) for each in found)
    found = map(CorrectedDistance.of, 1e-3 * rng.normal(size=(20_000, 16)))
    even = share(np.full(16, 0.6))
    assert not any(agreement(even, 0.6, each).contradiction for each in found)


def test_shares_beyond_noise_and_bound_are_a_contradiction(batches, same):
    found = agreement(share(batches), 0.61, same).contradiction
    assert found.startswith("the check contradicts itself: 61 % of the light")
    assert agreement(share(batches), 0.61, same, off=0.01).contradiction is None


def test_a_run_beside_the_check():
    assert run_apart(0.015, 0.0, 0.7, 0.702, 0.0) is None
    assert run_apart(0.3, 0.0004, 0.7, 0.7, 0.0).startswith("the image of the run is 30 % off")
    assert run_apart(0.0, 0.0, 1.13, 0.99, 0.001).startswith("the run finds 113 % of the light")
    assert run_apart(0.3, 0.3, 0.7, 0.7, 0.0) is None
