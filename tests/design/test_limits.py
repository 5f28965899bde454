"""Where control heights may be."""

import numpy as np
import pytest

from workbench.design.limits import HeightLimits, bounded
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


def test_a_surface_that_does_not_fit_is_cut_off_at_the_ends(limits_of, bowl):
    limits = limits_of({})
    assert limits.lacks(bowl) == pytest.approx(np.ptp(bowl) - 0.6)
    assert not limits.hold(bowl)
    cut = limits.nearest(bowl)
    assert limits.hold(cut) and limits.nearest(cut) is cut
    assert cut.min() == 0.2 or cut.max() == 0.8
