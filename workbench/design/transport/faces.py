"""Faces that send light to given places on a receiver."""

import math
from typing import NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.design.limits import HeightLimits
from workbench.design.transport.between import Pair, between
from workbench.design.transport.chart import SlopesFor
from workbench.design.transport.face import SlopeFit
from workbench.design.transport.face_light import FaceLight
from workbench.scene import Scene

Vector = tuple[Array, Array, Array]

# Where no face could bend the light as wanted, the normal is kept along the axis by this part of
# what it is where light goes straight on or back: n − 1, and 2 for a mirror.
UPRIGHT = 0.1
# Blocks along an axis within which what a net cannot follow cancels out.
_BLOCKS = 16


class Faces(NamedTuple):
    """Finds faces that send light where a transport says."""

    scene: Scene
    light: FaceLight
    fit: SlopeFit
    limits: HeightLimits

    def fitted(self, to: Pair, heights: Array, fits: int) -> Array:
        """Control heights of a face, from those of one like it, found in so many fits."""
        for _ in range(fits):
            heights = self.limits.placed(self.fit.heights(*self._wanted(to, heights)))
        return heights

    def missed(self, to: Pair, heights: Array) -> float:
        """How far a face as it is found by `fitted` sends light from where it should go.

        In parts of the receiver's width, a root mean square. What a net of control points cannot
        follow is left out: only what no smooth face can.
        """
        wanted, extent = self._wanted(to, heights), self.scene.receiver.half_extent
        found = self.fit.slopes(self.fit.heights(*wanted))
        square = 0.0
        for axis, half in enumerate(extent):
            beside = to[0] + (axis == 0) * half, to[1] + (axis == 1) * half
            rate = float(np.median(self._wanted(beside, heights)[axis] - wanted[axis]))
            square += float(np.square(_coarsely(found[axis] - wanted[axis]) / (2 * rate)).mean())
        return math.sqrt(square)

    def slopes_for(self, heights: Array) -> SlopesFor:
        """The slopes that light needs in any cell of a face like another."""
        z = self.fit.surface(heights)
        cells, direction = len(z), self.light.direction(z)

        def slopes(cell: Pair, to: Pair) -> Pair:
            x, y = (
                ((2 * place + 1) / cells - 1) * half
                for place, half in zip(cell, self.scene.optic.half_width, strict=True)
            )
            d_x, d_y, d_z = (between(part, cell) for part in direction)
            return self._slopes((x, y, between(z, cell)), (d_x, d_y, d_z), to)

        return slopes

    def _wanted(self, to: Pair, heights: Array) -> Pair:
        """Slopes in all cells of a face like another that send light to places."""
        z = self.fit.surface(heights)
        return self._slopes((self.light.x, self.light.y, z), self.light.direction(z), to)

    def _slopes(self, place: Vector, coming: Vector, to: Pair) -> Pair:
        """Slopes of the face that send light from places on it to places on the receiver."""
        optic, (d_x, d_y, d_z) = self.scene.optic, coming
        out_x, out_y, out_z = self.scene.receiver.towards(optic, place, *to)
        # Snell's law as vectors: the normal is along n d_in − d_out; of a mirror, n is 1.
        n = optic.index
        normal_z = np.maximum(n * d_z - out_z, UPRIGHT * optic.deflection)
        return -(n * d_x - out_x) / normal_z, -(n * d_y - out_y) / normal_z


def _coarsely(values: Array) -> Array:
    """Means of values over blocks of cells."""
    size = len(values) // _BLOCKS
    kept = values[: size * _BLOCKS, : size * _BLOCKS]
    return np.asarray(kept.reshape(_BLOCKS, size, _BLOCKS, size).mean((1, 3)))
