"""Light on the exit face from inside, by random rays: from each kind of source, in batches."""

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import numpy.typing as npt
from scipy.optimize import nnls

from workbench.analysis.cells import Cells
from workbench.analysis.face import Face, schlick
from workbench.scene import CollimatedSource, GridSource, PointSource, Scene

Array = npt.NDArray[np.float64]


class Arriving(NamedTuple):
    """Some rays that meet the exit face, and the light that was lost on the way to it.

    Attributes
    ----------
    places : ndarray, shape (m, 2)
        Where they meet it, scene units.
    height : ndarray, shape (m,)
        The face's height there.
    direction : ndarray, shape (m, 3)
        Unit vectors.
    flux : ndarray, shape (m,)
        Flux of each, in any unit.
    emitted, missed_lens, reflected, left_side : float
        Flux in the same unit: all of these rays and of those that got lost; of those that passed
        the entrance face by, were reflected there, left through the side.
    """

    places: Array
    height: Array
    direction: Array
    flux: Array
    emitted: float
    missed_lens: float
    reflected: float
    left_side: float


class CollimatedLight:
    """Parallel light along +z: it goes straight on to the exit face.

    Parameters
    ----------
    scene : Scene
        The scene.
    face : Face
        Its exit face.
    rays, seed : int
        How many rays at least, and which.
    """

    def __init__(self, scene: Scene, face: Face, rays: int, seed: int) -> None:
        r_x, r_y = scene.lens.half_width
        self._half_width = np.array([r_x, r_y])
        self._face = face
        self._reflectance = float(schlick(scene.lens.index, 0.0))
        self._cells = Cells(rays, r_x / r_y, seed)
        self.rays = self._cells.count

    def batch(self, batch: int) -> Iterator[Arriving]:
        """The rays of one batch, some at a time."""
        for a, b in self._cells.batch(batch):
            places = (np.stack([a, b], axis=-1) * 2 - 1) * self._half_width
            reflected = self._reflectance * len(a)
            yield Arriving(
                places,
                self._face.height(places),
                np.broadcast_to([0.0, 0.0, 1.0], (len(a), 3)),
                np.full(len(a), 1 - self._reflectance),
                emitted=len(a),
                missed_lens=0.0,
                reflected=reflected,
                left_side=0.0,
            )


class PointLight:
    """Light of points into the cones that just cover the entrance face.

    Parameters
    ----------
    scene, face, rays, seed
        As for `CollimatedLight`.
    """

    def __init__(self, scene: Scene, face: Face, rays: int, seed: int) -> None:
        assert not isinstance(scene.source, CollimatedSource)
        self._lens, self._face, self._seed = scene.lens, face, seed
        self._lambertian = scene.source.emission == "lambertian"
        self._points = _points(scene.source)
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

    def batch(self, batch: int) -> Iterator[Arriving]:
        """The rays of one batch, some at a time."""
        shuffle = np.random.default_rng([self._seed, 100 + batch])
        for a, b in self._cells.batch(batch):
            # As many rays from each point as from any other, but for one.
            from_point = shuffle.permutation(len(a)) + shuffle.integers(len(self._points))
            yield self._arriving(from_point % len(self._points), a, b)

    def _arriving(self, number: npt.NDArray[np.int64], a: Array, b: Array) -> Arriving:
        lens, origin = self._lens, self._points[number]
        direction = _within_cone(self._axes[number], a, b)
        cos = direction[:, 2]
        flux = cos.clip(0) if self._lambertian else np.ones(len(a))
        emitted = float(flux.sum())

        far = (lens.entrance_z - origin[:, 2]) / np.where(cos > 0, cos, np.nan)
        places = origin[:, :2] + direction[:, :2] * far[:, None]
        met = (np.abs(places) <= lens.half_width).all(axis=1)
        places, direction, flux = places[met], direction[met], flux[met]
        entering = float(flux.sum())

        # Snell's law by the angles to the axis.
        angle = np.arccos(direction[:, 2].clip(-1, 1))
        inside = np.arcsin(np.sin(angle) / lens.index)
        azimuth = np.arctan2(direction[:, 1], direction[:, 0])
        around = np.stack([np.cos(azimuth), np.sin(azimuth)], axis=-1)
        flux = flux * (1 - schlick(lens.index, angle))
        refracted = float(flux.sum())

        slope = around * np.tan(inside)[:, None]
        rise, meets = self._face.meet(places, slope)
        places = (places + slope * rise[:, None])[meets]
        direction = np.column_stack([around * np.sin(inside)[:, None], np.cos(inside)])[meets]
        return Arriving(
            places,
            lens.entrance_z + rise[meets],
            direction,
            flux[meets],
            emitted=emitted,
            missed_lens=emitted - entering,
            reflected=entering - refracted,
            left_side=float(flux[~meets].sum()),
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


def _within_cone(axis: Array, a: Array, b: Array) -> Array:
    """Directions uniform in solid angle around axes whose length is the cosine of the rim.

    They are made around +z and mirrored onto the axis, in the plane halfway between the two.
    """
    rim = np.linalg.norm(axis, axis=1)
    cos = 1 - a * (1 - rim)
    sin, azimuth = np.sqrt(1 - cos**2), 2 * math.pi * b
    upright = np.column_stack([sin * np.cos(azimuth), sin * np.sin(azimuth), cos])
    across = axis / rim[:, None] + [0.0, 0.0, 1.0]
    share = 2 * (upright * across).sum(axis=1) / (across * across).sum(axis=1)
    return np.asarray(share[:, None] * across - upright)
