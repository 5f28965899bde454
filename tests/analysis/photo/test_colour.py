"""Colours of light in a picture file."""

import numpy as np
import pytest

from workbench.analysis.photo.colour import (
    encoded,
    in_gamut,
    linear_rgb,
    luminance,
    tristimulus,
)

WAVELENGTHS = np.linspace(0.38, 0.78, 401)


def test_the_fit_is_near_the_table_of_another_program():
    mitsuba = pytest.importorskip("mitsuba")
    mitsuba.set_variant("scalar_rgb")
    table = np.array([np.ravel(mitsuba.cie1931_xyz(1000 * each)) for each in WAVELENGTHS])
    assert np.abs(tristimulus(WAVELENGTHS) - table).max() < 0.06
    # Light of all wavelengths together is much nearer.
    assert tristimulus(WAVELENGTHS).sum(axis=0) == pytest.approx(table.sum(axis=0), rel=0.005)


def test_equal_energy_has_equal_tristimulus_values():
    x, y, z = tristimulus(WAVELENGTHS).sum(axis=0)
    assert (x / y, z / y) == pytest.approx((1.0, 1.0), rel=0.005)


def test_luminance_is_the_second_tristimulus_value():
    xyz = np.random.default_rng(1).random((5, 4, 3))
    assert luminance(linear_rgb(xyz)) == pytest.approx(xyz[..., 1])


def test_colours_beyond_the_gamut_keep_their_luminance():
    rgb = linear_rgb(tristimulus(np.linspace(0.42, 0.66, 25)))
    assert rgb.min() < 0
    inside = in_gamut(rgb)
    assert inside.min() >= 0
    assert luminance(inside) == pytest.approx(luminance(rgb))
    assert in_gamut(inside) == pytest.approx(inside)


def test_a_picture_has_white_and_middle_grey_where_srgb_says_so():
    rgb = np.array([0.0, 0.2158605, 1.0, 7.0])[:, None] * np.ones(3)
    assert encoded(rgb)[:, 1].tolist() == [0, 128, 255, 255]
