"""Light of photometric files through the walk."""

import numpy as np
import pytest
import torch

from tests.lamps import PLATE, behind_plate, crooked_lamp, downlight
from workbench.geometry.surface import ControlNet
from workbench.measured.lamps import intensity_of
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.sources import emitter_of


@pytest.fixture
def plate(make_scene, tmp_path):
    return make_scene({**PLATE, "source": downlight(tmp_path)})


@pytest.fixture
def crooked(make_scene, tmp_path):
    return make_scene({"source": crooked_lamp(tmp_path)})


def radii(scene):
    n_x, n_y = scene.receiver.pixels
    r_x, r_y = scene.receiver.half_width
    x = (2 * (np.arange(n_x) + 0.5) / n_x - 1) * r_x
    y = (2 * (np.arange(n_y) + 0.5) / n_y - 1) * r_y
    return np.hypot(x, y[:, None])


def flat(scene):
    net = ControlNet.of(scene.optic)
    return {"lens.back": torch.full(net.shape, scene.optic.base.height, dtype=torch.float64)}


def test_light_behind_a_plate_is_that_of_the_closed_form(plate):
    light = BeamPlan(plate, (160, 160), dtype=torch.float64).trace(flat(plate))

    found = light.flux.numpy() / plate.receiver.pixel_measure
    wanted = behind_plate(radii(plate))
    assert np.linalg.norm(found - wanted) / np.linalg.norm(wanted) < 1e-3


@pytest.mark.parametrize("fused", [True, False])
def test_all_light_of_the_lamp_is_accounted_for(crooked, fused):
    light = BeamPlan(crooked, (40, 40), dtype=torch.float64, fused=fused).trace(flat(crooked))

    account = light.account
    assert account.on_screen + sum(account.lost.values()) == pytest.approx(1, abs=1e-9)
    assert account.lost["missed_lens"] > 0.5


def test_the_lamp_is_turned_about_x_then_y_then_z(crooked):
    from scipy.spatial.transform import Rotation

    pattern = emitter_of(crooked.source, crooked.optic).origins.pattern
    directions = np.random.default_rng(1).normal(size=(100, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)

    turn = Rotation.from_euler("xyz", [10, -20, 30], degrees=True)
    in_file = turn.inv().apply(directions)
    found = pattern.at(np.zeros(100, int), tuple(directions.T))
    assert np.allclose(found, intensity_of(crooked.source).at(in_file))


def test_gradients_are_those_of_central_differences(crooked):
    net = ControlNet.of(crooked.optic)
    plan = BeamPlan(crooked, (40, 40), dtype=torch.float64)
    generator = torch.Generator().manual_seed(1)
    x, y = (torch.as_tensor(c) for c in net.positions)
    heights = 0.5 + 0.05 * torch.sin(3 * x[:, None] + 1) * torch.cos(2 * y[None, :])
    weights = torch.rand(32, 32, generator=generator, dtype=torch.float64)
    step = torch.randn(net.shape, generator=generator, dtype=torch.float64)

    def value(z):
        return (plan.trace({"lens.back": z}).flux * weights).sum()

    leaf = heights.clone().requires_grad_()
    value(leaf).backward()
    h = 1e-6
    difference = (value(heights + h * step) - value(heights - h * step)) / (2 * h)
    assert (leaf.grad * step).sum().item() == pytest.approx(difference.item(), rel=1e-5)
