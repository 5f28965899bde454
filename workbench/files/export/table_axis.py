"""Angles of an intensity table along C or γ, and the samples of the light to which it is fitted."""

import math
from typing import NamedTuple

import numpy as np
from scipy.sparse import csr_array

from workbench.arrays import Array, Mask

# Planes and angles where there is no light are left out if there are as many as others.
_DARK = 2


class TableAxis(NamedTuple):
    """Samples of the light along C or γ.

    Attributes
    ----------
    lit : tuple[float, float]
        Angles between which there is light, degrees; samples reach farther.
    samples, weight : ndarray, shape (m,)
        Degrees, ascending, and how much each counts.
    ends : tuple[float, float], optional
        Angles with which a table begins and ends; None along an arc of C in a dark circle.
    around : bool
        Whether the last angle is the first one again.
    """

    lit: tuple[float, float]
    samples: Array
    weight: Array
    ends: tuple[float, float] | None
    around: bool = False

    def nodes(self, step: float) -> Array:
        """Angles of a table: multiples of a step around the light, or everywhere if few more."""
        if step >= 360:
            return np.zeros(1)
        low, high = math.floor(self.lit[0] / step) - 1, math.ceil(self.lit[1] / step) + 1
        if self.ends is None:
            return np.asarray(step * np.arange(low, high + 1), dtype=np.float64)
        first, last = (round(end / step) for end in self.ends)
        low, high = max(low, first), min(high, last)
        if last - first <= _DARK * (high - low):
            low, high = first, last
        inner = step * np.arange(low, high + 1)
        ends = np.array(self.ends)
        return np.asarray(np.unique(np.concatenate([ends, inner])), dtype=np.float64)

    def lights(self, nodes: Array) -> Mask:
        """Which angles of a table have light between them and the next ones."""
        if self.around or len(nodes) == 1:
            return np.ones(max(len(nodes) - self.around, 1), dtype=bool)
        before, behind = np.append(nodes[:1], nodes[:-1]), np.append(nodes[1:], nodes[-1:])
        return np.asarray((behind > self.lit[0]) & (before < self.lit[1]))

    def hats(self, nodes: Array) -> csr_array:
        """What part each angle has in each sample, shape (angles, m)."""
        count = max(len(nodes) - self.around, 1)
        if count == 1:
            return csr_array(np.ones((1, len(self.samples))))
        low = np.clip(np.searchsorted(nodes, self.samples, side="right") - 1, 0, len(nodes) - 2)
        part = (self.samples - nodes[low]) / (nodes[low + 1] - nodes[low])
        beyond = (part < 0) | (part > 1)  # of an arc: dark
        values = np.where(beyond, 0.0, [1 - part, part]).ravel()
        rows = np.concatenate([low, (low + 1) % count if self.around else low + 1])
        at = rows, np.tile(np.arange(len(part)), 2)
        return csr_array((values, at), shape=(count, len(part)))
