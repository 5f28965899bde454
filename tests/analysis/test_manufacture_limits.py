"""Bounds and limits of manufacture."""

import math

import numpy as np
import pytest

from workbench.analysis.manufacture import Extreme, Manufacture, verdicts
from workbench.analysis.manufacture_bounds import shape_bounds
from workbench.analysis.shop_limits import Limits
from workbench.geometry.curvature import local_shape
from workbench.geometry.surface import ControlNet

LINE = np.linspace(0, 1, 301)


def attained(net, heights):
    shape = local_shape(net, heights, LINE, LINE)
    return shape.slope.max(), shape.largest.max(), -shape.smallest.min()


@pytest.mark.parametrize("degree", [(2, 2), (3, 3), (4, 2), (5, 7)])
def test_bounds_hold_and_tighten_with_more_parts(degree, rng):
    net = ControlNet((9, 10), degree, (1.0, 0.7))
    heights = 0.02 * rng.random(net.shape)
    most = attained(net, heights)
    coarse, fine = (np.array(shape_bounds(net, heights, (k, k))) for k in (4, 32))
    assert (fine >= np.array(most) * (1 - 1e-12)).all()
    assert (fine <= coarse).all()
    assert fine == pytest.approx(most, rel=0.07)


def test_steep_slopes_count(rng):
    """Across a steep plane bends are softer than second derivatives say; bounds know it."""
    net = ControlNet((6, 6), (3, 3), (1.0, 1.0))
    x, _ = net.positions
    heights = 2.0 * x[:, None] + 0.05 * rng.random(net.shape)
    slope, hollow, hump = shape_bounds(net, heights, (64, 64))
    most = attained(net, heights)
    assert [slope, hollow, hump] == pytest.approx(most, rel=0.05)


def lens(**figures):
    plain = {
        "thinnest": Extreme(0.4, 0.39, (0.0, 0.0)),
        "thickest": Extreme(0.6, 0.61, (0.0, 0.0)),
        "sag_range": 0.2,
        "steepest": Extreme(20.0, 21.0, (0.0, 0.0)),
        "tightest_concave": Extreme(0.1, 0.09, (0.0, 0.0)),
        "tightest_convex": Extreme(math.inf, math.inf, (0.0, 0.0)),
        "tool_radius": Extreme(0.08, 0.07, (0.0, 0.0)),
    }
    return Manufacture(**(plain | figures))


def states(limits, **figures):
    return [(v.name, v.state) for v in verdicts(lens(**figures), limits)]


@pytest.mark.parametrize(
    ("limits", "state"),
    [
        ({"min_thickness": 0.38}, "met"),
        ({"min_thickness": 0.395}, "open"),
        ({"min_thickness": 0.41}, "broken"),
        ({"max_thickness": 0.62}, "met"),
        ({"max_thickness": 0.605}, "open"),
        ({"max_thickness": 0.59}, "broken"),
        ({"max_slope": 22.0}, "met"),
        ({"max_slope": 20.5}, "open"),
        ({"max_slope": 19.0}, "broken"),
    ],
)
def test_bounds_and_places_decide(limits, state):
    assert [s for _, s in states(Limits(**limits))] == [state]


@pytest.mark.parametrize(("radius", "state"), [(0.05, "met"), (0.095, "open"), (0.2, "broken")])
def test_radii_count_for_hollows_and_humps(radius, state):
    found = states(Limits(min_radius=radius))
    assert found == [("concave radius", state), ("convex radius", "met")]
    edge = Extreme(0.0, 0.0, (0.0, 0.0))
    assert states(Limits(min_radius=radius), tightest_convex=edge)[1][1] == "broken"


@pytest.mark.parametrize(("radius", "state"), [(0.07, "met"), (0.075, "open"), (0.09, "broken")])
def test_a_ball_cutter_has_to_fit(radius, state):
    assert states(Limits(min_tool_radius=radius)) == [("ball cutter", state)]


def test_limits_in_words():
    limits = Limits(min_thickness=0.3, max_thickness=1.0, max_slope=20.5, min_radius=0.05)
    found = [f"{v.name} {v.wanted('mm')}" for v in verdicts(lens(), limits)]
    assert found == [
        "thickness at least 0.3 mm",
        "thickness at most 1 mm",
        "slope at most 20.5°",
        "concave radius at least 0.05 mm",
        "convex radius at least 0.05 mm",
    ]
