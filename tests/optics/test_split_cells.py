"""Light of cells of which some rays are totally reflected."""

import math

import numpy as np
import pytest
import torch

from workbench.geometry.surface import ControlNet
from workbench.optics.beam_plan import BeamPlan
from workbench.scene import Scene

INDEX, RADIUS, NET = 1.5, 1.5, 60


@pytest.fixture(scope="module")
def dome():
    """A scene with a dome that reflects all light beyond R / n from the axis, and its heights."""
    scene = Scene.from_data(
        {
            "format": "freeform-scene",
            "version": 2,
            "unit": "mm",
            "lens": {
                "half_width": [1.0, 1.0],
                "refractive_index": INDEX,
                "control_points": [NET, NET],
                "base": {"shape": "flat", "height": 3.0},
                "reflection": "none",
            },
            "source": {"kind": "collimated"},
            "far_field": {"half_angle": [90, 90], "pixels": [16, 16]},
            "target": {"builtin": "tophat"},
        }
    )
    x, y = ControlNet.of(scene.optic).positions
    heights = 1.5 + np.sqrt(RADIUS**2 - x[:, None] ** 2 - y**2)
    return scene, {"exit": torch.as_tensor(heights)}


@pytest.mark.parametrize("mirrored", [(False, False), (True, False), (True, True)])
@pytest.mark.parametrize("cells", [48, 64])
def test_total_reflection_begins_at_its_angle(dome, cells, mirrored):
    scene, heights = dome
    plan = BeamPlan(scene, (cells, cells), dtype=torch.float64, fused=False, mirrored=mirrored)
    light = plan.trace(heights)
    refracted = math.pi * (RADIUS / INDEX) ** 2 / 4
    # The circle within which rays are refracted holds that many of them, more or less.
    assert light.account.on_screen == pytest.approx(refracted, abs=6e-3)
    assert light.account.lost["total_reflection"] == pytest.approx(1 - refracted, abs=6e-3)
    assert light.flux.sum().item() == pytest.approx(light.account.on_screen, abs=1e-9)
    assert light.flux.min() >= 0
