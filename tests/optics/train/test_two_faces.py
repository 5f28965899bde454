"""The fused trace through two freeform faces against its twin in torch."""

import numpy as np
import pytest
import torch
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.optics.train.test_behind_glass import (
    Light,
    changes,
    from_far,
    from_near,
    origins,
    receivers,
)
from tests.scenes import changed
from workbench.geometry.surface import ControlNet
from workbench.optics.images.beams import beam_image
from workbench.optics.interfaces import Refraction, TransmittanceLaw
from workbench.optics.path import Path
from workbench.optics.reference import Reference
from workbench.optics.samples import Corners
from workbench.optics.sources import Origins
from workbench.optics.steps import FaceStep
from workbench.optics.surfaces import BSplineSurface
from workbench.optics.train.compiled import CompiledTrain
from workbench.scene import Scene


def two_faces(scene, origins, cells, dtype=torch.float64):
    """The path of a scene with a B-spline in place of its flat entrance face."""
    flat = Path.of(scene, ControlNet.of(scene.optic), dtype)
    net = ControlNet((5, 6), (3, 2), scene.optic.half_width)
    surface = BSplineSurface(
        "lens.front", net, flat.datum, dtype, outline=flat.outline, level=scene.optic.entrance_z
    )
    law, _ = TransmittanceLaw.of(scene.optic)
    front = FaceStep(surface, Refraction(law, "fresnel_entrance"), "missed_lens")
    emitter, steps = Light(origins, Corners(*cells)), (front, flat.steps[1])
    front_z = scene.optic.entrance_z - 0.007  # the aperture
    given = flat.receiver, flat.datum, flat.outline, 0, dtype
    return Path(emitter, steps, *given, front_z=front_z)


def faces(scene, seed, amplitude):
    """Heights of both faces, some way apart."""
    rng, lens = np.random.default_rng(seed), scene.optic
    return {
        "lens.front": torch.tensor(lens.entrance_z + amplitude * rng.normal(size=(5, 6))),
        "lens.back": torch.tensor(lens.base.height + amplitude * rng.normal(size=lens.net_shape)),
    }


def landed(tracer, heights, cotangent):
    """Nodes that land, with room; their account; gradients of their product with a cotangent."""
    leaves = {name: each.clone().requires_grad_() for name, each in heights.items()}
    hits, light, room = tracer.nodes(leaves)
    lands = hits.isfinite().all(dim=0) & (hits[2] > 0)
    assert (room[lands] >= 0).all()
    hits = torch.cat([hits, room[None]])
    weighed = torch.where(lands, hits, 0.0) * torch.where(lands, cotangent, 0.0)
    found = torch.autograd.grad(weighed.sum(), list(leaves.values()))
    return torch.where(lands, hits.detach(), 0.0), light.to_data(), found


@settings(max_examples=40)
@given(
    changes=changes(),
    receiver=receivers(),
    origins=origins(),
    cells=st.tuples(st.integers(1, 20), st.integers(1, 20)),
    amplitude=st.sampled_from([0.0, 0.005, 0.05]),
    seed=st.integers(0, 99),
)
def test_twins_agree_in_float64(changes, receiver, origins, cells, amplitude, seed):
    data = changed(changes)
    data.pop("screen")
    scene = Scene.from_data(data | receiver | {"version": 2})
    path, heights = two_faces(scene, origins, cells), faces(scene, seed, amplitude)
    shape = 4, len(origins.flux) * (cells[1] + 1), cells[0] + 1
    cotangent = torch.tensor(np.random.default_rng(seed).normal(size=shape))
    (nodes, light, gradients), (fused, fused_light, fused_gradients) = (
        landed(tracer, heights, cotangent) for tracer in (Reference(path), CompiledTrain(path))
    )
    # A ray at the rim of the exit face, of total reflection or of the horizon is on either side.
    same = (nodes[2] > 0) == (fused[2] > 0)
    assert same.double().mean() > 0.999
    size = 1 + nodes.abs().max()
    assert ((fused - nodes) * same).abs().max() < 1e-8 * size
    if same.all():
        assert fused_light == pytest.approx(light, abs=1e-11)
        for fused_gradient, gradient in zip(fused_gradients, gradients, strict=True):
            assert (fused_gradient - gradient).norm() <= 1e-6 * gradient.norm() + 1e-12


LIGHTS = {
    "directions": from_far(4, 0.02, (0.1, 0.0)),
    "beam": from_far(3, 0.05, waist=0.7),
    "points": from_near(4, (0.1, 0, -3), 0.3, lambertian=True),
}


@pytest.mark.parametrize("light", LIGHTS.values(), ids=LIGHTS)
def test_gradients_are_those_of_central_differences(make_scene, light):
    scene = make_scene({"lens.reflection": "fresnel", "lens.absorption": 0.2})
    tracer, heights = CompiledTrain(two_faces(scene, light, (20, 16))), faces(scene, 1, 0.01)
    generator = np.random.default_rng(0)
    cotangent = torch.tensor(generator.normal(size=(4, len(light.flux) * 17, 21)))
    *_, gradients = landed(tracer, heights, cotangent)
    step = 1e-6
    for (name, face), gradient in zip(heights.items(), gradients, strict=True):
        way = torch.tensor(generator.normal(size=face.shape))
        ahead, behind = (
            (landed(tracer, heights | {name: face + sign * step * way}, cotangent)[0] * cotangent)
            for sign in (1, -1)
        )
        same = (ahead[2] != 0) == (behind[2] != 0)
        assert same.all()
        assert (gradient * way).sum().item() == pytest.approx(
            ((ahead - behind).sum() / (2 * step)).item(), rel=2e-6
        )


@pytest.mark.parametrize("light", LIGHTS.values(), ids=LIGHTS)
def test_single_precision_is_enough(make_scene, light):
    scene = make_scene({"screen.half_width": [2, 2]})
    heights = faces(scene, 1, 0.01)
    cotangent = torch.tensor(np.random.default_rng(0).normal(size=(4, len(light.flux) * 41, 51)))
    found = [
        landed(CompiledTrain(two_faces(scene, light, (50, 40), dtype)), heights, cotangent)
        for dtype in (torch.float64, torch.float32)
    ]
    (nodes, exact, gradients), (single, rounded, single_gradients) = found
    same = (nodes[2] > 0) == (single[2] > 0)
    assert same.double().mean() > 0.999
    assert ((single - nodes).abs() * same).max() < 1e-3  # of a pixel
    assert rounded == pytest.approx(exact, abs=1e-4)
    if same.all():
        for one, other in zip(single_gradients, gradients, strict=True):
            assert (one - other).norm() < 1e-3 * other.norm()


def test_a_mirrored_trace_is_the_whole_trace(make_scene):
    scene = make_scene({"screen.half_width": [1.5, 1.5]})
    quarter = np.array([[0.3, 0.2], [0.1, 0.4], [0.0, 0.1]])
    places = np.unique(np.vstack([quarter * [s, t] for s in (-1, 1) for t in (-1, 1)]), axis=0)
    places = np.column_stack([places, np.full(len(places), -4.0)])
    light = Origins(places, False, np.full(len(places), 0.1))
    heights, cotangent = faces(scene, 3, 0.002), torch.randn(32, 32, dtype=torch.float64)
    for axis in (0, 1):
        heights = {name: (each + each.flip(axis)) / 2 for name, each in heights.items()}
        cotangent = cotangent + cotangent.flip(1 - axis)
    found = []
    for promise in ((True, True), (False, False)):
        tracer = CompiledTrain(two_faces(scene, light, (40, 30)), promise)
        leaves = {name: each.clone().requires_grad_() for name, each in heights.items()}
        hits, account, _ = tracer.nodes(leaves)
        image, _ = beam_image(hits, scene.receiver.pixels, tracer.splits)
        for axis in (0, 1):
            if tracer.mirrored[axis]:
                image = image + image.flip(1 - axis)
        gradients = torch.autograd.grad((image * cotangent).sum(), list(leaves.values()))
        found.append((image.detach(), account.to_data(), gradients))
    (part, account, part_gradients), (whole, all_light, gradients) = found
    assert (part - whole).abs().max() < 1e-12
    assert account == pytest.approx(all_light, abs=1e-12)
    for one, other in zip(part_gradients, gradients, strict=True):
        assert (one - other).norm() < 1e-8 * other.norm()


def test_all_light_is_accounted_for(make_scene):
    scene = make_scene({"lens.absorption": 0.1})
    heights = faces(scene, 1, 0.05)
    for light in LIGHTS.values():
        found = CompiledTrain(two_faces(scene, light, (30, 30))).nodes(heights).account
        assert found.on_screen + sum(found.lost.values()) == pytest.approx(1, abs=1e-12)
        assert found.lost["absorbed"] > 0.002


def test_the_way_back_of_a_trace_may_come_after_another_trace(make_scene):
    scene, light = make_scene({"lens.absorption": 0.2}), LIGHTS["points"]
    tracer = CompiledTrain(two_faces(scene, light, (20, 16)))
    one, other = ({**faces(scene, seed, 0.01)} for seed in (1, 2))

    def traced(heights):
        leaves = [each.clone().requires_grad_() for each in heights.values()]
        hits = tracer.nodes(dict(zip(heights, leaves, strict=True))).hits
        return torch.where(hits.isfinite(), hits, 0.0).sum(), leaves

    alone = torch.autograd.grad(*traced(one))
    total, leaves = traced(one)
    traced(other)
    for late, early in zip(torch.autograd.grad(total, leaves), alone, strict=True):
        assert (late - early).norm() < 1e-9 * early.norm()
