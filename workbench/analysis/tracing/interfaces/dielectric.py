"""Refraction between two media, with the light that is absorbed before and reflected there."""

from collections.abc import Mapping
from typing import Literal

import numpy as np

from workbench.analysis.tracing.elements import Crossings, TracedRays
from workbench.analysis.tracing.kernels import LAWS, refract
from workbench.arrays import Array
from workbench.scene import Lens

Reflectance = Literal["fresnel", "schlick"] | float
"""By an equation, or the same at all angles."""


def reflectances(lens: Lens) -> tuple[Reflectance, Reflectance]:
    """Of the entrance face and the exit face."""
    if lens.coating is not None:
        return lens.coating
    bare = 0.0 if lens.reflection == "none" else lens.reflection
    return bare, bare


class DielectricBoundary:
    """Snell's law, and what does not pass the face; a `Boundary`.

    Parameters
    ----------
    before, behind : float
        Refractive indices on the sides from which and to which the light goes.
    reflected : str
        Name in the light account of what is reflected where the rest is refracted; under total
        reflection it is ``total_reflection``.
    reflectance : "fresnel", "schlick" or float
        How much of the light that is not totally reflected: by Fresnel's equations for
        unpolarised light, by Schlick's approximation to them, or the same part at all angles.
    absorption : float
        Of the medium before the face, per length; called ``absorbed`` in the light account.
    """

    onwards = 1

    def __init__(
        self,
        before: float,
        behind: float,
        reflected: str,
        reflectance: Reflectance = "schlick",
        absorption: float = 0.0,
    ) -> None:
        self._ratio, self._reflected, self._absorption = before / behind, reflected, absorption
        self._head_on = ((before - behind) / (before + behind)) ** 2
        if isinstance(reflectance, float):
            self._law, self._head_on = LAWS["constant"], reflectance
        else:
            self._law = LAWS[reflectance]

    def turn(
        self, rays: TracedRays, crossings: Crossings
    ) -> tuple[TracedRays, Mapping[str, Array]]:
        """The refracted light, and what is reflected; see `Boundary.turn`."""
        lost = {}
        arriving = crossings.flux
        if self._absorption > 0:
            arriving = crossings.flux * self._clear(rays.position, crossings)
            lost["absorbed"] = crossings.flux - arriving
        # Parallel rays at a flat face are all refracted as one is.
        alike = max(rays.direction.shape[0], crossings.normal.shape[0]) == 1
        flux = np.ones(1) if alike else arriving
        direction, passed, total = (
            np.empty((len(flux), 3)),
            np.empty_like(flux),
            np.empty_like(flux),
        )
        face = self._ratio, self._law, self._head_on
        refract(rays.direction, crossings.normal, flux, face, direction, passed, total)
        if alike:
            passed, total = passed * arriving, total * arriving
        lost |= {"total_reflection": total, self._reflected: arriving - passed - total}
        return TracedRays(crossings.position, direction, passed), lost

    def _clear(self, start: Array, crossings: Crossings) -> Array:
        """Part of the light of each ray that the medium lets through."""
        way = np.where(crossings.flux[:, None] > 0, crossings.position - start, 0.0)
        return np.asarray(np.exp(-self._absorption * np.linalg.norm(way, axis=1)))
