"""Each shape of a fixed face: what the scene, the design and the check say of it is one surface."""

from typing import get_args

import numpy as np
import pytest
import torch

from workbench.analysis.tracing.elements import TracedRays
from workbench.analysis.tracing.surfaces.fixed import fixed_surface as checked_surface
from workbench.geometry.outlines import Ellipse
from workbench.optics.rays import RayBundle
from workbench.optics.surfaces import fixed_surface
from workbench.scene.faces import ConicFace, FixedFace, PlaneFace

FACES = [
    PlaneFace(),
    ConicFace(radius=-4.0),
    ConicFace(radius=5.0, conic=-1.7, coefficients=(4e-3, -2e-4)),
]
SIZE, Z, STEP = (1.5, 1.0), 0.3, 1e-4


def test_each_shape_is_tested():
    assert {type(face) for face in FACES} == set(get_args(FixedFace))


@pytest.mark.parametrize("turned", [False, True])
@pytest.mark.parametrize("face", FACES, ids=lambda face: face.shape)
def test_rays_meet_the_face_that_the_scene_describes(face, turned):
    random = np.random.default_rng(3)
    x, y = random.uniform(-0.6, 0.6, (2, 500)) * np.array(SIZE)[:, None]
    way = np.column_stack([*random.uniform(-0.3, 0.3, (2, 500)), np.ones(500)])
    way /= np.linalg.norm(way, axis=1, keepdims=True)
    start = np.column_stack([x, y, np.full(500, -2.0)])
    seen = face.turned() if turned else face

    surface = fixed_surface(face, "face", -Z if turned else Z, Ellipse(SIZE))
    surface = surface.from_behind() if turned else surface
    rays = RayBundle(
        tuple(torch.as_tensor(start.T)),
        tuple(torch.as_tensor(way.T)),
        torch.ones(500, dtype=torch.float64),
        torch.ones(500, dtype=torch.bool),
    )
    met = surface.meet(rays, {})
    place, normal = (
        np.stack(np.broadcast_arrays(*part), axis=-1) for part in (met.position, met.normal)
    )
    crossings = checked_surface(seen, Z, Ellipse(SIZE), "missed").meet(
        TracedRays(start, way, np.ones(500))
    )

    lit = met.met.numpy()
    assert 250 < np.count_nonzero(lit) < 500
    np.testing.assert_array_equal(lit, crossings.flux > 0)
    (x, y, z), normal = place[lit].T, normal[lit]
    np.testing.assert_allclose(z, Z + seen.sag(x, y), atol=1e-12)
    np.testing.assert_allclose(normal, seen.normal(x, y), atol=1e-12)
    np.testing.assert_allclose(crossings.position[lit], place[lit], atol=1e-11)
    found = np.broadcast_to(crossings.normal, place.shape)[lit]
    np.testing.assert_allclose(found, normal, atol=1e-11)


@pytest.mark.parametrize("face", FACES, ids=lambda face: face.shape)
def test_the_vertex_has_the_curvature_of_the_sag(face):
    ring = face.sag(STEP * np.array([1, 0, -1, 0]), STEP * np.array([0, 1, 0, -1]))
    assert ring.mean() * 2 / STEP**2 == pytest.approx(face.vertex_curvature, abs=1e-6)
    assert face.extent(SIZE)[0] <= face.sag(*SIZE) <= face.extent(SIZE)[1]
    if face.sphere_radius is not None:
        x = np.linspace(-1, 1, 9)
        distance = np.hypot(x, face.sag(x, 0 * x) - face.sphere_radius)
        np.testing.assert_allclose(distance, abs(face.sphere_radius), rtol=1e-12)
