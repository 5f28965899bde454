"""Light behind the entrance face, by random rays: from each kind of source, in batches."""

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import numpy.typing as npt
from scipy.optimize import nnls

from workbench.analysis.cells import Cells
from workbench.analysis.face import schlick
from workbench.analysis.light_kernels import enter
from workbench.analysis.pose import Pose
from workbench.scene import CollimatedSource, GridSource, PointSource, Scene

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
                np.broadcast_to(self._direction, (len(a), 3)),
                np.full(len(a), 1 - self._reflectance),
                rays=len(a),
                emitted=len(a),
                missed_lens=0.0,
                reflected=self._reflectance * len(a),
            )


class PointLight:
    """Light of points into the cones that just cover the entrance face, however that stands.

    Parameters
    ----------
    scene, rays, seed, pose
        As for `CollimatedLight`.
    """

    def __init__(self, scene: Scene, rays: int, seed: int, pose: Pose) -> None:
        assert not isinstance(scene.source, CollimatedSource)
        self._lens, self._seed = scene.lens, seed
        self._index = scene.lens.index
        # Flux goes with the cosine to this; even light has none.
        lambertian = scene.source.emission == "lambertian"
        self._upwards = pose.axis() if lambertian else np.zeros(3)
        self._points = pose.to_lens(_points(scene.source), scene.lens.entrance_z)
        self._axes = np.array([self._nearest(point) for point in self._points])
        self._cells = Cells(rays, 1.0, seed)
        self.rays = self._cells.count

    def _nearest(self, point: Array) -> Array:
        """The smallest vector in the hull of the unit vectors to the corners of the entrance face.

        It points along the axis of the smallest cone that holds them, and its length is the
        cosine of that cone's half-angle.
        """
        (r_x, r_y), z = self._lens.half_width, self._lens.entrance_z
        corners = np.array([[x, y, z] for x in (-r_x, r_x) for y in (-r_y, r_y)]) - point
        corners /= np.linalg.norm(corners, axis=1, keepdims=True)
        # The sum of the weights is drawn to 1, at the same cost whatever their proportions.
        weights, _ = nnls(np.vstack([corners.T, np.ones(4)]), np.array([0.0, 0.0, 0.0, 1.0]))
        return np.asarray(weights @ corners / weights.sum())

    def batch(self, batch: int) -> Iterator[Entered]:
        """The rays of one batch, some at a time."""
        shuffle = np.random.default_rng([self._seed, 100 + batch])
        for a, b in self._cells.batch(batch):
            # As many rays from each point as from any other, but for one.
            from_point = shuffle.permutation(len(a)) + shuffle.integers(len(self._points))
            yield self._entered(from_point % len(self._points), a, b)

    def _entered(self, number: npt.NDArray[np.int64], a: Array, b: Array) -> Entered:
        start, direction, flux = np.empty((len(a), 2)), np.empty((len(a), 3)), np.empty(len(a))
        entered, emitted, missed_lens, reflected = enter(
            self._points,
            self._axes,
            number,
            a,
            b,
            self._upwards,
            self._lens.entrance_z,
            self._lens.half_width,
            self._index,
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


def _points(source: PointSource | GridSource) -> Array:
    if isinstance(source, PointSource):
        return np.array([source.position])
    offsets = [
        np.linspace(-r, r, count) if count > 1 else np.zeros(1)
        for r, count in zip(source.half_width, source.points, strict=True)
    ]
    x, y, z = source.center
    return np.array([[x + i, y + j, z] for i in offsets[0] for j in offsets[1]])
