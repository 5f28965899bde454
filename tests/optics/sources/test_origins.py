"""Origins of light, and samples where a beam is narrow."""

import math

import numpy as np
import pytest
import torch

from tests.optics.points import GRID, POINT
from workbench.geometry.surface import freeform_nets
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.interfaces import laws_of
from workbench.optics.samples import Corners, Crowd, places, places_of_points
from workbench.optics.sources import emitter_of
from workbench.optics.sources.emission import entering
from workbench.optics.sources.origins import Origins, through_cells
from workbench.scene import Scene

NODE, WEIGHT = np.polynomial.legendre.leggauss(60)


def through_the_face(origins, lens):
    """Flux of all origins through the face, by Gauss's rule."""
    r_x, r_y = lens.half_width
    x, y = NODE[:, None] * r_x, NODE * r_y
    area = np.outer(WEIGHT * r_x, WEIGHT * r_y)
    each = np.arange(len(origins.places))[:, None, None]
    return float((origins.light(x, y, lens.entrance_z, each).density * area).sum())


@pytest.mark.parametrize("source", [POINT, GRID])
@pytest.mark.parametrize("emission", ["uniform", "lambertian"])
def test_light_of_points_meets_the_face_or_misses_it(make_scene, source, emission):
    scene = make_scene({"source": source | {"emission": emission}})
    origins = emitter_of(scene.source, scene.optic).origins
    missed = entering(scene.source, scene.optic, laws_of(scene.optic)[0]).missed
    assert through_the_face(origins, scene.optic) == pytest.approx(1 - missed, abs=1e-12)


def test_parallel_light_is_even(make_scene):
    scene = make_scene()
    origins = emitter_of(scene.source, scene.optic).origins
    assert through_the_face(origins, scene.optic) == pytest.approx(1, abs=1e-12)


def test_a_tilted_gaussian_beam_has_its_flux_on_the_plane(make_scene):
    lens = make_scene().optic
    a, waist = 0.4, 0.15
    tilted = np.array([[math.sin(a), 0.0, math.cos(a)]])
    beam = Origins(tilted, True, np.array([2 / (math.pi * waist**2)]), waist=waist)
    assert through_the_face(beam, lens) == pytest.approx(1, abs=1e-9)
    along, across = (
        beam.light(np.array([x]), np.array([y]), 0.0, np.zeros(1, int)).density[0]
        for x, y in ((waist / math.cos(a), 0.0), (0.0, waist))
    )
    middle = beam.light(np.zeros(1), np.zeros(1), 0.0, np.zeros(1, int)).density[0]
    np.testing.assert_allclose([along / middle, across / middle], math.exp(-2))


def test_rays_through_corners_carry_the_light_of_their_cells(make_scene):
    scene = make_scene()
    z = scene.optic.entrance_z
    points = np.array([[0.2, 0.0, z - 3], [-0.2, 0.1, z - 3]])
    origins = Origins(points, False, np.array([0.5, 0.25]), lambertian=True)
    rays = through_cells(origins, scene.optic, Corners(64, 48, 2))
    assert rays.flux.shape == (65, 100)  # two grids with a row more at each end
    assert rays.flux.sum().item() == pytest.approx(through_the_face(origins, scene.optic), rel=1e-3)
    place, way = (torch.stack(list(part)) for part in (rays.position, rays.direction))
    assert torch.allclose(way.norm(dim=0), torch.ones(65, 100, dtype=torch.float64))
    for number, point in enumerate(points):
        own = slice(50 * number, 50 * (number + 1))
        away = place[:, :, own] - torch.as_tensor(point)[:, None, None]
        away = away / away.norm(dim=0)
        torch.testing.assert_close(way[:, :, own], away)


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
