"""What a face does to the light that meets it: a class a kind; laws of scatter are in ``_LAWS``."""

import math
from collections.abc import Callable, Mapping
from typing import Any, Literal

import numpy as np

from workbench.analysis.tracing.elements import Crossings, TracedRays
from workbench.analysis.tracing.kernels import LAWS, refract
from workbench.arrays import Array
from workbench.scene import Diffuser, GaussianScatter, LambertianScatter, Lens

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


class ScatterBoundary:
    """A diffuser; a `Boundary`.

    Random numbers come from the first lit ray: batches and threads do not share any.

    `diffuser`: how it scatters; what it absorbs is called ``absorbed_diffuser`` in the light
    account.
    """

    onwards = 1

    def __init__(self, diffuser: Diffuser) -> None:
        self._transmittance, self._scatter = diffuser.transmittance, diffuser.scatter

    def turn(
        self, rays: TracedRays, crossings: Crossings
    ) -> tuple[TracedRays, Mapping[str, Array]]:
        """The scattered light, and what is absorbed; see `Boundary.turn`."""
        flux = self._transmittance * crossings.flux
        lost = {"absorbed_diffuser": crossings.flux - flux}
        if not len(flux):
            return TracedRays(crossings.position, rays.direction, flux), lost
        normal = np.broadcast_to(crossings.normal, crossings.position.shape)
        before = np.broadcast_to(rays.direction, crossings.position.shape)
        lit = int(np.argmax(flux > 0))  # where a lost ray is, is not known
        first = np.concatenate([rays.position[lit], before[lit]])
        random = np.random.default_rng(first.view(np.uint64).tolist())
        before = np.where(flux[:, None] > 0, before, normal)
        direction = _LAWS[type(self._scatter)](self._scatter, before, normal, random)
        return TracedRays(crossings.position, direction, flux), lost


def _gaussian(
    scatter: GaussianScatter, before: Array, normal: Array, random: np.random.Generator
) -> Array:
    """Directions about those before, drawn again until they are onwards."""
    sigma, direction = math.radians(scatter.sigma), np.empty_like(before)
    left = np.arange(len(before))
    while len(left):
        # θ exp(−θ²/2σ²) by its inverse, of which sin θ / θ are kept: sin θ exp(−θ²/2σ²).
        angle = sigma * np.sqrt(-2 * np.log1p(-random.random(len(left))))
        kept = (angle < math.pi) & (random.random(len(left)) < np.sinc(angle / math.pi))
        found = _around(before[left], np.cos(angle), np.sin(angle), random)
        kept &= np.einsum("ij,ij->i", found, normal[left]) > 0
        direction[left[kept]] = found[kept]
        left = left[~kept]
    return direction


def _lambertian(
    scatter: LambertianScatter, before: Array, normal: Array, random: np.random.Generator
) -> Array:
    square = random.random(len(before))  # of the sine: flux is as the cosine
    return _around(normal, np.sqrt(1 - square), np.sqrt(square), random)


_LAWS: Mapping[type, Callable[[Any, Array, Array, np.random.Generator], Array]] = {
    GaussianScatter: _gaussian,
    LambertianScatter: _lambertian,
}


def _around(axis: Array, cosine: Array, sine: Array, random: np.random.Generator) -> Array:
    """Directions at angles to axes (m, 3), turned about them at random."""
    turn = 2 * math.pi * random.random(len(axis))
    # Two sides across each axis: the first is across the coordinate that the axis has least of.
    least = np.eye(3)[np.abs(axis).argmin(axis=1)]
    first = np.cross(axis, least)
    first /= np.linalg.norm(first, axis=1, keepdims=True)
    second = np.cross(axis, first)
    across = np.cos(turn)[:, None] * first + np.sin(turn)[:, None] * second
    return np.ascontiguousarray(cosine[:, None] * axis + sine[:, None] * across)
