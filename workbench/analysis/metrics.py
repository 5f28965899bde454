"""How like its target an image of light is: the field's usual figures.

Images are compared by their shape: each is divided by its sum first. All images have shape
(n_y, n_x), and no light counts as a dark image.
"""

import math
from dataclasses import asdict, dataclass

import numpy as np
import numpy.typing as npt
from scipy.ndimage import gaussian_filter

Array = npt.NDArray[np.float64]

# Window and constants of Wang et al. (2004): 11 × 11 pixels of a Gaussian.
_SIGMA, _RADIUS = 1.5, 5
_K_1, _K_2 = 0.01, 0.03
# Parts of the target's peak from where a pixel is lit and up to where it is black.
_LIT, _BLACK = 0.5, 0.01


def normalised(image: Array) -> Array:
    """An image divided by its sum; a dark one as it is."""
    total = float(image.sum())
    return image / total if total > 0 else image


def relative_l2(image: Array, target: Array) -> float:
    """‖I − T‖ / ‖T‖ of normalised images."""
    target = normalised(target)
    return float(np.linalg.norm(normalised(image) - target) / np.linalg.norm(target))


@dataclass(frozen=True)
class Quality:
    """Figures of an image against its target. None where a figure has no meaning.

    Attributes
    ----------
    psnr : float or None
        Peak signal-to-noise ratio, dB; the signal is the target's peak. None if they are equal.
    ssim : float
        Mean structural similarity.
    correlation : float or None
        Pearson's coefficient over the pixels. None if one of them is the same everywhere.
    uniformity : float
        Least over mean irradiance in the lit region, each relative to the target's.
    contrast : float or None
        (E_lit − E_black) / (E_lit + E_black), of the mean irradiances in the lit and in the black
        region: 1 is a perfect black. None if the target has no black region or neither is lit.
    """

    psnr: float | None
    ssim: float
    correlation: float | None
    uniformity: float
    contrast: float | None

    @classmethod
    def of(cls, image: Array, target: Array) -> "Quality":
        """Compare an image with its target, which has some light."""
        return cls(
            psnr(image, target),
            ssim(image, target),
            correlation(image, target),
            uniformity(image, target),
            contrast(image, target),
        )

    def to_data(self) -> dict[str, float | None]:
        """The figures by name, for JSON."""
        return asdict(self)


def psnr(image: Array, target: Array) -> float | None:
    """Peak signal-to-noise ratio in dB; None if the images are equal."""
    target = normalised(target)
    mean_square = float(np.square(normalised(image) - target).mean())
    if mean_square == 0:
        return None
    return 20 * math.log10(float(target.max())) - 10 * math.log10(mean_square)


def ssim(image: Array, target: Array) -> float:
    """Mean structural similarity (Wang, Bovik, Sheikh, Simoncelli 2004, eq. 13).

    In windows of 11 × 11 pixels, a Gaussian of 1.5 pixels; images are mirrored at their edges. The
    dynamic range is the target's peak.
    """
    a, b = normalised(image), normalised(target)
    peak = float(b.max())
    a, b = a / peak, b / peak
    mean_a, mean_b = _windowed(a), _windowed(b)
    # Rounding must not make a variance negative.
    variance_a = (_windowed(a * a) - mean_a * mean_a).clip(0)
    variance_b = (_windowed(b * b) - mean_b * mean_b).clip(0)
    covariance = _windowed(a * b) - mean_a * mean_b
    c_1, c_2 = _K_1**2, _K_2**2
    similar = (2 * mean_a * mean_b + c_1) * (2 * covariance + c_2)
    similar /= (mean_a**2 + mean_b**2 + c_1) * (variance_a + variance_b + c_2)
    return float(similar.mean())


def _windowed(image: Array) -> Array:
    return np.asarray(gaussian_filter(image, _SIGMA, radius=_RADIUS))


def correlation(image: Array, target: Array) -> float | None:
    """Pearson's coefficient over the pixels; None if one image is the same everywhere."""
    deviations = []
    for each in (normalised(image), normalised(target)):
        deviation = each - each.mean()
        # What rounding leaves of an even image is nothing to go by.
        if np.linalg.norm(deviation) <= 1e-12 * np.linalg.norm(each):
            return None
        deviations.append(deviation / np.linalg.norm(deviation))
    return float((deviations[0] * deviations[1]).sum())


def lit(target: Array) -> npt.NDArray[np.bool_]:
    """The lit region: pixels of at least half the target's peak."""
    return np.asarray(target >= _LIT * target.max())


def black(target: Array) -> npt.NDArray[np.bool_]:
    """The black region: pixels of at most a hundredth of the target's peak."""
    return np.asarray(target <= _BLACK * target.max())


def uniformity(image: Array, target: Array) -> float:
    """Least over mean of image / target in the lit region; 1 is even, 0 has a dark pixel."""
    ratio = image[lit(target)] / target[lit(target)]
    mean = float(ratio.mean())
    return float(ratio.min()) / mean if mean > 0 else 0.0


def contrast(image: Array, target: Array) -> float | None:
    """Michelson's contrast of the lit and the black region; None if there is nothing to compare."""
    dark = black(target)
    if not dark.any():
        return None
    bright, rest = float(image[lit(target)].mean()), float(image[dark].mean())
    return (bright - rest) / (bright + rest) if bright + rest > 0 else None
