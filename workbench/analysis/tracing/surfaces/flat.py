"""A plane across the axis of the lens, with the outline of the lens."""

import numpy as np

from workbench.analysis.tracing.elements import Crossings, FaceLight, TracedRays
from workbench.arrays import Array
from workbench.compiled import jit
from workbench.geometry.outlines import Outline

# Of a place on the rim of an ellipse the squares of x and y over the semi-axes add up to 1, or to
# a little more by rounding.
RIM = 1 + 1e-12


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
        missed = _meet(*rays, self._z, self._half_width, self._curved, position, flux)
        return Crossings(position, self._normal, flux, missed)

    def met_again(self, rays: TracedRays, onwards: int) -> Array:
        """Nowhere: it is flat; see `TracedFace.met_again`."""
        return np.full((len(rays.flux), 2), np.nan)

    def lit(self, source: FaceLight, origin: int, x: Array, y: Array) -> TracedRays:
        """See `TracedFace.lit`."""
        return source.through(origin, x, y, self._z)


@jit(error_model="numpy")
def _meet(  # type: ignore[no-untyped-def]
    position, direction, flux, z, half_width, curved, place, met
):
    """Get places (m, 3) and the flux (m,) that meets the face; returns the flux that does not."""
    r_x, r_y = half_width
    step = int(direction.shape[0] > 1)
    missed = 0.0
    for ray in range(len(flux)):
        d_z = direction[ray * step, 2]
        path = (z - position[ray, 2]) / d_z
        x = position[ray, 0] + path * direction[ray * step, 0]
        y = position[ray, 1] + path * direction[ray * step, 1]
        across, up = x / r_x, y / r_y
        within = across * across + up * up <= RIM if curved else abs(x) <= r_x and abs(y) <= r_y
        if d_z > 0 and within:
            place[ray, 0], place[ray, 1], place[ray, 2] = x, y, z
            met[ray] = flux[ray]
        else:
            met[ray] = 0.0
            missed += flux[ray]
    return missed
