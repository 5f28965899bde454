"""Collimated light through the exit face: exact cases and invariances."""

import numpy as np
import pytest
import torch

from tests.optics.landing import places_of
from workbench.geometry.surface import ControlNet
from workbench.optics.interfaces import refract
from workbench.optics.path import Path
from workbench.optics.paths import ray_paths
from workbench.optics.plan import Plan

DTYPES = [torch.float32, torch.float64]


def flat(scene):
    return torch.full(scene.optic.net_shape, scene.optic.base.height, dtype=torch.float64)


def wavy(scene, rng, amplitude=0.02):
    return flat(scene) + amplitude * torch.as_tensor(rng.normal(size=scene.optic.net_shape))


@pytest.mark.parametrize("dtype", DTYPES)
def test_a_flat_plate_does_not_deviate(make_scene, dtype):
    scene = make_scene()
    arrival = Path.of(scene, ControlNet.of(scene.optic), dtype).walk({"lens.back": flat(scene)})
    x, y = places_of(arrival, scene.receiver)
    centres = (np.arange(64) + 0.5) / 32 - 1
    assert np.abs(x.numpy() - centres[:, None]).max() < 1e-6
    assert np.abs(y.numpy() - centres[None, :]).max() < 1e-6
    assert arrival.rays.flux.sum().item() == pytest.approx(0.96**2, rel=1e-5)


def test_a_plano_hyperbolic_lens_focuses_to_one_point(make_scene):
    # Equal optical paths n w + sqrt(r^2 + (d - w)^2) = d: a hyperboloid with focus on the screen.
    scene = make_scene(
        {"lens.control_points": [80, 90], "lens.degree": [5, 6], "source.rays": [40, 40]}
    )
    n, d = scene.optic.index, scene.receiver.z - 0.6
    net = ControlNet.of(scene.optic)
    x, y = net.positions
    r2 = x[:, None] ** 2 + y[None, :] ** 2
    w = (d * (n - 1) - np.sqrt(d**2 * (n - 1) ** 2 + (n**2 - 1) * r2)) / (n**2 - 1)
    # Heights at the Greville sites, carried to the control heights that interpolate them.
    sites = (x + 1) / 2, (y + 1) / 2
    basis = net.grid(*sites)
    heights = np.linalg.solve(basis.along_x, np.linalg.solve(basis.along_y.T, (0.6 + w).T).T)
    arrival = Path.of(scene, net, torch.float64).walk({"lens.back": torch.as_tensor(heights)})
    assert arrival.rays.alive.all()
    assert all(place.abs().max() < 1e-7 for place in places_of(arrival, scene.receiver))


def test_the_walk_follows_snells_law(make_scene, rng):
    scene = make_scene({"lens.refractive_index": 1.7})
    heights = wavy(scene, rng)
    net = ControlNet.of(scene.optic)
    arrival = Path.of(scene, net, torch.float64).walk({"lens.back": heights})
    t = (np.arange(64) + 0.5) / 64
    z, slope_x, slope_y = (torch.as_tensor(a) for a in net.grid(t, t).evaluate(heights.numpy()))
    length = (1 + slope_x**2 + slope_y**2).sqrt()
    up = torch.zeros_like(z), torch.zeros_like(z), torch.ones_like(z)
    out = refract(up, (-slope_x / length, -slope_y / length, 1 / length), 1.7)
    path = (scene.receiver.z - z) / out.direction[2]
    x = torch.as_tensor(2 * t - 1)[:, None] + path * out.direction[0]
    y = torch.as_tensor(2 * t - 1)[None, :] + path * out.direction[1]
    assert torch.equal(arrival.rays.alive, out.passes)
    for place, expected in zip(places_of(arrival, scene.receiver), (x, y), strict=True):
        assert (place - expected)[out.passes].abs().max() < 1e-11


def test_gradient_is_that_of_central_differences(make_scene, rng):
    scene = make_scene({"lens.control_points": [6, 7], "source.rays": [37, 41]})
    plan = Plan(scene, dtype=torch.float64)
    cotangent = torch.as_tensor(rng.normal(size=(32, 32)))
    heights = wavy(scene, rng).requires_grad_()

    def value(h):
        return (plan.trace({"lens.back": h}).flux * cotangent).sum()

    (gradient,) = torch.autograd.grad(value(heights), heights)
    direction = torch.as_tensor(rng.normal(size=(6, 7)))
    step = 1e-7 * direction
    with torch.no_grad():
        central = (value(heights + step) - value(heights - step)) / 2e-7
    assert (gradient * direction).sum().item() == pytest.approx(central.item(), rel=1e-4)


def test_paths_end_where_the_trace_does(make_scene, rng):
    scene = make_scene({"source.rays": [5, 4]})
    heights = wavy(scene, rng)
    paths = ray_paths(scene, {"lens.back": heights.numpy()}, (5, 4))
    arrival = Path.of(scene, ControlNet.of(scene.optic), torch.float64).walk({"lens.back": heights})
    assert paths.points.shape == (20, 4, 3)
    assert paths.points[:, 3, 0] == pytest.approx(
        places_of(arrival, scene.receiver)[0].numpy().ravel()
    )
    assert paths.points[:, 3, 2] == pytest.approx(scene.receiver.z)
    assert paths.points[:, 1, 2] == pytest.approx(scene.optic.entrance_z)
    assert (paths.weight > 0.9).all()
    expected = (np.abs(paths.points[:, 3, :2]) < 1).all(axis=1)
    assert (paths.on_screen == expected).all()
