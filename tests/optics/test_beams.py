"""The image of beams of light: exact cases, lenses, grids of points, and mirror symmetry."""

import numpy as np
import pytest
import torch

from tests.optics.cells_of_light import nodes_of, splits
from workbench.geometry.surface import ControlNet
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.images.beams import beam_image
from workbench.optics.plan import Plan
from workbench.optics.samples import Corners
from workbench.scene import BoxFilter


def image_of(nodes, pixels, fused=True):
    image, landed = beam_image(nodes, pixels, splits(nodes.shape[1:]), fused)
    return image, landed


BOTH = pytest.mark.parametrize("fused", [True, False], ids=["kernel", "reference"])


@BOTH
def test_a_turned_square_is_exact_in_each_pixel(fused):
    # Its corners are in the middles of the sides of an image of 2 × 2 pixels.
    column, row = np.array([[1.0, 2.0], [0.0, 1.0]]), np.array([[0.0, 1.0], [1.0, 2.0]])
    image, _ = image_of(nodes_of(column, row), (2, 2), fused)
    np.testing.assert_allclose(image, np.full((2, 2), 0.25), atol=1e-15)


def tracers(scene, cells=(36, 28), **options):
    return [BeamPlan(scene, cells, fused=fused, **options) for fused in (True, False)]


SOURCES = {
    "collimated": {"kind": "collimated", "rays": [32, 32]},
    "point": {"kind": "point", "position": [0.1, -0.2, -4.0], "rays": 1000},
    "lambertian": {
        "kind": "point",
        "position": [0, 0, -2.0],
        "rays": 1000,
        "emission": "lambertian",
    },
    "grid": {
        "kind": "grid",
        "center": [0.1, 0, -4.0],
        "half_width": [0.2, 0.1],
        "points": [3, 2],
        "rays": 100,
    },
}


OUTLINES = {
    "collimated": "ellipse",
    "point": "rectangle",
    "lambertian": "ellipse",
    "grid": "rectangle",
}


@pytest.fixture(params=OUTLINES.items(), ids="-".join)
def lit(request, make_scene):
    source, outline = request.param
    return make_scene(
        {
            "lens.outline": outline,
            "source": SOURCES[source],
            "screen.pixels": [20, 16],
            "lens.control_points": [9, 8],
        }
    )


@pytest.fixture
def wavy(lit, rng):
    flat = lit.optic.base.height + 0.01 * rng.standard_normal(ControlNet.of(lit.optic).shape)
    return torch.tensor(flat)


def test_beams_and_many_rays_give_the_same_image(lit, wavy):
    image, account = BeamPlan(lit, (400, 400), dtype=torch.float64).trace({"lens.back": wavy})
    rays, others = Plan(lit, filter=BoxFilter(), samples=Corners(2400, 2400)).trace(
        {"lens.back": wavy}
    )
    assert (image - rays).norm() < 0.01 * rays.norm()
    assert account.on_screen == pytest.approx(others.on_screen, abs=1e-4)


MIRRORED = pytest.mark.parametrize("mirrored", [(True, False), (False, True), (True, True)])


def symmetric(values, mirrored):
    """Mean of values (along x first) and their mirror images."""
    for axis in (0, 1):
        if mirrored[axis]:
            values = (values + values.flip(axis)) / 2
    return values


@MIRRORED
@pytest.mark.parametrize(
    ("kind", "outline"),
    [("collimated", "rectangle"), ("point", "rectangle"), ("collimated", "ellipse")],
)
@pytest.mark.parametrize("steep", [0.01, 0.1], ids=["wavy", "with total reflection"])
def test_a_part_of_a_mirrored_lens_gives_the_whole_image(
    make_scene, rng, kind, outline, steep, mirrored
):
    source = SOURCES[kind] | ({} if kind == "collimated" else {"position": [0, 0, -4.0]})
    scene = make_scene(
        {
            "source": source,
            "lens.outline": outline,
            "screen.pixels": [20, 16],
            "lens.control_points": [9, 8],
        }
    )
    wavy = scene.optic.base.height + steep * rng.standard_normal(ControlNet.of(scene.optic).shape)
    wavy = symmetric(torch.tensor(wavy), mirrored)
    cotangent = torch.tensor(rng.standard_normal((16 + 2 * 3, 20 + 2 * 4)))
    found = []
    for promise in (mirrored, (False, False)):
        plan = BeamPlan(scene, (36, 28), dtype=torch.float64, mirrored=promise)
        heights = wavy.clone().requires_grad_()
        image, account = plan.trace({"lens.back": heights}, (4, 3))
        (gradient,) = torch.autograd.grad((image * cotangent).sum(), [heights])
        found.append((image.detach(), gradient, account.to_data()))
    (image, gradient, account), (whole, gradients, accounts) = found
    torch.testing.assert_close(image, whole, rtol=0, atol=1e-13)
    expected = symmetric(gradients, mirrored)
    torch.testing.assert_close(gradient, expected, rtol=1e-7, atol=1e-8 * expected.abs().max())
    assert account == pytest.approx(accounts, abs=1e-12)


def test_totally_reflected_light_is_in_the_account(make_scene):
    scene = make_scene({"lens.control_points": [8, 8], "lens.height_range": [-2.0, 2.0]})
    # A roof whose left half is far steeper than total reflection allows.
    ramp = np.linspace(0, 1, 8)
    heights = torch.tensor(
        scene.optic.base.height + np.maximum(0.4 - ramp, 0)[:, None] * np.ones(8) * 5
    )
    for plan in tracers(scene):
        _, account = plan.trace({"lens.back": heights})
        assert 0.2 < account.lost["total_reflection"] < 0.6
        assert account.on_screen + sum(account.lost.values()) == pytest.approx(1, abs=1e-6)
