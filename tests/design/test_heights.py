"""Control heights stay in their range, and the undesigned lens is its base."""

import numpy as np
import pytest
import torch
from hypothesis import given
from hypothesis import strategies as st

from workbench.design.heights import HeightRange
from workbench.geometry.surface import ControlNet, sample_faces
from workbench.scene import FlatBase, Lens, SphereBase

BASES = [
    FlatBase(height=0.5),
    SphereBase(height=0.5, radius=4.0, form="concave"),
    SphereBase(height=0.6, radius=8.0, form="convex"),
]


def lens_with(base, **changes):
    fields = {
        "half_width": (1.0, 1.0),
        "refractive_index": 1.5,
        "control_points": (9, 7),
        "base": base,
    }
    return Lens(**(fields | {"height_range": (-0.2, 0.3), "min_thickness": 0.05} | changes))


@pytest.mark.parametrize("base", BASES, ids=str)
def test_the_undesigned_lens_is_the_base_plus_the_middle_of_the_range(base):
    lens = lens_with(base)
    net = ControlNet.of(lens)
    free = HeightRange.of(lens, net)
    x, y = net.positions
    expected = base.height_at(x[:, None], y[None, :]) + 0.05
    assert free.heights(free.rest)["exit"].numpy() == pytest.approx(expected, abs=1e-14)


@given(
    seed=st.integers(0, 1000),
    size=st.sampled_from([0.1, 10.0, 1e6]),
    base=st.sampled_from(BASES),
    thickness=st.sampled_from([0.0, 0.05, 0.45]),
)
def test_no_parameters_leave_the_range_or_make_the_lens_too_thin(seed, size, base, thickness):
    lens = lens_with(base, min_thickness=thickness)
    net = ControlNet.of(lens)
    free = HeightRange.of(lens, net)
    parameters = torch.as_tensor(np.random.default_rng(seed).normal(0, size, net.shape))
    heights = free.heights(parameters)["exit"].numpy()
    x, y = net.positions
    offset = heights - base.height_at(x[:, None], y[None, :])
    assert offset.max() <= 0.3 + 1e-12
    assert (offset.min() >= -0.2 - 1e-12) or heights.min() >= thickness
    assert heights.min() >= lens.entrance_z + thickness - 1e-12
    surface = sample_faces(lens, {"exit": heights}, (40, 40))["exit"][..., 2]
    assert surface.min() >= lens.entrance_z + thickness - 1e-12


def test_heights_are_recovered_from_their_parameters(rng):
    lens = lens_with(BASES[1])
    net = ControlNet.of(lens)
    free = HeightRange.of(lens, net)
    heights = free.heights(torch.as_tensor(rng.normal(size=net.shape)))["exit"].numpy()
    back = free.heights(free.parameters(heights))["exit"]
    assert back.numpy() == pytest.approx(heights, abs=1e-13)
