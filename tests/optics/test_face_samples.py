"""Samples of the exit face against exact cases and against rays that search for the face."""

import pytest
import torch

from tests.optics.gradients import check_against_differences
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
from workbench.geometry.surface import ControlNet
from workbench.optics.images import reconstruct
from workbench.optics.path import Path
from workbench.optics.plan import Plan
from workbench.optics.reference import Reference
from workbench.optics.samples import Corners

BESIDE = POINT | {"position": [2.0, -1.3, -1.0]}
NEAR = POINT | {"position": [0.2, 0.0, -0.01]}
ALL = {"point": POINT, "grid": GRID, "beside": BESIDE, "near": NEAR}


def light_of(scene, heights, samples=None, dtype=torch.float64):
    """The light of a lens before it becomes an image, by samples or by rays that search."""
    path = Path.of(scene, ControlNet.of(scene.optic), dtype, samples=samples)
    return Reference(path).arrival({"lens.back": heights})


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
    traced = Plan(scene, samples=Corners(1001, 1003), dtype=torch.float64).trace(
        {"lens.back": heights}
    )
    expected = behind_thin_plate(scene, emission, power)
    assert traced.flux.numpy() == pytest.approx(expected, rel=0.045)
    assert traced.flux.sum().item() == pytest.approx(expected.sum(), rel=2e-3)


@pytest.mark.parametrize(
    ("source", "emission"),
    [(POINT, "uniform"), *((each, "lambertian") for each in ALL.values())],
    ids=["uniform", *ALL],
)
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
        flux = plan.trace({"lens.back": h}).flux
        return (flux / flux.sum() - wanted / wanted.sum()).norm() / 7

    x, y = (torch.as_tensor(c) for c in ControlNet.of(scene.optic).positions)
    directions = x[:, None] + 0 * y, (1 - x[:, None] ** 2) * torch.sin(4 * y[None, :])
    check_against_differences(loss, heights, directions)
