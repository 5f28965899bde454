"""The c-transform against its definition."""

import numpy as np
import pytest

from workbench.design.transport.envelope import c_transform


@pytest.mark.parametrize("shape", [(7, 12), (2, 9), (16, 16)])
@pytest.mark.parametrize("weights", [(1.0, 1.0), (0.25, 4.0)])
def test_envelope_is_the_least_of_all_parabolas(rng, shape, weights):
    potential = 5 * rng.normal(size=shape)
    a, b = (np.arange(m, dtype=float) for m in shape)
    cost_0 = 0.5 * weights[0] * (a[:, None] - a) ** 2
    cost_1 = 0.5 * weights[1] * (b[:, None] - b) ** 2
    everything = cost_0[:, None, :, None] + cost_1[None, :, None, :] - potential
    expected = everything.min(axis=(2, 3))
    assert c_transform(potential, *weights) == pytest.approx(expected, abs=1e-12)


def test_equal_values_leave_none_out():
    assert c_transform(np.zeros((5, 5)), 1.0, 1.0) == pytest.approx(0.0, abs=0)


def test_three_transforms_are_one(rng):
    potential = rng.normal(size=(10, 8))
    once = c_transform(potential, 1.0, 2.0)
    assert c_transform(c_transform(once, 1.0, 2.0), 1.0, 2.0) == pytest.approx(once, abs=1e-12)


def test_threads_share_the_lines(rng, monkeypatch):
    potential = rng.normal(size=(9, 13))
    alone = c_transform(potential, 1.0, 2.0)
    monkeypatch.setattr("workbench.optics.kernels.threads.parts", lambda cells: 4)
    assert (c_transform(potential, 1.0, 2.0) == alone).all()
