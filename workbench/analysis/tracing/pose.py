"""How a lens stands in the light, and its source: tilted and moved out of their places."""

from dataclasses import dataclass, field

import numpy as np
from scipy.spatial.transform import Rotation

from workbench.arrays import Array


@dataclass(frozen=True)
class Pose:
    """A lens turned about the middle of its entrance face, then moved sideways; and its source.

    The screen stays where it is.
    """

    # Rotation vector: radians about the axes x and y; their root sum of squares is the angle
    # between optical axis and lens.
    tilt: tuple[float, float] = (0.0, 0.0)
    decentre: tuple[float, float] = (0.0, 0.0)  # shift along x and y, scene units
    source_tilt: tuple[float, float] = (0.0, 0.0)  # as ``tilt``, of the source about its middle
    # Shift of the source along x, y and z, scene units.
    source_shift: tuple[float, float, float] = (0.0, 0.0, 0.0)
    # As ``tilt`` and ``decentre``, of the exit face against the entrance face, turned about its own
    # middle.
    exit_tilt: tuple[float, float] = (0.0, 0.0)
    exit_decentre: tuple[float, float] = (0.0, 0.0)

    def of_source(self, middle: tuple[float, float, float]) -> "Pose":
        """What takes points and directions of the source, as the scene says them, to the lens.

        `middle`: about which the source is turned, scene units.
        """
        if not any((*self.source_tilt, *self.source_shift)):
            return self
        return _SourcePose(**vars(self), middle=middle)

    @property
    def beam(self) -> tuple[float, float]:
        """Where in the scene a beam of light passes the plane of the entrance face."""
        return 0.0, 0.0

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


@dataclass(frozen=True, eq=False)
class ElementPose(Pose):
    """How the first element of a train stands; a beam passes its middle."""

    # (3, 3), its unit vectors in the scene, as columns, in place of ``tilt``.
    turn: Array = field(default_factory=lambda: np.eye(3))

    @property
    def beam(self) -> tuple[float, float]:
        """See `Pose.beam`."""
        return self.decentre

    def _rotation(self) -> Rotation:
        return Rotation.from_matrix(self.turn)


@dataclass(frozen=True)
class _SourcePose(Pose):
    """A pose for the points and directions of a source that is out of its place."""

    middle: tuple[float, float, float] = (0.0, 0.0, 0.0)

    def to_lens(self, points: Array, entrance_z: float) -> Array:
        moved: Array = self._turn().apply(points - np.array(self.middle)) + self._stands()
        return super().to_lens(moved, entrance_z)

    def ways(self, vectors: Array) -> Array:
        return super().ways(self._turn().apply(vectors))

    def to_scene(self, entrance_z: float) -> tuple[Array, Array]:
        turn, shift = super().to_scene(entrance_z)
        back = self._turn().inv()
        place: Array = back.apply(shift - self._stands()) + np.array(self.middle)
        return back.as_matrix() @ turn, place

    def _stands(self) -> Array:
        """Where the middle is."""
        return np.add(self.middle, self.source_shift)

    def _turn(self) -> Rotation:
        return Rotation.from_rotvec([*self.source_tilt, 0.0])
