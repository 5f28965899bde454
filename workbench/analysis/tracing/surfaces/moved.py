"""The exit face of a lens that is out of its place over the entrance face."""

import numpy as np
from scipy.spatial.transform import Rotation

from workbench.analysis.tracing.elements import Crossings, TracedRays
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.surfaces.spline import SplineFace
from workbench.arrays import Array
from workbench.scene import Lens


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
