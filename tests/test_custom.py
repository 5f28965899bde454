"""Faces, sources and losses of one's own, and how figures of the light change with any number."""

import math
import re

import numpy as np
import pytest
import torch

from resources import path
from tests.optics.points import smooth
from workbench.analysis.derivatives import sensitivities
from workbench.custom import (
    ControlNet,
    Rectangle,
    Sag,
    Screen,
    bspline,
    image,
    rays,
    reflecting,
    refracting,
    trace,
)
from workbench.geometry.faces import FaceArrays
from workbench.optics.path import Path
from workbench.optics.surfaces import Conic
from workbench.scene import Scene

OUTLINE = Rectangle((3.0, 3.0))
SCREEN = Screen(40.0, (6.0, 6.0), (16, 16))
GRID = torch.linspace(-2, 2, 21, dtype=torch.float64)
X, Y = (part.flatten() for part in torch.meshgrid(GRID, GRID, indexing="ij"))


def number(value):
    return torch.tensor(value, dtype=torch.float64, requires_grad=True)


def from_a_point(z=-20.0):
    return lambda: rays(0 * X, 0 * Y, z, (X, Y, -z))


def sphere(radius, vertex):
    def sag(x, y):
        r2 = x**2 + y**2
        return vertex + r2 / (radius + radius.sign() * (radius**2 - r2).sqrt())

    return sag


def test_an_own_sphere_is_the_conic_of_the_package():
    radius, index = number(-12.0), 1.5
    faces = [Sag(sphere(radius, 2.0), OUTLINE), Conic("sphere", 2.0, -1 / 12.0, 0.0, OUTLINE)]
    own, known = (trace(from_a_point(), [refracting(face, index, 1.0)], SCREEN) for face in faces)
    for one, other in zip(
        (own.column, own.row, own.rays.flux, *own.rays.position, *own.rays.direction),
        (known.column, known.row, known.rays.flux, *known.rays.position, *known.rays.direction),
        strict=True,
    ):
        assert torch.allclose(one, other, rtol=0, atol=1e-12)


def test_a_walk_is_that_of_a_scene(make_scene):
    scene = make_scene({"source": {"kind": "point", "position": [0.1, 0, -4], "rays": 500}})
    path_of_scene = Path.of(scene, ControlNet.of(scene.optic), torch.float64)
    height = smooth(scene, 0.1)
    wanted = path_of_scene.walk({"lens.back": height})
    receiver = scene.receiver
    screen = Screen(receiver.z, receiver.half_width, receiver.pixels)
    outline, source = Rectangle(scene.optic.half_width), path_of_scene.emitter.rays(0)
    n = scene.optic.index
    faces = [
        refracting(Sag(lambda x, y: 0 * x, outline), 1.0, n),
        refracting(bspline("back", ControlNet.of(scene.optic)), n, 1.0),
    ]
    found = trace(lambda: source, faces, screen, {"back": height})
    lit = found.rays.flux > 0
    for one, other in ((found.column, wanted.column), (found.row, wanted.row)):
        assert torch.allclose(one[lit], other[wanted.rays.flux > 0], rtol=0, atol=1e-9)


def test_gradients_by_all_numbers_are_those_of_central_differences(rng):
    numbers = {
        "radius": number(-9.0),
        "index": number(1.5),
        "distance": number(40.0),
        "source": number(-20.0),
    }
    net = ControlNet((8, 7), (3, 3), (3.0, 3.0))
    numbers["heights"] = (3 + 0.05 * torch.as_tensor(rng.random(net.shape))).requires_grad_()
    wanted = torch.as_tensor(rng.random((16, 16)))

    def loss(**given):
        n = given["index"]
        faces = [
            refracting(Sag(sphere(given["radius"], 0.5), OUTLINE), 1.0, n),
            refracting(bspline("back", net), n, 1.0),
        ]
        screen = Screen(given["distance"], (6.0, 6.0), (16, 16))
        arrival = trace(from_a_point(given["source"]), faces, screen, {"back": given["heights"]})
        return (image(arrival, screen) * wanted).sum()

    gradients = torch.autograd.grad(loss(**numbers), list(numbers.values()))
    for name, gradient in zip(numbers, gradients, strict=True):
        with torch.no_grad():
            way = torch.as_tensor(rng.standard_normal(gradient.shape))
            ahead, behind = (
                loss(**numbers | {name: numbers[name] + step * way}) for step in (1e-6, -1e-6)
            )
        assert float((gradient * way).sum()) == pytest.approx(
            float(ahead - behind) / 2e-6, rel=2e-4, abs=1e-9
        )


def test_rays_that_miss_an_own_face_are_lost_and_change_no_gradient():
    radius = number(2.45)
    sag = Sag(sphere(radius, 1.0), OUTLINE)  # no sphere beyond
    arrival = trace(lambda: rays(3 * X / 2, Y, -1.0), [refracting(sag, 1.0, 1.5)], SCREEN)
    lost = arrival.lost["missed sag"]
    beside = (X.mul(1.5).square() + Y.square() > 2.45**2).double().mean()
    assert float(lost) == pytest.approx(float(beside), abs=1e-12)
    (gradient,) = torch.autograd.grad(image(arrival, SCREEN).max(), radius)
    assert gradient.isfinite()


def test_an_own_paraboloid_of_a_mirror_has_its_focus():
    focal = number(7.0)
    bowl = Sag(lambda x, y: -(x**2 + y**2) / (4 * focal), OUTLINE)
    arrival = trace(lambda: rays(X, Y, -20.0), [reflecting(bowl)], Screen(-7.0, (1, 1), (10, 10)))
    assert torch.allclose(arrival.column, torch.full_like(X, 5.0), atol=1e-12)
    assert torch.allclose(arrival.row, torch.full_like(X, 5.0), atol=1e-12)


def test_a_fixed_sag_has_gradients_by_rays_alone():
    bowl = Sag(lambda x, y: (x**2 + y**2) / 20, OUTLINE, freeform=False)
    start = rays(X, Y, -5.0)
    assert not any(part.requires_grad for part in bowl.meet(start, {}).position)
    tilt = number(0.01)
    depth = bowl.meet(rays(X, Y, -5.0, (tilt, 0.0, 1.0)), {}).position[2]
    (change,) = torch.autograd.grad(depth.sum(), tilt)
    ahead, behind = (
        bowl.meet(rays(X, Y, -5.0, (each, 0.0, 1.0)), {}).position[2].sum()
        for each in (0.01 + 1e-6, 0.01 - 1e-6)
    )
    assert float(change) == pytest.approx(float(ahead - behind) / 2e-6, rel=1e-5)


def test_the_lines_of_the_manual_run_as_they_stand(tmp_path, monkeypatch, capsys):
    page = path("manual", "own-optics.md").read_text("utf-8")
    own, of_scene = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    exec(compile(own.replace("range(60)", "range(20)"), "own-optics.md", "exec"), {})
    *errors, changes = capsys.readouterr().out.splitlines()
    first, last = (float(errors[k].split()[1]) for k in (0, -1))
    assert last < 0.6 * first
    assert changes.startswith("change of the error by index and distance: (tensor(")
    (tmp_path / "resources").symlink_to(path())
    monkeypatch.chdir(tmp_path)
    exec(compile(of_scene.replace("iterations=5", "iterations=1"), "own-optics.md", "exec"), {})
    assert capsys.readouterr().out.startswith("Sensitivity(value=-")


def test_sensitivities_behind_a_wedge_are_those_of_snells_law():
    slope, thick, far, n = 0.2, 3.0, 60.0, 1.5
    scene = Scene.from_data(
        {
            "version": 3,
            "source": {"kind": "collimated"},
            "elements": [
                {
                    "kind": "lens",
                    "name": "wedge",
                    "half_width": [1, 1],
                    "material": {"index": n},
                    "thickness": thick,
                    "faces": [{"shape": "plane"}, {"shape": "bspline", "control_points": [6, 6]}],
                }
            ],
            "images": [
                {
                    "receiver": {
                        "kind": "plane",
                        "position": [6, 0, far],
                        "half_width": [3, 3],
                        "pixels": [64, 64],
                    },
                    "target": {"builtin": "tophat"},
                }
            ],
        }
    )
    x, _ = ControlNet.of(scene.optic).positions
    heights = FaceArrays({"wedge.back": np.repeat(thick + slope * x[:, None], 6, axis=1)})

    def beyond_the_middle(irradiance, account):
        return irradiance[:, 32:].sum() / irradiance.sum()

    paths = ["wedge.material.index", "images[0].receiver.position[2]", "wedge.position[2]"]
    found = sensitivities(scene, heights, beyond_the_middle, paths)
    inside = math.atan(slope)
    outside = math.asin(n * math.sin(inside))
    bent = outside - inside
    # Light from x lands at x (1 − slope t) + (far − thick) t.
    t, way = math.tan(bent), far - thick
    width = 1 - slope * t
    by_t = way / (2 * width) + (way * t - 6) * slope / (2 * width**2)
    by_index = by_t / math.cos(bent) ** 2 * math.sin(inside) / math.cos(outside)
    wanted = by_index, t / (2 * width), -t / (2 * width)
    for each, value in zip(found.values(), wanted, strict=True):
        assert each.value == pytest.approx(value, rel=1e-5)
        assert each.off < 1e-3 * abs(value)
