"""Spectra, and what images at some wavelengths count for."""

import numpy as np
import pytest

from workbench.analysis.photo.colour import linear_rgb, tristimulus
from workbench.analysis.photo.light import LIGHTS, light_of, line


def test_d65_has_its_chromaticity_and_is_the_white_of_srgb():
    power = LIGHTS["daylight"].power
    x, y, z = power @ tristimulus(np.linspace(0.38, 0.78, power.size))
    assert (x / (x + y + z), y / (x + y + z)) == pytest.approx((0.3127, 0.3290), abs=0.002)
    red, green, blue = linear_rgb(np.array([x, y, z]) / y)
    assert (red, green, blue) == pytest.approx((1.0, 1.0, 1.0), abs=0.02)


def test_a_laser_keeps_its_colour():
    ((red, green, blue),) = line(0.532).weights(np.array([0.532]))
    assert green > 1
    assert red < blue < 0


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
