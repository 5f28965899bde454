"""Light of photometric files in the independent check."""

import numpy as np
import pytest
import torch

from tests.lamps import PLATE, behind_plate, crooked_lamp, downlight
from workbench.analysis.cells.image import imaging
from workbench.analysis.metrics import relative_l2
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.validation import validate
from workbench.optics.beam_plan import BeamPlan
from workbench.watch import finished


def heights(scene):
    return {"exit": np.full(scene.optic.net_shape, scene.optic.base.height)}


def waves(scene):
    x, y = (np.linspace(-1, 1, n) for n in scene.optic.net_shape)
    return {"exit": 0.5 + 0.05 * np.sin(3 * x[:, None] + 1) * np.cos(2 * y)}


@pytest.fixture
def crooked(make_scene, tmp_path):
    return make_scene({"source": crooked_lamp(tmp_path)})


def test_cells_behind_a_plate_are_those_of_the_closed_form(make_scene, tmp_path):
    scene = make_scene({**PLATE, "source": downlight(tmp_path)})
    n_x, n_y = scene.receiver.pixels
    x, y = ((2 * (np.arange(n) + 0.5) / n - 1) * 2 for n in (n_x, n_y))

    image = finished(imaging(scene, heights(scene), 1e-4))

    wanted = behind_plate(np.hypot(x, y[:, None]))
    found = image.irradiance
    assert np.linalg.norm(found - wanted) / np.linalg.norm(wanted) < 1e-3


def test_random_rays_cells_and_the_walk_agree(crooked):
    lens = waves(crooked)
    target = np.ones(crooked.receiver.pixels[::-1])

    checked = validate(crooked, target, lens, rays=400_000, accuracy=1e-3)

    walked = BeamPlan(crooked, (60, 60), dtype=torch.float64).trace(
        {"exit": torch.tensor(lens["exit"])}
    )
    assert checked.by_cells.difference_over_noise < 1.3
    assert relative_l2(walked.flux.numpy(), checked.by_cells.irradiance) < 3e-3
    account = checked.account
    assert account.on_screen + sum(account.lost.values()) == pytest.approx(1, abs=1e-9)
    assert account.on_screen == pytest.approx(walked.account.on_screen, rel=2e-3)
    for name, flux in walked.account.lost.items():
        assert account.lost[name] == pytest.approx(flux, abs=4e-3)  # cells at walls


def test_a_lamp_stays_where_it_is_while_the_lens_is_turned(crooked):
    lens, target = waves(crooked), np.ones(crooked.receiver.pixels[::-1])
    tilted = Pose(tilt=(0.02, -0.03), decentre=(0.05, 0.0))

    turned = validate(crooked, target, lens, rays=200_000, pose=tilted, accuracy=1e-3)

    assert turned.by_cells.difference_over_noise < 1.3
    straight = validate(crooked, target, lens, rays=200_000, accuracy=1e-3)
    assert relative_l2(turned.by_cells.irradiance, straight.by_cells.irradiance) > 0.02
