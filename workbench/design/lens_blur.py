"""The blur of a source all over the image of a lens: its mean, and how it differs over the image.

A place of the lens that bends light farther blurs it by more, and most along the way that it bends
it. So behind a plate that spreads the sun over 200 mm at 500 mm, blurs differ by some 3 % in width,
and towards the corners they lean: x and y of their light have a correlation of up to 7 %. An image
by one blur for all of it is 0.68 % off there, and 0.31 % with differences that are polynomials of
third degree (0.34 % of second, 0.31 % of fourth); with those of widths alone it is 0.57 %, with
leaning alone 0.47 %.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Self

import numpy as np
from torch import Tensor

from workbench.arrays import Array
from workbench.extended.blur import Blur
from workbench.measured.lamps import of_known_size
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.samples import Corners
from workbench.scene import Scene

# Places of the lens that are looked at, and cells of the source: its middle and its rim.
_PLACES, _RIM = (96, 96), (2, 2)
_DEGREE = 3
# Nearly all light lands within what polynomials are fitted to, or it is a bit beyond the receiver:
# rays that hardly leave the lens land very far out. Farther out blurs are as at that border.
_NEARLY_ALL, _BEYOND = 0.999, 1.25
# The greatest part of the squares of all differences that they may leave: 0.01 to 0.1 behind plates
# that spread the light; 0.9 in the focus of a bowl, whose image is 0.7 % off with one blur for all
# of it and 1.7 % with polynomials.
_LEFT = 0.5


@dataclass(frozen=True, eq=False)
class BlurChange:
    """How a blur differs from its mean over an image, by the factors of `changes_at`."""

    # (3, k), of the powers of x and y up to the third, of width along x and along y and of
    # correlation.
    factors: Array
    # Pixels from the middle of the receiver where x and y are 1; beyond, nothing changes.
    half_extent: tuple[float, float]

    @classmethod
    def of(cls, scene: Scene, heights: Mapping[str, Tensor]) -> Self | None:
        """The change that a lens makes, from where light of the middle and rim of a source lands.

        `scene`: the design task, with a source of some size; `heights` (n_u, n_v): control heights
        of the lens. Returns None if that does not tell it: where no light lands, or light from
        several parts of the lens lands at the same places.
        """
        known = scene.model_copy(update={"source": of_known_size(scene.source, scene.optic)})
        spots = BeamPlan(known, Corners.and_of_source(*_PLACES, _RIM)).spots(heights)
        middle = [count / 2 for count in scene.receiver.pixels]
        x, y = (place - half for place, half in zip(spots.places, middle, strict=True))
        if not len(x):
            return None
        far_x, far_y = (
            min(max(float(np.quantile(np.abs(part), _NEARLY_ALL)), 1.0), _BEYOND * half)
            for part, half in zip((x, y), middle, strict=True)
        )
        inside = (np.abs(x) <= far_x) & (np.abs(y) <= far_y)
        if not inside.any():
            return None
        weight = np.sqrt(spots.flux[inside])
        terms = weight * powers(x[inside] / far_x, y[inside] / far_y, _DEGREE)
        found = weight * _differences(spots.spread[..., inside], spots.flux[inside])
        factors = np.linalg.lstsq(terms.T, found.T)[0].T
        left = np.square(found - factors @ terms).sum()
        return cls(factors, (far_x, far_y)) if left < _LEFT * np.square(found).sum() else None

    def at(self, pixels: tuple[int, int], margin: tuple[int, int]) -> Array:
        """Its values in the middles of pixels.

        `pixels`, `margin`: pixels of the receiver along x and y, and of the image beyond them on
        each side. Returns (3, n_y + 2 m_y, n_x + 2 m_x).
        """
        x, y = (
            ((np.arange(n + 2 * m) - (n + 2 * m - 1) / 2) / far).clip(-1, 1)
            for n, m, far in zip(pixels, margin, self.half_extent, strict=True)
        )
        return np.asarray(np.tensordot(self.factors, powers(x[None, :], y[:, None], _DEGREE), 1))


@dataclass(frozen=True, eq=False)
class LensBlur:
    """What the places of a lens make of a source of some size."""

    mean: Blur  # what they make of it on average
    change: BlurChange | None = None  # how that differs from place to place of the image

    def scaled(self, factor: float) -> Self:
        """Return it for so many times as many pixels along each axis."""
        change = self.change
        if change is not None:
            x, y = change.half_extent
            change = replace(change, half_extent=(factor * x, factor * y))
        return replace(self, mean=self.mean.scaled(factor), change=change)


def powers(x: Array, y: Array, degree: int) -> Array:
    """Powers of x and y together up to a degree, along the first axis; x and y broadcast."""
    each = range(degree + 1)
    return np.stack(
        np.broadcast_arrays(*(x**i * y**j for i in each for j in each if i + j <= degree))
    )


def _differences(spread: Array, flux: Array) -> Array:
    """Relative differences of widths from their means, and correlations; shape (3, k)."""
    x, y = np.sqrt(spread[0, 0]), np.sqrt(spread[1, 1])
    mean_x, mean_y = (np.average(each, weights=flux) for each in (x, y))
    return np.stack([x / mean_x - 1, y / mean_y - 1, spread[0, 1] / (mean_x * mean_y)])
