"""The image of beams of light: exact cases, lenses, grids of points, and mirror symmetry."""

import numpy as np
import pytest
import torch

from tests.optics.cells_of_light import exact_image, nodes_of, splits, triangles, unshifted
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


def narrowest(nodes, parts):
    """Least area of a triangle."""
    sides = (corners[1:] - corners[0] for corners, _ in triangles(nodes, parts))
    return min(abs(np.linalg.det(pair)) / 2 for pair in sides)


@BOTH
@pytest.mark.parametrize("fold", [0.02, 0.3, 1.5])
def test_nodes_on_borders_of_pixels_are_drawn_exactly(fold, fused, rng):
    parts, pixels, drawn = unshifted((6, 5)), (8, 7), 0
    while drawn < 10:
        u, v = np.meshgrid(np.linspace(0, 1, 5), np.linspace(0, 1, 6))
        places = np.stack([9 * u, 8 * v]) * rng.uniform(0.3, 1) - 0.5
        places += fold * rng.standard_normal(places.shape)
        places = np.where(rng.random(places.shape) < 0.5, places.round(), places)
        nodes = nodes_of(*places, rng.random(u.shape)).float()
        if narrowest(nodes, parts) < 1e-3:
            continue  # triangles along a border are in either pixel
        drawn += 1
        image, _ = beam_image(nodes, pixels, parts, fused)
        expected = exact_image(nodes.double(), pixels, parts)
        np.testing.assert_allclose(image, expected, rtol=1e-6, atol=1e-6)
        image, _ = beam_image(nodes.double(), pixels, parts, fused)
        np.testing.assert_allclose(image, expected, rtol=0, atol=1e-13)
        for aside in (-1e-11, 1e-11):
            moved, _ = beam_image(nodes.double() + aside, pixels, parts, fused)
            np.testing.assert_allclose(moved, image, rtol=0, atol=1e-9)


@BOTH
@pytest.mark.parametrize("width", [0.0, 1e-9, 5e-6, 3e-5])
def test_triangles_of_nearly_no_width_are_drawn_along_their_length(width, fused, rng):
    parts, pixels = unshifted((5, 6)), (8, 7)
    along = rng.uniform(-1, 9, (5, 6))
    nodes = nodes_of(along, 0.37 + 0.71 * along + width * rng.standard_normal(along.shape))
    expected = exact_image(nodes, pixels, parts)
    weights = torch.tensor(rng.standard_normal(expected.shape))
    way = (
        torch.tensor(rng.standard_normal(nodes.shape))
        * torch.tensor([1.0, 1.0, 0.1])[:, None, None]
    )
    leaf = nodes.clone().requires_grad_()
    image, _ = beam_image(leaf, pixels, parts, fused)
    (gradient,) = torch.autograd.grad((image * weights).sum(), [leaf])
    np.testing.assert_allclose(image.detach(), expected, rtol=0, atol=1e-9)
    step = 1e-5
    ahead, behind = (exact_image(nodes + s * way, pixels, parts) for s in (step, -step))
    rise = ((ahead - behind) * weights.numpy()).sum() / (2 * step)
    assert (gradient * way).sum().item() == pytest.approx(rise, rel=1e-4)


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


def any_lens(make_scene, seed):
    """A random lens: with folds or creases, light beside the screen, or focused on a line."""
    rng = np.random.default_rng(seed)
    degree, wide = [int(rng.choice([1, 3])) for _ in range(2)], rng.uniform(0.4, 1.5)
    scene = make_scene(
        {
            "lens.degree": degree,
            "lens.control_points": [11, 10],
            "lens.height_range": None,
            "screen.pixels": [20, 16],
            "screen.half_width": [wide, wide],
        }
    )
    net = ControlNet.of(scene.optic)
    u, v = (np.linspace(-1, 1, count) for count in net.shape)
    to_line = rng.choice([0.0, 0.2]) * (np.cos(seed) * u[:, None] + np.sin(seed) * v) ** 2
    rough = 10 ** rng.uniform(-4, -1.7) * rng.standard_normal(net.shape)
    return scene, torch.tensor(scene.optic.base.height - to_line + rough)


@pytest.mark.parametrize(
    "seeds", [[16, 31], pytest.param(range(50), marks=pytest.mark.slow)], ids=["some", "many"]
)
def test_images_of_random_lenses(seeds, make_scene):
    threads = torch.get_num_threads()
    for seed in seeds:
        scene, heights = any_lens(make_scene, seed)
        rng = np.random.default_rng(seed)
        weights = torch.tensor(rng.standard_normal((16, 20)))
        way = torch.tensor(rng.standard_normal(heights.shape))
        # No ray passes a crease: it could be on either side.
        plan, reference = (
            BeamPlan(scene, (181, 149), dtype=torch.float64, fused=fused) for fused in (True, False)
        )

        def seen(plan, heights=heights, weights=weights):
            leaf = heights.clone().requires_grad_()
            image = plan.trace({"lens.back": leaf}).flux
            (gradient,) = torch.autograd.grad((image * weights).sum(), [leaf])
            return image.detach(), gradient

        try:
            torch.set_num_threads(1)
            image, gradient = seen(plan)
            for number in (2, 3, 7):
                torch.set_num_threads(number)
                assert all(map(torch.equal, seen(plan), (image, gradient)))
        finally:
            torch.set_num_threads(threads)
        twin, twins = seen(reference)
        assert (image - twin).norm() < 1e-10 * twin.norm()
        assert (gradient - twins).norm() < 1e-8 * twins.norm()
        step = 1e-8
        ahead, behind = (seen(plan, heights + s * way)[0] for s in (step, -step))
        rise = ((ahead - behind) * weights).sum().item() / (2 * step)
        slope = (gradient * way).sum().item()
        # Within 2e-7 but for a focus, with triangles as small as slivers are narrow.
        assert slope == pytest.approx(rise, abs=2e-5 * gradient.norm().item()), seed
