"""The boundary that reflects."""

from collections.abc import Mapping

import numpy as np

from workbench.analysis.tracing.elements import Crossings, TracedRays
from workbench.arrays import Array


class MirrorBoundary:
    """Angles of incidence and reflection are the same; a `Boundary`.

    `reflectance`: part of the light that is reflected; the rest is called ``absorbed_mirror`` in
    the light account.
    """

    onwards = -1

    def __init__(self, reflectance: float) -> None:
        self._reflectance = reflectance

    def turn(
        self, rays: TracedRays, crossings: Crossings
    ) -> tuple[TracedRays, Mapping[str, Array]]:
        """The reflected light, and what is absorbed; see `Boundary.turn`."""
        normal = np.where(crossings.flux[:, None] > 0, crossings.normal, 0.0)
        along = np.einsum("mk,mk->m", *np.broadcast_arrays(rays.direction, normal))
        direction = rays.direction - 2 * along[:, None] * normal
        flux = self._reflectance * crossings.flux
        lost = {"absorbed_mirror": crossings.flux - flux} if self._reflectance < 1 else {}
        return TracedRays(crossings.position, np.ascontiguousarray(direction), flux), lost
