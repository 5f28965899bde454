"""The error of a lens from independent images of random rays: without cells that are too large.

Cells of a source of some size have to be fine, and lit from many origins, until nothing of them is
left in the error. Images of random rays have nothing but scatter, which pairs of them do without;
see `CorrectedDistance.of_pairs`.
"""

import math
from collections.abc import Mapping
from functools import partial
from typing import NamedTuple

import numpy as np

from workbench.analysis.scatter import CorrectedDistance
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.sources.cells import BATCHES
from workbench.analysis.tracing.trace import Trace
from workbench.arrays import Array
from workbench.scene import Scene
from workbench.watch import Steps, within

# Rays of all images at first, and at most: some ten seconds on two cores. And for each ray of the
# check at most.
_BEGIN, _MOST, _EACH = 1 << 22, 1 << 24, 4


class IndependentError(NamedTuple):
    """What independent images of random rays say of a lens."""

    unscattered: CorrectedDistance  # relative L2 distance of the lens's image to a target
    rays: int  # rays of all images together


def tracing_independently(
    scene: Scene,
    heights: Mapping[str, Array],
    target: Array,
    accuracy: float,
    pose: Pose | None = None,
    threads: int | None = None,
    random_rays: int | None = None,
) -> Steps[IndependentError]:
    """Find the error of a lens from independent images; twice as many rays until it is exact.

    `target` (n_y, n_x): the target image in any scale; `accuracy`: how far the error may be off,
    unless that takes too many rays; `random_rays`: random rays of the check: the images have at
    most four times as many.
    """
    images = np.zeros((BATCHES, *target.shape))
    most = _MOST if random_rays is None else min(_EACH * random_rays, _MOST)
    rays, run, together = 0, 0, min(_BEGIN, most)
    while True:
        more = (together if run == 0 else together // 2) // BATCHES
        for number in range(BATCHES):
            trace = Trace(scene, heights, more, _seed(run, number), pose)
            image = yield from within(_image(trace, threads), partial(_done, run, number))
            images[number] += image.reshape(target.shape)
            rays += trace.rays
        found = CorrectedDistance.of_pairs(list(images), target)
        run, together = run + 1, 2 * together
        if found.off <= accuracy or together > most:
            return IndependentError(found, rays)


def _image(trace: Trace, threads: int | None) -> Steps[Array]:
    """Flux in the pixels of all batches of a trace."""
    flux = np.zeros(1)
    for batch in trace.batches(threads):
        if batch is not None:
            flux = flux + batch.flux[0]
        yield trace.part
    return flux


def _done(run: int, image: int, fraction: float) -> float:
    """The part of the whole that is done with a part of an image."""
    return 1 - math.pow(0.5, run + (image + fraction) / BATCHES)


def _seed(run: int, image: int) -> int:
    """A seed for rays that have nothing to do with others."""
    mixed = np.random.SeedSequence([25, run, image])
    return int(mixed.generate_state(1, np.uint64)[0])
