"""The compiled train in light of any origins, against the walk in torch."""

import math

import pytest
import torch
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.optics.train.trains import (
    LIGHTS,
    all_losses,
    cotangent_of,
    from_far,
    from_near,
    heights_of,
    landed,
    train,
    two_faces,
)
from tests.scenes import changed
from workbench.geometry.surface import ControlNet
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.images.beams import beam_image
from workbench.optics.path import Path
from workbench.optics.reference import Reference
from workbench.optics.samples import Corners
from workbench.optics.train.compiled import CompiledTrain
from workbench.scene import Scene


class Lopsided:
    """A pattern that is another one for each origin."""

    def at(self, origin, direction):
        return 1 + 0.5 * direction[0] * direction[1] + 0.3 * origin * direction[2] ** 4


@st.composite
def origins(draw):
    seed, count = draw(st.integers(0, 99)), draw(st.integers(1, 4))
    if draw(st.booleans()):
        tilt = draw(st.floats(-0.5, 0.5)), draw(st.floats(-0.5, 0.5))
        waist = draw(st.sampled_from([math.inf, 0.8]))
        return from_far(count, draw(st.floats(0, 0.2)), tilt, waist, seed)
    middle = draw(st.floats(-2, 2)), draw(st.floats(-2, 2)), -draw(st.floats(1e-2, 9))
    near = from_near(count, middle, draw(st.floats(0, 1)), draw(st.booleans()), seed)
    return near._replace(pattern=Lopsided() if draw(st.booleans()) else None)


@st.composite
def changes(draw):
    degree = draw(st.tuples(*[st.integers(1, 5)] * 2))
    return {
        "lens.degree": list(degree),
        "lens.control_points": [p + draw(st.integers(1, 9)) for p in degree],
        "lens.half_width": [draw(st.floats(0.5, 2.0)), draw(st.floats(0.5, 2.0))],
        "lens.refractive_index": draw(st.floats(1.1, 2.0)),
        "lens.reflection": draw(st.sampled_from(["fresnel", "schlick", "none"])),
        "lens.absorption": draw(st.sampled_from([0.0, 0.3])),
        "lens.outline": draw(st.sampled_from(["rectangle", "ellipse"])),
    }


@st.composite
def receivers(draw):
    """What takes the place of the screen of a scene."""
    pixels = [draw(st.integers(1, 40)), draw(st.integers(1, 40))]
    if draw(st.booleans()):
        half_angle = [draw(st.floats(5, 60)), draw(st.floats(5, 60))]
        center = [draw(st.floats(-20, 20)), draw(st.floats(-20, 20))]
        return {"far_field": {"half_angle": half_angle, "center": center, "pixels": pixels}}
    tilt = [draw(st.floats(-40, 40)), draw(st.floats(-40, 40))]
    center = [draw(st.floats(-2, 2)), draw(st.floats(-2, 2))]
    screen = {"z": 6.0, "half_width": [1.0, 1.5], "center": center, "tilt": tilt}
    return {"screen": screen | {"pixels": pixels}}


@pytest.mark.parametrize(("build", "near"), [(train, 1e-9), (two_faces, 1e-8)])
@settings(max_examples=40)
@given(
    changes=changes(),
    receiver=receivers(),
    origins=origins(),
    cells=st.tuples(st.integers(1, 24), st.integers(1, 24)),
    amplitude=st.sampled_from([0.0, 0.005, 0.05]),
    seed=st.integers(0, 99),
)
def test_twins_agree_in_float64(build, near, changes, receiver, origins, cells, amplitude, seed):
    data = changed(changes)
    data.pop("screen")
    scene = Scene.from_data(data | receiver | {"version": 2})
    path = build(scene, origins, cells)
    heights, cotangent = heights_of(path, seed, amplitude), cotangent_of(path, seed)
    (nodes, light, gradients), (fused, fused_light, fused_gradients) = (
        landed(tracer, heights, cotangent) for tracer in (Reference(path), CompiledTrain(path))
    )
    # A ray at the rim of the exit face, of total reflection or of the horizon is on either side.
    same = (nodes[2] > 0) == (fused[2] > 0)
    assert same.double().mean() > 0.999
    assert ((fused - nodes) * same).abs().max() < near * (1 + nodes.abs().max())
    if same.all():
        assert fused_light == pytest.approx(light, abs=1e-11)
        for fused_gradient, gradient in zip(fused_gradients, gradients, strict=True):
            assert (fused_gradient - gradient).norm() <= 1e-6 * gradient.norm() + 1e-12


def test_samples_shared_by_points_make_the_image_of_samples_of_each(make_scene):
    grid = {"kind": "grid", "center": [0, 0.1, -5], "half_width": [0.4, 0.3], "points": [3, 2]}
    scene = make_scene({"source": grid, "screen.half_width": [1.5, 1.5]})
    path = Path.of(scene, ControlNet.of(scene.optic), torch.float64, samples=Corners(160, 160))
    heights, shared = heights_of(path, amplitude=0.005), CompiledTrain(path)
    each = BeamPlan(scene, (160, 160), dtype=torch.float64).trace(heights)
    image, _ = beam_image(shared.nodes(heights).hits, scene.receiver.pixels, shared.splits)
    assert (image - each.flux).norm() < 2e-3 * each.flux.norm()


def test_light_of_one_straight_direction_is_collimated_light(make_scene):
    scene = make_scene()
    path = Path.of(scene, ControlNet.of(scene.optic), torch.float64, samples=Corners(40, 30))
    heights, tracer = heights_of(path, amplitude=0.005), CompiledTrain(path)
    collimated = BeamPlan(scene, (40, 30), dtype=torch.float64).trace(heights)
    nodes, light, _ = tracer.nodes(heights)
    image, _ = beam_image(nodes, scene.receiver.pixels, tracer.splits)
    assert (image - collimated.flux).abs().max() < 1e-13
    assert light.lost["fresnel_entrance"] == pytest.approx(0.04, abs=1e-14)


def test_the_way_back_of_a_trace_may_come_after_another_trace():
    path = two_faces(all_losses(), LIGHTS["points"], (20, 16))
    tracer, (one, other) = CompiledTrain(path), (heights_of(path, seed) for seed in (1, 2))

    def traced(heights):
        leaves = [each.clone().requires_grad_() for each in heights.values()]
        hits = tracer.nodes(dict(zip(heights, leaves, strict=True))).hits
        return torch.where(hits.isfinite(), hits, 0.0).sum(), leaves

    alone = torch.autograd.grad(*traced(one))
    total, leaves = traced(one)
    traced(other)
    for late, early in zip(torch.autograd.grad(total, leaves), alone, strict=True):
        assert (late - early).norm() < 1e-9 * early.norm()
