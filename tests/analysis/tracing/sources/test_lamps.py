"""Light of emitters and lamps in the check."""

import math

import numpy as np
import pytest
import torch

from tests.lamps import PLATE, behind_plate, crooked_lamp, downlight
from tests.optics.points import smooth
from workbench.analysis.cells.image import imaging
from workbench.analysis.metrics import relative_l2
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.validation import validate
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.samples import Corners
from workbench.progress import finished

LED = {"kind": "area", "center": [0.1, -0.2, -2.0], "half_width": [0.3, 0.2]}


ROUND = LED | {"outline": "ellipse", "emission": "uniform"}


ALL = pytest.mark.parametrize("source", [LED, ROUND])


WIDE = {"screen.half_width": [4.0, 4.0], "screen.pixels": [12, 12]}


def disc_to_disc(r_1, r_2, distance):
    """Part of the light of a Lambertian disc that meets another one on its axis."""
    a, b = r_1 / distance, r_2 / distance
    x = 1 + (1 + b * b) / (a * a)
    return (x - math.sqrt(x * x - 4 * (b / a) ** 2)) / 2


def test_a_lambertian_disc_lights_a_round_lens_by_the_form_factor(make_scene):
    disc = {"kind": "area", "center": [0, 0, -1.0], "half_width": [0.5, 0.5], "outline": "ellipse"}
    scene = make_scene({"lens.outline": "ellipse", "source": disc})
    plate = {"lens.back": torch.full(scene.optic.net_shape, 0.5, dtype=torch.float64)}
    light = BeamPlan(scene, Corners(100, 100, 64), dtype=torch.float64).trace(plate)
    met = disc_to_disc(0.5, 1.0, 1.0)
    assert 1 - light.account.lost["missed_lens"] == pytest.approx(met, abs=1e-3)


@ALL
def test_the_check_agrees_with_beams(make_scene, source):
    scene = make_scene(WIDE | {"source": source})
    heights = smooth(scene)
    light = BeamPlan(scene, Corners(60, 60, 64), dtype=torch.float64).trace({"lens.back": heights})
    image = light.flux.numpy() / scene.receiver.pixel_measure
    found = validate(scene, image, {"lens.back": heights.numpy()}, rays=200_000)
    assert found.relative_l2_corrected < 1e-2
    assert sum(light.account.lost.values()) + light.account.on_screen == pytest.approx(1, abs=1e-9)
    for name, flux in found.account.lost.items():
        assert flux == pytest.approx(light.account.lost[name], abs=3e-3), name


@ALL
def test_gradients_are_those_of_central_differences(make_scene, rng, source):
    scene = make_scene(WIDE | {"source": source})
    plan = BeamPlan(scene, Corners(24, 24, 8), dtype=torch.float64)
    weight = torch.as_tensor(rng.normal(size=(12, 12)))
    direction = torch.as_tensor(rng.normal(size=scene.optic.net_shape))
    heights = smooth(scene).requires_grad_()
    (plan.trace({"lens.back": heights}).flux * weight).sum().backward()
    ahead, behind = (
        (plan.trace({"lens.back": heights.detach() + step * direction}).flux * weight).sum().item()
        for step in (1e-6, -1e-6)
    )
    found = (heights.grad * direction).sum().item()
    assert found == pytest.approx((ahead - behind) / 2e-6, rel=3e-4)


def heights(scene):
    return {"lens.back": np.full(scene.optic.net_shape, scene.optic.base.height)}


def waves(scene):
    x, y = (np.linspace(-1, 1, n) for n in scene.optic.net_shape)
    return {"lens.back": 0.5 + 0.05 * np.sin(3 * x[:, None] + 1) * np.cos(2 * y)}


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
        {"lens.back": torch.tensor(lens["lens.back"])}
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
