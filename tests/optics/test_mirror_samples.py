"""Samples on a mirror against the walk, whose rays search for it."""

import numpy as np
import pytest
import torch

from workbench.geometry.surface import ControlNet
from workbench.optics.interfaces import Passed, Reflection
from workbench.optics.mirror_samples import MirrorSamples, SharedMirror
from workbench.optics.path import Path
from workbench.optics.reference import Reference
from workbench.optics.samples import Corners
from workbench.scene import Scene

SOURCES = {
    "point": {"kind": "point", "position": [0.3, -0.2, -4.0]},
    "lambertian": {"kind": "point", "position": [-2.0, 0.5, -4.0], "emission": "lambertian"},
    "tilted": {"kind": "collimated", "direction": [5.0, -8.0]},
    "beam": {
        "kind": "collimated",
        "direction": [0.0, 9.0],
        "profile": {"kind": "gaussian", "radius": 0.7},
    },
    "area": {"kind": "area", "center": [0.1, 0, -4.0], "half_width": [0.3, 0.2]},
}


def scene_of(source, **mirror):
    return Scene.from_data(
        {
            "mirror": {"half_width": [1.0, 0.8], "control_points": [9, 7], **mirror},
            "source": SOURCES[source],
            "screen": {"z": -5.0, "half_width": [1.0, 1.0], "pixels": [16, 16]},
            "target": {"builtin": "tophat"},
        }
    )


def sampled(scene, heights, corners):
    path = Path.of(scene, ControlNet.of(scene.optic), torch.float64, samples=corners)
    shared = SharedMirror.of(path)
    assert shared is not None
    return MirrorSamples(shared, path).walk({"mirror": torch.as_tensor(heights)})


@pytest.mark.parametrize("source", SOURCES)
def test_light_goes_on_as_that_of_rays_that_search(source):
    """On a flat mirror both take the same light from the same places."""
    scene = scene_of(source, reflectance=0.8)
    heights = np.zeros((9, 7))
    corners = Corners(20, 16, 1)
    path = Path.of(scene, ControlNet.of(scene.optic), torch.float64, samples=corners)
    walked = path.walk({"mirror": torch.as_tensor(heights)})
    arrival = sampled(scene, heights, corners)
    assert torch.allclose(arrival.column, walked.column, rtol=0, atol=1e-9)
    assert torch.allclose(arrival.row, walked.row, rtol=0, atol=1e-9)
    total = walked.rays.flux.sum()
    assert torch.allclose(arrival.rays.flux / total, walked.rays.flux / total, rtol=1e-3, atol=1e-9)


@pytest.mark.parametrize("source", SOURCES)
def test_all_of_a_leaning_mirror_is_lit(source):
    """A plane mirror takes the light in its shadow, however it leans."""
    scene = scene_of(source)
    x, _ = ControlNet.of(scene.optic).positions
    found = []
    for slope in (0.0, 0.3):
        heights = np.repeat(slope * x[:, None], 7, axis=1)
        arrival = sampled(scene, heights, Corners(60, 50, 4))
        lost = sum(part.item() for part in arrival.lost.values())
        assert arrival.rays.flux.sum().item() + lost == pytest.approx(1, abs=1e-9)
        found.append(arrival.rays.flux.sum().item())
    if source in ("point", "lambertian"):
        assert found[1] == pytest.approx(
            _solid_angle(scene, 0.3) / _solid_angle(scene, 0) * found[0], rel=2e-3
        )


def _solid_angle(scene, slope):
    """Of the mirror as the point sees it, weighed by its emission: by many places."""
    p_x, p_y, p_z = scene.source.position
    x, y = (r * (2 * (np.arange(801) + 0.5) / 801 - 1) for r in (1.0, 0.8))
    away = np.broadcast_arrays(x[:, None] - p_x, y - p_y, slope * x[:, None] - p_z)
    distance = np.sqrt(sum(np.square(part) for part in away))
    facing = (away[2] - slope * away[0]) / distance
    weight = away[2] / distance if scene.source.emission == "lambertian" else 1.0
    return (weight * facing / distance**2).sum()


def test_a_mirror_is_sampled_whatever_it_does_to_light(monkeypatch):
    """A kind of interface that no kernel knows begins with the samples as well."""

    class Dark:
        def turn(self, rays, meeting):
            passed = Reflection(1.0, "absorbed_mirror").turn(rays, meeting).rays
            return Passed(passed._replace(flux=0 * passed.flux), {"absorbed_mirror": passed.flux})

    monkeypatch.setattr("workbench.optics.steps.Reflection", lambda *_: Dark())
    net = ControlNet((9, 7), (3, 3), (1.0, 0.8))
    path = Path.of(scene_of("point"), net, torch.float64, samples=(20, 16))
    arrival = Reference(path).arrival({"mirror": torch.zeros(9, 7, dtype=torch.float64)})
    assert arrival.rays.flux.shape == (20, 16)
    lost = sum(part.item() for part in arrival.lost.values())
    assert lost == pytest.approx(1, abs=1e-9)
