"""The independent trace of a lens: fresh random rays in batches, counted in pixels.

The batches are traced by as many threads as there are cores; what each finds depends on the seed
alone, and they are handed out in order. Whoever waits for one gets a word now and then, and may
leave at any time: batches of many rays take minutes.
"""

import math
import os
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, wait
from dataclasses import dataclass
from threading import Event

import numpy as np
import numpy.typing as npt

from workbench.analysis.cells import BATCHES
from workbench.analysis.face import Face
from workbench.analysis.face_kernels import land
from workbench.analysis.lights import CollimatedLight, PointLight
from workbench.analysis.pose import Pose
from workbench.analysis.ray_limit import MOST_RAYS
from workbench.errors import Refused
from workbench.geometry.body import check_body
from workbench.optics.ledger import Ledger
from workbench.scene import CollimatedSource, Scene, Screen

Array = npt.NDArray[np.float64]

Watch = Callable[[float], None]
"""Is told now and then which part of a trace is done."""

_OFTEN = 0.1  # seconds after which whoever waits for a batch gets a word
_MOST_THREADS = 8
# Each has the images of a batch at hand, which may be large: bytes for all of them together.
_LARGEST_IMAGES = 1 << 28


@dataclass
class Tally:
    """Where the light of some rays went, in any unit.

    Attributes
    ----------
    flux : ndarray, shape (k, n_y n_x)
        Flux in the pixels of a screen in each of k planes, along the rows.
    off_screen : ndarray, shape (k,)
        Flux that went beside these screens.
    emitted, missed_lens, left_side, total_reflection, fresnel_entrance, fresnel_exit : float
        As in `Ledger`.
    """

    flux: Array
    off_screen: Array
    emitted: float = 0.0
    missed_lens: float = 0.0
    left_side: float = 0.0
    total_reflection: float = 0.0
    fresnel_entrance: float = 0.0
    fresnel_exit: float = 0.0

    def add(self, other: "Tally") -> None:
        """Take in the light of other rays."""
        self.flux += other.flux
        self.off_screen += other.off_screen
        self.emitted += other.emitted
        self.missed_lens += other.missed_lens
        self.left_side += other.left_side
        self.total_reflection += other.total_reflection
        self.fresnel_entrance += other.fresnel_entrance
        self.fresnel_exit += other.fresnel_exit

    def ledger(self, plane: int = 0) -> Ledger:
        """The account of all light for one of the planes, as parts of what was emitted."""
        return Ledger(
            emitted=1.0,
            on_screen=float(self.flux[plane].sum()) / self.emitted,
            off_screen=float(self.off_screen[plane]) / self.emitted,
            missed_lens=self.missed_lens / self.emitted,
            left_side=self.left_side / self.emitted,
            total_reflection=self.total_reflection / self.emitted,
            fresnel_entrance=self.fresnel_entrance / self.emitted,
            fresnel_exit=self.fresnel_exit / self.emitted,
        )


class Trace:
    """Random rays through a lens.

    One ray starts at a random place in each of ``rays`` equal cells of the entrance face, or in a
    random direction in each of as many equal cells of a point's cone. Memory does not grow with
    them.

    Parameters
    ----------
    scene : Scene
        Lens, source and screen; filter and run settings play no part.
    control_points : ndarray, shape (n_u, n_v)
        Heights z of the exit face's control points, scene units.
    rays : int
        Rays to trace at least; rounded up to whole batches of a grid.
    seed : int
        The same seed gives the same rays.
    pose : Pose
        How the lens stands.
    distances : sequence of float, optional
        Where screens are, z of the k planes; the scene's alone by default.

    Attributes
    ----------
    rays : int
        Rays traced.

    Raises
    ------
    Refused
        If there are more rays than `MOST_RAYS`, the lens is no body, or passes one of the screens.
    """

    def __init__(
        self,
        scene: Scene,
        control_points: Array,
        rays: int,
        seed: int,
        pose: Pose | None = None,
        distances: Sequence[float] | None = None,
    ) -> None:
        if rays > MOST_RAYS:
            raise Refused("rays", f"{rays} are too many; at most {MOST_RAYS}")
        pose = Pose() if pose is None else pose
        self._screen, self._scale = scene.screen, _scale(scene.screen)
        self._planes = np.array([scene.screen.z] if distances is None else distances)
        check_body(scene, control_points, min(self._planes, default=scene.screen.z))
        self._face = Face(scene.lens, control_points)
        self._to_scene = pose.to_scene(scene.lens.entrance_z)
        kind = CollimatedLight if isinstance(scene.source, CollimatedSource) else PointLight
        self._light = kind(scene, rays, seed, pose)
        self.rays = self._light.rays
        self._traced = [0] * BATCHES  # rays of each batch up to now

    @property
    def part(self) -> float:
        """The part of the rays that is traced."""
        return sum(self._traced) / self.rays

    def batches(self, threads: int | None = None) -> Iterator[Tally | None]:
        """Trace; yields each of the `BATCHES` batches, and None now and then before one is done.

        Parameters
        ----------
        threads : int, optional
            How many trace; as many as there are cores by default. Fewer do if images are large.
        """
        room = max(_LARGEST_IMAGES // (8 * len(self._planes) * math.prod(self._screen.pixels)), 1)
        threads = min(threads or os.cpu_count() or 1, _MOST_THREADS, room)
        left = Event()
        with ThreadPoolExecutor(threads) as pool:
            try:
                # Not all at once: images that wait take memory.
                for first in range(0, BATCHES, threads):
                    numbers = range(first, min(first + threads, BATCHES))
                    some = [pool.submit(self._batch, number, left) for number in numbers]
                    while some:
                        if wait(some[:1], _OFTEN).done:
                            yield some.pop(0).result()
                        else:
                            yield None
            finally:
                left.set()

    def _batch(self, number: int, left: Event) -> Tally:
        n_x, n_y = self._screen.pixels
        planes = len(self._planes)
        tally = Tally(np.zeros((planes, n_y * n_x)), np.zeros(planes))
        lost = np.zeros(3)
        self._traced[number] = 0
        for some in self._light.batch(number):
            if left.is_set():  # nobody takes this batch
                break
            followed = self._face.follow(some.places, some.direction)
            land(
                *followed,
                some.flux,
                *self._to_scene,
                self._planes,
                self._scale,
                self._screen.pixels,
                tally.flux,
                tally.off_screen,
                lost,
            )
            self._traced[number] += some.rays
            tally.emitted += some.emitted
            tally.missed_lens += some.missed_lens
            tally.fresnel_entrance += some.reflected
        tally.left_side, tally.total_reflection, tally.fresnel_exit = lost.tolist()
        return tally


def added(total: Tally | None, batch: Tally | None) -> Tally | None:
    """The light of a batch and of those before, as far as there are any."""
    if total is None or batch is None:
        return total or batch
    total.add(batch)
    return total


def unwatched(part: float) -> None:
    """Take no notice."""


def part_of(watch: Watch, before: int, count: int, of: int) -> Watch:
    """What a trace is told to that does ``count`` of so many things, some before it."""
    return lambda part: watch((before + count * part) / of)


def _scale(screen: Screen) -> Array:
    """Column of x and row of y as factors and what is added, shape (2, 2)."""
    added, with_factor = np.array(screen.to_pixels(0.0, 0.0)), np.array(screen.to_pixels(1.0, 1.0))
    return np.column_stack([with_factor - added, added])
