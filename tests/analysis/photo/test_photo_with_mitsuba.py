"""Mitsuba 3 sees the same colours: its rays at each wavelength, its colour matching functions."""

import numpy as np
import pytest

from tests.analysis.lenses import net_of
from workbench.analysis.mitsuba import MitsubaScene
from workbench.analysis.photo.light import LIGHTS, linear_rgb
from workbench.analysis.photo.photo import at_wavelength, photograph

pytestmark = pytest.mark.full

RAYS = 40_000


def test_mitsuba_finds_the_same_colours(make_scene, monkeypatch):
    mitsuba = pytest.importorskip("mitsuba")
    monkeypatch.setattr("workbench.analysis.mitsuba_elements._CELLS", 96)  # made sooner
    changes = {
        "version": 2,
        "lens.reflection": "fresnel",
        "lens.refractive_index": "PC",
        "lens.wavelength_um": 0.55,
        "screen": {"z": 24.0, "center": [4.7, 0], "half_width": [2, 2], "pixels": [24, 24]},
    }
    scene = make_scene(changes)
    bowl = {"lens.back": net_of(scene, lambda x, y: 0.5 + 0.3 * x + 0.02 * x * x - 0.01 * y * y)}
    photo = photograph(scene, np.ones((24, 24)), bowl)
    x = np.arange(24) @ photo.rgb.sum(axis=0) / photo.rgb.sum(axis=(0, 1))
    assert abs(x[0] - x[2]) > 0.5  # pixels between red and blue

    halves = []
    for half in range(2):
        images = [
            MitsubaScene(at_wavelength(scene, wavelength), bowl).flux(RAYS, 10 * number + half)
            for number, wavelength in enumerate(photo.wavelengths_um)
        ]
        weights = weights_by(mitsuba, photo.wavelengths_um)
        halves.append(np.tensordot(images, weights, (0, 0)) / scene.receiver.pixel_measure)
    size = np.linalg.norm(photo.rgb)
    noise = np.linalg.norm(halves[0] - halves[1]) / 2 / size
    difference = np.linalg.norm((halves[0] + halves[1]) / 2 - photo.rgb) / size
    assert noise < 0.05
    assert difference < 1.25 * noise + 0.003
    assert halves[0].mean(axis=(0, 1)) == pytest.approx(photo.rgb.mean(axis=(0, 1)), rel=0.01)


def weights_by(mitsuba, wavelengths):
    """What its tables make of images at some wavelengths in daylight, by `Illuminant.weights`."""
    mitsuba.set_variant("scalar_rgb")
    power = LIGHTS["daylight"].power
    fine = np.linspace(0.38, 0.78, power.size)
    table = np.array([np.ravel(mitsuba.cie1931_xyz(1000 * each)) for each in fine])
    between = [np.interp(fine, wavelengths, each) for each in np.eye(len(wavelengths))]
    rgb = linear_rgb(np.stack(between) @ (power[:, None] * table))
    return rgb / rgb.sum(axis=0)
