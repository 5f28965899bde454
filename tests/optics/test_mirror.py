"""Mirrors against closed forms, central differences and themselves."""

import math

import numpy as np
import pytest
import torch

from workbench.geometry.surface import ControlNet
from workbench.optics.interfaces import Reflection
from workbench.optics.path import Path
from workbench.optics.rays import RayBundle
from workbench.optics.receivers import receiver_of
from workbench.optics.surfaces import Meeting
from workbench.scene import Scene

_MIRROR = {"half_width": [1.0, 0.8], "control_points": [9, 7], "degree": [2, 2]}


def scene_of(**changes):
    data = {
        "unit": "cm",
        "mirror": _MIRROR,
        "source": {"kind": "collimated", "rays": [40, 30]},
        "screen": {"z": -5.0, "half_width": [1.0, 1.0], "pixels": [16, 16]},
        "target": {"builtin": "tophat"},
        "filter": {"kind": "box"},
    }
    return Scene.from_data(data | changes)


def squares(net, axis):
    """Control points of the B-spline x² (or y²) of degree 2, by its polar form."""
    knots = (2 * net.knots[axis] - 1) * net.half_width[axis]
    return np.array([knots[i + 1] * knots[i + 2] for i in range(net.shape[axis])])


def walked(scene, heights):
    path = Path.of(scene, ControlNet.of(scene.optic), torch.float64)
    return path.walk({"mirror.face": torch.as_tensor(heights)})


def total(arrival):
    flux = arrival.rays.flux.sum().item()
    return flux + sum(part.item() for part in arrival.lost.values())


def test_a_paraboloid_gathers_parallel_light_in_its_focus():
    scene = scene_of()
    net = ControlNet.of(scene.optic)
    heights = -(squares(net, 0)[:, None] + squares(net, 1)) / (4 * 5.0)
    arrival = walked(scene, heights)
    assert arrival.column == pytest.approx(8, abs=1e-10)
    assert arrival.row == pytest.approx(8, abs=1e-10)
    assert total(arrival) == pytest.approx(1, abs=1e-12)


def test_a_plane_mirror_turns_light_by_twice_its_angle():
    """Tilted by a about y, it sends light to (sin 2a, 0, -cos 2a)."""
    angle = math.radians(25)
    screen = {"center": [0.0, 0.5], "tilt": [0.0, -50.0], "half_width": [2.0, 1.5]}
    middle = 6 * math.sin(2 * angle), -6 * math.cos(2 * angle)
    scene = scene_of(
        screen=screen | {"center": [middle[0], 0.5], "z": middle[1], "pixels": [40, 30]}
    )
    net = ControlNet.of(scene.optic)
    x, _ = net.positions
    heights = np.repeat(math.tan(angle) * x[:, None], net.shape[1], axis=1)
    arrival = walked(scene, heights)
    assert arrival.rays.direction[0] == pytest.approx(math.sin(2 * angle), abs=1e-12)
    assert arrival.rays.direction[2] == pytest.approx(-math.cos(2 * angle), abs=1e-12)
    at = arrival.rays.position
    # The screen is across the light, and turned about y as the light is.
    along = at[0] * math.cos(2 * angle) + at[2] * math.sin(2 * angle)
    assert arrival.column == pytest.approx((along + 2.0) * 10, abs=1e-10)
    assert arrival.row == pytest.approx((1.5 - (at[1] - 0.5)) * 10 + 0 * at[0], abs=1e-10)


class Ellipsoid:
    """Ellipsoid of revolution with its foci on the axis, met by rays from one of them."""

    def __init__(self, low, high, sum_of_ways):
        self.middle, half = (low + high) / 2, (high - low) / 2
        self.a, self.b2 = sum_of_ways / 2, (sum_of_ways / 2) ** 2 - half**2

    def meet(self, rays):
        (x, y, z), (d_x, d_y, d_z) = rays.position, rays.direction
        z = z - self.middle
        a, b = (d_x**2 + d_y**2) / self.b2 + d_z**2 / self.a**2, z * d_z / self.a**2
        c = (x**2 + y**2) / self.b2 + z**2 / self.a**2 - 1
        way = (-b + (b * b - a * c).sqrt()) / a
        place = x + way * d_x, y + way * d_y, z + way * d_z
        normal = torch.stack([place[0] / self.b2, place[1] / self.b2, place[2] / self.a**2])
        normal = normal / normal.norm(dim=0)
        at = place[0], place[1], place[2] + self.middle
        return Meeting(at, tuple(normal), torch.ones_like(way, dtype=torch.bool))


def test_an_ellipsoid_sends_the_light_of_one_focus_to_the_other():
    scene = scene_of()
    x, y = (
        part.ravel() for part in torch.meshgrid(*[torch.linspace(-0.5, 0.5, 9)] * 2, indexing="ij")
    )
    direction = torch.stack([x, y, torch.ones_like(x)]).double()
    direction = direction / direction.norm(dim=0)
    start = torch.zeros_like(direction)
    alive = torch.ones(81, dtype=torch.bool)
    flux = torch.full((81,), 1 / 81, dtype=torch.float64)
    rays = RayBundle(tuple(start), tuple(direction), flux, alive)
    meeting = Ellipsoid(-5.0, 0.0, 12.0).meet(rays)
    passed = Reflection(0.75, "absorbed_mirror").turn(rays, meeting)
    column, row = receiver_of(scene.receiver, scene.optic, 0.0, -1).places(passed.rays)
    assert column == pytest.approx(8, abs=1e-10)
    assert row == pytest.approx(8, abs=1e-10)
    assert passed.rays.flux.sum().item() == pytest.approx(0.75, abs=1e-14)
    assert passed.lost["absorbed_mirror"].sum().item() == pytest.approx(0.25, abs=1e-14)


SOURCES = {
    "collimated": {"kind": "collimated", "rays": [40, 30]},
    "tilted": {"kind": "collimated", "rays": [40, 30], "direction": [5.0, -8.0]},
    "point": {"kind": "point", "position": [0.3, -0.2, -4.0], "rays": 4096},
    "area": {"kind": "area", "center": [0, 0, -4.0], "half_width": [0.2, 0.1], "rays": 4096},
}


@pytest.mark.parametrize("source", SOURCES)
def test_a_mirror_takes_what_it_does_not_reflect(source):
    scene = scene_of(source=SOURCES[source], mirror=_MIRROR | {"reflectance": 0.9})
    random = np.random.default_rng(3)
    arrival = walked(scene, 0.05 * random.standard_normal((9, 7)))
    assert total(arrival) == pytest.approx(1, abs=1e-9)
    assert arrival.lost["absorbed_mirror"].item() == pytest.approx(
        arrival.rays.flux.sum().item() / 9, rel=1e-9
    )


@pytest.mark.parametrize("source", ["collimated", "point"])
def test_slopes_of_hits_are_those_of_central_differences(source):
    scene = scene_of(source=SOURCES[source])
    random = np.random.default_rng(4)
    heights, change = (0.05 * random.standard_normal((9, 7)) for _ in range(2))
    path = Path.of(scene, ControlNet.of(scene.optic), torch.float64)
    weight = torch.as_tensor(random.standard_normal(path.walk(_at(heights)).column.shape))

    def value(step):
        arrival = path.walk(_at(heights + step * change))
        return (torch.where(arrival.rays.alive, arrival.column, 0.0) * weight).sum()

    at = torch.tensor(heights, requires_grad=True)
    arrival = path.walk({"mirror.face": at})
    (torch.where(arrival.rays.alive, arrival.column, 0.0) * weight).sum().backward()
    slope = (value(1e-5) - value(-1e-5)).item() / 2e-5
    assert (at.grad.numpy() * change).sum() == pytest.approx(slope, rel=1e-6)


def _at(heights):
    return {"mirror.face": torch.as_tensor(heights)}
