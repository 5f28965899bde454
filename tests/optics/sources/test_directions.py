"""Collimated light that is tilted, comes from a disc, or is a Gaussian beam."""

import math

import numpy as np
import pytest
import torch
from scipy.special import erf

from tests.optics.points import smooth
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.plan import Plan
from workbench.optics.samples import Corners

SUN = {"kind": "collimated", "angular_diameter": 6.0}
TILTED = {"kind": "collimated", "direction": [8.0, -5.0], "angular_diameter": 2.0}
BEAM = {"kind": "collimated", "profile": {"kind": "gaussian", "radius": 0.4}}
OBLIQUE = BEAM | {"direction": [10.0, 4.0], "angular_diameter": 1.0}
ALL = pytest.mark.parametrize("source", [SUN, TILTED, BEAM, OBLIQUE])
PLATE = {"lens.base": {"shape": "flat", "height": 0.4}, "lens.height_range": [-0.1, 0.1]}


def plate(scene):
    return {"lens.back": torch.full(scene.optic.net_shape, 0.4, dtype=torch.float64)}


def places(scene):
    """Middles of the pixels: x of the columns, y of the rows."""
    (r_x, r_y), (n_x, n_y) = scene.receiver.half_width, scene.receiver.pixels
    x, y = (2 * (np.arange(n) + 0.5) / n - 1 for n in (n_x, n_y))
    return x * r_x, -y * r_y


@ALL
def test_gradients_are_those_of_central_differences(make_scene, rng, source):
    scene = make_scene({"source": source | {"rays": [40, 40]}, "screen.pixels": [9, 8]})
    weight = torch.as_tensor(rng.normal(size=(8, 9)))
    direction = torch.as_tensor(rng.normal(size=scene.optic.net_shape))
    beams = BeamPlan(scene, Corners(24, 24, 8), dtype=torch.float64)
    for plan in (beams, Plan(scene, dtype=torch.float64)):
        heights = smooth(scene).requires_grad_()
        (plan.trace({"lens.back": heights}).flux * weight).sum().backward()
        ahead, behind = (
            (plan.trace({"lens.back": heights.detach() + step * direction}).flux * weight)
            .sum()
            .item()
            for step in (1e-6, -1e-6)
        )
        found = (heights.grad * direction).sum().item()
        assert found == pytest.approx((ahead - behind) / 2e-6, rel=3e-4)


def test_the_sun_blurs_the_rim_of_a_plate_by_its_disc(make_scene):
    """Behind a plate directions are as before it; in the glass they are flatter."""
    wide = {"screen.half_width": [1.4, 1.4], "screen.pixels": [140, 14]}
    scene = make_scene(PLATE | wide | {"source": SUN})
    light = BeamPlan(scene, Corners(300, 4, 1024), dtype=torch.float64).trace(plate(scene))
    row = light.flux.numpy()[6:8].sum(0)
    row /= row[65:75].mean()
    # How far light of the rim of the disc is displaced, in air and in glass. What goes outwards in
    # the glass leaves it by the side.
    sine = math.sin(math.radians(3))
    air, glass = 4.6 * math.tan(math.radians(3)), 0.4 * sine / math.sqrt(1.5**2 - sine**2)
    x, _ = places(scene)
    u = np.where(x > 1, (x - 1) / air, (x - 1) / (air + glass)).clip(-1, 1)
    beyond = (np.arccos(u) - u * np.sqrt(1 - u**2)) / math.pi  # part of a disc
    edge = np.abs(x - 1) < 1.5 * air
    assert np.linalg.norm((row - beyond)[edge]) < 1e-3 * np.linalg.norm(beyond[edge])
    assert row[x > 1 + air + 0.02].max() < 1e-9


def test_a_gaussian_beam_goes_through_a_plate_as_it_is(make_scene):
    scene = make_scene(PLATE | {"source": BEAM})
    light = BeamPlan(scene, Corners(300, 300), dtype=torch.float64).trace(plate(scene))
    (r_x, r_y), (n_x, n_y) = scene.receiver.half_width, scene.receiver.pixels
    along_x, along_y = (
        np.diff(erf(math.sqrt(2) * np.linspace(-r, r, n + 1) / 0.4)) / 2
        for r, n in ((r_x, n_x), (r_y, n_y))
    )
    expected = 0.96**2 * np.outer(along_y, along_x)
    np.testing.assert_allclose(light.flux.numpy(), expected, atol=1e-3 * expected.max())
    met = erf(math.sqrt(2) / 0.4) ** 2
    assert light.account.lost["missed_lens"] == pytest.approx(1 - met, abs=1e-12)
    assert light.account.lost["fresnel_entrance"] == pytest.approx(0.04 * met, abs=1e-9)
