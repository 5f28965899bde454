"""Shaping an element by hand: a brush raises or lowers control points of one of its faces."""

import numpy as np

from workbench.arrays import Array, Mask
from workbench.design.limits import HeightLimits
from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.scene import Element

Block = tuple[slice, slice]

_SMALLEST = 1.5  # radius, in distances between neighbours: all eight of them
_GROWTH = 1.25  # from one size to the next


def bump(net: ControlNet, index: tuple[int, int], radius: float) -> tuple[Block, Array]:
    """How much each control point follows one in the middle of a brush.

    `net`: the control net; `index`: the control point in the middle, along x and along y; `radius`:
    of the brush, scene units; 0 for the control point alone. Returns `block`: the part of the net
    that the brush reaches; `weights`: 1 in the middle, smoothly falling to 0 at the radius: (1 − (d
    / radius)²)².
    """
    block, squares = [], []
    for at, i in zip(net.positions, index, strict=True):
        first = int(np.searchsorted(at, at[i] - radius))
        last = int(np.searchsorted(at, at[i] + radius, side="right"))
        block.append(slice(first, last))
        squares.append(np.square((at[first:last] - at[i]) / (radius or 1.0)))
    weights = np.square((1 - squares[0][:, None] - squares[1]).clip(0))
    return (block[0], block[1]), weights


def resized(net: ControlNet, radius: float, steps: int) -> float:
    """Radius of a brush some steps larger or, if they are negative, smaller.

    `net`: the control net; `radius`: of the brush, scene units; `steps`: the smallest brush is a
    single point, the next one takes its neighbours along, the largest one reaches over the whole
    lens.
    """
    least = _SMALLEST * max(float(np.diff(at).max()) for at in net.positions)
    for _ in range(abs(steps)):
        if steps > 0:
            radius = min(max(radius * _GROWTH, least), max(net.half_width))
        else:
            radius = radius / _GROWTH if radius > least else 0.0
    return radius


class Stroke:
    """One movement of the brush along z.

    Heights stay in the range that the element allows, which keeps its minimal thickness as well
    (see `HeightLimits`); locked control points stay where they are.

    `optic`: the lens or mirror; `face`: the name of the face that is shaped; `heights` (n_u, n_v):
    its control heights before, scene units; `locked` (n_u, n_v): control points that stay; `index`:
    the control point in the middle of the brush; `radius`: of the brush, scene units.
    """

    def __init__(
        self,
        optic: Element,
        face: str,
        heights: Array,
        locked: Mask | None,
        index: tuple[int, int],
        radius: float,
    ) -> None:
        net = freeform_nets(optic)[face]
        limits = HeightLimits.of_faces(optic)[face]
        self._heights = heights
        self._block, self._weights = bump(net, index, radius)
        if locked is not None:
            self._weights = np.where(locked[self._block], 0.0, self._weights)
        before = heights[self._block]
        # Heights that are beyond the range already may come back, but go no farther.
        self._lower = np.minimum(limits.lower[self._block], before)
        self._upper = np.maximum(limits.upper[self._block], before)

    @property
    def moves(self) -> bool:
        """Whether there is a control point that is not locked."""
        return bool(self._weights.any())

    def raised(self, by: float) -> Array:
        """Control heights, shape (n_u, n_v), after the middle has gone up by so much."""
        heights = self._heights.copy()
        moved = heights[self._block] + by * self._weights
        heights[self._block] = moved.clip(self._lower, self._upper)
        return heights
