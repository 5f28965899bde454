"""Figures of an image against its target.

Images (n_y, n_x) are compared by their shape: each is divided by its sum first. They are processed
some rows at a time, so that large images need no further memory.
"""

import math
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt
from scipy.ndimage import gaussian_filter

from workbench.arrays import Array, Mask

# Window and constants of Wang et al. (2004): 11 × 11 pixels of a Gaussian.
_SIGMA, _RADIUS = 1.5, 5
_K_1, _K_2 = 0.01, 0.03
# Parts of the target's peak from where a pixel is lit and up to where it is black.
_LIT, _BLACK = 0.5, 0.01
_AT_ONCE = 1 << 18  # pixels processed together
# A distance over its error that suffices, and the largest error that ever does: bounds of coarser
# images are less certain.
_DIGITS, _MOST_OFF = 40, 5e-3


def relative_l2(image: Array, target: Array) -> float:
    """‖I − T‖ / ‖T‖ of normalised images."""
    return root(product(image, image, target))


def enough(accuracy: float, distance: float) -> float:
    """Error of an image that suffices at a distance to its target: 0.3 % at 12 %, or more."""
    return max(accuracy, min(distance / _DIGITS, _MOST_OFF))


def root(square: float) -> float:
    """Square root; a negative square, by noise or rounding, counts as 0."""
    return math.sqrt(max(square, 0.0))


def product(image: Array, other: Array, target: Array) -> float:
    """⟨I − T, I′ − T⟩ / ‖T‖² of normalised images."""
    sum_i, sum_o, sum_t = _sum(image), _sum(other), _sum(target)
    found = size = 0.0
    for i, o, t in _rows(image, other, target):
        wanted = t / sum_t
        found += float(((i / sum_i - wanted) * (o / sum_o - wanted)).sum())
        size += float(np.square(wanted).sum())
    return found / size


def paper_loss(image: Array, target: Array) -> float:
    """‖I − T‖ / √(n_x n_y) of normalised images (section 2.4 of the paper)."""
    return math.sqrt(_mean_square(image, target))


@dataclass(frozen=True)
class Quality:
    """Figures of an image against its target; None where a figure is not defined."""

    psnr: float | None  # peak signal-to-noise ratio, dB; None for equal images
    ssim: float  # mean structural similarity
    correlation: float | None  # Pearson's coefficient; None for a constant image
    uniformity: float  # least over mean of image / target in the lit region
    # (E_lit − E_black) / (E_lit + E_black) of the mean irradiances in both regions; None if the
    # target has no black region.
    contrast: float | None

    @classmethod
    def of(cls, image: Array, target: Array) -> "Quality":
        """Compare an image with its target, which is not dark."""
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
    mean_square = _mean_square(image, target)
    if mean_square == 0:
        return None
    return 20 * math.log10(float(target.max()) / _sum(target)) - 10 * math.log10(mean_square)


def ssim(image: Array, target: Array) -> float:
    """Mean structural similarity (Wang, Bovik, Sheikh, Simoncelli 2004, eq. 13).

    In windows of 11 × 11 pixels, a Gaussian of 1.5 pixels; images are mirrored at their edges. The
    dynamic range is the target's peak.
    """
    sum_i, sum_t = _sum(image), _sum(target)
    peak = float(target.max()) / sum_t
    found = 0.0
    rows = len(target)
    step = _step(target)
    for first in range(0, rows, step):
        # Windows include neighbouring rows.
        begin, end = max(first - _RADIUS, 0), min(first + step + _RADIUS, rows)
        similar = _similarity(image[begin:end] / sum_i / peak, target[begin:end] / sum_t / peak)
        found += float(similar[first - begin : first - begin + step].sum())
    return found / target.size


def _similarity(a: Array, b: Array) -> Array:
    """Structural similarity of each window, for a dynamic range of 1."""
    mean_a, mean_b = _windowed(a), _windowed(b)
    # Rounding may make a variance negative.
    variance_a = (_windowed(a * a) - mean_a * mean_a).clip(0)
    variance_b = (_windowed(b * b) - mean_b * mean_b).clip(0)
    covariance = _windowed(a * b) - mean_a * mean_b
    c_1, c_2 = _K_1**2, _K_2**2
    similar = (2 * mean_a * mean_b + c_1) * (2 * covariance + c_2)
    return np.asarray(similar / ((mean_a**2 + mean_b**2 + c_1) * (variance_a + variance_b + c_2)))


def _windowed(image: Array) -> Array:
    return np.asarray(gaussian_filter(image, _SIGMA, radius=_RADIUS))


def correlation(image: Array, target: Array) -> float | None:
    """Pearson's coefficient over the pixels; None if one image is the same everywhere."""
    sums = _sum(image), _sum(target)
    means = float(image.mean()) / sums[0], float(target.mean()) / sums[1]
    squares, deviations, together = np.zeros(2), np.zeros(2), 0.0
    for parts in _rows(image, target):
        scaled = [part / total for part, total in zip(parts, sums, strict=True)]
        off = [each - mean for each, mean in zip(scaled, means, strict=True)]
        squares += [np.square(each).sum() for each in scaled]
        deviations += [np.square(each).sum() for each in off]
        together += float((off[0] * off[1]).sum())
    # A constant image has deviations by rounding.
    if (deviations <= 1e-24 * squares).any():
        return None
    return together / math.sqrt(deviations[0] * deviations[1])


def lit(target: Array) -> Mask:
    """The lit region: pixels of at least half the target's peak."""
    return np.asarray(target >= _LIT * target.max())


def black(target: Array) -> Mask:
    """The black region: pixels of at most a hundredth of the target's peak."""
    return np.asarray(target <= _BLACK * target.max())


class LitLight(NamedTuple):
    """Least, mean and most of an image in the lit region of its target."""

    least: float
    mean: float
    most: float


def lit_light(image: Array, target: Array) -> LitLight:
    """Return the light of the lit region, pixel by pixel over the target's part of its median.

    So a pixel at the edge that is lit in part only does not count as dark.
    """
    region = lit(target)
    level = float(np.median(target[region]))
    least, most, total = math.inf, 0.0, 0.0
    for i, t, inside in _rows(image, target, region):
        light = i[inside] * (level / t[inside])
        least = min(least, float(light.min(initial=math.inf)))
        most = max(most, float(light.max(initial=0.0)))
        total += float(light.sum())
    return LitLight(least, total / int(region.sum()), most)


def uniformity(image: Array, target: Array) -> float:
    """Least over mean of image / target in the lit region; 1 is uniform, 0 has a dark pixel."""
    found = lit_light(image, target)
    return found.least / found.mean if found.mean > 0 else 0.0


def contrast(image: Array, target: Array) -> float | None:
    """Michelson contrast of the lit and the black region; None without a black region."""
    dark = black(target)
    if not dark.any():
        return None
    bright, rest = (float(image.mean(where=region)) for region in (lit(target), dark))
    return (bright - rest) / (bright + rest) if bright + rest > 0 else None


def _mean_square(image: Array, target: Array) -> float:
    """Mean of (I − T)² of normalised images."""
    sum_i, sum_t = _sum(image), _sum(target)
    squares = (float(np.square(i / sum_i - t / sum_t).sum()) for i, t in _rows(image, target))
    return sum(squares) / target.size


def _sum(image: Array) -> float:
    """Sum of an image; 1 for a dark one."""
    total = float(image.sum())
    return total if total > 0 else 1.0


def _step(image: Array) -> int:
    return max(_AT_ONCE // int(image.shape[1]), 1)


def _rows(*images: npt.NDArray[Any]) -> Iterator[list[npt.NDArray[Any]]]:
    """Yield the same rows of several images, some at a time."""
    step = _step(images[0])
    for first in range(0, len(images[0]), step):
        yield [image[first : first + step] for image in images]
