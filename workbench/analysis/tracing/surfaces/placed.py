"""Faces that stand elsewhere, or are cut otherwise, than their shape says."""

import numpy as np
from scipy.spatial.transform import Rotation

from workbench.analysis.tracing.elements import Crossings, TracedFace, TracedRays
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.surfaces.spline import SplineFace
from workbench.arrays import Array
from workbench.geometry.ball_cutter import Raster
from workbench.scene import Lens

# Steps back along a ray, over the size of the element, by rounding.
_BACK = 1e-9


class PlacedSurface:
    """A face in the coordinates of its element, met by rays in those of the walk; a `TracedFace`.

    A ray goes forwards only: a face that is behind its beginning is missed.

    `turn` (3, 3): takes vectors of the element, as columns, to the walk; `shift` (3,): where the
    element's origin is; `size`: about how large the element is.
    """

    def __init__(self, face: TracedFace, turn: Array, shift: Array, size: float) -> None:
        self.missed = face.missed
        self._face, self._turn, self._shift = face, turn, shift
        self._back = _BACK * size

    def meet(self, rays: TracedRays) -> Crossings:
        """Where rays meet it; see `TracedFace.meet`."""
        seen = self._seen(rays)
        found = self._face.meet(seen)
        lit = found.flux > 0
        path = np.einsum(
            "ij,ij->i",
            np.where(lit[:, None], found.position - seen.position, 0.0),
            np.where(lit[:, None], seen.direction, 0.0),
        )
        flux = np.where(path >= -self._back, found.flux, 0.0)
        return Crossings(
            found.position @ self._turn.T + self._shift,
            np.ascontiguousarray(found.normal @ self._turn.T),
            flux,
        )

    def met_again(self, rays: TracedRays, onwards: int) -> Array:
        """See `TracedFace.met_again`; x and y as the element counts them."""
        return self._face.met_again(self._seen(rays), onwards)

    def _seen(self, rays: TracedRays) -> TracedRays:
        """Rays in the coordinates of the element."""
        with np.errstate(invalid="ignore"):  # libraries may compute beside its end, too
            position = (rays.position - self._shift) @ self._turn
            direction = np.ascontiguousarray(rays.direction @ self._turn)
        return rays._replace(position=position, direction=direction)


class MovedFace(SplineFace):
    """A B-spline turned about its middle, then moved sideways, its outline with it; a `TracedFace`.

    Rays come and go in the coordinates of the lens. There is always a face before it, so that
    `lit` is not asked of it.

    `lens`, `control_points`, `missed`: see `SplineFace`; `pose`: how the exit face stands.
    """

    def __init__(self, lens: Lens, control_points: Array, missed: str, pose: Pose) -> None:
        super().__init__(lens, control_points, missed)
        # Rows are vectors: those of the lens times this matrix are those of the face.
        self._turn: Array = Rotation.from_rotvec([*pose.exit_tilt, 0.0]).as_matrix()
        z, _, _ = self.shape_at(np.zeros(1), np.zeros(1))
        self._middle = np.array([0.0, 0.0, z[0]])
        self._shift = np.array([*pose.exit_decentre, 0.0])

    def meet(self, rays: TracedRays) -> Crossings:
        """Where rays that go upwards first meet it; see `TracedFace.meet`."""
        seen = self._seen(rays)
        # They may begin beside the face and come to it: they are followed from below it on.
        way = seen.direction / seen.direction[:, 2:]
        ahead = (self._lowest - seen.position[:, 2:]).clip(min=0)
        found = super().meet(seen._replace(position=seen.position + ahead * way))
        found = self._inside(found)
        place = (found.position - self._middle) @ self._turn.T + self._middle + self._shift
        return found._replace(position=place, normal=found.normal @ self._turn.T)

    def met_again(self, rays: TracedRays, onwards: int) -> Array:
        """See `TracedFace.met_again`; x and y as the face counts them."""
        return super().met_again(self._seen(rays), onwards)

    def _seen(self, rays: TracedRays) -> TracedRays:
        """Rays in the coordinates of the face."""
        place = (rays.position - self._shift - self._middle) @ self._turn + self._middle
        return rays._replace(position=place, direction=rays.direction @ self._turn)


_STEPS = 3  # from the face that was to be cut onto what was: they are closer than ridges are wide


class CutSurface:
    """What a cutter leaves of the last face of a lens; a `TracedFace`.

    `designed`: the face that was to be cut; `raster`: the cuts; z in scene units; `front_z`: where
    the plane is from which rays count z.
    """

    def __init__(self, designed: TracedFace, raster: Raster, front_z: float) -> None:
        self.missed = designed.missed
        self._designed, self._raster, self._front_z = designed, raster, front_z

    def meet(self, rays: TracedRays) -> Crossings:
        """Where rays meet it; see `TracedFace.meet`."""
        found = self._designed.meet(rays)
        place = found.position.copy()
        for _ in range(_STEPS):
            height, normal = self._raster.cut(*place[:, :2].T)
            along = (height - self._front_z - place[:, 2]) / rays.direction[:, 2]
            place += along[:, None] * rays.direction
        return found._replace(position=place, normal=normal)

    def met_again(self, rays: TracedRays, onwards: int) -> Array:
        """Where rays come back to the face that was to be cut; see `TracedFace.met_again`."""
        return self._designed.met_again(rays, onwards)
