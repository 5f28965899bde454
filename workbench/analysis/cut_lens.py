"""Error of a lens with the scallops of its cutter, and of the lens as designed.

Scallops of a few micrometres have slopes of degrees; polishing removes them.
"""

from collections.abc import Mapping
from functools import partial
from typing import NamedTuple

import numpy as np

from workbench.analysis.scatter import CorrectedDistance
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.sources.sampling import BATCHES
from workbench.analysis.tracing.train import OpticalTrain, Tally
from workbench.arrays import Array
from workbench.errors import Refused
from workbench.geometry.ball_cutter import Raster
from workbench.messages import Message
from workbench.progress import Steps, of_equal, within
from workbench.scene import Scene


class CutLens(NamedTuple):
    """Relative L2 errors of a lens as designed and as cut."""

    designed: CorrectedDistance
    cut: CorrectedDistance

    @property
    def sentence(self) -> Message:
        """Both errors in words."""
        return Message(
            "Error as cut {cut:.3g} % (± {cut_off:.1g}), as designed {designed:.3g} % "
            "(± {designed_off:.1g}).",
            cut=100 * self.cut.distance,
            cut_off=100 * self.cut.off,
            designed=100 * self.designed.distance,
            designed_off=100 * self.designed.off,
        )


def tracing_cut(
    scene: Scene,
    heights: Mapping[str, Array],
    target: Array,
    raster: Raster,
    rays: int = 1_000_000,
) -> Steps[CutLens]:
    """Trace a lens as cut by ``raster`` in steps, and as designed with four times as many rays.

    The cut face is the exit face of the last designed element, and the first image counts. Raises
    `Refused` for a mirror.
    """
    if scene.optic.onwards < 0:
        raise Refused("mirror", Message("its cut is not traced; only that of an exit face is"))
    images: list[list[Array]] = [[], []]
    lines = scene.lines
    for number in range(BATCHES):
        sums = [np.zeros(target.shape), np.zeros(target.shape)]
        for k, line in enumerate(lines):
            seed = number + BATCHES * k
            trains = (
                OpticalTrain.of(line.scene, heights, each, seed, Pose(), (scene.receiver,), cut)
                for each, cut in ((4 * rays // BATCHES, None), (rays // BATCHES, raster))
            )
            for which, each in enumerate(trains):
                done = 2 * (len(lines) * number + k) + which
                part = partial(of_equal, 2 * len(lines) * BATCHES, done)
                image = yield from within(_imaging(each, target.shape), part)
                sums[which] += line.part * image
        for which, image in enumerate(sums):
            images[which].append(image)
    found = (CorrectedDistance.of_pairs(each, target) for each in images)
    return CutLens(*found)


def _imaging(train: OpticalTrain, shape: tuple[int, ...]) -> Steps[Array]:
    tally = Tally(train.detector.images, train.detector.pixels)
    for number in range(BATCHES):
        for rays in train.source.batch(number):
            train.walk(rays, tally)
        yield (number + 1) / BATCHES
    return np.asarray(tally.flux[0].reshape(shape))
