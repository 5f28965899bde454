"""Snell's law and the critical angle."""

import math

import pytest
import torch

from workbench.optics.refraction import refract, root_where_positive
from workbench.optics.transmittance import TransmittanceLaw

DTYPES = [torch.float32, torch.float64]


def incoming(angles, dtype):
    """Rays in the x-z plane at the given angles to the normal +z."""
    angles = torch.as_tensor(angles, dtype=dtype)
    return (angles.sin(), torch.zeros_like(angles), angles.cos()), angles


UP = tuple(torch.tensor(c, dtype=torch.float64) for c in (0.0, 0.0, 1.0))


@pytest.mark.parametrize("ratio", [1.5, 1 / 1.5, 1.0003, 1 / 4])
def test_angles_obey_snell(ratio):
    limit = math.asin(min(1.0, 1 / ratio)) - 1e-6
    direction, angles = incoming(torch.linspace(-limit, limit, 101), torch.float64)
    out = refract(direction, UP, ratio)
    assert out.passes.all()
    assert torch.allclose(out.direction[0], ratio * angles.sin(), atol=1e-14)
    length = sum(c.square() for c in out.direction)
    assert torch.allclose(length, torch.ones_like(length), atol=1e-13)
    assert torch.allclose(out.cos_out, out.direction[2], atol=1e-13)


@pytest.mark.parametrize("law", [TransmittanceLaw.schlick(1.5), TransmittanceLaw.fresnel(1.5)])
@pytest.mark.parametrize("dtype", DTYPES)
def test_beyond_the_critical_angle_nothing_passes_and_nothing_is_nan(dtype, law):
    critical = math.asin(1 / 1.5)
    angles = torch.linspace(0, math.pi / 2, 1001, dtype=dtype).requires_grad_()
    direction = (angles.sin(), torch.zeros_like(angles), angles.cos())
    out = refract(direction, tuple(c.to(dtype) for c in UP), 1.5)
    expected = angles.detach() < critical
    near = (angles.detach() - critical).abs() < 1e-3
    assert torch.equal(out.passes[~near], expected[~near])
    weight = torch.where(out.passes, law.at(out.cos_in, out.cos_out), 0.0)
    (sum(out.direction).sum() + weight.sum()).backward()
    assert torch.isfinite(angles.grad).all()
    assert (weight[~out.passes] == 0).all()


@pytest.mark.parametrize("dtype", DTYPES)
def test_masked_roots_have_no_gradient(dtype):
    square = torch.tensor([-1.0, 0.0, 0.25], dtype=dtype, requires_grad=True)
    root, positive = root_where_positive(square)
    root.sum().backward()
    assert positive.tolist() == [False, False, True]
    assert square.grad.tolist() == [0, 0, 1]
