"""The fused trace of samples that all origins of the light share, against its twin in torch."""

import math
from typing import NamedTuple

import numpy as np
import pytest
import torch
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.optics.kernels.twins import lens
from tests.scenes import changed
from workbench.geometry.surface import ControlNet
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.images.beams import beam_image
from workbench.optics.path import Path
from workbench.optics.reference import Reference
from workbench.optics.samples import Corners
from workbench.optics.sources import Origins
from workbench.optics.train.compiled import CompiledTrain
from workbench.optics.train.incident import halved
from workbench.scene import Scene


class Light(NamedTuple):
    """An emitter as far as samples of the exit face need one."""

    origins: Origins
    samples: Corners


class Lopsided:
    """A pattern that is another one for each origin."""

    def at(self, origin, direction):
        return 1 + 0.5 * direction[0] * direction[1] + 0.3 * origin * direction[2] ** 4


def path_of(scene, origins, cells, dtype=torch.float64):
    path = Path.of(scene, ControlNet.of(scene.optic), dtype)
    path.emitter = Light(origins, Corners(*cells))
    return path


def from_far(count, spread, tilt=(0.0, 0.0), waist=math.inf, seed=0):
    """Directions within a cone about a tilted axis, radians, of equal flux."""
    angle = np.random.default_rng(seed).uniform(-spread, spread, (2, count))
    x, y = (np.sin(tilt[axis] + angle[axis]) for axis in (0, 1))
    places = np.stack([x, y, np.sqrt(1 - x**2 - y**2)], axis=1)
    return Origins(places, True, np.full(count, 0.25 / count), waist=waist)


def from_near(count, middle, spread, lambertian=False, seed=0):
    """Points within a square across the axis, of equal flux."""
    aside = np.random.default_rng(seed).uniform(-spread, spread, (count, 2))
    places = np.column_stack([middle[:2] + aside, np.full(count, middle[2])])
    return Origins(places, False, np.full(count, 1 / (2 * math.pi * count)), lambertian)


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


def landed(tracer, heights, cotangent):
    """Nodes that land, their account, and the gradient of their product with a cotangent."""
    leaf = heights.clone().requires_grad_()
    hits, light, _ = tracer.nodes({"lens.back": leaf})
    lands = hits.isfinite().all(dim=0)
    (gradient,) = torch.autograd.grad(torch.where(lands, hits * cotangent, 0.0).sum(), leaf)
    return torch.where(lands, hits.detach(), 0.0), light.to_data(), gradient


@settings(max_examples=50)
@given(
    changes=changes(),
    receiver=receivers(),
    origins=origins(),
    cells=st.tuples(st.integers(1, 30), st.integers(1, 30)),
    amplitude=st.sampled_from([0.0, 0.005, 0.05]),
    seed=st.integers(0, 99),
)
def test_twins_agree_in_float64(changes, receiver, origins, cells, amplitude, seed):
    data = changed(changes)
    data.pop("screen")
    scene = Scene.from_data(data | receiver | {"version": 2})
    path, heights = path_of(scene, origins, cells), lens(scene, seed, amplitude)
    shape = 3, len(origins.flux) * (cells[1] + 1), cells[0] + 1
    cotangent = torch.tensor(np.random.default_rng(seed).normal(size=shape))
    (nodes, light, gradient), (fused, fused_light, fused_gradient) = (
        landed(tracer, heights, cotangent) for tracer in (Reference(path), CompiledTrain(path))
    )
    # A ray at the rim of total reflection or of the horizon may be on either side of it.
    same = (nodes[0] != 0) == (fused[0] != 0)
    assert same.double().mean() > 0.999
    size = 1 + nodes.abs().max()
    assert ((fused - nodes) * same).abs().max() < 1e-9 * size
    assert fused_light == pytest.approx(light, abs=1e-11)
    if same.all():
        assert (fused_gradient - gradient).norm() <= 1e-6 * gradient.norm() + 1e-12


@pytest.mark.parametrize(
    "light",
    [from_far(4, 0.02, (0.1, 0.0)), from_far(3, 0.05, waist=0.7), from_near(4, (0, 0, -3), 0.3)],
    ids=["directions", "beam", "points"],
)
def test_single_precision_is_enough(make_scene, light):
    scene = make_scene({"screen.half_width": [2, 2]})
    heights = lens(scene, 1, 0.01)
    cotangent = torch.tensor(np.random.default_rng(0).normal(size=(3, len(light.flux) * 41, 51)))
    found = [
        landed(CompiledTrain(path_of(scene, light, (50, 40), dtype)), heights, cotangent.to(dtype))
        for dtype in (torch.float64, torch.float32)
    ]
    (nodes, exact, gradient), (single, rounded, single_gradient) = found
    assert (single - nodes).abs().max() < 1e-3  # of a pixel
    assert rounded == pytest.approx(exact, abs=1e-5)
    assert (single_gradient - gradient).norm() < 1e-4 * gradient.norm()


@pytest.mark.parametrize("beams", [True, False], ids=["points", "directions"])
def test_gradients_are_those_of_central_differences(make_scene, beams):
    scene = make_scene({"lens.reflection": "fresnel", "lens.absorption": 0.2})
    light = from_near(3, (0.2, 0, -2), 0.3) if beams else from_far(3, 0.1, (0.2, 0.1), 0.9)
    tracer, heights = CompiledTrain(path_of(scene, light, (20, 16))), lens(scene, 1, 0.01)
    generator = np.random.default_rng(0)
    cotangent = torch.tensor(generator.normal(size=(3, 51, 21)))
    way = torch.tensor(generator.normal(size=heights.shape))
    *_, gradient = landed(tracer, heights, cotangent)
    step = 1e-6
    ahead, behind = (
        (landed(tracer, heights + sign * step * way, cotangent)[0] * cotangent).sum()
        for sign in (1, -1)
    )
    assert (gradient * way).sum().item() == pytest.approx(
        ((ahead - behind) / (2 * step)).item(), rel=1e-6
    )


def test_samples_shared_by_points_make_the_image_of_samples_of_each(make_scene):
    grid = {"kind": "grid", "center": [0, 0.1, -5], "half_width": [0.4, 0.3], "points": [3, 2]}
    scene = make_scene({"source": grid, "screen.half_width": [1.5, 1.5]})
    heights = {"lens.back": lens(scene, 1, 0.005)}
    each = BeamPlan(scene, (160, 160), dtype=torch.float64).trace(heights)
    path = Path.of(scene, ControlNet.of(scene.optic), torch.float64, samples=Corners(160, 160))
    shared = CompiledTrain(path)
    image, _ = beam_image(shared.nodes(heights).hits, scene.receiver.pixels, shared.splits)
    assert (image - each.flux).norm() < 2e-3 * each.flux.norm()


def test_light_of_one_straight_direction_is_collimated_light(make_scene):
    scene = make_scene()
    heights = {"lens.back": lens(scene, 1, 0.005)}
    collimated = BeamPlan(scene, (40, 30), dtype=torch.float64).trace(heights)
    path = Path.of(scene, ControlNet.of(scene.optic), torch.float64, samples=Corners(40, 30))
    nodes, light, _ = CompiledTrain(path).nodes(heights)
    splits = CompiledTrain(path).splits
    image, _ = beam_image(nodes, scene.receiver.pixels, splits)
    assert (image - collimated.flux).abs().max() < 1e-13
    assert light.lost["fresnel_entrance"] == pytest.approx(0.04, abs=1e-14)


def test_one_of_two_mirrored_origins_is_traced():
    places = np.array([[-1.0, 0, -3], [1.0, 0, -3], [0.0, 2, -3], [0.0, -2, -3]])
    origins = Origins(places, False, np.array([1.0, 1.0, 2.0, 2.0]))
    kept, mirrored = halved(origins, (True, True))
    assert mirrored == (True, True)
    np.testing.assert_array_equal(kept.places[:, :2], [[1, 0], [0, 2]])
    np.testing.assert_array_equal(kept.flux, [0.5, 1.0])
    lopsided = origins._replace(flux=np.array([1.0, 3.0, 2.0, 2.0]))
    assert halved(lopsided, (True, True))[1] == (False, True)
    aside = origins._replace(places=places + np.array([0.1, 0, 0]))
    assert halved(aside, (True, False))[1] == (False, False)


@pytest.mark.parametrize("mirrored", [(True, False), (True, True)])
def test_a_mirrored_trace_is_the_whole_trace(make_scene, mirrored):
    scene = make_scene({"screen.half_width": [1.5, 1.5]})
    quarter = np.array([[0.3, 0.2], [0.1, 0.4], [0.0, 0.1]])
    places = np.unique(np.vstack([quarter * [s, t] for s in (-1, 1) for t in (-1, 1)]), axis=0)
    places = np.column_stack([places, np.full(len(places), -4.0)])
    light = Origins(places, False, np.full(len(places), 0.1))
    heights, cotangent = lens(scene, 3, 0.002), torch.randn(32, 32, dtype=torch.float64)
    for axis in (0, 1):
        heights = (heights + heights.flip(axis)) / 2
        cotangent = cotangent + cotangent.flip(1 - axis)
    found = []
    for promise in (mirrored, (False, False)):
        tracer, leaf = CompiledTrain(path_of(scene, light, (80, 60)), promise), heights.clone()
        hits, account, _ = tracer.nodes({"lens.back": leaf.requires_grad_()})
        image, _ = beam_image(hits, scene.receiver.pixels, tracer.splits)
        for axis in (0, 1):
            if tracer.mirrored[axis]:
                image = image + image.flip(1 - axis)
        (gradient,) = torch.autograd.grad((image * cotangent).sum(), leaf)
        found.append((image.detach(), account.to_data(), gradient, tracer.mirrored))
    (part, account, part_gradient, used), (whole, all_light, gradient, _) = found
    assert used == mirrored
    assert (part - whole).abs().max() < 1e-13
    assert account == pytest.approx(all_light, abs=1e-13)
    assert (part_gradient - gradient).norm() < 1e-9 * gradient.norm()


def test_all_light_is_accounted_for(make_scene):
    scene = make_scene({"lens.absorption": 0.1})
    heights = {"lens.back": lens(scene, 1, 0.05)}
    for light in (from_far(3, 0.4), from_near(3, (1, 0, -1), 0.3, lambertian=True)):
        found = CompiledTrain(path_of(scene, light, (30, 30))).nodes(heights).account
        assert found.on_screen + sum(found.lost.values()) == pytest.approx(1, abs=1e-12)
        assert found.lost["absorbed"] > 0.005


@pytest.mark.parametrize("mirrored", [(True, False), (False, True), (True, True)])
def test_half_of_the_samples_of_a_point_on_the_axis_have_its_gradient(make_scene, mirrored):
    source = {"kind": "point", "position": [0, 0, -3.0]}
    scene = make_scene({"source": source, "screen.half_width": [1.5, 1.5]})
    heights, cotangent = lens(scene, 3, 0.02), torch.randn(32, 32, dtype=torch.float64)
    for axis in (0, 1):
        if mirrored[axis]:
            heights = (heights + heights.flip(axis)) / 2
            cotangent = cotangent + cotangent.flip(1 - axis)
    found = []
    for promise in (mirrored, (False, False)):
        plan = BeamPlan(scene, (40, 36), mirrored=promise, dtype=torch.float64)
        leaf = heights.clone().requires_grad_()
        image, account = plan.trace({"lens.back": leaf})
        (gradient,) = torch.autograd.grad((image * cotangent).sum(), leaf)
        found.append((image.detach(), account.to_data(), gradient))
    (part, light, part_gradient), (whole, all_light, gradient) = found
    assert (part - whole).abs().max() < 1e-12
    assert light == pytest.approx(all_light, abs=1e-12)
    assert (part_gradient - gradient).norm() < 1e-8 * gradient.norm()
