"""The boundary that scatters: a random direction for each ray."""

import math
from collections.abc import Mapping

import numpy as np

from workbench.analysis.tracing.elements import Crossings, TracedRays
from workbench.arrays import Array
from workbench.scene import Diffuser, GaussianScatter


class ScatterBoundary:
    """A diffuser; a `Boundary`.

    Random numbers come from the first ray: batches and threads do not share any.

    `diffuser`: how it scatters; what it absorbs is called ``absorbed_diffuser`` in the light
    account.
    """

    def __init__(self, diffuser: Diffuser) -> None:
        self._transmittance = diffuser.transmittance
        scatter = diffuser.scatter
        self._sigma = None
        if isinstance(scatter, GaussianScatter):
            self._sigma = math.radians(scatter.sigma)

    def turn(
        self, rays: TracedRays, crossings: Crossings
    ) -> tuple[TracedRays, Mapping[str, float]]:
        """The scattered light, and what is absorbed; see `Boundary.turn`."""
        flux = self._transmittance * crossings.flux
        lost = {}
        if self._transmittance < 1:
            lost = {"absorbed_diffuser": float(crossings.flux.sum() - flux.sum())}
        if not len(flux):
            return TracedRays(crossings.position, rays.direction, flux), lost
        first = np.concatenate([rays.position[0], rays.direction[0]])
        random = np.random.default_rng(first.view(np.uint64).tolist())
        normal = np.broadcast_to(crossings.normal, crossings.position.shape)
        if self._sigma is None:
            square = random.random(len(flux))  # of the sine: flux is as the cosine
            direction = _around(normal, np.sqrt(1 - square), np.sqrt(square), random)
        else:
            before = np.broadcast_to(rays.direction, crossings.position.shape)
            direction = self._about(np.where(flux[:, None] > 0, before, normal), normal, random)
        return TracedRays(crossings.position, direction, flux), lost

    def _about(self, before: Array, normal: Array, random: np.random.Generator) -> Array:
        """Directions about those before, drawn again until they are onwards."""
        assert self._sigma is not None
        direction = np.empty_like(before)
        left = np.arange(len(before))
        while len(left):
            # θ exp(−θ²/2σ²) by its inverse, of which sin θ / θ are kept: sin θ exp(−θ²/2σ²).
            angle = self._sigma * np.sqrt(-2 * np.log1p(-random.random(len(left))))
            kept = (angle < math.pi) & (random.random(len(left)) < np.sinc(angle / math.pi))
            found = _around(before[left], np.cos(angle), np.sin(angle), random)
            kept &= np.einsum("ij,ij->i", found, normal[left]) > 0
            direction[left[kept]] = found[kept]
            left = left[~kept]
        return direction


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
