"""A plane across the axis of the lens, with the outline of the lens."""

import numpy as np

from workbench.analysis.tracing.elements import Crossings, TracedRays
from workbench.analysis.tracing.kernels import meet_plane
from workbench.arrays import Array
from workbench.geometry.outlines import Outline


class FlatFace:
    """Plate about the axis; a `TracedFace`.

    Parameters
    ----------
    z : float
        Where it is, over the entrance face.
    outline : Outline
        What of the plane is glass.
    missed : str
        See `TracedFace`.
    """

    def __init__(self, z: float, outline: Outline, missed: str) -> None:
        self.missed = missed
        self._z, self._half_width = z, outline.half_width
        self._curved = not outline.whole
        self._normal = np.array([[0.0, 0.0, 1.0]])

    def meet(self, rays: TracedRays) -> Crossings:
        """Where rays meet it; see `TracedFace.meet`."""
        # Rays that do not meet it get the origin: memory as it comes might hold any number.
        position, flux = np.zeros_like(rays.position), np.empty_like(rays.flux)
        meet_plane(*rays, self._z, self._half_width, self._curved, position, flux)
        return Crossings(position, self._normal, flux)

    def met_again(self, rays: TracedRays, onwards: int) -> Array:
        """Nowhere: it is flat; see `TracedFace.met_again`."""
        return np.full((len(rays.flux), 2), np.nan)
