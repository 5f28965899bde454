"""The fused trace through two freeform faces against its twin in torch."""


import numpy as np
import pytest
import torch
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.optics.kernels.test_origins_kernel import (
    Light,
    changes,
    origins,
    receivers,
)
from tests.scenes import changed
from workbench.geometry.surface import ControlNet
from workbench.optics.interfaces import Refraction
from workbench.optics.kernels.two_faces import FusedTwoFaces
from workbench.optics.path import Path, Step
from workbench.optics.reference import Reference
from workbench.optics.samples import Corners
from workbench.optics.surfaces import BSplineSurface
from workbench.optics.transmittance import TransmittanceLaw
from workbench.scene import Scene


def two_faces(scene, origins, cells, dtype=torch.float64):
    """The path of a scene with a B-spline in place of its flat entrance face."""
    flat = Path.of(scene, ControlNet.of(scene.lens), dtype)
    net = ControlNet((5, 6), (3, 2), scene.lens.half_width)
    surface = BSplineSurface(
        "entrance", net, flat.datum, dtype, outline=flat.outline, level=scene.lens.entrance_z
    )
    law, _ = TransmittanceLaw.of(scene.lens)
    front = Step(surface, Refraction(law, "fresnel_entrance"), "missed_lens")
    path = Path(
        Light(origins, Corners(*cells)),
        (front, flat.steps[1]),
        flat.receiver,
        flat.datum,
        flat.outline,
        0,
        dtype,
    )
    return path


def faces(scene, seed, amplitude):
    """Heights of both faces, some way apart."""
    rng, lens = np.random.default_rng(seed), scene.lens
    return {
        "entrance": torch.tensor(lens.entrance_z + amplitude * rng.normal(size=(5, 6))),
        "exit": torch.tensor(lens.base.height + amplitude * rng.normal(size=lens.net_shape)),
    }


def landed(tracer, heights, cotangent):
    """Nodes that land, their account, and gradients of their product with a cotangent."""
    leaves = {name: each.clone().requires_grad_() for name, each in heights.items()}
    hits, light = tracer.nodes(leaves)
    lands = hits.isfinite().all(dim=0) & (hits[2] > 0)
    weighed = torch.where(lands, hits, 0.0) * torch.where(lands, cotangent, 0.0)
    found = torch.autograd.grad(weighed.sum(), list(leaves.values()))
    return torch.where(lands, hits.detach(), 0.0), light.to_data(), found


@settings(max_examples=40)
@given(
    changes=changes(),
    receiver=receivers(),
    origins=origins(),
    cells=st.tuples(st.integers(1, 20), st.integers(1, 20)),
    amplitude=st.sampled_from([0.0, 0.005, 0.05]),
    seed=st.integers(0, 99),
)
def test_twins_agree_in_float64(changes, receiver, origins, cells, amplitude, seed):
    data = changed(changes)
    data.pop("screen")
    scene = Scene.from_data(data | receiver | {"version": 2})
    path, heights = two_faces(scene, origins, cells), faces(scene, seed, amplitude)
    shape = 3, len(origins.flux) * (cells[1] + 1), cells[0] + 1
    cotangent = torch.tensor(np.random.default_rng(seed).normal(size=shape))
    (nodes, light, gradients), (fused, fused_light, fused_gradients) = (
        landed(tracer, heights, cotangent) for tracer in (Reference(path), FusedTwoFaces(path))
    )
    # A ray at the rim of the exit face, of total reflection or of the horizon is on either side.
    same = (nodes[2] > 0) == (fused[2] > 0)
    assert same.double().mean() > 0.999
    size = 1 + nodes.abs().max()
    assert ((fused - nodes) * same).abs().max() < 1e-8 * size
    if same.all():
        assert fused_light == pytest.approx(light, abs=1e-11)
        for fused_gradient, gradient in zip(fused_gradients, gradients, strict=True):
            assert (fused_gradient - gradient).norm() <= 1e-6 * gradient.norm() + 1e-12
