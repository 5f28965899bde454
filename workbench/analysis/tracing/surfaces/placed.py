"""Faces that stand elsewhere, or have other normals, than their shape says."""

from collections.abc import Sequence

import numpy as np
from scipy.spatial.transform import Rotation

from workbench.analysis.tracing.elements import Crossings, TracedFace, TracedRays
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.surfaces.spline import SplineFace
from workbench.arrays import Array
from workbench.scene import Lens
from workbench.scene.making.relief import FacePlaces, Relief

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


class ReliefFace:
    """A designed face with the relief that manufacture adds to it; a `TracedFace`.

    Relief turns normals; it is too low to change where rays meet the face. x and y are those of
    the element.

    `face`: the face without relief; `reliefs`: each with the rms width by which later steps smooth
    it; `outward`: 1 if it is seen from +z, -1 from -z.
    """

    def __init__(
        self,
        face: TracedFace,
        reliefs: Sequence[tuple[Relief, float]],
        outward: int,
    ) -> None:
        self.missed = face.missed
        self._face, self._reliefs, self._outward = face, reliefs, outward

    def meet(self, rays: TracedRays) -> Crossings:
        """Where rays meet it; see `TracedFace.meet`."""
        found = self._face.meet(rays)
        lit = found.flux > 0
        normal, (x, y) = found.normal[lit], found.position[lit, :2].T
        slope_x, slope_y = -normal[:, 0] / normal[:, 2], -normal[:, 1] / normal[:, 2]
        sign = self._outward
        places = FacePlaces(x, y, sign * slope_x, sign * slope_y)
        for relief, smoothing in self._reliefs:
            more_x, more_y = relief.slopes(places, smoothing)
            slope_x, slope_y = slope_x + sign * more_x, slope_y + sign * more_y
        turned = np.stack([-slope_x, -slope_y, np.ones_like(slope_x)], axis=1)
        turned /= np.linalg.norm(turned, axis=1, keepdims=True) * np.sign(normal[:, 2:])
        normals = found.normal.copy()
        normals[lit] = turned
        return found._replace(normal=normals)

    def met_again(self, rays: TracedRays, onwards: int) -> Array:
        """See `TracedFace.met_again`; relief plays no part."""
        return self._face.met_again(rays, onwards)
