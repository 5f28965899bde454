"""Where control heights may be."""

import numpy as np
import pytest

from workbench.design.limits import CLOSEST, HeightLimits, bounded
from workbench.geometry.surface import ControlNet


@pytest.fixture
def limits_of(make_scene):
    """Limits of the small scene with some fields changed."""

    def make(changes):
        lens = bounded(make_scene(changes))
        return HeightLimits.of(lens, ControlNet.of(lens))

    return make


@pytest.fixture
def bowl():
    """A surface of the small scene's size that is 1 cm higher at its rim, at any height."""
    across, up = (np.linspace(-1, 1, n) for n in (12, 10))
    return 7.0 + np.maximum(np.abs(across[:, None]), np.abs(up[None, :]))


def test_a_range_and_both_thicknesses_hold_together(limits_of):
    limits = limits_of({"lens.max_thickness": 0.7, "lens.min_thickness": 0.3})
    assert (limits.lower == 0.3).all() and (limits.upper == 0.7).all()
    limits = limits_of({"lens.max_thickness": 2.0})
    assert limits.lower == pytest.approx(0.2) and limits.upper == pytest.approx(0.8)


def test_without_a_range_the_stock_alone_limits_the_lens(limits_of):
    limits = limits_of({"lens.height_range": None, "lens.max_thickness": 2.0})
    assert (limits.lower == 0.05).all() and (limits.upper == 2.0).all()
    assert (limits.undesigned == 0.5).all()


def test_without_any_limit_the_lens_stays_in_the_nearer_half_before_the_screen(limits_of):
    limits = limits_of({"lens.height_range": None})
    assert (limits.upper == (0.5 + 5.0) / 2).all()


def test_without_any_limit_the_lens_keeps_clear_of_the_screen_at_most(make_scene):
    lens = bounded(make_scene({"lens.height_range": None}), CLOSEST)
    assert lens.ceiling == pytest.approx(5.0 - 0.05 * (5.0 - 0.5))


def test_the_undesigned_lens_is_within_the_stock(limits_of):
    limits = limits_of({"lens.height_range": None, "lens.max_thickness": 0.4})
    assert limits.hold(limits.undesigned)
    assert limits.undesigned == pytest.approx(0.4, abs=1e-3)


def test_a_surface_is_placed_about_the_undesigned_lens(limits_of, bowl):
    placed = limits_of({"lens.base.height": 1.5, "lens.height_range": [-1.4, 1.4]}).placed(bowl)
    assert np.ptp(placed - bowl) < 1e-12
    assert placed.max() + placed.min() == pytest.approx(2 * 1.5)


def test_a_surface_is_placed_at_a_rise_above_the_undesigned_lens_that_has_room(limits_of, bowl):
    limits = limits_of({"lens.base.height": 1.5, "lens.height_range": [-1.4, 1.4]})
    risen = limits.placed(bowl, 0.1)
    assert risen - limits.placed(bowl) == pytest.approx(0.1)
    assert limits.hold(limits.placed(bowl, 10.0))


def test_a_surface_keeps_away_from_an_end_that_is_near(limits_of, bowl):
    placed = limits_of({"lens.height_range": None}).placed(bowl)
    assert placed.min() == pytest.approx(0.05 + 0.25 * np.ptp(bowl))


def test_a_surface_that_just_fits_is_placed_in_the_middle(limits_of, bowl):
    extent = float(np.ptp(bowl))
    limits = limits_of({"lens.height_range": None, "lens.max_thickness": 0.05 + extent + 0.01})
    placed = limits.placed(bowl)
    assert placed.min() == pytest.approx(0.055)
    assert limits.lacks(bowl) == pytest.approx(-0.01)


def test_a_surface_that_does_not_fit_is_cut_off_at_the_ends(limits_of, bowl):
    limits = limits_of({})
    assert limits.lacks(bowl) == pytest.approx(np.ptp(bowl) - 0.6)
    assert not limits.hold(bowl)
    cut = limits.nearest(bowl)
    assert limits.hold(cut) and limits.nearest(cut) is cut
    assert cut.min() == 0.2 or cut.max() == 0.8


def test_a_far_screen_does_not_make_the_lens_thick(limits_of):
    """The lens before any design is as thick for a screen that is 1e9 away as for a far field."""
    limits = limits_of({"lens.height_range": None, "screen.z": 1e9})
    assert np.abs(limits.undesigned - 0.5).max() < 0.5
    assert limits.upper.max() < 2000
