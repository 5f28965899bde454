"""Flat emitters: the walk, the check and closed forms agree."""

import math

import pytest
import torch

from tests.optics.points import smooth
from workbench.analysis.validation import validate
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.samples import Corners

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
    plate = {"exit": torch.full(scene.optic.net_shape, 0.5, dtype=torch.float64)}
    light = BeamPlan(scene, Corners(100, 100, 64), dtype=torch.float64).trace(plate)
    met = disc_to_disc(0.5, 1.0, 1.0)
    assert 1 - light.account.lost["missed_lens"] == pytest.approx(met, abs=1e-3)


@ALL
def test_the_check_agrees_with_beams(make_scene, source):
    scene = make_scene(WIDE | {"source": source})
    heights = smooth(scene)
    light = BeamPlan(scene, Corners(60, 60, 64), dtype=torch.float64).trace({"exit": heights})
    image = light.flux.numpy() / scene.receiver.pixel_measure
    found = validate(scene, image, {"exit": heights.numpy()}, rays=200_000)
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
    (plan.trace({"exit": heights}).flux * weight).sum().backward()
    ahead, behind = (
        (plan.trace({"exit": heights.detach() + step * direction}).flux * weight).sum().item()
        for step in (1e-6, -1e-6)
    )
    found = (heights.grad * direction).sum().item()
    assert found == pytest.approx((ahead - behind) / 2e-6, rel=3e-4)
