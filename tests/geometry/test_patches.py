"""One polynomial per knot span, against the basis functions and scipy."""

import numpy as np
import pytest
import torch
from scipy.interpolate import NdBSpline

from workbench.geometry.patches import Patches
from workbench.geometry.surface import ControlNet

DEGREES = [(1, 1), (1, 4), (2, 7), (3, 3), (4, 2), (5, 3), (6, 6), (7, 1), (7, 7)]


def nets(degree):
    """The smallest net of these degrees, and a larger one."""
    (p, q) = degree
    return [
        ControlNet((p + 1, q + 1), degree, (1.0, 1.0)),
        ControlNet((p + 9, q + 14), degree, (2.0, 0.3)),
    ]


@pytest.mark.parametrize("degree", DEGREES)
def test_points_agree_with_basis_functions_and_scipy(degree, rng):
    for net in nets(degree):
        heights = rng.normal(size=net.shape)
        u, v = np.concatenate([rng.random((2, 500)), [[0, 1, 1, 0, 1], [0, 1, 0, 1, 0.3]]], axis=1)
        x, y = ((2 * t - 1) * r for t, r in zip((u, v), net.half_width, strict=True))
        patches = Patches(net, torch.float64)
        table = patches.table(torch.as_tensor(heights))
        place = patches.place(torch.as_tensor(x), torch.as_tensor(y))
        ours = patches.evaluate(table, place)
        assert torch.equal(ours[0], patches.height(table, place))

        spline = NdBSpline(net.knots, heights, net.degree)
        for order, found, basis in zip(
            [(0, 0), (1, 0), (0, 1)], ours, net.points(u, v).evaluate(heights), strict=True
        ):
            theirs = spline(np.stack([u, v], axis=-1), nu=order)
            theirs /= (2 * net.half_width[0]) ** order[0] * (2 * net.half_width[1]) ** order[1]
            scale = max(1, np.abs(theirs).max())
            if degree[0] == 1 or degree[1] == 1:  # slopes jump at knots: one side is as good
                clear = np.abs((u * 9) % 1 - 0.5) < 0.499
            else:
                clear = np.ones(len(u), dtype=bool)
            assert np.abs(found.numpy() - theirs)[clear].max() <= 1e-12 * scale
            assert np.abs(found.numpy() - basis)[clear].max() <= 1e-12 * scale


@pytest.mark.parametrize("degree", DEGREES)
def test_no_slope_or_curvature_is_beyond_its_bound(degree, rng):
    for net in nets(degree):
        heights = rng.normal(size=net.shape)
        patches = Patches(net, torch.float64)
        slopes = patches.slope_bounds(torch.as_tensor(heights))
        curvatures = patches.curvature_bounds(torch.as_tensor(heights))
        places = rng.random((4000, 2))
        spline = NdBSpline(net.knots, heights, net.degree)
        orders = [(1, 0), (0, 1), (2, 0), (1, 1), (0, 2)]
        for order, bound in zip(orders, (*slopes, *curvatures), strict=True):
            if order[0] > degree[0] or order[1] > degree[1]:
                continue
            width = np.prod((2 * np.array(net.half_width)) ** order)
            most = np.abs(spline(places, nu=order)).max() / width
            assert most <= bound * (1 + 1e-12)
            # A rough net comes near its bounds where neighbours matter: they are not idle.
            if np.isfinite(bound) and max(degree) <= 3:
                assert most > 0.02 * bound


def test_heights_and_places_are_differentiable(rng):
    net = ControlNet((6, 7), (2, 3), (1.0, 0.5))
    patches = Patches(net, torch.float64)
    heights = torch.as_tensor(rng.normal(size=net.shape)).requires_grad_()
    x = torch.as_tensor(rng.uniform(-0.9, 0.9, 5)).requires_grad_()
    y = torch.as_tensor(rng.uniform(-0.4, 0.4, 5)).requires_grad_()

    def surface(h, x, y):
        return patches.evaluate(patches.table(h), patches.place(x, y))

    assert torch.autograd.gradcheck(surface, (heights, x, y))
