"""A face of an element that stands elsewhere than where positions of the walk are counted from."""

import numpy as np

from workbench.analysis.tracing.elements import Crossings, TracedFace, TracedRays
from workbench.arrays import Array

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
        position = (rays.position - self._shift) @ self._turn
        direction = np.ascontiguousarray(rays.direction @ self._turn)
        return rays._replace(position=position, direction=direction)
