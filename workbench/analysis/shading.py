"""Light that the last face or the receiver blocks, which the design and the check ignore.

A deep mirror sends light onto itself, and a screen on the axis blocks the light of a mirror. The
images count such light as if nothing blocked it; random rays measure how much of it there is.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.sources.cells import BATCHES
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

    meets_again: float  # leaves the last face and meets it again
    at: tuple[float, float] | None  # x and y of the brightest part, scene units
    through_receiver: float  # comes to the first face through the receiver

    @property
    def figures(self) -> dict[str, Message]:
        """Blocked light in words, by the names of `SHADED`; empty without any."""
        parts = dict(zip(SHADED, (self.meets_again, self.through_receiver), strict=True))
        said = {
            name: Message("{part:.3g} % of the light", part=100 * part)
            for name, part in parts.items()
            if part
        }
        if self.at is not None:
            x, y = self.at
            said[SHADED[0]] = Message(
                "{share}, most around ({x:.4g}, {y:.4g})", share=said[SHADED[0]], x=x, y=y
            )
        return said

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
    """Measure the blocked light by random rays."""
    scene.check_one_element("the search for light that comes back")
    pose = pose or Pose()
    train = OpticalTrain.of(scene, heights, _RAYS, seed, pose, [scene.receiver])
    begin = -np.inf if scene.source.place is None else scene.source.place[2]
    emitted = through = 0.0
    places, fluxes = [], []
    for number in range(BATCHES):
        for rays in train.source.batch(number):
            emitted += float(rays.flux.sum()) * (1 + train.source.beside)
            first = train.faces[0][0].meet(rays)
            arrives = rays._replace(position=first.position, flux=first.flux)
            through += float(first.flux[train.detector.in_the_way(arrives, begin)].sum())
            leaves = train.leaving(rays)
            where = train.faces[-1][0].met_again(leaves, scene.optic.onwards)
            back = np.isfinite(where[:, 0])
            places.append(where[back])
            fluxes.append(leaves.flux[back])
    at, flux = np.concatenate(places), np.concatenate(fluxes)
    middle = _brightest(at, flux, scene.optic.half_width) if flux.size else None
    return Shading(float(flux.sum()) / emitted, middle, through / emitted)


def _brightest(at: Array, flux: Array, half_width: tuple[float, float]) -> tuple[float, float]:
    """Centre of the light in the brightest part of the face."""
    part = ((at / half_width + 1) / 2 * _PARTS).astype(np.intp).clip(0, _PARTS - 1)
    number = part[:, 0] * _PARTS + part[:, 1]
    most = number == np.bincount(number, flux).argmax()
    x, y = np.average(at[most], axis=0, weights=flux[most])
    return float(x), float(y)
