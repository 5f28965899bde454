"""Aspheres in torch: rays meet the sag of ISO 10110, with its normal and its derivatives."""

import numpy as np
import pytest
import torch

from workbench.geometry.outlines import Ellipse, Rectangle
from workbench.optics.rays import RayBundle
from workbench.optics.surfaces import Conic

SHAPES = {
    "convex": (0.3, -0.7, [0.05, -0.02, 0.003]),
    "plane base": (0.0, 0.0, [-0.08, 0.01]),
    "hyperboloid": (-0.6, -2.5, [0.1]),
    "ellipsoid near its equator": (0.68, 1.0, [0.02, -0.01]),
}


def sag(shape, r2):
    c, k, terms = shape
    conic = c * r2 / (1 + np.sqrt(1 - (1 + k) * c**2 * r2))
    return conic + sum(a * r2 ** (2 + number) for number, a in enumerate(terms))


def slanted(rng, count, z=-1.0, wide=0.6):
    x, y = rng.uniform(-wide, wide, (2, count))
    way = np.stack([*rng.uniform(-0.4, 0.4, (2, count)), np.ones(count)])
    way /= np.linalg.norm(way, axis=0)
    place, direction = (tuple(map(torch.tensor, each)) for each in ((x, y, np.full(count, z)), way))
    return RayBundle(place, direction, torch.ones(count), torch.ones(count, dtype=torch.bool))


@pytest.mark.parametrize("shape", SHAPES.values(), ids=SHAPES)
def test_rays_meet_the_sag_with_its_normal(rng, shape):
    surface = Conic("face", 0.2, *shape[:2], Rectangle((0.7, 0.7)), shape[2])
    rays = slanted(rng, 500)
    place, normal, met = surface.meet_unbounded(rays, {})
    x, y, z = (part.numpy()[met] for part in place)
    assert met.double().mean() > 0.8
    assert (np.abs(x) < 0.7).mean() > 0.7
    assert z - 0.2 == pytest.approx(sag(shape, x**2 + y**2), abs=1e-14)
    # On the ray.
    for axis in (0, 1):
        way = (place[2] - rays.position[2]) / rays.direction[2]
        expected = rays.position[axis] + way * rays.direction[axis]
        assert (place[axis] - expected).abs().max() < 1e-13
    step = 1e-6
    for axis, (d_x, d_y) in enumerate([(step, 0), (0, step)]):
        ahead, behind = (
            sag(shape, (x + sign * d_x) ** 2 + (y + sign * d_y) ** 2) for sign in (1, -1)
        )
        slope = -(normal[axis] / normal[2]).numpy()[met]
        assert slope == pytest.approx((ahead - behind) / (2 * step), abs=1e-8)
    assert sum(part.square() for part in normal).numpy() == pytest.approx(1.0, abs=1e-14)


@pytest.mark.parametrize("shape", SHAPES.values(), ids=SHAPES)
def test_places_and_normals_follow_the_rays(rng, shape):
    surface = Conic("face", 0.0, *shape[:2], Ellipse((0.9, 0.9)), shape[2])
    rays = slanted(rng, 6, -0.3, 0.3)

    def meeting(*parts):
        rays_of = rays._replace(position=parts[:3], direction=parts[3:])
        place, normal, met = surface.meet_unbounded(rays_of, {})
        assert met.all()
        return (*place, *normal)

    leaves = [part.clone().requires_grad_() for part in (*rays.position, *rays.direction)]
    assert torch.autograd.gradcheck(meeting, leaves, eps=1e-7, atol=1e-6)


def test_without_terms_it_is_the_conic(rng):
    rays, outline = slanted(rng, 200), Rectangle((0.7, 0.7))
    conic = Conic("face", 0.1, 0.4, -0.5, outline)
    almost = Conic("face", 0.1, 0.4, -0.5, outline, [0.0, 0.0, 1e-18])
    assert (conic.kind, almost.kind) == ("conic", "asphere")
    one, other = conic.meet(rays, {}), almost.meet(rays, {})
    assert (one.met == other.met).all()
    for here, there in zip(
        (*one.position, *one.normal), (*other.position, *other.normal), strict=True
    ):
        assert (here - there)[one.met].abs().max() < 1e-14


def test_rays_that_pass_beside_the_asphere_do_not_meet_it(rng):
    shape = SHAPES["ellipsoid near its equator"]
    surface = Conic("face", 0.0, *shape[:2], Rectangle((0.9, 0.9)), shape[2])
    rays = slanted(rng, 100)
    x, y, z = rays.position
    beside = rays._replace(position=(x + 5.0, y, z))
    meeting = surface.meet(beside, {})
    assert not meeting.met.any()
    assert all(part.isfinite().all() for part in (*meeting.position, *meeting.normal))
