"""Changes of a net as cosine waves."""

from itertools import pairwise

import numpy as np
import pytest
import torch
from scipy.fft import dctn, idctn

from workbench.design.waves import FaceWaves, Waves

SHAPE = 9, 6


def wave(p, q):
    """The cosine wave of p and q half periods over a net, of length 1."""
    along = [
        torch.cos(torch.pi * k * (torch.arange(n).double() + 0.5) / n)
        for k, n in zip((p, q), SHAPE, strict=True)
    ]
    each = torch.outer(*along)
    return each / each.norm()


def test_waves_stay_themselves_and_long_ones_are_large():
    waves = Waves(SHAPE, 1.25, (False, False))
    for p, q in np.ndindex(SHAPE):
        square = (1 + (p / 2) ** 2 + (q / 2) ** 2) ** -1.25
        assert torch.allclose(waves.eased(wave(p, q)), square * wave(p, q), rtol=0, atol=1e-14)
    sizes = [waves.eased(wave(0, q)).norm().item() for q in range(SHAPE[1])]
    assert sizes[0] == pytest.approx(1.0)
    assert all(longer > shorter for longer, shorter in pairwise(sizes))


@pytest.mark.parametrize("mirrored", [(True, False), (False, True), (True, True)])
def test_only_even_waves_are_left_of_a_mirrored_net(mirrored, rng):
    waves, every = (Waves(SHAPE, 1.25, each) for each in (mirrored, (False, False)))
    some = torch.as_tensor(rng.normal(size=SHAPE))
    made, even = waves.eased(some), every.eased(some)
    for axis, each in enumerate(mirrored):
        assert torch.allclose(made, made.flip(axis), atol=1e-12) == each
        even = (even + even.flip(axis)) / 2 if each else even
    assert torch.allclose(made, even, rtol=0, atol=1e-13)


def test_only_the_longest_waves_are_left_of_a_part(rng):
    some = torch.as_tensor(rng.normal(size=SHAPE))
    made, every = (
        dctn(Waves(SHAPE, 1.25, (False, False), longest=part).eased(some).numpy(), norm="ortho")
        for part in (0.3, 1.0)
    )
    # 3 of 9 along u, and 2 of 6 along v.
    np.testing.assert_allclose(made[:3, :2], every[:3, :2], rtol=1e-12)
    assert np.abs(made[3:]).max() < 1e-14
    assert np.abs(made[:, 2:]).max() < 1e-14


def test_heights_of_two_faces_change_as_easily(rng):
    nets = {"entrance": torch.zeros(4, 5).double(), "exit": torch.zeros(SHAPE).double()}
    widths = {"entrance": 0.5, "exit": 2.0}
    waves = FaceWaves(nets, 1.25, (False, False), widths)
    values = torch.as_tensor(rng.normal(size=20 + 54))
    found = waves.nets(values)
    assert {face: each.shape for face, each in found.items()} == {"entrance": (4, 5), "exit": SHAPE}
    assert torch.equal(waves.values(found), values)
    # A parameter of a face changes its heights by a width: so does a descent along its gradient.
    gradient = waves.values({face: widths[face] * torch.ones_like(nets[face]) for face in nets})
    change = waves.nets(waves.eased(gradient))
    moved = {face: widths[face] * each for face, each in change.items()}
    assert torch.allclose(moved["entrance"], torch.full((4, 5), 4.0).double())
    assert torch.allclose(moved["exit"], torch.full(SHAPE, 4.0).double())


def test_waves_that_a_blur_damps_are_of_one_size():
    shape = 401, 61
    every = torch.as_tensor(idctn(np.ones(shape), norm="ortho"))
    sharp, blurred = (
        dctn(Waves(shape, 1.25, (False, False), widths).eased(every).numpy(), norm="ortho")
        for widths in ((0.0, 0.0), (0.1, 0.0))
    )
    # Along u, those of many periods within the blur; along v nothing is damped.
    assert sharp[200, 0] > 5 * sharp[400, 0]
    assert blurred[200, 0] == pytest.approx(blurred[400, 0], rel=0.02)
    np.testing.assert_allclose(blurred[0], sharp[0], rtol=1e-9)
    np.testing.assert_allclose(blurred[:2], sharp[:2], rtol=0.02)
