"""Refraction between two media, with the light that is absorbed before and reflected there."""

import math
from collections.abc import Mapping
from typing import Literal

import numpy as np

from workbench.analysis.tracing.elements import Crossings, TracedRays
from workbench.arrays import Array
from workbench.compiled import jit
from workbench.scene import Lens

Reflectance = Literal["fresnel", "schlick"] | float
"""By an equation, or the same at all angles."""

_SCHLICK, _CONSTANT, _FRESNEL = range(3)


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
        match reflectance:
            case "fresnel":
                self._law = _FRESNEL
            case "schlick":
                self._law = _SCHLICK
            case float(part):
                self._law, self._head_on = _CONSTANT, part

    def turn(
        self, rays: TracedRays, crossings: Crossings
    ) -> tuple[TracedRays, Mapping[str, float]]:
        """The refracted light, and what is reflected; see `Boundary.turn`."""
        lost = {}
        if self._absorption > 0:
            arriving = crossings.flux * self._clear(rays.position, crossings)
            lost["absorbed"] = float((crossings.flux - arriving).sum())
            crossings = crossings._replace(flux=arriving)
        columns = max(rays.direction.shape[0], crossings.normal.shape[0])
        # Parallel rays at a flat face are all refracted as one is.
        alike = columns == 1
        flux = np.ones(1) if alike else crossings.flux
        direction, passed = np.empty((len(flux), 3)), np.empty_like(flux)
        total, reflected = _refract(
            rays.direction,
            crossings.normal,
            flux,
            (self._ratio, self._law, self._head_on),
            direction,
            passed,
        )
        if alike:
            light = float(crossings.flux.sum())
            total, reflected = total * light, reflected * light
            passed = passed * crossings.flux
        lost |= {"total_reflection": total, self._reflected: reflected}
        return TracedRays(crossings.position, direction, passed), lost

    def _clear(self, start: Array, crossings: Crossings) -> Array:
        """Part of the light of each ray that the medium lets through."""
        way = np.where(crossings.flux[:, None] > 0, crossings.position - start, 0.0)
        return np.asarray(np.exp(-self._absorption * np.linalg.norm(way, axis=1)))


@jit(error_model="numpy")
def _refract(direction, normal, flux, face, turned, passed):  # type: ignore[no-untyped-def]
    """Get directions (m, 3) and flux (m,) behind a face.

    Parameters
    ----------
    direction, normal : array, shape (m, 3) or (1, 3)
        Unit vectors before the face, and of the face.
    flux : array, shape (m,)
        Flux before it; rays that have none are left as they are.
    face : tuple of float, int, float
        Refractive index before the face over that behind it, the law of its reflectance, and that
        at normal incidence.
    turned, passed : array, shapes (m, 3), (m,)
        Get direction and flux behind it.

    Returns
    -------
    total, reflected : float
        Flux of rays that are totally reflected, and flux that others lose.
    """
    ratio, law, head_on = face
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
        reflectance = head_on
        if law == _SCHLICK:
            # Schlick (1994), eq. 24: the cosine is that in the thinner medium.
            thinner = cosine if ratio > 1 else along
            reflectance += (1 - head_on) * (1 - thinner) ** 5
        elif law == _FRESNEL:
            across = (ratio * along - cosine) / (ratio * along + cosine)
            within = (along - ratio * cosine) / (along + ratio * cosine)
            reflectance = (across * across + within * within) / 2
        loss = flux[ray] * reflectance
        reflected += loss
        passed[ray] = flux[ray] - loss
    return total, reflected
