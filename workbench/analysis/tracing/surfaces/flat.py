"""A plane across the axis of the lens, with a rectangular outline."""

import numpy as np

from workbench.analysis.tracing.elements import Crossings, TracedRays
from workbench.compiled import jit


class FlatFace:
    """Rectangle about the axis; a `Face`.

    Parameters
    ----------
    z : float
        Where it is, over the entrance face.
    half_width : tuple[float, float]
        Its half-widths, scene units.
    missed : str
        See `Face`.
    """

    def __init__(self, z: float, half_width: tuple[float, float], missed: str) -> None:
        self.missed = missed
        self._z, self._half_width = z, half_width
        self._normal = np.array([[0.0, 0.0, 1.0]])

    def meet(self, rays: TracedRays) -> Crossings:
        """Where rays meet it; see `Face.meet`."""
        position, flux = np.empty_like(rays.position), np.empty_like(rays.flux)
        missed = _meet(*rays, self._z, self._half_width, position, flux)
        return Crossings(position, self._normal, flux, missed)


@jit(error_model="numpy")
def _meet(position, direction, flux, z, half_width, place, met):  # type: ignore[no-untyped-def]
    """Get places (m, 3) and the flux (m,) that meets the face; returns the flux that does not."""
    r_x, r_y = half_width
    step = int(direction.shape[0] > 1)
    missed = 0.0
    for ray in range(len(flux)):
        d_z = direction[ray * step, 2]
        path = (z - position[ray, 2]) / d_z
        x = position[ray, 0] + path * direction[ray * step, 0]
        y = position[ray, 1] + path * direction[ray * step, 1]
        if d_z > 0 and abs(x) <= r_x and abs(y) <= r_y:
            place[ray, 0], place[ray, 1], place[ray, 2] = x, y, z
            met[ray] = flux[ray]
        else:
            met[ray] = 0.0
            missed += flux[ray]
    return missed
