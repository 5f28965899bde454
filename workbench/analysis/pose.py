"""How a lens stands in the light: tilted and moved out of its place."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from scipy.spatial.transform import Rotation

Array = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Pose:
    """A lens turned about the middle of its entrance face, then moved sideways.

    Source and screen stay where they are.

    Attributes
    ----------
    tilt : tuple[float, float]
        Rotation vector: radians about the axes x and y; their root sum of squares is the angle
        between optical axis and lens.
    decentre : tuple[float, float]
        Shift along x and y, scene units.
    """

    tilt: tuple[float, float] = (0.0, 0.0)
    decentre: tuple[float, float] = (0.0, 0.0)

    def to_lens(self, points: Array, entrance_z: float) -> Array:
        """Points of shape (m, 3) as the lens sees them."""
        pivot = np.array([0.0, 0.0, entrance_z])
        turned = self._inverse(points - pivot - np.array([*self.decentre, 0.0]))
        return np.asarray(turned + pivot)

    def axis(self) -> Array:
        """The unit vector +z as the lens sees it, shape (3,)."""
        return self._inverse(np.array([0.0, 0.0, 1.0]))

    def to_scene(self, entrance_z: float) -> tuple[Array, Array]:
        """Matrix (3, 3) and vector (3,) that take points of the lens into the scene."""
        pivot = np.array([0.0, 0.0, entrance_z])
        turn = self._rotation().as_matrix()
        return turn, pivot + np.array([*self.decentre, 0.0]) - turn @ pivot

    def _rotation(self) -> Rotation:
        return Rotation.from_rotvec([*self.tilt, 0.0])

    def _inverse(self, vectors: Array) -> Array:
        found: Array = self._rotation().inv().apply(vectors)
        return found
