"""Rays that see a control point which may move, and the others, whose light stays where it is.

A ray of a tensor grid sees the control points whose basis functions reach it, and no others. Those
of the smallest rectangle of rays that holds all which see a point that is not locked are traced
for each lens; the up to four rectangles around it are traced once.
"""

import numpy as np

from workbench.arrays import Mask
from workbench.optics.kernels.grid import Axis

Rays = tuple[Axis, Axis]
"""A tensor grid of rays: across and up."""


def split(rays: Rays, locked: Mask | None) -> tuple[Rays, tuple[Rays, ...]]:
    """Rays to be traced for each lens, and those to be traced once.

    Parameters
    ----------
    rays : tuple[Axis, Axis]
        All rays.
    locked : ndarray of bool, shape (n_u, n_v), optional
        Control points whose heights stay.
    """
    if locked is None:
        return rays, ()
    across, up = rays
    left, right = _seeing(across, np.asarray((~locked).any(axis=1)))
    low, high = _seeing(up, np.asarray((~locked).any(axis=0)))
    middle = _cut(across, left, right)
    around = (
        (_cut(across, 0, left), up),
        (_cut(across, right, None), up),
        (middle, _cut(up, 0, low)),
        (middle, _cut(up, high, None)),
    )
    return (middle, _cut(up, low, high)), tuple(part for part in around if count(part) > 0)


def count(rays: Rays) -> int:
    """How many rays there are."""
    return len(rays[0].place) * len(rays[1].place)


def _seeing(axis: Axis, free: Mask) -> tuple[int, int]:
    """Where the rays that see a free row (or column) of the net begin and end; 0, 0 for none."""
    seen = axis.first[:, None] + np.arange(axis.value.shape[1], dtype=np.uintp)
    rays = np.flatnonzero(free[seen].any(axis=1))
    return (int(rays[0]), int(rays[-1]) + 1) if len(rays) else (0, 0)


def _cut(axis: Axis, begin: int, end: int | None) -> Axis:
    part = slice(begin, end)
    return Axis._make(values[part] for values in axis)
