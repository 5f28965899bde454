"""What compiled traces of parallel light along the axis have in common.

Their rays are a tensor grid that goes straight on to the first freeform face: no intersection, and
slopes by small matrix products. The loops are those of `workbench.optics.kernels.rows`. Nothing is
kept for the way back: it traces the same rays again, which costs less than memory.
"""

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import Array, Mask
from workbench.geometry.surface import ControlNet
from workbench.optics.halves import Halves
from workbench.optics.kernels.function import Sums, kind_of, trace
from workbench.optics.kernels.grid import Axis, make_axis
from workbench.optics.kernels.locked import Rays, count, split
from workbench.optics.kernels.passes import GridLanding, GridPasses
from workbench.optics.kernels.spread import Spread, make_spread
from workbench.optics.light import Light, Nodes
from workbench.optics.path import Path
from workbench.optics.samples import Samples, places
from workbench.optics.sources import CollimatedEmitter
from workbench.said import Said
from workbench.scene import BoxFilter, Filter


class ParallelRays(ABC):
    """A tensor grid of rays; a `workbench.optics.light.Tracer`.

    Parameters
    ----------
    path : Path
        The path of the light.
    emitter : CollimatedEmitter
        Its source.
    net : ControlNet
        Where the control heights of its freeform face sit.
    face : str
        Name of that face.
    mirrored : tuple[bool, bool]
        Whether heights, optic and locks are mirror images of themselves in x, in y: then the rays
        of one half are traced alone, if their number is even.
    locked : ndarray of bool, shape (n_u, n_v), optional
        Control points whose heights are the same in all optics to come; rays that see none of the
        others are traced for the first one alone.
    """

    note: str
    """What is left out, in words."""

    def __init__(
        self,
        path: Path,
        emitter: CollimatedEmitter,
        net: ControlNet,
        face: str,
        mirrored: tuple[bool, bool],
        locked: Mask | None,
    ) -> None:
        samples, self._net = emitter.samples, net
        self._name, self._dtype, self.kind = face, path.dtype, kind_of(path.dtype)
        self._halves, self._emitter = Halves.of(samples, (1, 1), mirrored), emitter
        self.mirrored = self._halves.mirrored
        shares = [emitter.shares(axis) for axis in (0, 1)]
        across, up = (
            rays_along(net, samples, axis, shares[axis], self._halves, self.kind) for axis in (0, 1)
        )
        self._all, self._inside = (across, up), emitter.inside
        self._moving, self._still = split((across, up), locked)
        self._still_light: tuple[Filter, Tensor, Sums] | None = None
        self.traced = count(self._moving) / count((across, up))
        self._level, self.receiver = path.datum, path.receiver

    @abstractmethod
    def passes(self, rays: Rays, spread: Spread) -> GridPasses:
        """The trace of some of the rays, and its adjoint."""

    @abstractmethod
    def light(self, flux: Tensor, sums: Sums) -> Light:
        """An image or nodes, and the account of its light."""

    @property
    def notes(self) -> list[str]:
        """See `workbench.optics.light.Tracer`."""
        notes = [self.note, *self._halves.notes]
        if self.traced < 1:
            notes.append(
                Said(
                    "locked control points: {part:.0f} % of the rays after the first iteration",
                    part=100 * self.traced,
                )
            )
        return notes

    @property
    def splits(self) -> tuple[Array, Array]:
        """See `workbench.optics.light.BeamTracer`."""
        return self._halves.splits(self._emitter.splits)

    def inside(self, rays: Rays) -> Array:
        """Part of what some rays stand for that is glass: a row for each v, or one for all."""
        if self._inside is None:
            return np.ones((1, len(rays[0].place)))
        columns, rows = (
            np.searchsorted(every.place, some.place)
            for every, some in zip(self._all, rays, strict=True)
        )
        return self._inside[columns].T[rows]

    def image(self, heights: Mapping[str, Tensor], filter: Filter) -> Light:
        """Trace a lens; see `workbench.optics.light.Tracer`."""
        spread = make_spread(self.receiver, filter, self.kind)
        face = heights[self._name]

        def traced(rays: Rays) -> tuple[Tensor, Sums]:
            return trace(face, self._net, self._level, self._dtype, self.passes(rays, spread))

        flux, sums = traced(self._moving)
        if self._still:
            if self._still_light is None or self._still_light[0] != filter:
                with torch.no_grad():
                    parts = [traced(rays) for rays in self._still]
                self._still_light = filter, *_together(parts)
            flux, sums = _together([(flux, sums), self._still_light[1:]])
        return self.light(flux, sums)

    def nodes(self, heights: Mapping[str, Tensor]) -> Nodes:
        """Trace the corners of cells of light; see `workbench.optics.light.BeamTracer`."""
        spread = make_spread(self.receiver, BoxFilter(), self.kind)
        landing = GridLanding(self.passes(self._moving, spread))
        traced = trace(heights[self._name], self._net, self._level, self._dtype, landing)
        return Nodes(*self.light(*traced))


def rays_along(
    net: ControlNet,
    samples: Samples,
    axis: int,
    share: Array,
    halves: Halves,
    kind: type[np.floating[Any]],
) -> Axis:
    """All rays along an axis, or the first half of them; see `CollimatedEmitter.shares`."""
    part = halves.first(places(samples, axis).part, axis)
    return make_axis(net, axis, part, kind, halves.weighted(share, axis))


def _together(parts: Sequence[tuple[Tensor, Sums]]) -> tuple[Tensor, Sums]:
    """The light of several sets of rays."""
    images, sums = zip(*parts, strict=True)
    return sum(images[1:], images[0]), Sums(*map(sum, zip(*sums, strict=True)))
