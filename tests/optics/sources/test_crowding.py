"""Corners of cells where the light of a narrow beam is."""

import numpy as np
import pytest
import torch

from workbench.geometry.surface import freeform_nets
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.samples import Corners, Crowd, places, places_of_points
from workbench.scene import Scene

LENS = {"half_width": [1.0, 1.0], "refractive_index": 1.5, "control_points": [6, 6]}
OPTICS = {
    "lens": {"lens": LENS},
    "two faces": {"lens": LENS | {"entrance": {"shape": "freeform"}}},
    "mirror": {"mirror": {"half_width": [1.0, 1.0], "control_points": [6, 6]}},
}


def scene_of(optic, radius, direction, angle=0.0):
    return Scene.from_data(
        OPTICS[optic]
        | {
            "format": "freeform-scene",
            "version": 2,
            "unit": "mm",
            "source": {
                "kind": "collimated",
                "direction": direction,
                "angular_diameter": angle,
                "profile": {"kind": "gaussian", "radius": radius},
            },
            "far_field": {"half_angle": [40, 40], "pixels": [8, 8]},
            "target": {"builtin": "tophat"},
        }
    )


@pytest.mark.parametrize("radius", [0.02, 0.1, 0.4])
@pytest.mark.parametrize("direction", [[0.0, 0.0], [0.0, 15.0]])
@pytest.mark.parametrize("optic", OPTICS)
def test_all_light_of_a_narrow_beam_comes_through_flat_faces(optic, direction, radius):
    scene = scene_of(optic, radius, direction)
    heights = {
        face: torch.full(net.shape, float(scene.optic.place_of(face, 0.0, 0.0))).double()
        for face, net in freeform_nets(scene.optic).items()
    }
    light = BeamPlan(scene, (48, 48), dtype=torch.float64, fused=False).trace(heights)
    account = light.account
    beside = account.lost["missed_mirror" if optic == "mirror" else "missed_lens"]
    assert beside == pytest.approx(0, abs=2e-5)
    # Fresnel's equations: 4 % of light along the axis at each face, and little more at 15°.
    passed = 1.0 if optic == "mirror" else 0.96**2
    assert account.on_screen == pytest.approx(passed, abs=3e-4)
    assert light.flux.sum().item() == pytest.approx(account.on_screen, abs=1e-9)


@pytest.mark.parametrize("crowd", [Crowd(), Crowd.of(0.05, 0.0), Crowd.of(0.1, 0.3)])
def test_samples_fill_the_aperture(crowd):
    corners = Corners(40, 30, 3, crowd_x=crowd, crowd_y=crowd)
    for found in (places(corners, 0), places_of_points(corners, 1, 3)):
        assert found.part.min() == pytest.approx(0, abs=1e-12)
        assert found.part.max() == pytest.approx(1, abs=1e-12)
        assert (found.low <= found.part).all() and (found.part <= found.high).all()
    assert (np.diff(places(corners, 0).part) > 0).all()
    assert (places(corners, 0).high - places(corners, 0).low).sum() == pytest.approx(1)


def test_a_crowd_is_even_where_the_beam_is():
    part = Crowd.of(0.05, 0.3)(np.linspace(0, 1, 61))
    within = np.abs(2 * part - 1 - 0.3) < 0.05
    assert within.sum() >= 38
    assert np.diff(part[within]) == pytest.approx(np.diff(part[within]).mean(), rel=0.6)
