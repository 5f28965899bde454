"""The range of a run: what its task needs of it, and what is stated where that is not allowed."""

import numpy as np
import pytest

from workbench.design.bounds import Bounds
from workbench.design.run import run

FREE = {"lens.height_range": None, "lens.control_points": [24, 24]}


@pytest.fixture
def corner():
    """Light in one quarter of the screen."""
    image = np.zeros((32, 32))
    image[4:14, 4:14] = 1.0
    return image


def ends(bounds):
    free = bounds.height_range()["lens.back"]
    return free.lower.min().item(), free.upper.max().item()


def test_an_automatic_range_holds_the_first_lens_with_some_space(make_scene, corner):
    bounds = Bounds(make_scene(FREE), corner)
    low, high = ends(bounds)
    most = np.abs(bounds.first["lens.back"] - 0.5).max()
    assert high - 0.5 == pytest.approx(3 * most)
    assert low == max(0.05, 0.5 - 3 * most)
    assert bounds.notes == (f"heights within {3 * most:.3g} cm of the base",)


def test_a_too_small_range_is_reported_with_the_range_that_is_needed(make_scene, corner):
    *_, last = run(make_scene(FREE | {"lens.height_range": [-0.05, 0.05]}), corner)
    short = last.state.shortfall
    first = Bounds(make_scene(FREE), corner).first["lens.back"]
    assert (short.cause, short.allowed) == ("height_range", (-0.05, 0.05))
    assert short.needed == pytest.approx((first.min() - 0.5, first.max() - 0.5), rel=0.1)
    heights = last.state.heights["lens.back"]
    assert heights.min() >= 0.45 and heights.max() <= 0.55
    assert short.share == pytest.approx((np.abs(heights - 0.5) >= 0.05 * (1 - 2 * 0.003)).mean())


def test_a_run_whose_range_is_too_small_says_so_at_once_and_stops_early(make_scene, corner):
    narrow = {"lens.height_range": [-0.02, 0.02], "run.iterations": 300}
    _, first, *_, last = run(make_scene(FREE | narrow), corner)
    assert first.state.shortfall.cause == "height_range"
    assert last.iteration < 60


def test_too_thin_stock_is_reported_with_the_thickness_that_is_needed(make_scene, corner):
    stock = {"lens.max_thickness": 0.2, "lens.min_thickness": 0.1}
    *_, last = run(make_scene(FREE | stock), corner)
    short = last.state.shortfall
    extent = np.ptp(Bounds(make_scene(FREE), corner).first["lens.back"])
    assert (short.cause, short.allowed) == ("max_thickness", (0.1, 0.2))
    assert short.needed == pytest.approx((0.1, 0.1 + extent), rel=0.1)


ASIDE = {
    "lens.height_range": None,
    "lens.control_points": [24, 24],
    "source": {"kind": "point", "position": [4, 0, -5]},
}


def test_an_automatic_thickness_is_as_large_as_the_first_lens_needs(make_scene):
    target = np.zeros((32, 32))
    target[8:24, 8:24] = 1.0
    bounds = Bounds(make_scene(ASIDE), target)
    half_way = (0.5 + 5.0) / 2
    assert bounds.limits["lens.back"].upper == pytest.approx(half_way)
    extent = np.ptp(bounds.first["lens.back"])
    assert extent > half_way - 0.05  # the nearer half before the screen is too thin
    limits, first = bounds.limits["lens.back"], bounds.first["lens.back"]
    assert limits.hold(limits.nearest(first))
    assert limits.lacks(first) <= 0
    assert half_way < limits.upper.max() < 4.5
    assert bounds.shortfall({"lens.back": first}) is None
    stock = Bounds(make_scene(ASIDE | {"lens.max_thickness": half_way}), target)
    assert stock.first is not None and stock.shortfall(stock.begin).cause == "max_thickness"


ENTRANCE = {"lens.entrance": {"shape": "freeform", "height_range": [-0.1, 0.1]}}


def test_an_entrance_face_that_fills_its_range_is_reported(make_scene, corner):
    half = np.where(np.arange(24)[:, None] < 12, -0.09, 0.09) * np.ones((24, 24))
    bounds = Bounds(make_scene(FREE | ENTRANCE), corner)
    short = bounds.shortfall({"lens.back": np.full((24, 24), 0.5), "lens.front": half})
    assert (short.cause, short.allowed) == ("entrance_range", (-0.1, 0.1))
    assert short.share == pytest.approx(0.9)
    assert short.sentence(make_scene(ENTRANCE)) == (
        "The entrance face fills 90 % of its range of ±0.1 cm, and would bend more of the light "
        "in a wider one"
    )
    assert short.cure_in(make_scene(ENTRANCE)) == "widen the entrance range"
