"""Changes of a net as cosine waves."""

from itertools import pairwise

import numpy as np
import pytest
import torch
from scipy.fft import dctn, idctn

from workbench.design.waves import Waves

SHAPE = 9, 6


def wave(p, q):
    """The cosine wave of p and q half periods over a net, of length 1."""
    along = [
        torch.cos(torch.pi * k * (torch.arange(n).double() + 0.5) / n)
        for k, n in zip((p, q), SHAPE, strict=True)
    ]
    each = torch.outer(*along)
    return each / each.norm()


def eased(waves, gradient):
    """What a descent along the amplitudes of waves changes the net by."""
    return waves.change(waves.amplitudes(gradient)).to(gradient)


def test_waves_stay_themselves_and_long_ones_are_large():
    waves = Waves(SHAPE, 1.25, (False, False))
    for p, q in np.ndindex(SHAPE):
        square = (1 + (p / 2) ** 2 + (q / 2) ** 2) ** -1.25
        assert torch.allclose(eased(waves, wave(p, q)), square * wave(p, q), rtol=0, atol=1e-14)
    sizes = [eased(waves, wave(0, q)).norm().item() for q in range(SHAPE[1])]
    assert sizes[0] == pytest.approx(1.0)
    assert all(longer > shorter for longer, shorter in pairwise(sizes))


@pytest.mark.parametrize("mirrored", [(True, False), (False, True), (True, True)])
def test_only_even_waves_are_left_of_a_mirrored_net(mirrored, rng):
    waves, every = (Waves(SHAPE, 1.25, each) for each in (mirrored, (False, False)))
    some = torch.as_tensor(rng.normal(size=SHAPE))
    made, even = eased(waves, some), eased(every, some)
    for axis, each in enumerate(mirrored):
        assert torch.allclose(made, made.flip(axis), atol=1e-12) == each
        even = (even + even.flip(axis)) / 2 if each else even
    assert torch.allclose(made, even, rtol=0, atol=1e-13)


def test_larger_waves_in_places_leave_a_symmetric_and_positive_change(rng):
    eases = rng.uniform(0.3, 3.0, SHAPE)
    waves = Waves(SHAPE, 1.25, (True, False), eases=eases)
    one, other = (torch.as_tensor(rng.normal(size=SHAPE)) for _ in range(2))
    by_one = (waves.amplitudes(one) * other).sum()
    assert torch.isclose(by_one, (one * waves.change(other)).sum())
    assert (eased(waves, one) * one).sum() > 0
    even = Waves(SHAPE, 1.25, (True, False), eases=np.full(SHAPE, 3.0))
    plain = Waves(SHAPE, 1.25, (True, False))
    assert torch.allclose(eased(even, one), 9 * eased(plain, one), rtol=0, atol=1e-13)


def test_waves_that_a_blur_damps_are_of_one_size():
    shape = 401, 61
    every = torch.as_tensor(idctn(np.ones(shape), norm="ortho"))
    sharp, blurred = (
        dctn(eased(Waves(shape, 1.25, (False, False), widths), every).numpy(), norm="ortho")
        for widths in ((0.0, 0.0), (0.1, 0.0))
    )
    # Along u, those of many periods within the blur; along v nothing is damped.
    assert sharp[200, 0] > 5 * sharp[400, 0]
    assert blurred[200, 0] == pytest.approx(blurred[400, 0], rel=0.02)
    np.testing.assert_allclose(blurred[0], sharp[0], rtol=1e-9)
    np.testing.assert_allclose(blurred[:2], sharp[:2], rtol=0.02)
