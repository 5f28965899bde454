"""The receiver as an element sees it: in coordinates that light moves along evenly as it is turned.

Transport with a quadratic cost makes faces that can be exact where the place that light reaches
moves evenly with the slope of the face. On a screen across the axis it does. On one that leans, the
same turn moves light much farther at the far edge than at the near one: transport in the screen's
own coordinates asks for slopes that no one face has. So a leaning screen is seen in perspective,
from the middle of the element on a plane across the axis.
"""

import math
from typing import NamedTuple, Self

import numpy as np

from workbench.arrays import Array
from workbench.design.transport.back_and_forth import Transport
from workbench.design.transport.cells import in_perspective
from workbench.scene import Scene

# Samples along an axis for the light that is wanted in cells: for each pixel and for each cell, at
# least.
_PER_PIXEL, _PER_CELL = 6.0, 2
_ONE = 0, 0, 1


class ReceiverView(NamedTuple):
    """A rectangle that holds the receiver as it is seen."""

    scene: Scene
    # (3, 3), takes (x, y, 1) of a place as it is seen to a multiple of (u, v, 1) on the receiver.
    back: Array
    # Of the rectangle.
    middle: tuple[float, float]
    half_extent: tuple[float, float]

    @classmethod
    def of(cls, scene: Scene) -> Self:
        """The view of a scene's receiver from the middle of the face that light leaves."""
        receiver = scene.receiver
        seen = receiver.perspective(scene.optic)
        left, right, bottom, top = receiver.bounds
        corners = seen @ [[left, left, right, right], [bottom, top, bottom, top], [1.0] * 4]
        x, y = corners[:2] / corners[2]
        low, high = np.array([x.min(), y.min()]), np.array([x.max(), y.max()])
        (mid_x, mid_y), (r_x, r_y) = (high + low) / 2, (high - low) / 2
        return cls(scene, np.asarray(np.linalg.inv(seen)), (mid_x, mid_y), (r_x, r_y))

    def places(self, transport: Transport) -> tuple[Array, Array]:
        """Where on the receiver the light of each cell should go, in the receiver's coordinates."""
        x, y = transport.map()
        return self.at((x, y), len(x))

    def at(self, place: tuple[Array, Array], cells: int) -> tuple[Array, Array]:
        """Where on the receiver places are that are given in so many cells of the rectangle."""
        x, y = self._seen(place, cells)
        u, v, far = (a * x + b * y + c for a, b, c in self.back)
        return u / far, v / far

    def seen(self, cells: int) -> tuple[Array, Array]:
        """Where the middles of cells are seen, two arrays of shape (cells, cells)."""
        return self._seen(self.grid(cells), cells)

    @staticmethod
    def grid(cells: int) -> tuple[Array, Array]:
        """Numbers of cells along x and y, two arrays of shape (cells, cells)."""
        x, y = np.meshgrid(np.arange(float(cells)), np.arange(float(cells)), indexing="ij")
        return x, y

    def weights(self, half_extent: tuple[float, float]) -> tuple[float, float]:
        """What ways along x and y cost between cells of the lens and of another rectangle."""
        r_x, r_y = (a * b for a, b in zip(self.scene.optic.half_width, half_extent, strict=True))
        return math.sqrt(r_x / r_y), math.sqrt(r_y / r_x)

    def wanted(self, image: Array, cells: int) -> Array:
        """The light of an image (n_y, n_x) in the cells of the rectangle, shape (cells, cells).

        Along x first and y upwards, as the lens is.
        """
        image = image[::-1].T
        if not self.leans:
            into_0, into_1 = (overlaps(count, cells) for count in image.shape)
            return np.asarray(into_0 @ image @ into_1.T)
        samples = max(_PER_CELL, math.ceil(_PER_PIXEL * max(image.shape) / cells))
        (m_x, m_y), (r_x, r_y) = self.middle, self.half_extent
        seen = np.array([[2 * r_x / cells, 0, m_x - r_x], [0, 2 * r_y / cells, m_y - r_y], _ONE])
        left, right, bottom, top = self.scene.receiver.bounds
        n_x, n_y = image.shape[0] / (right - left), image.shape[1] / (top - bottom)
        pixels = np.array([[n_x, 0, -left * n_x], [0, n_y, -bottom * n_y], _ONE])
        return in_perspective(image, pixels @ self.back @ seen, cells, samples)

    @property
    def leans(self) -> bool:
        """Whether it differs from the receiver's own coordinates."""
        return not np.array_equal(self.back, np.eye(3))

    def _seen(self, place: tuple[Array, Array], cells: int) -> tuple[Array, Array]:
        """Where places in cells of the rectangle are seen."""
        x, y = (
            ((2 * at + 1) / cells - 1) * half + middle
            for at, half, middle in zip(place, self.half_extent, self.middle, strict=True)
        )
        return x, y


def overlaps(pixels: int, cells: int) -> Array:
    """Which part of each pixel lies in each cell of the same line, shape (cells, pixels)."""
    below = (np.linspace(0, pixels, cells + 1)[:, None] - np.arange(pixels)).clip(0, 1)
    return np.diff(below, axis=0)
