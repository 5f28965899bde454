"""Taps, scatter and gather against the torch reference and against each other."""

import numpy as np
import pytest
import torch
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.optics.landing import image_at
from workbench.optics.images import _taps
from workbench.optics.kernels.spread import (
    BATCH,
    add_up,
    gather,
    make_canvases,
    make_spread,
    pad,
    scatter,
    workspace,
)
from workbench.optics.kernels.taps import fill_taps, make_taps
from workbench.scene import BoxFilter, GaussianFilter, Screen

SCREEN = Screen(position=(0.0, 0.0, 5.0), half_width=(3.0, 2.0), pixels=(12, 8))
PER_X, PER_Y = 12 / 6, -8 / 4
KINDS = [np.float32, np.float64]
FILTERS = [
    BoxFilter(),
    GaussianFilter(size=(1, 1)),
    GaussianFilter(size=(3, 3)),
    GaussianFilter(size=(1, 5)),
    GaussianFilter(size=(11, 5), alpha=0.2),
    GaussianFilter(size=(3, 3), alpha=16.0),
    GaussianFilter(size=(3, 7), alpha=1e6),
    GaussianFilter(size=(3, 3), alpha=1e-6),
]


def found_taps(alpha, size, kind):
    """Offsets, all taps and all slopes at them."""
    offset = np.linspace(-0.5, 0.5, BATCH, endpoint=False).astype(kind)
    # Offsets, four batches of intermediate results, taps, slopes.
    numbers = np.full((5 + 2 * size) * BATCH, np.nan, kind)
    numbers[:BATCH] = offset
    batch, state, value, slope = (np.uintp(BATCH * k) for k in (1, 1, 5, 5 + size))
    taps = make_taps(alpha, size, kind)
    fill_taps(taps, numbers, batch, np.uintp(0), batch, True, state, value, slope)
    value, slope = numbers[5 * BATCH :].reshape(2, size, BATCH)
    return offset, value, slope


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize(
    ("alpha", "size"),
    [(alpha, size) for alpha in (1e-6, 1.0, 16.0, 1e3, 1e6) for size in (3, 5)]
    + [(1e-4, 99), (300.0, 21)],
)
def test_taps_and_slopes_are_those_of_the_filter(alpha, size, kind):
    offset, value, slope = found_taps(alpha, size, kind)
    at = torch.tensor(offset, dtype=torch.float64, requires_grad=True)
    exact = _taps(at, GaussianFilter(size=(size, size), alpha=alpha), axis=0)
    slopes = [torch.autograd.grad(tap.sum(), at, retain_graph=True)[0].numpy() for tap in exact]
    eps = float(np.finfo(kind).eps)
    # An exponential of a large number has its relative rounding, and α is a large number.
    slack = eps * max(16, 4 * alpha)
    steepest = max(1, np.abs(slopes).max())
    assert value == pytest.approx(np.stack([tap.detach() for tap in exact]), abs=slack)
    assert slope == pytest.approx(np.stack(slopes), abs=slack * steepest)


@pytest.mark.parametrize("kind", KINDS)
@settings(max_examples=40)
@given(alpha=st.floats(1e-6, 1e6), size=st.sampled_from([1, 3, 5, 7, 21, 99]))
def test_taps_share_the_light_out_and_none_is_negative(kind, alpha, size):
    _, value, slope = found_taps(alpha, size, kind)
    eps = float(np.finfo(kind).eps)
    assert (value >= 0).all()
    assert value.sum(axis=0, dtype=np.float64) == pytest.approx(1, abs=eps * size)
    assert slope.sum(axis=0, dtype=np.float64) == pytest.approx(0, abs=eps * size * (1 + 2 * alpha))


def hits(rng, kind, count=BATCH):
    """Rays on and beside the screen, and some that go nowhere."""
    x, y = rng.normal(0, 2.5, (2, count)).astype(kind)
    x[:4] = np.inf, -np.inf, np.nan, 1e30
    y[4:8] = np.inf, -np.inf, np.nan, -1e30
    weight = rng.random(count).astype(kind)
    return x, y, weight


def in_pixels(x, y):
    kind = x.dtype.type
    return kind(6) + kind(PER_X) * x, kind(4) + kind(PER_Y) * y


def spread_out(spread, x, y, weight):
    column, row = in_pixels(x, y)
    canvases = make_canvases(spread, 1)
    work = workspace(spread, weight)
    landing = scatter(spread, column, row, weight, len(x), work, canvases[0])
    return add_up(spread, canvases), landing


def pull_back(spread, x, y, weight, cotangent):
    column, row = in_pixels(x, y)
    d_column, d_row, d_weight = np.full((3, BATCH), np.nan, weight.dtype)
    work = workspace(spread, weight)
    canvas = pad(spread, cotangent)
    gather(spread, column, row, weight, len(x), work, canvas, d_column, d_row, d_weight)
    return d_column * x.dtype.type(PER_X), d_row * x.dtype.type(PER_Y), d_weight


@pytest.mark.parametrize("filter", FILTERS, ids=str)
@pytest.mark.parametrize("kind", KINDS)
def test_the_image_is_that_of_the_reference(filter, kind, rng):
    x, y, weight = hits(rng, kind)
    image, (on_screen, beside) = spread_out(make_spread(SCREEN.pixels, filter, kind), x, y, weight)
    exact = image_at(*(torch.tensor(c) for c in (x, y, weight)), SCREEN, filter)
    eps = float(np.finfo(kind).eps)
    steepness = filter.alpha if isinstance(filter, GaussianFilter) and filter.size != (1, 1) else 1
    # A step moves with the rounding of the hit.
    slack = 100 * eps * max(1, steepness)
    assert image.dtype == kind
    assert image == pytest.approx(exact.numpy(), abs=slack)
    lands = (abs(x) < 3) & (abs(y) < 2)
    assert on_screen == pytest.approx(weight[lands].sum(), rel=100 * eps)
    assert beside == pytest.approx(weight[~lands].sum(), rel=100 * eps)


@pytest.mark.parametrize("filter", FILTERS[2:6] + FILTERS[7:], ids=str)
@pytest.mark.parametrize("kind", KINDS)
def test_cotangents_are_those_of_the_reference(filter, kind, rng):
    x, y, weight = hits(rng, kind)
    cotangent = rng.normal(size=(8, 12)).astype(kind)
    leaves = [torch.tensor(c, requires_grad=True) for c in (x, y, weight)]
    flux = image_at(*leaves, SCREEN, filter)
    exact = torch.autograd.grad(
        (flux * torch.tensor(cotangent)).sum(), leaves, materialize_grads=True, allow_unused=True
    )
    found = pull_back(make_spread(SCREEN.pixels, filter, kind), x, y, weight, cotangent)
    eps = float(np.finfo(kind).eps)
    for mine, theirs in zip(found, exact, strict=True):
        scale = theirs.abs().max().item()
        assert mine == pytest.approx(theirs.numpy(), abs=2000 * eps * max(1, scale))
    for mine in found:
        assert not mine[:8].any()


@pytest.mark.parametrize("kind", KINDS)
def test_a_box_has_no_slope(kind, rng):
    x, y, weight = hits(rng, kind)
    cotangent = rng.normal(size=(8, 12)).astype(kind)
    d_x, d_y, d_weight = pull_back(
        make_spread(SCREEN.pixels, BoxFilter(), kind), x, y, weight, cotangent
    )
    assert not d_x.any()
    assert not d_y.any()
    image, _ = spread_out(make_spread(SCREEN.pixels, BoxFilter(), kind), x, y, weight)
    # Linear in the weights: the image meets a cotangent as the weights meet its adjoint.
    assert (image * cotangent).sum() == pytest.approx(
        (weight * d_weight).sum(), rel=1e4 * float(np.finfo(kind).eps)
    )


@settings(max_examples=60)
@given(
    size=st.tuples(*[st.sampled_from([1, 3, 5, 9])] * 2),
    alpha=st.floats(1e-3, 5),
    x=st.floats(-5, 5),
    y=st.floats(-4, 4),
)
def test_one_ray_anywhere_through_any_filter(size, alpha, x, y):
    filter = GaussianFilter(size=size, alpha=alpha)
    one = np.ones(1)
    image, landing = spread_out(
        make_spread(SCREEN.pixels, filter, np.float64),
        np.array([x]),
        np.array([y]),
        one,
    )
    exact = image_at(*(torch.tensor([c], dtype=torch.float64) for c in (x, y, 1)), SCREEN, filter)
    column, row = SCREEN.to_pixels(x, y)
    on_edge = min(abs(column - round(column)), abs(row - round(row))) < 1e-12
    if not on_edge or 1 not in size:  # a box along an axis makes the image jump there
        assert image == pytest.approx(exact.numpy(), abs=1e-12)
    if not on_edge:
        lands = abs(x) < 3 and abs(y) < 2
        assert landing == (lands, not lands)
