"""Where rays meet the exit face, against bisection on scipy's spline; hard cases."""

import numpy as np
import pytest
import torch
from scipy.interpolate import NdBSpline

from workbench.geometry.patches import Patches
from workbench.geometry.surface import ControlNet
from workbench.optics.surfaces.intersection import RIM, Bundle, ExactIntersection

DTYPES = [torch.float32, torch.float64]
RAYS = 4_000


def rays(rng, count, half_width, slope):
    """Rays from all over the entrance face, up to ``slope`` oblique."""
    r_x, r_y = half_width
    return (
        rng.uniform(-r_x, r_x, count),
        rng.uniform(-r_y, r_y, count),
        rng.uniform(-slope, slope, count),
        rng.uniform(-slope, slope, count),
    )


def meet(net, heights, bundle, dtype=torch.float64, before=()):
    """Depths and flags of the rays, after other lenses were searched ``before``."""
    tensors = [torch.as_tensor(part, dtype=dtype) for part in bundle]
    patches = Patches(net, dtype)
    search = ExactIntersection(
        Bundle(*tensors, flux=torch.ones_like(tensors[0])), net.half_width, patches
    )
    for lens in (*before, heights):
        control = torch.as_tensor(lens, dtype=dtype)
        met = search.meet(control, patches.table(control))
    return met.depth.numpy().astype(float), met.found.numpy()


class Reference:
    """f along rays on scipy's spline up to `RIM`, where it goes on as the same polynomials."""

    def __init__(self, net, heights, bundle):
        knots = [(2 * t - 1) * r for t, r in zip(net.knots, net.half_width, strict=True)]
        self._spline = NdBSpline(tuple(knots), np.asarray(heights, float), net.degree)
        self.start = np.stack(bundle[:2], axis=-1)
        self.slope = np.stack(bundle[2:], axis=-1)
        ends = np.array(net.half_width) * RIM - self.start * np.sign(self.slope)
        with np.errstate(divide="ignore"):
            self.side = (ends / np.abs(self.slope)).min(axis=1)
        self.low = np.minimum(heights.min(), self.side)
        self.high = np.minimum(heights.max(), self.side)

    def f(self, depth, rays=slice(None)):
        place = self.start[rays] + self.slope[rays] * depth[:, None]
        return self._spline(place) - depth

    def bisect(self, low, high, rays=slice(None)):
        for _ in range(56):
            middle = (low + high) / 2
            above = self.f(middle, rays) > 0
            low, high = np.where(above, middle, low), np.where(above, high, middle)
        return (low + high) / 2

    def first_roots(self, count):
        """First change of sign among ``count`` equal steps, and where there is one."""
        found = np.zeros(len(self.start), dtype=bool)
        low, high = self.low.copy(), self.high.copy()
        before = self.low
        for step in np.linspace(0, 1, count + 1)[1:]:
            here = self.low + step * (self.high - self.low)
            new = ~found & (self.f(here) <= 0)
            low, high = np.where(new, before, low), np.where(new, here, high)
            found |= new
            before = here
        found &= self.side > self.low
        return self.bisect(low, high), found


def surface(kind, net, rng):
    x, y = net.positions
    r_x, r_y = net.half_width
    x, y = x[:, None] / r_x, y[None, :] / r_y
    small = min(r_x, r_y)
    if kind == "spherical":
        return small * (0.8 - 0.2 * (x**2 + y**2))
    if kind == "wavy":
        return small * (0.5 + 0.05 * np.sin(7 * x + 3 * y) * np.cos(5 * y))
    smooth = 0.5 + 0.1 * np.cos(3 * x) * np.sin(2 * y + 1)
    return small * (smooth + 0.004 * rng.normal(size=net.shape))  # "optimised": slopes of order 1


NETS = [
    ControlNet((32, 24), (3, 3), (1.0, 1.0)),
    ControlNet((40, 33), (2, 5), (0.5, 0.8)),
    ControlNet((20, 24), (1, 1), (1.0, 2.0)),
    ControlNet((4, 4), (3, 3), (1.0, 1.0)),
    ControlNet((2, 2), (1, 1), (1.0, 1.0)),
    ControlNet((64, 5), (3, 4), (100.0, 1.0)),
]


@pytest.mark.parametrize("kind", ["spherical", "wavy", "optimised"])
@pytest.mark.parametrize("net", NETS, ids=str)
def test_roots_are_those_of_bisection_and_no_ray_is_lost(net, kind, rng):
    heights = surface(kind, net, rng)
    bundle = rays(rng, RAYS, net.half_width, 0.3)
    reference = Reference(net, heights, bundle)
    roots = reference.bisect(reference.low, reference.high)
    beyond_side = reference.f(reference.high)
    scale = heights.max()
    for dtype, accuracy in zip(DTYPES, (5e-6, 1e-10), strict=True):
        depth, found = meet(net, heights, bundle, dtype)
        # The side cuts a ray off where f is still positive there; rounding decides within a hair.
        clear = (np.abs(beyond_side) > accuracy * scale) | (reference.side > heights.max())
        expected = (beyond_side <= 0) | (reference.side > heights.max())
        assert np.array_equal(found[clear], expected[clear])
        both = found & expected
        assert both.sum() > 0.4 * RAYS
        assert np.abs(depth - roots)[both].max() <= accuracy * roots[both].min()


@pytest.mark.parametrize(("degree", "before"), [((3, 3), 0), ((3, 3), 2), ((2, 4), 2), ((1, 1), 2)])
def test_the_first_of_several_roots(rng, degree, before):
    net = ControlNet((24, 20), degree, (1.0, 1.0))
    heights = rng.uniform(0.2, 0.8, size=net.shape)
    bundle = rays(rng, 600, net.half_width, 0.9)
    reference = Reference(net, heights, bundle)
    roots, expected = reference.first_roots(3000)
    depth, found = meet(
        net, heights, bundle, before=[rng.uniform(0.2, 0.8, net.shape) for _ in range(before)]
    )
    # Only a ray that all but grazes the face may slip through the reference's steps.
    same = (found == expected) & (~found | (np.abs(depth - roots) < 1e-10))
    assert (~same).sum() <= 3
    odd = np.flatnonzero(~same & found)
    assert (np.abs(reference.f(depth[odd], odd)) < 1e-9).all()
    assert (depth[odd] <= np.where(expected, roots, np.inf)[odd]).all()
    assert 0.3 < found.mean() < 0.95
