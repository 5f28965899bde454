"""Refraction between two media, with the light that is reflected there."""

import math
from collections.abc import Mapping

import numpy as np

from workbench.analysis.tracing.elements import Crossings, TracedRays
from workbench.compiled import jit


class DielectricBoundary:
    """Snell's law, and Schlick's reflectance; a `Boundary`.

    Parameters
    ----------
    before, behind : float
        Refractive indices on the sides from which and to which the light goes.
    reflected : str
        Name in the light account of what is reflected where the rest is refracted; under total
        reflection it is ``total_reflection``.
    """

    def __init__(self, before: float, behind: float, reflected: str) -> None:
        self._ratio, self._reflected = before / behind, reflected

    def turn(
        self, rays: TracedRays, crossings: Crossings
    ) -> tuple[TracedRays, Mapping[str, float]]:
        """The refracted light, and what is reflected; see `Boundary.turn`."""
        columns = max(rays.direction.shape[0], crossings.normal.shape[0])
        # Parallel rays at a flat face are all refracted as one is.
        alike = columns == 1
        flux = np.ones(1) if alike else crossings.flux
        direction, passed = np.empty((len(flux), 3)), np.empty_like(flux)
        total, reflected = _refract(
            rays.direction, crossings.normal, flux, self._ratio, direction, passed
        )
        if alike:
            light = float(crossings.flux.sum())
            total, reflected = total * light, reflected * light
            passed = passed * crossings.flux
        lost = {"total_reflection": total, self._reflected: reflected}
        return TracedRays(crossings.position, direction, passed), lost


@jit(error_model="numpy")
def _refract(direction, normal, flux, ratio, turned, passed):  # type: ignore[no-untyped-def]
    """Get directions (m, 3) and flux (m,) behind a face.

    Parameters
    ----------
    direction, normal : array, shape (m, 3) or (1, 3)
        Unit vectors before the face, and of the face.
    flux : array, shape (m,)
        Flux before it; rays that have none are left as they are.
    ratio : float
        Refractive index before the face over that behind it.
    turned, passed : array, shapes (m, 3), (m,)
        Get direction and flux behind it.

    Returns
    -------
    total, reflected : float
        Flux of rays that are totally reflected, and flux that others lose.
    """
    head_on = ((ratio - 1) / (ratio + 1)) ** 2
    step, step_n = int(direction.shape[0] > 1), int(normal.shape[0] > 1)
    total = reflected = 0.0
    for ray in range(len(flux)):
        passed[ray] = 0.0
        if flux[ray] == 0:
            continue
        k, k_n = ray * step, ray * step_n
        d_x, d_y, d_z = direction[k, 0], direction[k, 1], direction[k, 2]
        n_x, n_y, n_z = normal[k_n, 0], normal[k_n, 1], normal[k_n, 2]
        # Snell's law changes the angle between ray and normal, in the plane that holds both.
        along = d_x * n_x + d_y * n_y + d_z * n_z
        a_x, a_y, a_z = d_x - along * n_x, d_y - along * n_y, d_z - along * n_z
        sine = ratio * math.sqrt(a_x * a_x + a_y * a_y + a_z * a_z)
        if sine >= 1 or along <= 0:
            total += flux[ray]
            continue
        cosine = math.sqrt((1 - sine) * (1 + sine))
        turned[ray, 0] = cosine * n_x + ratio * a_x
        turned[ray, 1] = cosine * n_y + ratio * a_y
        turned[ray, 2] = cosine * n_z + ratio * a_z
        # Schlick (1994), eq. 24: the cosine is that in the thinner medium.
        thinner = cosine if ratio > 1 else along
        loss = flux[ray] * (head_on + (1 - head_on) * (1 - thinner) ** 5)
        reflected += loss
        passed[ray] = flux[ray] - loss
    return total, reflected
