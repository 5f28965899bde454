"""Samples of the exit face against exact cases and against rays that search for the face."""

import numpy as np
import pytest
import torch

from tests.optics.gradients import check_against_differences, check_both_modes
from tests.optics.landing import places_of
from tests.optics.points import (
    DTYPES,
    GRID,
    OVAL,
    OVAL_DISTANCE,
    POINT,
    THIN_PLATE,
    behind_thin_plate,
    oval,
    smooth,
)
from workbench.analysis.validation import validate
from workbench.geometry.surface import ControlNet
from workbench.optics.cap import covering_caps
from workbench.optics.irradiance import reconstruct
from workbench.optics.path import Path
from workbench.optics.plan import Plan
from workbench.optics.reference import Reference
from workbench.optics.samples import Corners

BESIDE = POINT | {"position": [2.0, -1.3, -1.0]}
NEAR = POINT | {"position": [0.2, 0.0, -0.01]}
ALL = {"point": POINT, "grid": GRID, "beside": BESIDE, "near": NEAR}
SOURCES = pytest.mark.parametrize("source", ALL.values(), ids=ALL.keys())


def light_of(scene, heights, samples=None, dtype=torch.float64):
    """The light of a lens before it becomes an image, by samples or by rays that search."""
    path = Path.of(scene, ControlNet.of(scene.optic), dtype, samples=samples)
    return Reference(path).arrival({"exit": heights})


def image_of(arrival, scene):
    flux = arrival.rays.flux
    return reconstruct(
        arrival.column, arrival.row, flux, scene.receiver.pixels, scene.filter
    ).double()


def distance(image, other):
    return ((image - other).norm() / other.norm()).item()


@pytest.mark.parametrize("dtype", DTYPES)
def test_an_oval_of_equal_paths_brings_all_light_to_one_point(make_scene, dtype):
    scene = make_scene({"source": POINT | {"position": [0, 0, -OVAL_DISTANCE]}, **OVAL})
    net = ControlNet.of(scene.optic)
    hits = light_of(scene, oval(net), Corners(40, 50), dtype)
    arrives = (hits.rays.flux > 0).numpy()
    assert arrives.mean() > 0.8  # steep corners reflect it
    accuracy = 1e-6 if dtype == torch.float64 else 3e-5
    for place in places_of(hits, scene.receiver):
        assert place[arrives].abs().max() < accuracy


@pytest.mark.parametrize(("emission", "power"), [("uniform", 3), ("lambertian", 4)])
def test_irradiance_behind_a_thin_plate_falls_with_a_power_of_the_cosine(
    make_scene, emission, power
):
    source = POINT | {"position": [0, 0, -1.0], "emission": emission}
    scene = make_scene({"source": source, **THIN_PLATE})
    heights = torch.full(scene.optic.net_shape, 1e-6, dtype=torch.float64)
    # 50 rows and columns of samples light a pixel; its edges cut one off, or do not.
    traced = Plan(scene, samples=Corners(1001, 1003), dtype=torch.float64).trace({"exit": heights})
    expected = behind_thin_plate(scene, emission, power)
    assert traced.flux.numpy() == pytest.approx(expected, rel=0.045)
    assert traced.flux.sum().item() == pytest.approx(expected.sum(), rel=2e-3)


@pytest.mark.parametrize("emission", ["uniform", "lambertian"])
@SOURCES
def test_images_are_those_of_rays_that_search_for_the_face(make_scene, source, emission):
    grid = source["kind"] == "grid"
    rays = {"rays": 1 << (11 if grid else 15), "emission": emission}
    scene = make_scene(
        {"source": source | rays, "screen.half_width": [4, 4], "screen.pixels": [8, 8]}
    )
    heights = smooth(scene)
    searched = light_of(scene, heights)
    image = image_of(searched, scene)
    # Down to the noise of these rays; among themselves samples agree better.
    samples = light_of(scene, heights, Corners(200, 200))
    fine = image_of(samples, scene)
    coarse = image_of(light_of(scene, heights, Corners(5, 5)), scene)
    noise = 0.015 if grid else 0.008
    assert distance(fine, image) < noise < distance(coarse, image)
    finer = image_of(light_of(scene, heights, Corners(410, 390)), scene)
    assert distance(fine, finer) < 2e-3
    for name, close in (("missed_lens", 1e-3), ("fresnel_entrance", 2e-4), ("left_side", 2e-3)):
        expected = searched.lost[name].item()
        assert samples.lost[name].item() == pytest.approx(expected, abs=close)


def test_light_from_very_far_is_collimated(make_scene):
    far = make_scene({"source": POINT | {"position": [0, 0, -2e4]}})
    parallel = make_scene({"source": {"kind": "collimated", "rays": [90, 80]}})
    heights = smooth(far)
    hits, others = (light_of(scene, heights, Corners(90, 80)) for scene in (far, parallel))
    assert torch.equal(hits.rays.alive, others.rays.alive)
    found, expected = (places_of(each, far.receiver) for each in (hits, others))
    for place, other in zip(found, expected, strict=True):
        assert (place - other).abs().max() < 1e-3
    flux, parallel_flux = hits.rays.flux, others.rays.flux
    ratio = flux / flux.sum() * parallel_flux.sum() / parallel_flux
    assert (ratio - 1).abs().max() < 1e-3


def test_each_point_of_a_grid_gives_the_light_that_it_gives_alone(make_scene):
    wide = {"screen.half_width": [4, 4], "screen.pixels": [8, 8]}
    scene = make_scene({"source": GRID | {"points": [2, 2]}, **wide})
    heights = smooth(scene)
    together = Plan(scene, samples=Corners(400, 400), dtype=torch.float64).trace({"exit": heights})
    alone = [
        Plan(
            make_scene({"source": POINT | {"position": [x, y, -5.0]}, **wide}),
            samples=Corners(200, 200),
            dtype=torch.float64,
        ).trace({"exit": heights})
        for x in (-1, 1)
        for y in (-0.9, 1.1)
    ]
    # Of equal intensity: each with the flux of its own cone.
    points = scene.source.positions
    part = covering_caps(points, scene.optic.half_width, 0.0).solid_angle
    part /= part.sum()
    expected = sum(p * one.flux for p, one in zip(part, alone, strict=True))
    assert distance(together.flux, expected) < 1e-3
    for part, value in together.account.to_data().items():
        mean = np.mean([one.account.to_data()[part] for one in alone])
        assert value == pytest.approx(mean, abs=2e-4)


@SOURCES
@pytest.mark.parametrize("amplitude", [0.0, 0.02, 0.2, 3.0])
@pytest.mark.parametrize("dtype", DTYPES)
def test_the_account_adds_up_and_nothing_is_nan(make_scene, rng, source, amplitude, dtype):
    scene = make_scene({"source": source, "lens.degree": [2, 3]})
    noise = torch.as_tensor(rng.uniform(-1, 1, size=scene.optic.net_shape))
    heights = (3.0 + amplitude * noise).requires_grad_()
    for fused in (False, True):
        plan = Plan(scene, samples=Corners(60, 50), dtype=dtype, fused=fused)
        traced = plan.trace({"exit": heights})
        emitted, *where = traced.account.to_data().values()
        assert sum(where) == pytest.approx(emitted, abs=1e-9 if dtype == torch.float64 else 3e-6)
        (gradient,) = torch.autograd.grad(traced.flux.square().sum(), heights)
        assert torch.isfinite(traced.flux).all()
        assert torch.isfinite(gradient).all()


@pytest.mark.parametrize("dtype", DTYPES)
@pytest.mark.parametrize("position", [[0, 0, -1e-6], [0.999, -0.5, -1e-6], [40, 30, -0.01]])
def test_a_source_just_before_the_lens_or_far_off_the_axis(make_scene, dtype, position):
    scene = make_scene({"source": POINT | {"position": position}})
    heights = smooth(scene).requires_grad_()
    for fused in (False, True):
        traced = Plan(scene, samples=Corners(65, 64), dtype=dtype, fused=fused).trace(
            {"exit": heights}
        )
        (gradient,) = torch.autograd.grad(traced.flux.sum(), heights)
        assert torch.isfinite(gradient).all()
        account = traced.account
        assert account.lost["missed_lens"] + account.lost["fresnel_entrance"] > 0.1
        assert sum(account.to_data().values()) == pytest.approx(2, abs=3e-6)


@pytest.mark.parametrize("degree", [(3, 3), (5, 3)])
# No light near total reflection, whose onset is as steep as a root.
@pytest.mark.parametrize("position", [[0.3, -0.2, -5.0], [1.5, -1.2, -4.0], [0.2, 0.0, -1.0], None])
def test_gradient_is_that_of_central_differences(make_scene, rng, position, degree):
    scene = make_scene(
        {
            "source": POINT | {"position": position} if position else GRID,
            "lens.degree": degree,
            # All light in the pixel in the middle: hits that cross an edge would make a kink.
            "screen.half_width": [60, 60],
            "screen.pixels": [7, 7],
            "filter": {"kind": "gaussian", "size": [5, 5], "alpha": 0.3},
        }
    )
    plan = Plan(scene, samples=Corners(61, 64), dtype=torch.float64)
    heights = smooth(scene).requires_grad_()
    wanted = torch.as_tensor(rng.random((7, 7)))

    def loss(h):
        flux = plan.trace({"exit": h}).flux
        return (flux / flux.sum() - wanted / wanted.sum()).norm() / 7

    x, y = (torch.as_tensor(c) for c in ControlNet.of(scene.optic).positions)
    directions = x[:, None] + 0 * y, (1 - x[:, None] ** 2) * torch.sin(4 * y[None, :])
    check_against_differences(loss, heights, directions)


@SOURCES
def test_forward_mode_agrees_with_reverse_mode(make_scene, rng, source):
    scene = make_scene({"source": source})
    plan = Plan(scene, samples=Corners(40, 40), dtype=torch.float64)
    check_both_modes(plan, smooth(scene), rng)


THIN = {
    "lens.base": {"shape": "flat", "height": 0.01},
    "lens.height_range": [-0.003, 0.003],
    "lens.min_thickness": 0.0,
    "screen": {"z": 2.0, "half_width": [6.0, 6.0], "pixels": [16, 16]},
    "filter": {"kind": "box"},
}


@pytest.mark.parametrize("fused", [False, True], ids=["reference", "kernel"])
@pytest.mark.parametrize("source", [[0.3, -0.2, -1e-3], [0, 0, -1e-4]], ids=["aside", "middle"])
def test_samples_are_dense_before_a_source_that_is_near_a_thin_lens(make_scene, source, fused):
    """Of even samples a few saw all of the light, and the image was off by more than all of it."""
    scene = make_scene(THIN | {"source": POINT | {"position": source}})
    heights = 0.005 + 0.01 * smooth(scene)
    flux = (
        Plan(scene, samples=Corners(400, 400), fused=fused, dtype=torch.float64)
        .trace({"exit": heights})
        .flux
    )
    exact = validate(scene, np.ones((16, 16)), {"exit": heights.numpy()}, 1 << 19).irradiance
    assert distance(flux, torch.tensor(exact * scene.receiver.pixel_measure)) < 0.1


def test_half_of_the_dense_samples_see_a_mirror_image(make_scene):
    # A filter that is smooth over the edges of pixels, on one of which the middle samples arrive.
    smooth_filter = {"kind": "gaussian", "size": [3, 3], "alpha": 1.0}
    source = POINT | {"position": [0, 0, -1e-3]}
    scene = make_scene(THIN | {"source": source, "filter": smooth_filter})
    heights = torch.full(scene.optic.net_shape, 0.01, dtype=torch.float64)
    whole, quarter = (
        Plan(scene, samples=Corners(400, 400), mirrored=halved, dtype=torch.float64).trace(
            {"exit": heights}
        )
        for halved in ((False, False), (True, True))
    )
    assert distance(quarter.flux, whole.flux) < 1e-9
    assert quarter.account.to_data() == pytest.approx(whole.account.to_data(), abs=1e-9)
