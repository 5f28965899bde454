"""Images of cells of light, drawn as beams or as boxes: what holds for both."""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import pytest
import torch
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.optics.cells_of_light import nodes_of, splits
from workbench.optics import ready
from workbench.optics.images.beams import beam_image, box_image


class Kind(NamedTuple):
    """How cells are drawn, and how far rounding moves light."""

    draw: Callable[..., Any]
    rounding: float


KINDS = pytest.mark.parametrize(
    "kind", [Kind(beam_image, 1e-13), Kind(box_image, 1e-12)], ids=["beams", "boxes"]
)
BOTH = pytest.mark.parametrize("fused", [True, False], ids=["kernel", "reference"])


def image_of(kind, nodes, pixels, fused=True):
    return kind.draw(nodes, pixels, splits(nodes.shape[1:]), fused)


@pytest.fixture(autouse=True, scope="module")
def kernels():
    """A kernel that cannot be compiled gives way to the reference, which would equal itself."""
    for name in ("beams", "boxes"):
        for dtype in (torch.float32, torch.float64):
            assert ready.obtain(name, dtype), ready.failure(name, dtype)


@pytest.fixture
def folded(rng):
    """Rays of a map with folds, of which some leave the image on each side."""
    u, v = np.meshgrid(np.linspace(0, 1, 9), np.linspace(0, 1, 7))
    column = 11 * u - 0.5 + 2.5 * np.sin(7 * v + 3 * u) + 0.8 * rng.standard_normal(u.shape)
    row = 9 * v - 0.5 + 2.0 * np.cos(6 * u) + 0.8 * rng.standard_normal(u.shape)
    return nodes_of(column, row, rng.random(u.shape))


@KINDS
@BOTH
@pytest.mark.parametrize("cells", [(1, 1), (2, 3), (40, 31), (300, 2)])
def test_even_light_on_a_rectangle_is_exact_in_each_pixel(kind, fused, cells):
    column = np.linspace(1.25, 6.5, cells[0] + 1)[None, :]
    row = np.linspace(5.75, 0.5, cells[1] + 1)[:, None]
    image, landed = image_of(kind, nodes_of(column, row), (8, 6), fused)
    wide = np.array([0, 0.75, 1, 1, 1, 1, 0.5, 0])
    high = np.array([0.5, 1, 1, 1, 1, 0.75])
    np.testing.assert_allclose(image, np.outer(high, wide) / (5.25 * 5.25), rtol=0, atol=1e-13)
    assert landed == pytest.approx(1, abs=1e-12)


@KINDS
@BOTH
def test_light_that_folds_over_itself_adds_up(kind, fused):
    column = np.array([0.0, 37 / 14, 1.0])[None, :]  # the middle rays are shifted to 3
    row = np.array([0.0, 1.0])[:, None]
    flux = np.array([[0.25, 0.5, 0.25]] * 2) / 2
    image, _ = image_of(kind, nodes_of(column, row, flux), (3, 1), fused)
    np.testing.assert_allclose(image, [[0.5 / 3, 0.5 / 3 + 0.25, 0.5 / 3 + 0.25]], atol=1e-15)


@pytest.fixture
def fine(rng):
    """Rays of many cells a pixel that do not fold, some of which are lost."""
    u, v = np.meshgrid(np.linspace(0, 1, 61), np.linspace(0, 1, 54))
    column = 11 * u - 0.5 + 0.4 * np.sin(7 * v + 3 * u)
    row = 9 * v - 0.5 + 0.3 * np.cos(6 * u)
    nodes = nodes_of(column, row, rng.random(u.shape) / u.size)
    nodes[:2, rng.random(u.shape) < 0.02] = np.inf
    return nodes


@KINDS
@pytest.mark.parametrize("rays", ["folded", "fine"])
def test_the_kernel_equals_its_twin(kind, rays, rng, request):
    given = request.getfixturevalue(rays)
    cotangent = torch.tensor(rng.standard_normal((8, 10)))
    found = []
    for fused in (True, False):
        nodes = given.clone().requires_grad_()
        image, landed = image_of(kind, nodes, (10, 8), fused)
        (gradient,) = torch.autograd.grad((image * cotangent).sum(), [nodes])
        found.append((image.detach(), gradient, landed))
    (image, gradient, landed), (twin, twins, lands) = found
    torch.testing.assert_close(image, twin, rtol=0, atol=kind.rounding)
    torch.testing.assert_close(gradient, twins, rtol=1e-9, atol=1e-10)
    assert landed == pytest.approx(lands, abs=1e-13)


@KINDS
@BOTH
@pytest.mark.parametrize("part", [0, 1, 2], ids=["columns", "rows", "flux"])
@pytest.mark.parametrize("rays", ["folded", "fine"])
def test_the_gradient_is_that_of_the_image_even_at_folds(kind, fused, part, rays, rng, request):
    given = request.getfixturevalue(rays)
    cotangent = torch.tensor(rng.standard_normal((8, 10)))
    nodes = given.clone().requires_grad_()
    (gradient,) = torch.autograd.grad(
        (image_of(kind, nodes, (10, 8), fused)[0] * cotangent).sum(), [nodes]
    )
    way = torch.zeros_like(given)
    way[part] = torch.tensor(rng.standard_normal(given.shape[1:]))
    step = 1e-6
    ahead, back = (image_of(kind, given + s * way, (10, 8), fused)[0] for s in (step, -step))
    rise = ((ahead - back) * cotangent).sum().item() / (2 * step)
    assert (gradient * way).sum().item() == pytest.approx(rise, rel=1e-6, abs=1e-8)


@KINDS
@settings(max_examples=30, deadline=None)
@given(seed=st.integers(0, 10**6), spread=st.sampled_from([1e-9, 1e-3, 1.0, 50.0]))
def test_any_rays_give_light_that_adds_up(kind, seed, spread):
    rng = np.random.default_rng(seed)
    middle = rng.uniform(0, 12, (2, 1, 1))
    column, row = middle + spread * rng.standard_normal((2, 5, 6))
    nodes = nodes_of(column, row, rng.random((5, 6))).requires_grad_()
    image, landed = image_of(kind, nodes, (12, 12))
    assert landed == pytest.approx(nodes[2].sum().item(), rel=1e-12)
    assert image.min() >= 0
    assert image.sum().item() <= landed * (1 + 1e-9)
    (gradient,) = torch.autograd.grad(image.square().sum(), [nodes])
    assert gradient.isfinite().all()
