"""Light that a face or the receiver blocks, which the design and the check ignore.

A deep mirror sends light onto itself, and a screen on the axis blocks the light of a mirror. The
images count such light as if nothing blocked it; random rays measure how much of it there is.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from workbench.analysis.tracing.elements import TracedRays
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.sources.sampling import BATCHES
from workbench.analysis.tracing.train import OpticalTrain
from workbench.arrays import Array
from workbench.messages import Message
from workbench.scene import Scene

SHADED = "meets the face again", "comes through the screen"
"""Names of the figures."""

_RAYS = 40_000
_PARTS = 8  # of the face along x and y, of which the brightest is reported


@dataclass(frozen=True)
class Shading:
    """Blocked light, as parts of the emitted flux."""

    meets_again: float  # leaves a face and meets it again
    at: tuple[float, float] | None  # x and y of the brightest part of that face, scene units
    through_receiver: float  # comes to a face through the receiver

    @property
    def figures(self) -> dict[str, Message]:
        """Blocked light in words, by the names of `SHADED`; empty without any."""
        parts = dict(zip(SHADED, (self.meets_again, self.through_receiver), strict=True))
        figures = {
            name: Message("{part:.3g} % of the light", part=100 * part)
            for name, part in parts.items()
            if part
        }
        if self.at is not None:
            x, y = self.at
            figures[SHADED[0]] = Message(
                "{share}, most around ({x:.4g}, {y:.4g})", share=figures[SHADED[0]], x=x, y=y
            )
        return figures

    def to_data(self) -> dict[str, Any]:
        """The figures by name, for JSON."""
        return {
            "meets_again": self.meets_again,
            "at": self.at and list(self.at),
            "through_receiver": self.through_receiver,
        }


def shading_of(
    scene: Scene, heights: Mapping[str, Array], seed: int, pose: Pose | None = None
) -> Shading:
    """Measure the blocked light of all faces by random rays, at the first wavelength."""
    scene = scene.lines[0].scene
    train = OpticalTrain.of(scene, heights, _RAYS, seed, pose or Pose(), [scene.receiver])
    emitted = through = 0.0
    back: list[list[tuple[Array, Array]]] = [[] for _ in train.faces]
    for number in range(BATCHES):
        for rays in train.source.batch(number):
            emitted += float(rays.flux.sum()) * (1 + train.source.beside)
            points = train.source.places
            far = np.full(3, -np.inf) if points is None else points.mean(axis=0)
            begin = np.broadcast_to(far, rays.position.shape)
            for (face, boundary), returned in zip(train.faces, back, strict=True):
                crossings = face.meet(rays)
                lit = crossings.flux > 0
                place, flux = crossings.position[lit], crossings.flux[lit]
                ways = np.broadcast_to(rays.direction, rays.position.shape)[lit]
                length = np.linalg.norm(place - begin[lit], axis=1)
                in_the_way = train.detector.in_the_way(TracedRays(place, ways, flux), length)
                through += float(flux[in_the_way].sum())
                rays, _ = boundary.turn(rays, crossings)
                begin = rays.position
                again = face.met_again(rays, boundary.onwards)
                known = np.isfinite(again[:, 0])
                returned.append((again[known], rays.flux[known]))
    places, fluxes = zip(
        *(map(np.concatenate, zip(*each, strict=True)) for each in back), strict=True
    )
    sums = [float(flux.sum()) for flux in fluxes]
    most = int(np.argmax(sums))
    middle = _brightest(places[most], fluxes[most]) if sums[most] else None
    return Shading(sum(sums) / emitted, middle, through / emitted)


def _brightest(at: Array, flux: Array) -> tuple[float, float]:
    """Centre of the light in the brightest part of a face."""
    half_width = np.abs(at).max(axis=0).clip(min=np.finfo(float).tiny)
    part = ((at / half_width + 1) / 2 * _PARTS).astype(np.intp).clip(0, _PARTS - 1)
    number = part[:, 0] * _PARTS + part[:, 1]
    most = number == np.bincount(number, flux).argmax()
    x, y = np.average(at[most], axis=0, weights=flux[most])
    return float(x), float(y)
