"""Which rays stand for the first half of light that is its own mirror image, along x and y.

Diagonals of cells are mirror images of each other too, where an even number of cells lies side by
side: what half of the cells gives and its mirror image are the image of all.
"""

from typing import NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.optics.samples import Corners, Samples, counts
from workbench.optics.sources.origins import Origins
from workbench.said import Said

# Origins nearer to each other's mirror image than this part of their extent count as a pair.
_SAME = 1e-9


class Halves(NamedTuple):
    """Parts of the first rays along x and y that belong to the half that is traced."""

    # (m,), 1 for most rays, 0.5 for one in the middle; and 0 for one behind it, which tells how the
    # light bends there. None where all rays are traced.
    x: Array | None
    y: Array | None

    @classmethod
    def of(cls, samples: Samples, wanted: tuple[bool, bool]) -> "Halves":
        """Halves of the rays along x and y, where wanted; none of an odd number of cells."""
        x, y = (_half(samples, axis) if wanted[axis] else None for axis in (0, 1))
        return cls(x, y)

    @property
    def mirrored(self) -> tuple[bool, bool]:
        """Whether half of the rays are traced along x, along y."""
        return self.x is not None, self.y is not None

    @property
    def notes(self) -> list[str]:
        """What is left out, in words."""
        if not any(self.mirrored):
            return []
        if all(self.mirrored):
            return [Said("mirror symmetry: a quarter of the rays")]
        return [Said("mirror symmetry: half of the rays")]

    def first(self, values: Array, axis: int) -> Array:
        """What there is for all rays along an axis, for those that are traced."""
        half = self[axis]
        return values if half is None else values[: len(half)]

    def rows(self, values: Array) -> Array:
        """Values (m_x, m_y) of all samples for those that are traced, shape (m_y, m_x)."""
        rows = np.ascontiguousarray(self.first(values, 0).T)
        return np.ascontiguousarray(self.first(rows, 1))

    def weighted(self, flux: Array, axis: int) -> Array:
        """The flux of rays along an axis that belongs to the traced half."""
        half = self[axis]
        return flux if half is None else flux[: len(half)] * half

    def splits(self, whole: tuple[Array, Array]) -> tuple[Array, Array]:
        """See `workbench.optics.beams.beam_image`; the middle ray's flux is all before it."""
        x, y = (self.first(split, axis).copy() for axis, split in enumerate(whole))
        for split, half in ((x, self.x), (y, self.y)):
            if half is not None:
                split[half < 1, :2] = 1.0, 0.0
        return x, y


def _half(samples: Samples, axis: int) -> Array | None:
    count = counts(samples)[axis]
    if count % 2:
        return None
    half = np.ones(count // 2)
    return np.append(half, [0.5, 0.0]) if isinstance(samples, Corners) else half


def halved(origins: Origins, wanted: tuple[bool, bool]) -> tuple[Origins, tuple[bool, bool]]:
    """Origins of which mirror images give all, and along which axes they do.

    `origins`: all of them; `wanted`: along which axes to leave mirror images out, if there are any.
    """
    kept, done = origins, [False, False]
    for axis in (0, 1):
        side = kept.places[:, axis]
        if wanted[axis] and (side != 0).any() and _paired(kept, axis):
            share = np.where(side == 0, 0.5, 1.0)
            some = side >= 0
            kept = kept._replace(places=kept.places[some], flux=(kept.flux * share)[some])
            done[axis] = True
    return kept, (done[0], done[1])


def _paired(origins: Origins, axis: int) -> bool:
    """Whether each origin has a mirror image of the same flux."""
    flipped = origins.places.copy()
    flipped[:, axis] *= -1
    size = np.ptp(origins.places, axis=0).max()
    orders = (np.lexsort(np.round(p / (_SAME * size)).T) for p in (origins.places, flipped))
    one, other = orders
    same = np.abs(origins.places[one] - flipped[other]).max() <= 2 * _SAME * size
    return bool(same) and np.allclose(origins.flux[one], origins.flux[other], rtol=1e-9)


def is_on_axis(origins: Origins) -> bool:
    """Whether there is one origin, on the axis, whose light is its own mirror image."""
    return len(origins.flux) == 1 and not origins.places[0, :2].any() and origins.pattern is None
