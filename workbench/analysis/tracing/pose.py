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
        """Points (m, 3) of the scene as the lens sees them, from the middle of its entrance."""
        return self._inverse(points - np.array([*self.decentre, entrance_z]))

    def axis(self) -> Array:
        """The unit vector +z as the lens sees it, shape (3,)."""
        return self.ways(np.array([0.0, 0.0, 1.0]))

    def ways(self, vectors: Array) -> Array:
        """Directions (m, 3) of the scene as the lens sees them."""
        return self._inverse(vectors)

    def to_scene(self, entrance_z: float) -> tuple[Array, Array]:
        """Matrix (3, 3) and vector (3,) that take points back: the reverse of `to_lens`."""
        return self._rotation().as_matrix(), np.array([*self.decentre, entrance_z])

    def _rotation(self) -> Rotation:
        return Rotation.from_rotvec([*self.tilt, 0.0])

    def _inverse(self, vectors: Array) -> Array:
        found: Array = self._rotation().inv().apply(vectors)
        return found
