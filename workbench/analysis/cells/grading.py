"""Places of nodes along an axis: closer together where the light is near.

Light of a point at a distance d from the face spreads as tan of its angle does. Far from its foot,
equal cells of the face would each hold less and less light, and those next to the foot far too
much. Here the width of a cell is in proportion to √(d² + x²), how far the point is from it.
"""

from typing import Self

import numpy as np

from workbench.arrays import Array
from workbench.scene import Scene

# Light from farther than so many half-widths away is as good as parallel: cells are equal.
_FAR = 16.0


class Grading:
    """The map from [-1, 1], where nodes are even, onto [-1, 1], where they are not.

    `distance`, `foot`: how far a point of light is from the face and where its foot is,
    half-widths.

    Examples
    --------
    >>> place, stretch = Grading(0.1, 0.0)(np.array([-1.0, 0.0, 1.0]))
    >>> place.round(12).tolist(), (stretch[0] / stretch[1]).round(2).item()
    ([-1.0, 0.0, 1.0], 10.05)
    """

    def __init__(self, distance: float, foot: float) -> None:
        self._even = distance > _FAR
        self._distance, self._foot = distance, foot
        low, high = (float(np.arcsinh((end - foot) / distance)) for end in (-1, 1))
        self._middle, self._half = (low + high) / 2, (high - low) / 2

    @classmethod
    def of(cls, scene: Scene) -> tuple[Self, Self]:
        """Those along x and y for the light of a scene."""
        optic, place = scene.optic, scene.source.place
        if place is None:
            return cls(np.inf, 0.0), cls(np.inf, 0.0)
        away = optic.front_z - place[2]
        x, y = (
            cls(away / r, foot / r) for r, foot in zip(optic.half_width, place[:2], strict=True)
        )
        return x, y

    def __call__(self, even: Array) -> tuple[Array, Array]:
        """Places of even ones, and how much longer the way there is; any shape."""
        if self._even:
            return even, np.ones_like(even)
        angle = self._middle + self._half * even
        place = self._foot + self._distance * np.sinh(angle)
        return place.clip(-1, 1), self._distance * self._half * np.cosh(angle)
