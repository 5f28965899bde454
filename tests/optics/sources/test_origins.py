"""Places and directions from which light comes to the entrance face."""

import math

import numpy as np
import pytest
import torch

from tests.optics.points import GRID, POINT
from workbench.optics.entering import entering
from workbench.optics.samples import Corners
from workbench.optics.sources import emitter_of
from workbench.optics.sources.origins import Origins, through_cells
from workbench.optics.transmittance import TransmittanceLaw

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
    missed = entering(scene.source, scene.optic, TransmittanceLaw.of(scene.optic)[0]).missed
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
