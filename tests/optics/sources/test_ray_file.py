"""Light of ray files: the walk, the check and cells."""

import numpy as np
import pytest
import torch

from tests.lamps import led
from workbench.analysis.metrics import relative_l2
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.validation import validate
from workbench.geometry.surface import ControlNet
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.plan import Plan
from workbench.optics.samples import Corners


@pytest.fixture
def scene(make_scene, tmp_path):
    changes = {"source": led(tmp_path), "screen.pixels": [16, 16], "lens.reflection": "none"}
    return make_scene(changes)


def waves(scene):
    x, y = (torch.as_tensor(c) for c in ControlNet.of(scene.optic).positions)
    return 0.5 + 0.05 * torch.sin(3 * x[:, None] + 1) * torch.cos(2 * y[None, :])


def test_beams_of_points_make_the_image_of_the_rays(scene):
    lens = waves(scene)
    light = BeamPlan(scene, Corners(40, 40, 64), dtype=torch.float64).trace({"exit": lens})

    found = validate(scene, np.ones((16, 16)), {"exit": lens.numpy()}, 200_000, accuracy=3e-3)

    assert found.rays == 200_000
    # The file's own noise: about 7,000 of its rays come to 256 pixels.
    assert relative_l2(light.flux.numpy(), found.irradiance) < 0.25
    assert relative_l2(light.flux.numpy(), found.by_cells.irradiance) < 5e-3
    assert found.account.on_screen == pytest.approx(light.account.on_screen, rel=0.02)
    assert found.account.on_screen + sum(found.account.lost.values()) == pytest.approx(1, abs=1e-9)


def test_all_light_of_the_file_is_accounted_for(scene):
    heights = {"exit": waves(scene)}
    beams = BeamPlan(scene, Corners(24, 24, 16), dtype=torch.float64).trace(heights).account
    drawn = Plan(scene, dtype=torch.float64).trace(heights).account

    for account in (beams, drawn):
        assert account.on_screen + sum(account.lost.values()) == pytest.approx(1, abs=1e-9)
    assert drawn.on_screen == pytest.approx(beams.on_screen, rel=0.02)
    assert drawn.lost["missed_lens"] > 0.5


def test_the_lamp_stays_where_it_is_while_the_lens_is_turned(scene):
    lens, pose = {"exit": waves(scene).numpy()}, Pose(tilt=(0.05, -0.03), decentre=(0.1, 0.0))

    turned = validate(scene, np.ones((16, 16)), lens, 200_000, pose=pose, accuracy=3e-3)

    by_cells, rays = turned.by_cells.irradiance, turned.irradiance
    assert rays.sum() == pytest.approx(by_cells.sum(), rel=0.02)
    straight = validate(scene, np.ones((16, 16)), lens, 200_000)
    assert relative_l2(by_cells, rays) < relative_l2(by_cells, straight.irradiance)


def test_gradients_are_those_of_central_differences(scene):
    plan = BeamPlan(scene, Corners(12, 12, 4), dtype=torch.float64)
    heights = waves(scene)
    generator = torch.Generator().manual_seed(1)
    weights = torch.rand(16, 16, generator=generator, dtype=torch.float64)
    step = torch.randn(heights.shape, generator=generator, dtype=torch.float64)

    def value(z):
        return (plan.trace({"exit": z}).flux * weights).sum()

    leaf = heights.clone().requires_grad_()
    value(leaf).backward()
    h = 1e-6
    difference = (value(heights + h * step) - value(heights - h * step)) / (2 * h)
    assert (leaf.grad * step).sum().item() == pytest.approx(difference.item(), rel=1e-5)
