"""Where elements stand, and the coordinates of one element in those of another."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from workbench.arrays import Array
from workbench.scene.turning import tilted

# Parts of a shift that are smaller than this part of the positions are rounding.
_ROUNDING = 1e-15


@dataclass(frozen=True, eq=False)
class Frame:
    """Where an element stands: a point p of it is at ``position + rotation @ p``."""

    position: Array  # (3,), of the element's origin, scene units
    rotation: Array  # (3, 3), the element's unit vectors as columns

    @classmethod
    def at(
        cls, position: Sequence[float] | Array, tilt: Sequence[float] = (0.0, 0.0, 0.0)
    ) -> "Frame":
        """Return the frame at a position with a tilt as for `tilted`."""
        return cls(np.asarray(position, float), tilted(tilt))

    def turned(self) -> "Frame":
        """Return the frame turned by 180° about its own x: its z points the other way."""
        return Frame(self.position, self.rotation * np.array([1.0, -1.0, -1.0]))

    def seen_from(self, other: "Frame") -> "Frame":
        """Return this frame in the coordinates of another one.

        Applied to points of this element, it gives them in the coordinates of the other element.
        What differs from the identity by rounding is exact.
        """
        same = np.array_equal(self.rotation, other.rotation)
        rotation = np.eye(3) if same else other.rotation.T @ self.rotation
        position = other.rotation.T @ (self.position - other.position)
        size = max(np.abs(self.position).max(), np.abs(other.position).max())
        return Frame(np.where(np.abs(position) <= _ROUNDING * size, 0.0, position), rotation)

    def counting_from(self, z: float, there: float) -> "Frame":
        """Return it for points that count z from a level, in coordinates that do so from another.

        `z`, `there`: the levels of this element, and of the coordinates that it is seen from.
        """
        return Frame(self.position + z * self.rotation[:, 2] - [0.0, 0.0, there], self.rotation)

    @property
    def is_identity(self) -> bool:
        """Whether it is the frame of the coordinates themselves."""
        return self.is_along_axis and not self.position[2]

    @property
    def is_along_axis(self) -> bool:
        """Whether it differs from the coordinates by a shift along z alone."""
        return np.array_equal(self.rotation, np.eye(3)) and not self.position[:2].any()

    def keeps_mirror_images(self, axis: int) -> bool:
        """Whether points that are mirror images in x (0) or y (1) stay so in these coordinates."""
        flip = np.ones(3)
        flip[axis] = -1.0
        turned = flip[:, None] * self.rotation * flip
        return bool(
            np.allclose(turned, self.rotation, rtol=0, atol=1e-12)
            and abs(self.position[axis]) <= 1e-12 * (1.0 + np.abs(self.position).max())
        )
