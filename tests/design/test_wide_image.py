"""The image of a run holds all the light, and nothing else that would only cost time."""

import pytest
import torch

from workbench.design.wide_image import WideImage
from workbench.geometry.surface import ControlNet
from workbench.optics.beam_plan import BeamPlan
from workbench.targets import load_target


def descend(scene, target, heights, light_extent):
    image = WideImage(scene, target, (64, 64), light_extent)
    error, step = image.compare({"exit": heights})
    (gradient,) = torch.autograd.grad(error.square().sum(), [heights])
    return error, step, gradient


@pytest.mark.parametrize("source", ["collimated", "point"])
def test_pixels_that_no_light_reaches_change_nothing(source, make_scene, tmp_path, rng):
    changes = {"screen.pixels": [24, 24], "lens.control_points": [9, 9]}
    if source == "point":
        changes["source"] = {"kind": "point", "position": [0, 0, -5], "rays": 4096}
    scene = make_scene(changes)
    target = load_target(scene, tmp_path)
    free = scene.optic.base.height + 0.003 * rng.random(ControlNet.of(scene.optic).shape)
    heights = torch.tensor(free, requires_grad=True)
    light_extent = BeamPlan(scene, (64, 64)).light_extent({"exit": heights.detach()})
    narrow, near, gradient = descend(scene, target, heights, light_extent)
    wide, far, same = descend(scene, target, heights, (5.0, 5.0))
    assert narrow.numel() < wide.numel() / 2
    assert wide.norm().item() == pytest.approx(narrow.norm().item(), rel=1e-5)
    assert far.state.loss == pytest.approx(near.state.loss, rel=1e-5)
    assert (same - gradient).norm() < 3e-3 * gradient.norm()
