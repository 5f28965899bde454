"""From light of a wavelength to the colours of a picture file."""

import numpy as np
import numpy.typing as npt

from workbench.arrays import Array
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
    return np.stack([sum(_lobe(nm, *lobe) for lobe in lobes) for lobes in _LOBES], axis=-1)


def _lobe(nm: Array, height: float, middle: float, below: float, above: float) -> Array:
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
    """Colours without negative parts, of the same luminance: as much grey is mixed in as it takes.

    `rgb` (..., 3): linear sRGB of light, so that its luminance is not negative.
    """
    grey, least = luminance(rgb), rgb.min(axis=-1)
    kept = np.ones_like(grey)
    beyond = least < 0
    kept[beyond] = grey[beyond] / (grey[beyond] - least[beyond])
    mixed = grey[..., None] + kept[..., None] * (rgb - grey[..., None])
    return np.asarray(mixed.clip(0))  # what rounding leaves


def encoded(rgb: Array) -> npt.NDArray[np.uint8]:
    """Values of a picture file for linear sRGB; what is brighter than 1 is overexposed.

    `rgb` (..., 3): linear sRGB, 1 is white.
    """
    return np.rint(255 * SRGB.stored(in_gamut(rgb).clip(0, 1))).astype(np.uint8)
