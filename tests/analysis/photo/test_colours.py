"""Colours of the predicted photo, and the light that it is taken in."""

import numpy as np
import pytest

from workbench.analysis.photo.light import (
    LIGHTS,
    encoded,
    in_gamut,
    light_of,
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


def test_d65_has_its_chromaticity_and_is_the_white_of_srgb():
    power = LIGHTS["daylight"].power
    x, y, z = power @ tristimulus(np.linspace(0.38, 0.78, power.size))
    assert (x / (x + y + z), y / (x + y + z)) == pytest.approx((0.3127, 0.3290), abs=0.002)
    red, green, blue = linear_rgb(np.array([x, y, z]) / y)
    assert (red, green, blue) == pytest.approx((1.0, 1.0, 1.0), abs=0.02)


def test_lights_follow_from_sources(make_scene):
    def named(changes):
        return light_of(make_scene(changes)).name

    beam = {"kind": "collimated", "profile": {"kind": "gaussian", "radius": 0.5}}
    green = {"lens.refractive_index": "PMMA", "lens.wavelength_um": 0.532}
    infrared = {"lens.refractive_index": "N-BK7", "lens.wavelength_um": 1.064}
    assert named({}) == "daylight"
    assert named({"source": {"kind": "point", "position": [0, 0, -3]}}) == "led"
    assert named({"source": beam} | green) == "laser"
    assert named({"source": beam} | infrared) == "equal"
    assert named({"source": beam}) == "equal"
