"""The image of boxes of light: exact cases, its twin, its gradient, and light that folds."""

import numpy as np
import pytest
import torch
from hypothesis import given, settings
from hypothesis import strategies as st

from workbench.geometry.surface import ControlNet
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.beams import beam_image
from workbench.optics.boxes import box_image
from workbench.optics.kernels.box_cells import NARROWEST
from workbench.optics.samples import Corners, places

BOTH = pytest.mark.parametrize("fused", [True, False], ids=["kernel", "reference"])


def splits(shape):
    """Of one grid with rays in n rows of m."""
    n, m = shape
    return places(Corners(m - 1, n - 1), 0).split, places(Corners(m - 1, n - 1), 1).split


def nodes_of(column, row, flux=None):
    column, row = np.broadcast_arrays(column, row)
    if flux is None:
        n, m = column.shape
        flux = np.ones((n, m)) / ((n - 1) * (m - 1))
        flux[[0, -1]] /= 2
        flux[:, [0, -1]] /= 2
    return torch.tensor(np.stack([column, row, flux]))


def image_of(nodes, pixels, fused=True):
    return box_image(nodes, pixels, splits(nodes.shape[1:]), fused)


@pytest.fixture
def folded(rng):
    """Rays of a map with folds, of which some leave the image on each side."""
    u, v = np.meshgrid(np.linspace(0, 1, 9), np.linspace(0, 1, 7))
    column = 11 * u - 0.5 + 2.5 * np.sin(7 * v + 3 * u) + 0.8 * rng.standard_normal(u.shape)
    row = 9 * v - 0.5 + 2.0 * np.cos(6 * u) + 0.8 * rng.standard_normal(u.shape)
    return nodes_of(column, row, rng.random(u.shape))


@BOTH
@pytest.mark.parametrize("cells", [(1, 1), (2, 3), (40, 31), (300, 2)])
def test_even_light_on_a_rectangle_is_exact_in_each_pixel(fused, cells):
    column = np.linspace(1.25, 6.5, cells[0] + 1)[None, :]
    row = np.linspace(5.75, 0.5, cells[1] + 1)[:, None]
    image, landed = image_of(nodes_of(column, row), (8, 6), fused)
    wide = np.array([0, 0.75, 1, 1, 1, 1, 0.5, 0])
    high = np.array([0.5, 1, 1, 1, 1, 0.75])
    np.testing.assert_allclose(image, np.outer(high, wide) / (5.25 * 5.25), rtol=0, atol=1e-13)
    assert landed == pytest.approx(1, abs=1e-12)


@BOTH
def test_a_turned_square_is_a_box_as_wide_as_its_sides(fused):
    # They are √2 pixels long, and its corners 2 pixels apart along the axes.
    column, row = np.array([[1.0, 2.0], [0.0, 1.0]]), np.array([[0.0, 1.0], [1.0, 2.0]])
    image, _ = image_of(nodes_of(column + 0.5, row), (3, 2), fused)
    outer = (np.sqrt(2) - 1) / 2 / np.sqrt(2)
    along = [outer, 1 - 2 * outer, outer]
    np.testing.assert_allclose(image, np.outer([0.5, 0.5], along), atol=1e-15)


@BOTH
@pytest.mark.parametrize("pixels", [64, 256])
def test_a_box_has_the_middle_and_the_spread_of_its_cell(fused, pixels):
    a, b, middle = np.array([0.21, 0.08]), np.array([-0.05, 0.13]), np.array([0.48, 0.53])
    corners = [[middle + s * a / 2 + t * b / 2 for s in (-1, 1)] for t in (-1, 1)]
    column, row = np.moveaxis(np.array(corners), -1, 0) * pixels
    image = image_of(nodes_of(column, row), (pixels, pixels), fused)[0].numpy()
    place = (np.arange(pixels) + 0.5) / pixels
    for axis, light in enumerate((image.sum(0), image.sum(1))):
        mean = light @ place  # as if all light of a pixel were in its middle
        assert mean == pytest.approx(middle[axis], abs=1 / pixels**2)
        spread = (a[axis] ** 2 + b[axis] ** 2) / 12
        assert light @ (place - mean) ** 2 == pytest.approx(spread, abs=1 / pixels**2)


@BOTH
def test_light_beside_the_image_is_left_out_of_it(fused):
    column = np.linspace(-3.0, 7.0, 11)[None, :]
    row = np.linspace(-2.0, 8.0, 6)[:, None]
    image, landed = image_of(nodes_of(column, row), (4, 6), fused)
    np.testing.assert_allclose(image, np.full((6, 4), 0.01), atol=1e-15)
    assert landed == pytest.approx(1, abs=1e-14)


@BOTH
def test_light_that_folds_over_itself_adds_up(fused):
    column = np.array([0.0, 37 / 14, 1.0])[None, :]  # the middle rays are shifted to 3
    row = np.array([0.0, 1.0])[:, None]
    flux = np.array([[0.25, 0.5, 0.25]] * 2) / 2
    image, _ = image_of(nodes_of(column, row, flux), (3, 1), fused)
    np.testing.assert_allclose(image, [[0.5 / 3, 0.5 / 3 + 0.25, 0.5 / 3 + 0.25]], atol=1e-15)


@BOTH
def test_all_light_in_one_point_is_a_narrow_box_around_it(fused):
    image, landed = image_of(nodes_of(np.full((3, 3), 1.5), np.full((3, 3), 0.5)), (3, 2), fused)
    np.testing.assert_allclose(image, [[0, 1, 0], [0, 0, 0]], atol=1e-11)
    assert landed == pytest.approx(1, abs=1e-15)
    border = np.full((3, 3), 1 + NARROWEST / 4)
    image, _ = image_of(nodes_of(border, np.full((3, 3), 0.5)), (3, 2), fused)
    np.testing.assert_allclose(image, [[0.25, 0.75, 0], [0, 0, 0]], atol=1e-11)


@BOTH
def test_cells_with_a_ray_that_goes_nowhere_are_dark(fused):
    column = np.linspace(0.0, 4.0, 5)[None, :] * np.ones((3, 1))
    column[0, 0] = np.inf
    nodes = nodes_of(column, np.linspace(0.0, 2.0, 3)[:, None]).requires_grad_()
    image, landed = image_of(nodes, (4, 2), fused)
    expected = [[0, 1, 1, 1], [1, 1, 1, 1]] * np.array(0.125)
    np.testing.assert_allclose(image.detach(), expected, atol=1e-14)
    assert landed == pytest.approx(0.875, abs=1e-14)
    (gradient,) = torch.autograd.grad(image.square().sum(), [nodes])
    assert gradient.isfinite().all()


@BOTH
def test_flux_is_conserved_where_light_folds(fused, folded):
    folded[:2] += 30
    image, landed = image_of(folded, (80, 80), fused)
    assert image.sum().item() == pytest.approx(landed, abs=1e-11)
    assert landed == pytest.approx(folded[2].sum().item(), abs=1e-12)
    assert image.min() >= 0


def test_the_kernel_equals_its_twin(folded, rng):
    cotangent = torch.tensor(rng.standard_normal((8, 10)))
    found = []
    for fused in (True, False):
        nodes = folded.clone().requires_grad_()
        image, landed = image_of(nodes, (10, 8), fused)
        (gradient,) = torch.autograd.grad((image * cotangent).sum(), [nodes])
        found.append((image.detach(), gradient, landed))
    (image, gradient, landed), (twin, twins, lands) = found
    torch.testing.assert_close(image, twin, rtol=0, atol=1e-12)
    torch.testing.assert_close(gradient, twins, rtol=1e-9, atol=1e-10)
    assert landed == pytest.approx(lands, abs=1e-13)


@BOTH
@pytest.mark.parametrize("part", [0, 1, 2], ids=["columns", "rows", "flux"])
def test_the_gradient_is_that_of_the_image_even_at_folds(fused, part, folded, rng):
    cotangent = torch.tensor(rng.standard_normal((8, 10)))
    nodes = folded.clone().requires_grad_()
    (gradient,) = torch.autograd.grad(
        (image_of(nodes, (10, 8), fused)[0] * cotangent).sum(), [nodes]
    )
    way = torch.zeros_like(folded)
    way[part] = torch.tensor(rng.standard_normal(folded.shape[1:]))
    step = 1e-6
    ahead, back = (image_of(folded + s * way, (10, 8), fused)[0] for s in (step, -step))
    rise = ((ahead - back) * cotangent).sum().item() / (2 * step)
    assert (gradient * way).sum().item() == pytest.approx(rise, rel=1e-6, abs=1e-8)


@settings(max_examples=30, deadline=None)
@given(seed=st.integers(0, 10**6), spread=st.sampled_from([1e-9, 1e-3, 1.0, 50.0]))
def test_any_rays_give_light_that_adds_up(seed, spread):
    rng = np.random.default_rng(seed)
    middle = rng.uniform(0, 12, (2, 1, 1))
    column, row = middle + spread * rng.standard_normal((2, 5, 6))
    nodes = nodes_of(column, row, rng.random((5, 6))).requires_grad_()
    image, landed = image_of(nodes, (12, 12))
    assert landed == pytest.approx(nodes[2].sum().item(), rel=1e-12)
    assert image.min() >= 0
    assert image.sum().item() <= landed * (1 + 1e-9)
    (gradient,) = torch.autograd.grad(image.square().sum(), [nodes])
    assert gradient.isfinite().all()


def test_hits_infinitely_far_away_change_nothing(folded):
    far = folded.clone()
    far[0, 2, 3] = 1e30
    image, _ = image_of(far, (10, 8))
    assert image.isfinite().all()


def test_float32_loses_no_light(folded):
    image, landed = image_of(folded.float(), (10, 8))
    exact, lands = image_of(folded, (10, 8))
    assert landed == pytest.approx(lands, rel=1e-6)
    assert (image - exact).norm() < 1e-5 * exact.norm()


def test_a_bent_map_is_that_of_beams_but_for_few_parts():
    t = np.linspace(0, 1, 129)
    u, v = np.meshgrid(t, t)
    column = 32 * (u + 0.1 * np.sin(2 * np.pi * u) * np.cos(2 * np.pi * v) / 2)
    row = 32 * (v + 0.1 * np.cos(2 * np.pi * u) * np.sin(2 * np.pi * v) / 2)
    nodes = nodes_of(column, row)
    boxes, beams = (
        draw(nodes, (32, 32), splits((129, 129)))[0] for draw in (box_image, beam_image)
    )
    assert (boxes - beams).norm() < 3e-3 * beams.norm()


LED = {"kind": "area", "center": [0, 0, -1.5], "half_width": [0.3, 0.2], "emission": "lambertian"}


@pytest.fixture
def lit(make_scene):
    """A lens near an emitter, and heights that bend it."""
    changes = {"version": 2, "lens.control_points": [7, 6], "source": LED}
    screen = {"screen.z": 8.0, "screen.half_width": [8.0, 8.0], "screen.pixels": [16, 14]}
    scene = make_scene({**changes, **screen})
    along = (np.linspace(-1, 1, count) ** 2 for count in ControlNet.of(scene.lens).shape)
    return scene, torch.as_tensor(scene.lens.base.height - 0.1 * np.add.outer(*along))


def test_cells_of_many_origins_of_a_source_are_boxes(lit, rng):
    scene, curved = lit
    cotangent = torch.tensor(rng.standard_normal((14 + 2, 16 + 4)))
    found = []
    for fused in (True, False):
        heights = curved.clone().requires_grad_()
        plan = BeamPlan(scene, Corners(20, 24, 8), dtype=torch.float64, fused=fused)
        image, account = plan.trace({"exit": heights}, (2, 1))
        (gradient,) = torch.autograd.grad((image * cotangent).sum(), [heights])
        assert account.on_screen + sum(account.lost.values()) == pytest.approx(1, abs=1e-9)
        found.append((image.detach(), gradient))
    (image, gradient), (twin, twins) = found
    torch.testing.assert_close(image, twin, rtol=0, atol=1e-11)
    assert (gradient - twins).norm() < 1e-6 * twins.norm()
    tracer = plan._tracer
    nodes = tracer.nodes({"exit": curved}).hits
    boxes, _ = box_image(nodes, (16, 14), tracer.splits)
    torch.testing.assert_close(image[1:-1, 2:-2], boxes, rtol=0, atol=1e-11)


def test_the_gradient_of_heights_is_that_of_the_image(lit, rng):
    scene, curved = lit
    plan = BeamPlan(scene, Corners(20, 24, 8), dtype=torch.float64)
    cotangent = torch.tensor(rng.standard_normal((14, 16)))
    heights = curved.clone().requires_grad_()
    image = plan.trace({"exit": heights}).flux
    (gradient,) = torch.autograd.grad((image * cotangent).sum(), [heights])
    way, step = torch.tensor(rng.standard_normal(curved.shape)), 1e-6
    ahead, back = (plan.trace({"exit": curved + s * way}).flux for s in (step, -step))
    rise = ((ahead - back) * cotangent).sum().item() / (2 * step)
    assert (gradient * way).sum().item() == pytest.approx(rise, rel=1e-5)


@pytest.mark.parametrize("mirrored", [(True, False), (False, True), (True, True)])
def test_a_part_of_the_origins_makes_all_of_a_mirrored_image(lit, mirrored):
    scene, curved = lit
    part, whole = (
        BeamPlan(scene, Corners(20, 24, 8), dtype=torch.float64, mirrored=promise).trace(
            {"exit": curved}
        )
        for promise in (mirrored, (False, False))
    )
    torch.testing.assert_close(part.flux, whole.flux, rtol=0, atol=1e-12)
    assert part.account.to_data() == pytest.approx(whole.account.to_data(), abs=1e-10)


def test_boxes_of_few_origins_are_as_near_to_many_as_beams_are(lit):
    scene, curved = lit
    plans = [BeamPlan(scene, Corners(40, 40, count)) for count in (16, 256)]
    few, many = (plan.trace({"exit": curved}).flux for plan in plans)
    tracer = plans[0]._tracer
    beams, _ = beam_image(tracer.nodes({"exit": curved}).hits, (16, 14), tracer.splits)
    assert (few - many).norm() < 1.02 * (beams - many).norm()
