"""Light of points through the whole lens: exact cases and gradients."""

import numpy as np
import pytest
import torch

from tests.optics.gradients import check_against_differences
from tests.optics.landing import places_of
from tests.optics.points import (
    DTYPES,
    GRID,
    INDEX,
    OVAL,
    OVAL_DISTANCE,
    POINT,
    THIN_PLATE,
    behind_thin_plate,
    interpolating,
    oval,
    smooth,
)
from tests.optics.rays import bundle, with_rays
from workbench.geometry.surface import ControlNet
from workbench.optics.path import Path
from workbench.optics.plan import Plan

SOURCES = pytest.mark.parametrize("source", [POINT, GRID], ids=["point", "grid"])


def towards(scene, origin, count=40):
    """Rays from a point on the axis to a grid of places on the entrance face."""
    lens = scene.optic
    place = ((np.arange(count) + 0.5) / count * 2 - 1) * 0.8
    x, y = (c.ravel() for c in np.meshgrid(place, place, indexing="ij"))
    direction = np.column_stack([x, y, np.full(len(x), lens.entrance_z)]) - origin
    direction /= np.linalg.norm(direction, axis=1, keepdims=True)
    places = np.column_stack([x, y, np.full(len(x), lens.entrance_z)])
    return x, y, bundle(places, direction, np.full(len(x), 1 / len(x)))


def walked(scene, rays, heights, dtype=torch.float64):
    """Given rays at the receiver."""
    return with_rays(Path.of(scene, ControlNet.of(scene.optic), dtype), rays).walk(
        {"lens.back": heights}
    )


def parts(account):
    emitted, *where = account.to_data().values()
    return emitted, where


@pytest.mark.parametrize("dtype", DTYPES)
def test_an_oval_of_equal_paths_brings_all_light_to_one_point(make_scene, dtype):
    scene = make_scene({"source": POINT, **OVAL})
    net = ControlNet.of(scene.optic)
    _, _, rays = towards(scene, np.array([0, 0, -OVAL_DISTANCE]))
    hits = walked(scene, rays, oval(net), dtype)
    arrives = (hits.rays.flux > 0).numpy()
    assert arrives.mean() > 0.9
    accuracy = 1e-6 if dtype == torch.float64 else 3e-5
    for place in places_of(hits, scene.receiver):
        assert place[arrives].abs().max() < accuracy


class TestFlatPlate:
    @pytest.mark.parametrize(("emission", "power"), [("uniform", 3), ("lambertian", 4)])
    def test_irradiance_falls_with_a_power_of_the_cosine(self, make_scene, emission, power):
        """A thin plate leaves the inverse square and the cosines: cos³, Lambertian cos⁴."""
        source = {"kind": "point", "position": [0, 0, -1.0], "rays": 1 << 20}
        scene = make_scene({"source": source | {"emission": emission}, **THIN_PLATE})
        heights = torch.full(scene.optic.net_shape, 1e-6, dtype=torch.float64)
        traced = Plan(scene, dtype=torch.float64).trace({"lens.back": heights})
        expected = behind_thin_plate(scene, emission, power)
        assert traced.flux.numpy() == pytest.approx(expected, rel=0.02)
        assert traced.flux.sum().item() == pytest.approx(expected.sum(), rel=1e-3)


def test_a_spherical_lens_focuses_where_the_lens_maker_says(make_scene):
    """Paraxial image of a plano-convex lens, its vertex in glass thickness t: n/s' + vergences."""
    radius, distance, thickness = 4.0, 12.0, 0.5
    base = {"shape": "sphere", "height": thickness, "radius": radius, "form": "convex"}
    scene = make_scene(
        {
            "source": POINT,
            "lens.base": base,
            "lens.control_points": [40, 40],
            "screen.z": 60.0,
            "lens.degree": [5, 5],
        }
    )
    net = ControlNet.of(scene.optic)
    control = interpolating(net, scene.optic.base.height_at)
    # Behind the entrance face the object seems n times as far; the exit face adds (n − 1)/R.
    vergence = -INDEX / (INDEX * distance + thickness) + (INDEX - 1) / radius
    image = thickness + 1 / vergence
    path, crossings = Path.of(scene, net, torch.float64), []
    for aperture in (0.01, 0.02, 0.4):
        direction = np.array([[aperture, 0, distance]]) / np.hypot(aperture, distance)
        rays = bundle([[aperture, 0, 0]], direction, [1])
        (_, _, (start, _, depth)), hits = path.follow(rays, {"lens.back": control})
        slope = (places_of(hits, scene.receiver)[0] - start) / (60.0 - depth)
        crossings.append((depth - start / slope).item())
    paraxial = (4 * crossings[0] - crossings[1]) / 3  # without the term of second order
    assert paraxial == pytest.approx(image, rel=1e-4)
    assert crossings[2] < image * 0.99  # undercorrected spherical aberration


@SOURCES
@pytest.mark.parametrize("degree", [(3, 3), (5, 3)])
def test_gradient_is_that_of_central_differences(make_scene, rng, source, degree):
    scene = make_scene(
        {
            "source": source,
            "lens.degree": degree,
            # All light far from the edges of pixels' reach: a wide filter, a screen for all.
            "screen.half_width": [4, 4],
            "screen.pixels": [8, 8],
            "filter": {"kind": "gaussian", "size": [5, 5], "alpha": 0.3},
        }
    )
    plan = Plan(scene, dtype=torch.float64)
    heights = smooth(scene).requires_grad_()
    wanted = torch.as_tensor(rng.random((8, 8)))

    def loss(h):
        flux = plan.trace({"lens.back": h}).flux
        return (flux / flux.sum() - wanted / wanted.sum()).norm() / 8

    x, y = (torch.as_tensor(c) for c in ControlNet.of(scene.optic).positions)
    # A tilt, a focus and a bump, all of them away from the rim, where rays change their side.
    window = (1 - x[:, None] ** 2) * (1 - y[None, :] ** 2)
    directions = window * x[:, None], window**2, window * torch.sin(4 * y[None, :])
    check_against_differences(loss, heights, directions)


class TestHardCases:
    def gradient_of(self, plan, heights):
        heights = heights.clone().requires_grad_()
        traced = plan.trace({"lens.back": heights})
        (gradient,) = torch.autograd.grad(traced.flux.sum(), heights)
        assert torch.isfinite(traced.flux).all()
        assert torch.isfinite(gradient).all()
        emitted, where = parts(traced.account)
        assert sum(where) == pytest.approx(emitted, abs=1e-5)
        return traced.account

    @pytest.mark.parametrize("dtype", DTYPES)
    def test_all_light_totally_reflected(self, make_scene, dtype):
        scene = make_scene(
            {"lens.control_points": [4, 4], "lens.half_width": [0.1, 0.1], "source": POINT}
        )
        x, _ = ControlNet.of(scene.optic).positions
        steep = torch.as_tensor(np.repeat((0.5 + 3 * x)[:, None], 4, axis=1))
        account = self.gradient_of(Plan(scene, dtype=dtype), steep)
        assert account.lost["total_reflection"] > 0.1
        assert account.on_screen == account.lost["off_screen"] == 0
