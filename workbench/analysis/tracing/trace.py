"""Random rays through a lens in batches, by as many threads as there are cores.

What each batch finds depends on the seed alone, and batches are handed out in order. Whoever waits
for one gets control back now and then, and may leave at any time: many rays take minutes.
"""

from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from threading import Event

import numpy as np

from workbench.analysis.tracing.in_order import in_order
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.ray_limit import MOST_RAYS
from workbench.analysis.tracing.sources.cells import BATCHES
from workbench.analysis.tracing.train import OpticalTrain, Tally
from workbench.arrays import Array
from workbench.errors import Refused
from workbench.geometry.body import check_body
from workbench.messages import Message
from workbench.scene import Scene


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
