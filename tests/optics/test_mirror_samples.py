"""Samples on a mirror against the walk, whose rays search for it."""

import numpy as np
import pytest
import torch

from workbench.geometry.surface import ControlNet
from workbench.optics.path import Path
from workbench.optics.sampled import SampledTrain, SampledWalk
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
    train = SampledTrain.of(path)
    assert train is not None
    return SampledWalk(train, path).walk({"mirror.face": torch.as_tensor(heights)})


@pytest.mark.parametrize("source", SOURCES)
def test_light_goes_on_as_that_of_rays_that_search(source):
    """On a flat mirror both take the same light from the same places."""
    scene = scene_of(source, reflectance=0.8)
    heights = np.zeros((9, 7))
    corners = Corners(20, 16, 1)
    path = Path.of(scene, ControlNet.of(scene.optic), torch.float64, samples=corners)
    walked = path.walk({"mirror.face": torch.as_tensor(heights)})
    arrival = sampled(scene, heights, corners)
    assert torch.allclose(arrival.column, walked.column, rtol=0, atol=1e-9)
    assert torch.allclose(arrival.row, walked.row, rtol=0, atol=1e-9)
    total = walked.rays.flux.sum()
    assert torch.allclose(arrival.rays.flux / total, walked.rays.flux / total, rtol=1e-3, atol=1e-9)


@pytest.mark.parametrize("outline", ["rectangle", "ellipse"])
@pytest.mark.parametrize("source", SOURCES)
def test_a_leaning_mirror_takes_the_light_of_its_aperture(source, outline):
    """A plane mirror is lit where its light passes the outline in the plane of its vertex."""
    scene, slope = scene_of(source, outline=outline), 0.3
    x, _ = ControlNet.of(scene.optic).positions
    heights = np.repeat(slope * x[:, None], 7, axis=1)
    arrival = sampled(scene, heights, Corners(60, 50, 4))
    lost = sum(part.item() for part in arrival.lost.values())
    met = arrival.rays.flux.sum().item()
    assert met + lost == pytest.approx(1, abs=1e-9)
    assert met == pytest.approx(_through_aperture(scene, slope), abs=1e-3)


def _through_aperture(scene, slope):
    """Light of a source through the aperture onto a plane mirror: by many places of the plane."""
    path = Path.of(scene, ControlNet.of(scene.optic), torch.float64, samples=Corners(60, 50, 4))
    origins, outline = path.emitter.origins, path.outline
    x, y = np.meshgrid(*(r * (2 * (np.arange(801) + 0.5) / 801 - 1) for r in (1, 0.8)))
    met = 0.0
    for number in range(len(origins.places)):
        lit = origins.light(x, y, 0.0, np.array(number))
        s_x, s_y = (part / lit.direction[2] for part in lit.direction[:2])
        z = slope * x / (1 - slope * s_x)
        meets = outline.contains(x, y) & outline.contains(x + s_x * z, y + s_y * z)
        met += (lit.density * meets).sum() * 4 * 0.8 / 801**2
    return met
