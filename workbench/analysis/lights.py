"""Light behind the entrance face, by random rays: from each kind of source, in batches."""

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from workbench.analysis.cells import Cells
from workbench.analysis.cones import Cones, covering_cones
from workbench.analysis.face import schlick
from workbench.analysis.light_kernels import enter
from workbench.analysis.pose import Pose
from workbench.scene import Scene, of_points

Array = npt.NDArray[np.float64]


class Entered(NamedTuple):
    """Some rays behind the entrance face, and the light that was lost on the way there.

    Attributes
    ----------
    places : ndarray, shape (m, 2)
        Where they begin on the entrance face; these and the directions as the lens sees them.
    direction : ndarray, shape (m, 3)
        Unit vectors in the lens.
    flux : ndarray, shape (m,)
        Flux of each, in any unit.
    rays : int
        Rays that were emitted; those that got lost are among them.
    emitted, missed_lens, reflected : float
        Flux in the same unit: all of these rays and of those that got lost; of those that passed
        the entrance face by; of what it reflected.
    """

    places: Array
    direction: Array
    flux: Array
    rays: int
    emitted: float
    missed_lens: float
    reflected: float


class CollimatedLight:
    """Parallel light along +z. It has no edge: it fills the entrance face however that stands.

    Parameters
    ----------
    scene : Scene
        The scene.
    rays, seed : int
        How many rays at least, and which.
    pose : Pose
        How the lens stands.
    """

    def __init__(self, scene: Scene, rays: int, seed: int, pose: Pose) -> None:
        r_x, r_y = scene.lens.half_width
        self._half_width = np.array([r_x, r_y])
        arriving = pose.axis()
        # Snell's law at a face across z: sines are divided by the index.
        x, y = arriving[:2] / scene.lens.index
        self._direction = np.array([x, y, math.sqrt(1 - x * x - y * y)])
        self._reflectance = float(schlick(scene.lens.index, arriving[2]))
        self._cells = Cells(rays, r_x / r_y, seed)
        self.rays = self._cells.count

    def batch(self, batch: int) -> Iterator[Entered]:
        """The rays of one batch, some at a time."""
        for a, b in self._cells.batch(batch):
            yield Entered(
                (np.stack([a, b], axis=-1) * 2 - 1) * self._half_width,
                np.full((len(a), 3), self._direction),
                np.full(len(a), 1 - self._reflectance),
                rays=len(a),
                emitted=len(a),
                missed_lens=0.0,
                reflected=self._reflectance * len(a),
            )


class PointLight:
    """Light of points into the cones that just cover the entrance face, however that stands.

    All points have the same intensity, so those that see the face larger emit more.

    Parameters
    ----------
    scene, rays, seed, pose
        As for `CollimatedLight`.
    """

    def __init__(self, scene: Scene, rays: int, seed: int, pose: Pose) -> None:
        source = of_points(scene.source)
        self._lens, self._seed = scene.lens, seed
        # Flux goes with the cosine to this; even light has none.
        lambertian = source.emission == "lambertian"
        self._upwards = pose.axis() if lambertian else np.zeros(3)
        points = pose.to_lens(source.positions, scene.lens.entrance_z)
        cones = covering_cones(points, scene.lens.half_width, scene.lens.entrance_z)
        # In one order of memory always, or the loops would be compiled for each.
        self._cones = Cones(*map(np.ascontiguousarray, cones))
        self._cells = Cells(rays, 1.0, seed)
        self.rays = self._cells.count

    def batch(self, batch: int) -> Iterator[Entered]:
        """The rays of one batch, some at a time."""
        cones = len(self._cones.axis)
        shuffle = np.random.default_rng([self._seed, 100 + batch])
        for a, b in self._cells.batch(batch):
            # As many rays from each point as from any other, but for one.
            from_point = shuffle.permutation(len(a)) + shuffle.integers(cones)
            yield self._entered(from_point % cones, a, b)

    def _entered(self, number: npt.NDArray[np.int64], a: Array, b: Array) -> Entered:
        start, direction, flux = np.empty((len(a), 2)), np.empty((len(a), 3)), np.empty(len(a))
        entered, emitted, missed_lens, reflected = enter(
            self._cones.axis,
            self._cones.centre,
            self._cones.distance,
            self._cones.versine,
            number,
            a,
            b,
            self._upwards,
            self._lens.half_width,
            self._lens.index,
            start,
            direction,
            flux,
        )
        return Entered(
            start[:entered],
            direction[:entered],
            flux[:entered],
            rays=len(a),
            emitted=emitted,
            missed_lens=missed_lens,
            reflected=reflected,
        )
