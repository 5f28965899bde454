"""The light of a point behind a flat face: against rays that go the other way, from the face on."""

import numpy as np
import pytest
import torch
from hypothesis import given
from hypothesis import strategies as st

from workbench.optics.glass import FlatGlass
from workbench.optics.interfaces import TransmittanceLaw

DTYPES = [torch.float32, torch.float64]
LAW = TransmittanceLaw.schlick(1 / 1.5)


def forward(glass_index, distance, enters, depth):
    """Radius at the depth of rays that enter at a radius, by the angles."""
    outer = np.arctan2(enters, distance)
    return enters + depth * np.tan(np.arcsin(np.sin(outer) / glass_index))


@pytest.mark.parametrize("dtype", DTYPES)
@given(
    distance=st.floats(1e-7, 1e4),
    index=st.floats(1.01, 4.0),
    depth=st.floats(0.0, 10.0),
    enters=st.floats(0.0, 10.0),
)
def test_the_inverse_map_agrees_with_the_forward_map(dtype, distance, index, depth, enters):
    radius = forward(index, distance, enters, depth)
    radius2 = torch.tensor([radius**2], dtype=dtype)
    light = FlatGlass(distance, TransmittanceLaw.schlick(1 / index), False).light(
        radius2, torch.tensor([depth], dtype=dtype)
    )
    found = light.radius_ratio.item() * radius
    # Near the rim of the cone of a near point, many places of the face light nearly one place.
    again = forward(index, distance, found, depth)
    eps = torch.finfo(dtype).eps
    assert again == pytest.approx(radius, rel=32 * eps, abs=1e-12)
    if radius > 0:
        slope = np.tan(np.arcsin(np.sin(np.arctan2(found, distance)) / index))
        assert light.steepness.item() * found == pytest.approx(slope, rel=32 * eps, abs=1e-12)


@pytest.mark.parametrize("distance", [1e-6, 0.3, 5.0])
def test_derivatives_by_the_depth(distance):
    generator = torch.Generator().manual_seed(1)
    radius2 = torch.rand(50, generator=generator, dtype=torch.float64) * 4
    depth = torch.rand(50, generator=generator, dtype=torch.float64) + 0.1
    glass = FlatGlass(distance, LAW, True)
    assert torch.autograd.gradcheck(
        lambda t: tuple(glass.light(radius2, t)), depth.requires_grad_(), eps=1e-7
    )
