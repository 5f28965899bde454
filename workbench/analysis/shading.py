"""What the design and the check ignore: light that is in its own way, or behind the receiver.

A mirror that is a deep bowl sends light to itself, and a screen on the axis stands in the light of
the mirror. The images count all such light as if nothing were in its way; here it is said how much
of it there is, by random rays.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.sources.cells import BATCHES
from workbench.analysis.tracing.train import OpticalTrain
from workbench.arrays import Array
from workbench.said import Said
from workbench.scene import Scene

SHADED = "meets the face again", "comes through the screen"
"""Names of the figures."""

_RAYS = 40_000
# Parts of the face along x and y; the brightest says where light comes back to it.
_PARTS = 8


@dataclass(frozen=True)
class Shading:
    """Light that something is in the way of."""

    meets_again: float  # part of the emitted light that leaves the last face and comes back to it
    at: tuple[float, float] | None  # about where most of it comes back, x and y in scene units
    # Part of the emitted light that comes to the first face through the receiver.
    through_receiver: float

    @property
    def figures(self) -> dict[str, Said]:
        """What there is to say, by the names of `SHADED`; nothing where nothing is in the way."""
        parts = dict(zip(SHADED, (self.meets_again, self.through_receiver), strict=True))
        said = {
            name: Said("{part:.3g} % of the light", part=100 * part)
            for name, part in parts.items()
            if part
        }
        if self.at is not None:
            x, y = self.at
            said[SHADED[0]] = Said(
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
    """Look along some random rays for what is in their way."""
    scene.check_one_element("the search for light that comes back")
    pose = pose or Pose()
    train = OpticalTrain.of(scene, heights, _RAYS, seed, pose, [scene.receiver])
    # Sources that are somewhere stand at a z; others are far away.
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
    """The middle of the light in the part of the face that gets most of it."""
    part = ((at / half_width + 1) / 2 * _PARTS).astype(np.intp).clip(0, _PARTS - 1)
    number = part[:, 0] * _PARTS + part[:, 1]
    most = number == np.bincount(number, flux).argmax()
    x, y = np.average(at[most], axis=0, weights=flux[most])
    return float(x), float(y)
