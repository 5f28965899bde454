"""The fused trace of collimated light on a mirror against its twin in torch."""

import numpy as np
import pytest
import torch

from workbench.geometry.surface import ControlNet
from workbench.optics.path import Path
from workbench.optics.reference import Reference
from workbench.optics.samples import Corners
from workbench.optics.train.compiled import CompiledTrain
from workbench.scene import Scene

RECEIVERS = {
    "upright": {"screen": {"z": -5.0, "half_width": [1.2, 0.9], "pixels": [23, 17]}},
    "tilted": {
        "screen": {
            "z": -4.0,
            "center": [1.5, -0.5],
            "tilt": [15.0, -35.0],
            "half_width": [2.0, 2.0],
            "pixels": [23, 17],
        }
    },
    "far": {"far_field": {"half_angle": [40.0, 30.0], "center": [5.0, 0.0], "pixels": [23, 17]}},
}
MIRRORS = {
    "whole": {"half_width": [1.0, 0.8]},
    "ellipse": {"half_width": [1.0, 0.8], "outline": "ellipse", "reflectance": 0.85},
}


def scene_of(receiver, mirror, source=None):
    return Scene.from_data(
        {
            "mirror": {"control_points": [9, 8], **MIRRORS[mirror]},
            "source": {"kind": "collimated", "rays": [61, 46], **(source or {})},
            "target": {"builtin": "tophat"},
            **RECEIVERS[receiver],
        }
    )


def twins(scene, dtype=torch.float64, samples=None):
    path = Path.of(scene, ControlNet.of(scene.optic), dtype, samples=samples)
    assert CompiledTrain.matches(path)
    return Reference(path), CompiledTrain(path)


def heights_of(scene, amplitude, seed=2):
    noise = np.random.default_rng(seed).normal(size=scene.optic.net_shape)
    return torch.tensor(amplitude * noise)


def imaged(tracer, scene, heights, cotangent):
    leaf = heights.clone().requires_grad_()
    light = tracer.image({"mirror.face": leaf}, scene.filter)
    (gradient,) = torch.autograd.grad((light.flux * cotangent).sum(), leaf)
    return light, gradient


@pytest.mark.parametrize("receiver", RECEIVERS)
@pytest.mark.parametrize("mirror", MIRRORS)
@pytest.mark.parametrize("profile", [{"kind": "uniform"}, {"kind": "gaussian", "radius": 0.6}])
def test_twins_agree(receiver, mirror, profile):
    scene = scene_of(receiver, mirror, {"profile": profile})
    heights = heights_of(scene, 0.03)
    cotangent = torch.tensor(np.random.default_rng(1).normal(size=(17, 23)))
    (exact, slope), (light, found) = (
        imaged(tracer, scene, heights, cotangent) for tracer in twins(scene)
    )
    assert torch.allclose(light.flux, exact.flux, rtol=0, atol=1e-12)
    assert light.account.to_data() == pytest.approx(exact.account.to_data(), abs=1e-12)
    assert (found - slope).norm() <= 1e-10 * slope.norm()


@pytest.mark.parametrize("receiver", RECEIVERS)
def test_corners_of_cells_land_where_those_of_the_twin_do(receiver):
    scene = scene_of(receiver, "whole")
    heights = heights_of(scene, 0.03)
    found = []
    for tracer in twins(scene, samples=Corners(40, 30)):
        leaf = heights.clone().requires_grad_()
        hits, account, _ = tracer.nodes({"mirror.face": leaf})
        cotangent = torch.tensor(np.random.default_rng(1).normal(size=hits.shape))
        lands = hits.isfinite()
        (slope,) = torch.autograd.grad(torch.where(lands, hits * cotangent, 0.0).sum(), leaf)
        found.append((hits, account.to_data(), slope))
    (exact, lost, slope), (hits, own_lost, own_slope) = found
    assert torch.allclose(hits, exact, rtol=0, atol=1e-9)
    assert own_lost == pytest.approx(lost, abs=1e-12)
    assert (own_slope - slope).norm() <= 1e-10 * slope.norm()


def test_float32_is_as_close_as_it_can_be():
    scene = scene_of("tilted", "whole")
    heights = heights_of(scene, 0.01)
    cotangent = torch.tensor(np.random.default_rng(1).normal(size=(17, 23)))
    exact, slope = imaged(twins(scene)[1], scene, heights, cotangent)
    light, found = imaged(twins(scene, torch.float32)[1], scene, heights, cotangent)
    assert (light.flux - exact.flux).abs().sum().item() <= 1e-4
    assert (found - slope).norm() <= 1e-3 * slope.norm()
