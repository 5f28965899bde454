"""The light that is wanted beside a receiver whose source blurs its image."""

import numpy as np
import pytest

from workbench.extended.blur import Blur
from workbench.extended.wanted import wanted_light


def test_light_without_a_size_is_wanted_on_the_receiver_alone(rng):
    target = rng.random((12, 10))
    wanted = wanted_light(target, Blur((0.0, 0.0)), (3, 2))
    assert wanted.shape == (16, 16)
    np.testing.assert_allclose(wanted[2:-2, 3:-3], target / target.sum())
    assert wanted[:2].sum() == 0


@pytest.mark.parametrize("margin", [(1, 1), (3, 3), (9, 7)])
def test_a_blurred_bright_border_wants_light_beyond_it(margin):
    wanted = wanted_light(np.ones((40, 30)), Blur((5.0, 5.0), "ellipse"), margin)
    m_x, m_y = margin
    inside = wanted[m_y:-m_y, m_x:-m_x]
    assert wanted.sum() == pytest.approx(1)
    assert np.ptp(inside) < 1e-12  # on the receiver it is the target
    assert 0.02 < 1 - inside.sum() < 0.3
    beyond = wanted[m_y - 1, m_x:-m_x]  # the first row above the receiver
    assert 0 < beyond.mean() < inside.mean()
