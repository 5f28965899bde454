"""Spectra of light, and their colours in a camera."""

import math
from collections.abc import Iterable
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from workbench.arrays import Array
from workbench.messages import Message
from workbench.scene import Scene
from workbench.targets.colour import SRGB

# Lobes of the CIE 1931 functions: height, middle, widths below and above it, nm. Wyman, Sloan,
# Shirley, "Simple Analytic Approximations to the CIE XYZ Color Matching Functions", Journal of
# Computer Graphics Techniques 2 (2), 2013.
_LOBES = (
    ((1.056, 599.8, 37.9, 31.0), (0.362, 442.0, 16.0, 26.7), (-0.065, 501.1, 20.4, 26.2)),
    ((0.821, 568.8, 46.9, 40.5), (0.286, 530.9, 16.3, 31.1)),
    ((1.217, 437.0, 11.8, 36.0), (0.681, 459.0, 26.0, 13.8)),
)

# IEC 61966-2-1: linear sRGB of tristimulus values.
_RGB_OF_XYZ = np.array(
    [
        [3.2404542, -1.5371385, -0.4985314],
        [-0.9692660, 1.8760108, 0.0415560],
        [0.0556434, -0.2040259, 1.0572252],
    ]
)
_LUMINANCE = np.linalg.inv(_RGB_OF_XYZ)[1]


def tristimulus(wavelength_um: Array) -> Array:
    """CIE 1931 colour matching functions of the 2° observer, by a published fit.

    `wavelength_um` (m,): wavelengths in µm. Returns (m, 3): x̄, ȳ and z̄; off by up to 0.06, where
    x̄ and z̄ reach 1.06 and 1.78.

    Examples
    --------
    Green light of 0.555 µm is what the eye sees best:

    >>> tristimulus(np.array([0.555]))[0, 1].round(2).item()
    1.0
    """
    nm = 1000 * np.asarray(wavelength_um, dtype=np.float64)
    return np.stack([sum(_matching(nm, *lobe) for lobe in lobes) for lobes in _LOBES], axis=-1)


def _matching(nm: Array, height: float, middle: float, below: float, above: float) -> Array:
    return np.asarray(
        height * np.exp(-0.5 * ((nm - middle) / np.where(nm < middle, below, above)) ** 2)
    )


def linear_rgb(xyz: Array) -> Array:
    """Linear sRGB of tristimulus values, shape (..., 3); negative for colours beyond its gamut."""
    return np.asarray(xyz @ _RGB_OF_XYZ.T)


def luminance(rgb: Array) -> Array:
    """Tristimulus value Y of linear sRGB, shape (..., 3)."""
    return np.asarray(rgb @ _LUMINANCE)


def in_gamut(rgb: Array) -> Array:
    """Mix grey into linear sRGB (..., 3) until no part is negative; the luminance stays."""
    grey, least = luminance(rgb), rgb.min(axis=-1)
    kept = np.ones_like(grey)
    beyond = least < 0
    kept[beyond] = grey[beyond] / (grey[beyond] - least[beyond])
    mixed = grey[..., None] + kept[..., None] * (rgb - grey[..., None])
    return np.asarray(mixed.clip(0))  # rounding


def encoded(rgb: Array) -> npt.NDArray[np.uint8]:
    """Return the values of an sRGB file for linear sRGB (..., 3), where 1 is white."""
    return np.rint(255 * SRGB.stored(in_gamut(rgb).clip(0, 1))).astype(np.uint8)


SHORTEST, LONGEST = 0.40, 0.70
"""Range of the traced wavelengths, µm; the little visible light beyond counts as at its ends."""

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

    name: str
    title: Message
    # (m,), flux per wavelength at equal steps from 0.38 to 0.78 µm, in any unit; empty for lines.
    power: Array = field(default_factory=lambda: np.zeros(0), repr=False)
    lines: tuple[tuple[float, float], ...] = ()  # wavelengths in µm, ascending, and parts of flux

    def weights(self, wavelengths_um: Array) -> Array:
        """Return the weights (k, 3) of images at ascending wavelengths in linear sRGB.

        Images are interpolated linearly between wavelengths and constant beyond. Each column sums
        to 1, or the luminance does where the camera does not see this light as white.
        """
        if self.lines:
            power = np.array([part for _, part in self.lines])
            seen = power[:, None] * tristimulus(wavelengths_um)
        else:
            count = len(wavelengths_um)
            between = [np.interp(_GRID, wavelengths_um, each) for each in np.eye(count)]
            seen = np.stack(between) @ (self.power[:, None] * tristimulus(_GRID))
        rgb = linear_rgb(seen)
        white = rgb.sum(axis=0)
        return np.asarray(rgb / (luminance(white) if white.min() <= 0 else white))


def line(wavelength_um: float) -> Illuminant:
    """Light of a single wavelength from 0.38 to 0.78 µm, as of a laser."""
    title = Message("laser of {wavelength:g} µm", wavelength=wavelength_um)
    return Illuminant("laser", title, lines=((wavelength_um, 1.0),))


def of_spectrum(spectrum: Iterable[tuple[float, float]]) -> Illuminant:
    """Light of the visible lines of a spectrum; white light if it has none."""
    lines = sorted((w, part) for w, part in spectrum if part and _GRID[0] <= w <= _GRID[-1])
    if not lines:
        return LIGHTS["equal"]
    return Illuminant("spectrum", Message("the spectrum of the source"), lines=tuple(lines))


def _lobe(middle: float, width: float) -> Array:
    """A Gaussian of some full width at half maximum, µm."""
    return np.asarray(np.exp(-4 * math.log(2) * ((_GRID - middle) / width) ** 2))


LIGHTS = {
    light.name: light
    for light in (
        Illuminant(
            "daylight",
            Message("daylight (D65)"),
            np.interp(_GRID, np.linspace(0.38, 0.78, 41), _D65),
        ),
        # A model: the blue of the chip and the light of its phosphor.
        Illuminant("led", Message("white LED"), _lobe(0.45, 0.02) + 0.7 * _lobe(0.57, 0.12)),
        Illuminant("equal", Message("equal energy"), np.ones(_GRID.size)),
    )
}


def light_of(scene: Scene) -> Illuminant:
    """Return the light of a scene: its spectrum, or a guess by the kind of source.

    Collimated light is daylight, a Gaussian beam a laser of its wavelength, and a source with a
    position an LED. A beam without a visible wavelength is white.
    """
    if scene.source.spectrum:
        return of_spectrum(scene.source.spectrum)
    if scene.source.place is not None:
        return LIGHTS["led"]
    if not scene.source.moves:
        return LIGHTS["daylight"]
    wavelength = scene.source.wavelength_um
    if wavelength is None or not _GRID[0] <= wavelength <= _GRID[-1]:
        return LIGHTS["equal"]
    return line(wavelength)
