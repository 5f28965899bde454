"""Trains of several elements: the compiled loops against the walk in torch, and closed forms."""

import numpy as np
import pytest
import torch

from tests.optics.kernels.twins import lens
from tests.optics.train.test_behind_glass import Light, from_far, from_near
from workbench.geometry.surface import ControlNet
from workbench.optics.interfaces import Reflection, Refraction, TransmittanceLaw
from workbench.optics.path import Path
from workbench.optics.reference import Reference
from workbench.optics.samples import Corners
from workbench.optics.steps import FaceStep
from workbench.optics.surfaces import BSplineSurface, Conic, Plane
from workbench.optics.train.compiled import CompiledTrain
from workbench.scene import Scene

LIGHTS = {
    "directions": from_far(3, 0.03, (0.1, -0.05)),
    "points": from_near(3, (0.1, 0, -3), 0.3, lambertian=True),
}


def into(ratio, name):
    """An interface to a medium that is denser by 1 / ratio."""
    return Refraction(TransmittanceLaw.fresnel(ratio), f"fresnel_{name}")


def plate(outline, front, back, index=1.6):
    """A plate between two faces."""
    leaving = Refraction(TransmittanceLaw.fresnel(index), "fresnel_exit", absorption=0.1)
    return [
        FaceStep(front, into(1 / index, "entrance"), "missed_lens"),
        FaceStep(back, leaving, "left_side"),
    ]


def second_lens(flat, dtype):
    """A lens with a plane front and a freeform back."""
    net = ControlNet((6, 5), (2, 3), (1.0, 1.0))
    back = BSplineSurface("second", net, flat.datum, dtype, outline=flat.outline, level=2.2)
    return plate(flat.outline, Plane("front", 1.2, flat.outline), back)


def cover(flat, dtype):
    faces = (Plane(name, z, flat.outline) for name, z in (("front", 0.7), ("back", 1.1)))
    return plate(flat.outline, *faces)


def lens_of_conics(flat, dtype):
    front = Conic("front", 0.9, 0.3, -0.5, flat.outline)
    return plate(flat.outline, front, Conic("back", 1.5, -0.4, 0.7, flat.outline))


def fold(flat, dtype):
    mirror = Conic("mirror", 1.4, -0.1, 0.0, flat.outline)
    return [
        *cover(flat, dtype),
        FaceStep(mirror, Reflection(0.9, "absorbed_mirror"), "missed_mirror"),
    ]


BEHIND = {
    "plate": cover,
    "conics": lens_of_conics,
    "second lens": second_lens,
    "plate and second lens": lambda flat, dtype: [
        *cover(flat, dtype),
        *second_lens(flat, dtype),
    ],
}


def train(scene, light, cells, behind, dtype=torch.float64):
    """The path of a scene with further elements behind its lens."""
    flat = Path.of(scene, ControlNet.of(scene.optic), dtype)
    steps = [*flat.steps, *behind(flat, dtype)]
    emitter = Light(light, Corners(*cells))
    return Path(emitter, steps, flat.receiver, flat.datum, flat.outline, 0, dtype)


def faces(scene, seed, amplitude=0.01):
    noise = np.random.default_rng(seed).normal(size=(6, 5))
    second = torch.tensor(2.2 + amplitude * noise)
    return {"lens.back": lens(scene, seed, amplitude), "second": second}


def landed(tracer, heights, cotangent):
    """Nodes within the rims, their account, and gradients of a product with a cotangent."""
    leaves = {name: each.clone().requires_grad_() for name, each in heights.items()}
    hits, account, rim = tracer.nodes(leaves)
    lands = hits.isfinite().all(dim=0) & (hits[2] > 0)
    hits = torch.cat([hits, rim[None]])
    weighed = torch.where(lands, hits, 0.0) * torch.where(lands, cotangent, 0.0)
    found = torch.autograd.grad(weighed.sum(), list(leaves.values()), allow_unused=True)
    gradients = [torch.zeros(1) if each is None else each for each in found]
    return torch.where(lands, hits.detach(), 0.0), account.to_data(), gradients


@pytest.mark.parametrize("outline", ["rectangle", "ellipse"])
@pytest.mark.parametrize("light", LIGHTS.values(), ids=LIGHTS)
@pytest.mark.parametrize("behind", BEHIND.values(), ids=BEHIND)
def test_twins_agree(make_scene, behind, light, outline):
    scene = make_scene(
        {"lens.outline": outline, "lens.reflection": "fresnel", "lens.absorption": 0.2}
        | {"screen.half_width": [3, 3], "version": 2}
    )
    path, heights = train(scene, light, (30, 24), behind), faces(scene, 1)
    assert CompiledTrain.matches(path)
    cotangent = torch.tensor(np.random.default_rng(0).normal(size=(4, len(light.flux) * 25, 31)))
    (nodes, account, gradients), (fused, fused_account, fused_gradients) = (
        landed(tracer, heights, cotangent) for tracer in (Reference(path), CompiledTrain(path))
    )
    assert ((nodes[2] > 0) == (fused[2] > 0)).all()
    assert (nodes[2] > 0).double().mean() > 0.3
    assert (fused - nodes).abs().max() < 1e-8 * (1 + nodes.abs().max())
    assert fused_account == pytest.approx(account, abs=1e-11)
    assert sum(account.values()) == pytest.approx(2, abs=1e-11)  # and once as emitted
    for one, other in zip(fused_gradients, gradients, strict=True):
        assert (one - other).norm() <= 1e-8 * other.norm()


@pytest.mark.parametrize("light", LIGHTS.values(), ids=LIGHTS)
def test_a_mirror_may_be_the_last_element(light):
    """Light that comes back through nothing: a mirror behind a lens and a plate."""
    scene = Scene.from_data(
        {
            "format": "freeform-scene",
            "version": 2,
            "lens": {
                "half_width": [1.0, 1.0],
                "control_points": [12, 10],
                "refractive_index": 1.5,
                "base": {"shape": "flat", "height": 0.5},
            },
            "source": {"kind": "collimated"},
            "far_field": {"half_angle": [40, 40], "pixels": [16, 16]},
            "target": {"builtin": "tophat"},
        }
    )
    path, heights = train(scene, light, (20, 16), fold), faces(scene, 2)
    path.receiver._onwards = -1
    cotangent = torch.tensor(np.random.default_rng(0).normal(size=(4, len(light.flux) * 17, 21)))
    (nodes, account, gradients), (fused, fused_account, fused_gradients) = (
        landed(tracer, heights, cotangent) for tracer in (Reference(path), CompiledTrain(path))
    )
    assert (nodes[2] > 0).double().mean() > 0.3
    assert (fused - nodes).abs().max() < 1e-8 * (1 + nodes.abs().max())
    assert fused_account == pytest.approx(account, abs=1e-11)
    for one, other in zip(fused_gradients, gradients, strict=True):
        assert (one - other).norm() <= 1e-8 * other.norm()


@pytest.mark.parametrize("light", LIGHTS.values(), ids=LIGHTS)
@pytest.mark.parametrize("behind", [second_lens, lens_of_conics])
def test_gradients_are_those_of_central_differences(scene, behind, light):
    tracer, heights = CompiledTrain(train(scene, light, (20, 16), behind)), faces(scene, 3)
    generator = np.random.default_rng(0)
    cotangent = torch.tensor(generator.normal(size=(4, len(light.flux) * 17, 21)))
    _, _, gradients = landed(tracer, heights, cotangent)
    step = 1e-6
    for (name, face), gradient in zip(heights.items(), gradients, strict=True):
        way = torch.tensor(generator.normal(size=face.shape))
        ahead, behind_it = (
            landed(tracer, heights | {name: face + sign * step * way}, cotangent)[0] * cotangent
            for sign in (1, -1)
        )
        assert ((ahead[2] != 0) == (behind_it[2] != 0)).all()
        expected = ((ahead - behind_it).sum() / (2 * step)).item()
        assert (gradient * way).sum().item() == pytest.approx(expected, rel=5e-6, abs=1e-9)


def test_a_hyperbola_brings_parallel_light_to_one_point(make_scene):
    """A plane front and a conic of −n²: the focus is at R / (n − 1) behind the vertex."""
    index, radius = 1.6, 3.0
    focus = 1.5 + radius / (index - 1)
    scene = make_scene({"screen.z": focus, "screen.half_width": [1, 1], "screen.pixels": [20, 20]})
    straight = from_far(1, 0.0)

    def behind(flat, dtype):
        front, z = Plane("front", 1.0 - flat.datum, flat.outline), 1.5 - flat.datum
        back = Conic("back", z, -1 / radius, -(index**2), flat.outline)
        return plate(flat.outline, front, back, index)

    heights = {"lens.back": torch.full(scene.optic.net_shape, 0.5, dtype=torch.float64)}
    for dtype, accuracy in ((torch.float64, 1e-9), (torch.float32, 2e-4)):
        path = train(scene, straight, (40, 40), behind, dtype)
        columns, rows, flux = CompiledTrain(path).nodes(heights).hits
        assert (flux > 0).all()
        assert (columns - 10).abs().max() < accuracy
        assert (rows - 10).abs().max() < accuracy


def test_a_plate_shifts_tilted_light(make_scene):
    """By t sin θ (1 − cos θ / (n cos θ')), across the light; its direction stays."""
    angle, index, thick = 0.3, 1.6, 0.4
    scene = make_scene({"screen.half_width": [10, 10], "screen.pixels": [20, 20]})
    light = from_far(1, 0.0, (angle, 0.0))
    heights = {"lens.back": torch.full(scene.optic.net_shape, 0.5, dtype=torch.float64)}
    found = []
    for bent in (index, 1.0 + 1e-12):
        path = train(scene, light, (10, 10), lambda flat, _, bent=bent: plate(
            flat.outline,
            Plane("front", 0.2, flat.outline),
            Plane("back", 0.2 + thick, flat.outline),
            bent,
        ))  # fmt: skip
        hits = CompiledTrain(path).nodes(heights).hits
        found.append(torch.where(hits[2] > 0, hits[0], torch.nan))
    inside = np.arcsin(np.sin(angle) / index)
    across = thick * np.sin(angle) * (1 - np.cos(angle) / (index * np.cos(inside)))
    shift = (found[1] - found[0])[~(found[0].isnan() | found[1].isnan())]
    assert len(shift) > 50
    assert shift.numpy() == pytest.approx(across / np.cos(angle), abs=1e-9)  # pixels of 1
