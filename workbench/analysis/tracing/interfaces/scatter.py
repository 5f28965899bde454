"""The boundary that scatters: a random direction for each ray. A new law is a row in ``_LAWS``."""

import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from workbench.analysis.tracing.elements import Crossings, TracedRays
from workbench.arrays import Array
from workbench.scene import Diffuser, GaussianScatter, LambertianScatter


class ScatterBoundary:
    """A diffuser; a `Boundary`.

    Random numbers come from the first ray: batches and threads do not share any.

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
        first = np.concatenate([rays.position[0], rays.direction[0]])
        random = np.random.default_rng(first.view(np.uint64).tolist())
        normal = np.broadcast_to(crossings.normal, crossings.position.shape)
        before = np.broadcast_to(rays.direction, crossings.position.shape)
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
