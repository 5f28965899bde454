"""Certified lower bound of the distance of blurred light from a target, by duality.

All images v of light have v = Σ u_y k_y, where k_y ≥ 0 is the blur about a position y and u ≥ 0;
only their shape counts, so Σ v = 1 as for the target t. For any image w and any number c with

⟨k_y, w⟩ ≥ c ⟨k_y, 1⟩ for all positions y

follows ⟨v, w⟩ ≥ c, and with the inequality of Cauchy and Schwarz

‖v − t‖ ‖w‖ ≥ ⟨v − t, w⟩ ≥ c − ⟨t, w⟩.

So no image comes closer to t than (c − ⟨t, w⟩) / ‖w‖. For the closest image v, both sides are equal
for w = v − t and c = ⟨v, w⟩. For an image that is merely close some positions fail, by

r(y) = c − ⟨k_y, w⟩ / ⟨k_y, 1⟩ > 0.

Let δ(x) be the largest r of all positions whose blur touches the pixel x. Then ⟨k_y, δ⟩ is at least
r(y) ⟨k_y, 1⟩, and no position fails for w + δ.

Before that, w is raised where positions fail: by a multiple of the blur about the position that
fails most, so that it no longer fails, then about the next one that still does. Such steps of the
dual problem cost less than the largest deficit: at the rim, a position whose blur grazes one pixel
has a deficit a thousand times that of others. A photograph in the sun of which light makes 10.86 %
is certified to 10.66 % with these steps, and to 10.60 % with the mean deficit of the failing
positions that touch each pixel, three times.
"""

from collections.abc import Iterator

import numpy as np

from workbench.arrays import Array
from workbench.extended.blurring import Blurring

# Less than this part of the blur within the image is rounding.
_GRAZING = 1e-9
# Passes over the positions that fail.
_PASSES = 2
# Search range of c about its first guess, in typical sizes of w, and number of evaluations.
_BELOW, _ABOVE, _TRIES = 1.0, 0.1, 8


class Certifier:
    """Certifies bounds for kernels (positions, 2 m_y + 1, 2 m_x + 1) and a target of sum 1.

    The positions in a pixel represent all.
    """

    def __init__(self, kernels: Array, target: Array) -> None:
        n_y, n_x = target.shape
        self._target, self._size = target, float(np.linalg.norm(target))
        self._kernels = kernels
        margins = kernels.shape[1] // 2, kernels.shape[2] // 2
        self._image = tuple(slice(m, m + n) for m, n in zip(margins, target.shape, strict=True))
        # One position after the other limits the memory; all have the same grid.
        self._each = [Blurring(kernel[None], (n_y, n_x)) for kernel in kernels]
        self._first = self._each[0]
        ones = np.ones_like(target)
        self._shares = [blurring.back(ones)[0][blurring.places] for blurring in self._each]

    def bound(self, residual: Array) -> float:
        """Return the lower bound, relative L2, that an image w (n_y, n_x) certifies.

        Any image; best that of blurred light less the target, close to the optimum.
        """
        from scipy.optimize import minimize_scalar  # slow import

        w = residual.astype(np.float64)  # a copy
        spread = float(np.linalg.norm(w)) / np.sqrt(w.size)
        if spread == 0:
            return 0.0
        guess = float(((self._target + w) * w).sum() / (self._target + w).sum())
        for _ in range(_PASSES):
            self._raise(w, guess)
        least = self._least_means(w)

        def lost(c: float) -> float:
            corrected = w + self._correction(c, least)
            return -(c - float((self._target * corrected).sum())) / float(np.linalg.norm(corrected))

        tried = minimize_scalar(
            lost,
            bounds=(guess - _BELOW * spread, guess + _ABOVE * spread),
            method="bounded",
            options={"xatol": 0.0, "maxiter": _TRIES},
        )
        return max(-min(lost(guess), float(tried.fun)) / self._size, 0.0)

    def _means(self, w: Array) -> Iterator[Array]:
        """Means of an image over the part of the blur within it, about each position."""
        waves = self._first.waves(self._first.on_grid(w))
        for blurring, share in zip(self._each, self._shares, strict=True):
            seen = share > _GRAZING
            inverse = np.divide(1.0, share, out=np.zeros_like(share), where=seen)
            means = blurring.back_from(waves)[0][blurring.places] * inverse
            yield np.where(seen, means, np.inf)

    def _raise(self, w: Array, c: float) -> None:
        """Raise an image, in place, until no position fails of those in a pixel that fail most."""
        most = np.zeros(self._shares[0].shape)
        position = np.zeros(most.shape, int)
        for number, means in enumerate(self._means(w)):
            more = c - means > most
            most[more], position[more] = (c - means)[more], number
        places = np.argwhere(most > 0)
        order = np.argsort(-most[most > 0])
        (n_y, n_x), (_, k_y, k_x) = w.shape, self._kernels.shape
        for y, x in places[order].tolist():
            top, left = y + 1 - k_y, x + 1 - k_x  # of the blur on the image
            kernel = self._kernels[position[y, x]]
            kernel = kernel[max(-top, 0) : n_y - top, max(-left, 0) : n_x - left]
            touched = w[max(top, 0) : top + k_y, max(left, 0) : left + k_x]
            lacking = c * kernel.sum() - np.vdot(kernel, touched)
            if lacking > 0:
                touched += lacking / np.vdot(kernel, kernel) * kernel

    def _least_means(self, w: Array) -> Array:
        least = np.full(self._shares[0].shape, np.inf)
        for means in self._means(w):
            np.minimum(least, means, out=least)
        return least

    def _correction(self, c: float, least: Array) -> Array:
        from scipy.ndimage import maximum_filter  # slow import

        fails = (c - least).clip(min=0.0)
        return np.asarray(
            maximum_filter(fails, self._kernels.shape[1:], mode="constant")[self._image]
        )
