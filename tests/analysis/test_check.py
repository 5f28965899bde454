"""The independent check in steps, and by cells."""

import numpy as np
import pytest

from tests.analysis.lenses import net_of
from workbench.analysis.by_cells import Agreement, RandomShare, run_apart
from workbench.analysis.metrics import paper_loss, relative_l2
from workbench.analysis.scatter import CorrectedDistance
from workbench.analysis.validation import validate


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


POINT = {"kind": "point", "position": [0.3, -0.2, -4.0]}


GRID = {"kind": "grid", "center": [0.1, 0, -4], "half_width": [0.5, 1], "points": [2, 3]}


@pytest.fixture
def lens(make_scene):
    def make(source):
        scene = make_scene({"source": source, "screen.half_width": [1.4, 1.1]})
        heights = net_of(scene, lambda x, y: 0.5 - 0.08 * x**2 + 0.03 * np.sin(x + 2 * y))
        return scene, {"lens.back": heights}

    return make


@pytest.fixture
def target(rng):
    return 1 + rng.random((32, 32))


@pytest.mark.parametrize("source", [{"kind": "collimated"}, POINT, GRID])
def test_both_say_the_same_of_each_kind_of_source(lens, target, source):
    scene, heights = lens(source)
    found = validate(scene, target, heights, 1_000_000, seed=4, accuracy=2e-3)
    exact = found.by_cells
    low, high = found.relative_l2_corrected_interval
    assert low < exact.relative_l2_corrected < high
    assert exact.bound <= exact.relative_l2_corrected / 40
    assert exact.unscattered.interval[0] == 0
    assert found.contradiction is None
    assert found.beside_run(1.004 * exact.irradiance, scene.receiver) is None
    assert exact.difference_over_noise == pytest.approx(1, abs=0.1)
    assert exact.efficiency == pytest.approx(found.efficiency, abs=1e-3)
    assert exact.relative_l2_corrected == relative_l2(exact.irradiance, target)
    assert exact.loss == paper_loss(exact.irradiance, target)


def test_the_error_of_the_lens_itself_is_that_by_cells(lens, target):
    scene, heights = lens({"kind": "collimated"})
    found = validate(scene, target, heights, 10_000, accuracy=1e-2)
    assert found.verified is found.by_cells
    expected = found.loss * found.verified.relative_l2_corrected / found.relative_l2
    assert found.loss_corrected == pytest.approx(expected)
    assert found.loss_corrected == pytest.approx(found.by_cells.loss, rel=0.1)
