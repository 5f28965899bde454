"""The unit in which the light of a scene is stated."""

import math

import numpy as np
import pytest
import torch

from tests.lamps import DISTANCE, PLATE, SCREEN, THICKNESS, downlight
from workbench.analysis.regions import light_of_regions
from workbench.geometry.surface import ControlNet
from workbench.measured.lamps import IN_PARTS, light_unit
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.samples import Corners
from workbench.pictures.images import shown_error
from workbench.powers import written
from workbench.scene import RectangleRegion

LED = {"kind": "area", "center": [0.0, 0.0, -DISTANCE], "half_width": [0.02, 0.02]}
# Of light that goes straight through both faces, and how far it seems to come; in metres.
THROUGH = 0.96**2
WAY = (DISTANCE + SCREEN - THICKNESS + THICKNESS / 1.5) / 100


def middle(scene):
    """What is stated of the light in the middle of the screen behind a plate."""
    net = ControlNet.of(scene.optic)
    flat = {"lens.back": torch.full(net.shape, scene.optic.base.height, dtype=torch.float64)}
    count = 64 if scene.source.continuous else 1
    light = BeamPlan(scene, Corners(160, 160, count), dtype=torch.float64).trace(flat)
    density = (light.flux.numpy() / scene.receiver.pixel_measure)[19:21, 19:21].mean()
    return density * light_unit(scene).density


def test_a_photometric_file_gives_lux_by_the_law_of_distance(make_scene, tmp_path):
    scene = make_scene({**PLATE, "source": downlight(tmp_path)})
    unit = light_unit(scene)
    assert unit.words == "lx"
    assert unit.lumens == pytest.approx(1000 * 2 * math.pi / 4, rel=1e-4)
    assert middle(scene) == pytest.approx(1000 * THROUGH / WAY**2, rel=5e-3)


def test_an_emitter_with_a_flux_gives_lux_in_any_unit_of_length(make_scene):
    scene = make_scene({**PLATE, "source": LED | {"flux": 200.0}})
    lux = 200 / math.pi * THROUGH / WAY**2
    assert middle(scene) == pytest.approx(lux, rel=0.02)
    in_mm = light_unit(scene.in_unit("mm"))
    assert in_mm.lumens == 200
    assert in_mm.density == pytest.approx(100 * light_unit(scene).density)
    assert in_mm.flux_in_words(0.5) == "100 lm"


def test_regions_and_differences_are_told_in_lux(make_scene, rng):
    scene = make_scene({**PLATE, "source": LED | {"flux": 200.0}})
    light, unit = rng.random((40, 40)) / 16, light_unit(scene)
    desk = RectangleRegion(name="Desk", size=(0.5, 0.5))
    (found,) = light_of_regions([desk], scene.receiver, light, unit)
    inside = light[10:30, 10:30]
    mean, share = inside.mean(), inside.sum() * 0.01
    assert (
        f"({200 * share:.4g} lm) of the light, average {written(mean * 2e6, 'lx')}" in found.words
    )
    (plain,) = light_of_regions([desk], scene.receiver, light)
    assert plain.unit is IN_PARTS and "lx" not in plain.words
    target = rng.random((40, 40))
    error = shown_error(scene, target, light)
    flux = light.sum() * 0.01
    expected = light * 2e6 - target / target.sum() / 0.01 * flux * 2e6
    np.testing.assert_allclose(error, expected, atol=1e-6)
    plain_scene = make_scene({**PLATE, "source": LED})
    area = plain_scene.receiver.total(np.ones((40, 40)))
    shown = shown_error(plain_scene, target, light)
    np.testing.assert_allclose(shown, area * error / 2e6, atol=1e-12)
