"""A face as a ball cutter leaves it, with its ridges."""

from workbench.analysis.tracing.elements import Crossings, TracedFace, TracedRays
from workbench.arrays import Array
from workbench.geometry.ball_cutter import Raster

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
