"""The fused trace of samples of the exit face against its twin in torch."""

import numpy as np
import pytest
import torch
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.optics.kernels.twins import account, lens, losses, with_gradient
from workbench.geometry.surface import ControlNet
from workbench.optics.kernels.face import FusedFaceSamples
from workbench.optics.path import Path
from workbench.optics.plan import Plan
from workbench.optics.reference import Reference


def twins(scene, samples, dtype):
    path = Path.of(scene, ControlNet.of(scene.lens), dtype, samples=samples)
    return Reference(path), FusedFaceSamples(path)


@st.composite
def scenes(draw):
    degree = draw(st.tuples(*[st.integers(1, 7)] * 2))
    position = [draw(st.floats(-2, 2)), draw(st.floats(-2, 2)), -draw(st.floats(1e-3, 9))]
    emission = draw(st.sampled_from(["uniform", "lambertian"]))
    source = {"kind": "point", "position": position, "emission": emission}
    if draw(st.booleans()):
        source = {"kind": "grid", "center": position, "emission": emission, "rays": 1}
        source["half_width"] = [draw(st.floats(0, 2)), draw(st.floats(0, 2))]
        source["points"] = [draw(st.integers(1, 6)), draw(st.integers(1, 6))]
    return draw(losses()) | {
        "lens.degree": list(degree),
        "lens.control_points": [p + draw(st.integers(1, 9)) for p in degree],
        "lens.half_width": [draw(st.floats(0.5, 2.0)), draw(st.floats(0.5, 2.0))],
        "lens.refractive_index": draw(st.floats(1.1, 2.0)),
        "source": source,
        "screen.pixels": [draw(st.integers(1, 40)), draw(st.integers(1, 40))],
        # Smooth over the edges of pixels, where rounding moves light from one to the next.
        "filter": {"kind": "gaussian", "size": [3, 5], "alpha": draw(st.sampled_from([0.1, 1.0]))},
    }


# The fixture makes every scene anew.
@settings(max_examples=50, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    changes=scenes(),
    samples=st.tuples(st.integers(1, 90), st.integers(1, 90)),
    amplitude=st.sampled_from([0.0, 0.005, 0.05, 0.5]),
    seed=st.integers(0, 99),
)
def test_twins_agree_in_float64(make_scene, changes, samples, amplitude, seed):
    scene = make_scene(changes)
    heights = lens(scene, seed, amplitude)
    cotangent = torch.tensor(np.random.default_rng(seed).normal(size=scene.screen.pixels[::-1]))
    (light, gradient), (fused, fused_gradient) = (
        with_gradient(tracer, heights, scene, cotangent)
        for tracer in twins(scene, samples, torch.float64)
    )
    assert (fused.flux - light.flux).abs().max() < 1e-12
    # Of a ray within rounding of total reflection the gradient grows beyond bounds.
    assert (fused_gradient - gradient).norm() <= 1e-7 * gradient.norm() + 1e-14
    assert account(fused) == pytest.approx(account(light), abs=1e-11)


SOURCES = {
    "point": {"kind": "point", "position": [0.3, -0.2, -5.0]},
    "lambertian": {"kind": "point", "position": [0, 0, -0.5], "emission": "lambertian"},
    "beside": {"kind": "point", "position": [2.0, -1.3, -1.0]},
    "near": {"kind": "point", "position": [0.2, 0, -0.01]},
    "grid": {"kind": "grid", "center": [0, 0.1, -5], "half_width": [1, 1], "points": [5, 4]},
}


@pytest.mark.parametrize("amplitude", [0.0, 0.01, 0.05])
@pytest.mark.parametrize("source", SOURCES.values(), ids=SOURCES.keys())
def test_single_precision_is_enough(make_scene, source, amplitude):
    """Single from double, and the twins from each other, by their rounding alone."""
    scene = make_scene({"source": source, "screen.pixels": [8, 8], "screen.half_width": [4, 4]})
    heights = lens(scene, 1, amplitude)
    cotangent = torch.randn(8, 8, generator=torch.Generator().manual_seed(1))
    exact, _ = twins(scene, (101, 64), torch.float64)
    reference, fused = twins(scene, (101, 64), torch.float32)
    light, gradient = with_gradient(exact, heights, scene, cotangent)
    for tracer in (reference, fused):
        single, single_gradient = with_gradient(tracer, heights, scene, cotangent)
        assert (single.flux - light.flux).norm() < 1e-5 * light.flux.norm()
        assert (single_gradient - gradient).norm() < 2e-3 * gradient.norm()
        assert account(single) == pytest.approx(account(light), abs=1e-5)


@pytest.mark.parametrize("samples", [(100, 120), (101, 120), (90, 75)])
@pytest.mark.parametrize("mirrored", [(True, False), (False, True), (True, True)])
@pytest.mark.parametrize("kind", ["point", "grid"])
def test_a_mirrored_trace_is_the_whole_trace(make_scene, kind, mirrored, samples):
    source = {"kind": "point", "position": [0, 0, -3.0]}
    if kind == "grid":
        source = {"kind": "grid", "center": [0, 0, -3], "half_width": [1, 0.5], "points": [5, 4]}
    scene = make_scene({"source": source, "screen.half_width": [1.5, 1.5]})
    heights, cotangent = lens(scene, 3, 0.02), torch.randn(32, 32, dtype=torch.float64)
    for axis in (0, 1):
        if mirrored[axis]:
            heights = (heights + heights.flip(axis)) / 2
            cotangent = cotangent + cotangent.flip(1 - axis)
    found = []
    for promise in (mirrored, (False, False)):
        plan = Plan(scene, samples=samples, mirrored=promise, dtype=torch.float64)
        leaf = heights.clone().requires_grad_()
        traced = plan.trace({"exit": leaf})
        (gradient,) = torch.autograd.grad((traced.flux * cotangent).sum(), leaf)
        found.append((traced, gradient))
    (part, part_gradient), (whole, whole_gradient) = found
    assert (part.flux - whole.flux).abs().max() < 1e-15
    assert (part_gradient - whole_gradient).norm() < 1e-12 * whole_gradient.norm()
    assert part.account.to_data() == pytest.approx(whole.account.to_data(), abs=1e-12)


def test_the_number_of_threads_leaves_the_light_alone(make_scene):
    scene = make_scene({"source": SOURCES["point"]})
    heights, cotangent = lens(scene, 1, 0.02), torch.randn(32, 32, dtype=torch.float64)
    _, fused = twins(scene, (300, 200), torch.float64)
    threads = torch.get_num_threads()
    found = []
    try:
        for count in (1, 2, 3):
            torch.set_num_threads(count)
            found.append(with_gradient(fused, heights, scene, cotangent))
    finally:
        torch.set_num_threads(threads)
    for light, gradient in found[1:]:
        assert (light.flux - found[0][0].flux).abs().max() < 1e-15
        assert (gradient - found[0][1]).norm() < 1e-12 * found[0][1].norm()


def test_gradcheck(make_scene):
    scene = make_scene(
        {
            "source": SOURCES["grid"],
            "lens.control_points": [4, 5],
            "screen.pixels": [3, 3],
            "screen.half_width": [4, 4],
            "filter": {"kind": "gaussian", "size": [3, 3], "alpha": 0.5},
        }
    )
    _, fused = twins(scene, (20, 20), torch.float64)
    heights = lens(scene, 2, 0.02).requires_grad_()
    assert torch.autograd.gradcheck(
        lambda h: fused.image({"exit": h}, scene.filter).flux,
        heights,
        eps=1e-7,
        atol=1e-6,
    )
