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
