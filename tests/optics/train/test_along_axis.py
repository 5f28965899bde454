"""The fused trace of collimated light against its twin in torch."""

import threading
from typing import ClassVar

import numpy as np
import pytest
import torch

from tests.optics.kernels.twins import account, lens, with_gradient
from workbench.geometry.surface import ControlNet
from workbench.optics.path import Path
from workbench.optics.reference import Reference
from workbench.optics.train.compiled import CompiledTrain
from workbench.scene import GaussianFilter

# Rays nearer than this to the edge of a pixel may count on either side in float32, in pixels.
BAND = 1e-4


def twins(scene, dtype, mirrored=(False, False)):
    path = Path.of(scene, ControlNet.of(scene.optic), dtype)
    return Reference(path), CompiledTrain(path, mirrored)


def share_in_band(scene, heights):
    """Part of the rays that float32 may see in another pixel."""
    arrival = Path.of(scene, ControlNet.of(scene.optic), torch.float64).walk({"lens.back": heights})
    near = [(c - c.round()).abs() < BAND for c in (arrival.column, arrival.row)]
    return (near[0] | near[1]).double().mean().item()


@pytest.mark.parametrize("size", [(1, 1), (3, 3), (5, 3)])
@pytest.mark.parametrize("amplitude", [0.0, 0.01, 0.1])
@pytest.mark.parametrize("half_width", [0.64, 30.0])
def test_twins_agree_in_float32_but_for_rays_on_the_edge_of_a_pixel(
    make_scene, size, amplitude, half_width
):
    scene = make_scene(
        {
            "source.rays": [150, 130],
            "filter.size": list(size),
            "lens.half_width": [half_width, half_width],
            "screen.half_width": [half_width, half_width],
            "screen.z": 5 * half_width,
        }
    )
    heights = lens(scene, 3, amplitude * half_width)
    cotangent = torch.tensor(np.random.default_rng(5).normal(size=(32, 32)))
    (exact, gradient), (light, found) = (
        with_gradient(tracer, heights, scene, cotangent) for tracer in twins(scene, torch.float32)
    )
    band = share_in_band(scene, heights)
    assert light.flux.dtype == torch.float32
    # Through a box a ray in the band may light another pixel; else the image has no jumps.
    moved = 2 * band if size == (1, 1) else 0
    assert (light.flux - exact.flux).abs().sum().item() <= 2e-5 + moved
    assert account(light) == pytest.approx(account(exact), abs=2e-6 + moved)
    assert (found - gradient).norm() <= (1e-4 + 4 * band) * max(1e-3, gradient.norm().item())


@pytest.mark.parametrize("rays", [(1, 1), (1, 300), (300, 1), (257, 3), (700, 40)])
def test_any_number_of_rays_fills_its_batches(make_scene, rays):
    scene = make_scene({"source.rays": list(rays)})
    heights = lens(scene, 2, 0.02)
    cotangent = torch.tensor(np.random.default_rng(5).normal(size=(32, 32)))
    (exact, gradient), (light, found) = (
        with_gradient(tracer, heights, scene, cotangent) for tracer in twins(scene, torch.float64)
    )
    assert torch.allclose(light.flux, exact.flux, rtol=0, atol=1e-13)
    assert (found - gradient).norm() <= 1e-11 * gradient.norm()


def test_two_threads_of_python_may_trace_at_once(make_scene):
    scene = make_scene({"source.rays": [256, 200]})
    kernel = twins(scene, torch.float64)[1]
    lenses = [lens(scene, seed, 0.02) for seed in range(8)]
    alone = [kernel.image({"lens.back": heights}, scene.filter).flux for heights in lenses]
    together = [None] * len(lenses)

    def trace(number):
        together[number] = kernel.image({"lens.back": lenses[number]}, scene.filter).flux

    started = [threading.Thread(target=trace, args=[number]) for number in range(len(lenses))]
    for thread in started:
        thread.start()
    for thread in started:
        thread.join()
    assert all(torch.equal(a, b) for a, b in zip(alone, together, strict=True))


class TestMirrored:
    CHANGES: ClassVar = {"source.rays": [60, 50], "lens.control_points": [9, 10]}

    def symmetric(self, values, mirrored):
        for axis, wanted in enumerate(mirrored):
            if wanted:
                values = (values + values.flip(axis)) / 2
        return values

    @pytest.mark.parametrize("mirrored", [(True, False), (False, True), (True, True)])
    @pytest.mark.parametrize("filter", [{"kind": "box"}, {"kind": "gaussian", "size": [3, 5]}])
    def test_half_the_rays_give_the_whole(self, make_scene, mirrored, filter):
        scene = make_scene({**self.CHANGES, "filter": filter})
        heights = self.symmetric(lens(scene, 3, 0.04), mirrored)
        cotangent = torch.tensor(np.random.default_rng(5).normal(size=(32, 32)))
        cotangent = self.symmetric(cotangent.T, mirrored).T
        whole, gradient = with_gradient(twins(scene, torch.float64)[1], heights, scene, cotangent)
        kernel = twins(scene, torch.float64, mirrored)[1]
        assert kernel.mirrored == mirrored
        light, found = with_gradient(kernel, heights, scene, cotangent)
        assert torch.allclose(light.flux, whole.flux, rtol=0, atol=1e-13)
        assert account(light) == pytest.approx(account(whole), abs=1e-13)
        assert (found - gradient).norm() <= 1e-11 * gradient.norm()

    def test_an_odd_number_of_rays_is_traced_whole(self, make_scene):
        scene = make_scene({"source.rays": [61, 50]})
        kernel = twins(scene, torch.float64, (True, True))[1]
        assert kernel.mirrored == (False, True)


@pytest.mark.parametrize("dtype", [torch.float32, torch.float64])
def test_leaves_of_either_float_type_get_gradients_of_their_own(make_scene, dtype):
    scene = make_scene()
    leaf = lens(scene, 3, 0.02).to(dtype).requires_grad_()
    flux = twins(scene, torch.float32)[1].image({"lens.back": leaf}, scene.filter).flux
    (gradient,) = torch.autograd.grad(flux.square().sum(), leaf)
    assert gradient.dtype == dtype
    with torch.no_grad():
        light = twins(scene, torch.float32)[1].image({"lens.back": leaf}, GaussianFilter())
    assert not light.flux.requires_grad
