"""Spectra of light that lenses are lit by, and what a camera makes of them.

A camera is balanced: the light itself is white to it, if it can be. That of a laser cannot.
"""

import math
from dataclasses import dataclass, field

import numpy as np

from workbench.analysis.photo.colour import linear_rgb, luminance, tristimulus
from workbench.arrays import Array
from workbench.said import Said
from workbench.scene import Scene

SHORTEST, LONGEST = 0.40, 0.70
"""Wavelengths that are traced, µm. What little the eye sees beyond is taken to go there too."""

_GRID = np.linspace(0.38, 0.78, 401)

# CIE standard illuminant D65, 0.38 to 0.78 µm by 0.01 µm (CIE 15:2004, table T.1).
_D65 = (
    *(49.9755, 54.6482, 82.7549, 91.4860, 93.4318, 86.6823, 104.865, 117.008, 117.812, 114.861),
    *(115.923, 108.811, 109.354, 107.802, 104.790, 107.689, 104.405, 104.046, 100.000, 96.3342),
    *(95.7880, 88.6856, 90.0062, 89.5991, 87.6987, 83.2886, 83.6992, 80.0268, 80.2146, 82.2778),
    *(78.2842, 69.7213, 71.6091, 74.3490, 61.6040, 69.8856, 75.0870, 63.5927, 46.4182, 66.8054),
    63.3828,
)


@dataclass(frozen=True, eq=False)
class Illuminant:
    """Light of some spectrum."""

    name: str  # what it is called
    title: Said  # what a person reads
    # (m,), flux per wavelength from 0.38 to 0.78 µm, evenly spaced, in any unit.
    power: Array = field(repr=False)
    line_um: float | None = None  # its only wavelength, where it has but one

    def weights(self, wavelengths_um: Array) -> Array:
        """What images at some wavelengths count for in the linear sRGB of all light.

        Between two wavelengths the image is taken to go over evenly from the one to the other,
        and to stay as it is beyond them.

        `wavelengths_um` (k,): the wavelengths, growing. Returns (k, 3): each column sums to 1 where
        the camera sees this light as white; otherwise their luminance sums to 1.
        """
        between = [np.interp(_GRID, wavelengths_um, each) for each in np.eye(len(wavelengths_um))]
        rgb = linear_rgb(np.stack(between) @ (self.power[:, None] * tristimulus(_GRID)))
        white = rgb.sum(axis=0)
        return np.asarray(rgb / (luminance(white) if white.min() <= 0 else white))


def line(wavelength_um: float) -> Illuminant:
    """Light of a single wavelength from 0.38 to 0.78 µm, as of a laser."""
    power = np.zeros(_GRID.size)
    power[np.abs(_GRID - wavelength_um).argmin()] = 1.0
    title = Said("laser of {wavelength:g} µm", wavelength=wavelength_um)
    return Illuminant("laser", title, power, wavelength_um)


def _lobe(middle: float, width: float) -> Array:
    """A Gaussian of some full width at half maximum, µm."""
    return np.asarray(np.exp(-4 * math.log(2) * ((_GRID - middle) / width) ** 2))


LIGHTS = {
    light.name: light
    for light in (
        Illuminant(
            "daylight", Said("daylight (D65)"), np.interp(_GRID, np.linspace(0.38, 0.78, 41), _D65)
        ),
        # a model: the blue of the chip, and what its phosphor makes of it.
        Illuminant("led", Said("white LED"), _lobe(0.45, 0.02) + 0.7 * _lobe(0.57, 0.12)),
        Illuminant("equal", Said("equal energy"), np.ones(_GRID.size)),
    )
}
"""By name."""


def light_of(scene: Scene) -> Illuminant:
    """The light that the source of a scene is likely to be.

    Light from infinitely far is daylight, a Gaussian beam that of a laser of the wavelength
    stated, and what stands somewhere is an LED. A beam of no stated or no visible wavelength counts
    as white.
    """
    if scene.source.place is not None:
        return LIGHTS["led"]
    if not scene.source.moves:
        return LIGHTS["daylight"]
    wavelength = scene.source.wavelength_um
    if wavelength is None or not _GRID[0] <= wavelength <= _GRID[-1]:
        return LIGHTS["equal"]
    return line(wavelength)
