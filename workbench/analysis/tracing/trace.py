"""Random rays through a lens in batches, by as many threads as there are cores.

What each batch finds depends on the seed alone, and batches are handed out in order. Whoever waits
for one gets control back now and then, and may leave at any time: many rays take minutes.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor, wait
from functools import partial
from threading import Event
from typing import TypeVar

import numpy as np

from workbench.analysis.tracing import MOST_RAYS
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.sources.sampling import BATCHES
from workbench.analysis.tracing.train import OpticalTrain, Tally
from workbench.arrays import Array
from workbench.errors import Refused
from workbench.geometry.body import check_body
from workbench.messages import Message
from workbench.process import usable_threads
from workbench.scene import Scene

T = TypeVar("T")

_OFTEN = 0.1  # seconds after which whoever waits for an outcome gets control back
_MOST_THREADS = 8
# Each has an outcome at hand, which may be large: bytes for all of them together.
_LARGEST = 1 << 28


def in_order(
    works: Sequence[Callable[[Event], T]], size: int, threads: int | None = None
) -> Iterator[T | None]:
    """Do all of some works; yields each outcome, and None now and then before one is there.

    `works`: called with an event that is set once nobody waits for the outcome; `size`: bytes of an
    outcome: fewer threads work where that is much; `threads`: how many work; as many as may be by
    default; see `usable_threads`.
    """
    threads = min(threads or usable_threads(), _MOST_THREADS, max(_LARGEST // size, 1))
    left = Event()
    with ThreadPoolExecutor(threads) as pool:
        try:
            # Not all at once: outcomes that wait take memory.
            for first in range(0, len(works), threads):
                some = [pool.submit(work, left) for work in works[first : first + threads]]
                while some:
                    if wait(some[:1], _OFTEN).done:
                        yield some.pop(0).result()
                    else:
                        yield None
        finally:
            left.set()


class Trace:
    """Random rays through a lens.

    One ray starts at a random place in each of ``rays`` equal cells of the entrance face, or in a
    random direction in each of as many equal cells of a point's cone. Memory does not grow with
    them. Each line of the light has an equal share of the rays.

    `scene`: lens, source and screen; filter and run settings play no part; `heights` (n_u, n_v);
    `rays`: rays to trace at least; rounded up to whole batches of a grid; `pose`: how the lens
    stands; `distances`: where screens are, z of the k planes; the scene's alone by default. `rays`:
    rays traced; `sampled`: whether batches are independent samples of the light; see `LightSource`.
    Raises `Refused` if there are more rays than `MOST_RAYS`, the lens is no body, or passes one of
    the screens.
    """

    def __init__(
        self,
        scene: Scene,
        heights: Mapping[str, Array],
        rays: int,
        seed: int,
        pose: Pose | None = None,
        distances: Sequence[float] | None = None,
    ) -> None:
        if rays > MOST_RAYS:
            raise Refused(
                "rays", Message("{rays} are too many; at most {most}", rays=rays, most=MOST_RAYS)
            )
        pose = Pose() if pose is None else pose
        at = [scene.receiver] if distances is None else map(scene.receiver.moved_to, distances)
        receivers = tuple(at)
        check_body(scene, heights, receivers or (scene.receiver,))
        lines = scene.lines
        each = -(-rays // len(lines))
        self._trains = [
            OpticalTrain.of(line.scene, heights, each, _seed(seed, number), pose, receivers)
            for number, line in enumerate(lines)
        ]
        self._parts = [line.part for line in lines]
        sources = [train.source for train in self._trains]
        self.rays, self.sampled = sum(source.rays for source in sources), sources[0].sampled
        self._traced = [0] * BATCHES  # rays of each batch up to now

    @property
    def part(self) -> float:
        """The part of the rays that is traced."""
        return sum(self._traced) / self.rays

    def batches(self, threads: int | None = None) -> Iterator[Tally | None]:
        """Trace; yields each of the `BATCHES` batches, and None now and then before one is done.

        `threads`: how many trace; as many as there are cores by default. Fewer do if images are
        large.
        """
        detector = self._trains[0].detector
        works = [partial(self._batch, number) for number in range(BATCHES)]
        yield from in_order(works, 8 * detector.images * detector.pixels, threads)

    def _batch(self, number: int, left: Event) -> Tally:
        detector = self._trains[0].detector
        tally = Tally(detector.images, detector.pixels)
        self._traced[number] = 0
        for part, train in zip(self._parts, self._trains, strict=True):
            for rays in train.source.batch(number):
                if left.is_set():  # nobody takes this batch
                    return tally
                train.walk(rays._replace(flux=part * rays.flux) if part < 1 else rays, tally)
                self._traced[number] += len(rays.flux)
        return tally


def _seed(seed: int, line: int) -> int:
    """The seed of the rays of a line of the light; each line has other rays."""
    return seed if line == 0 else int(np.random.SeedSequence([seed, line]).generate_state(1)[0])


def added(total: Tally | None, batch: Tally | None) -> Tally | None:
    """The light of a batch and of those before, as far as there are any."""
    if total is None or batch is None:
        return total or batch
    total.add(batch)
    return total
