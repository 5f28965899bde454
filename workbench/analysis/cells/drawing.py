"""Images of a lens by cells of its first face, traced by several threads."""

import math
from abc import ABC, abstractmethod
from collections.abc import Mapping
from functools import partial
from itertools import pairwise
from threading import Event
from typing import Self

import numpy as np

from workbench.analysis.tracing.elements import TracedRays
from workbench.analysis.tracing.trace import in_order
from workbench.analysis.tracing.train import OpticalTrain, Tally
from workbench.arrays import Array, Index
from workbench.geometry.outlines import outline_of
from workbench.progress import Steps
from workbench.scene import Scene

_PARTS = 16  # of the work for any number of threads: rounding depends on them
_STEP = 0.7549, 0.5698  # of the shift of samples from cell to cell
_FAR = 1e7  # pixels beyond which light counts as lost


class Canvas:
    """An image in the making.

    Parameters
    ----------
    pixels : tuple[int, int]
        Pixels along x and y.

    Attributes
    ----------
    here, behind : ndarray, shapes (n_y, n_x), (n_y, n_x + 1)
        What is added to each pixel, and what is added to a pixel and all behind it in its row.
    rays : int
        Rays followed for it.
    passed : float
        Flux behind all faces, on the screen or beside it.
    lost : dict
        Flux that is lost before, by keys of the light account.
    """

    def __init__(self, pixels: tuple[int, int]) -> None:
        n_x, n_y = pixels
        self.here, self.behind = np.zeros((n_y, n_x)), np.zeros((n_y, n_x + 1))
        self.rays, self.passed = 0, 0.0
        self.lost: dict[str, float] = {}

    def add(self, other: "Canvas") -> None:
        """Take in the light of another one."""
        self.here += other.here
        self.behind += other.behind
        self.rays += other.rays
        self.passed += other.passed
        for name, flux in other.lost.items():
            self.lose(name, flux)

    def lose(self, name: str, flux: float) -> None:
        """Add to a loss."""
        self.lost[name] = self.lost.get(name, 0.0) + flux

    def record(self, weights: Array, passed: Array, lost: Mapping[str, Array]) -> None:
        """Add weighted sums of the flux that passed and of what was lost."""
        self.passed += float(np.vdot(weights, passed))
        for name, each in lost.items():
            self.lose(name, float(np.vdot(weights, each)))

    def flux(self) -> Array:
        """Flux in each pixel, shape (n_y, n_x)."""
        return self.here + np.cumsum(self.behind[:, :-1], axis=1)


class Drawing(ABC):
    """Base of images by ``cells`` along x and y of the aperture, for a train with one receiver.

    The aperture is the outline of the first element, which all light passes. The cells are equal on
    a square. `Grading` makes them smaller near an origin, and `workbench.geometry.outlines` maps
    them onto the outline, which cuts no cell. At the end, ``rays`` is the number of traced rays,
    and ``lost`` has the lost parts of the emitted flux by keys of the light account.
    """

    def __init__(self, scene: Scene, train: OpticalTrain, cells: tuple[int, int]) -> None:
        self._train, self._pixels = train, scene.receiver.pixels
        self._outline = outline_of(scene.first)
        places, half_width = train.source.places, scene.first.half_width
        self._grading = None if places is None else [Grading.of(p, half_width) for p in places]
        self._width = tuple(2 / n for n in cells)
        self._strips: list[tuple[int, int]] = []
        self.rays = self._done = 0
        self.lost: dict[str, float] = {}

    @abstractmethod
    def _fill(self, canvas: Canvas, origin: int, first: int) -> None:
        """Add the light of a strip of cells."""

    def tracing(self, threads: int | None = None) -> Steps[Array]:
        """Return the part of the emitted flux in each pixel (n_y, n_x), for any ``threads``."""
        count = min(_PARTS, len(self._strips))
        ends = [k * len(self._strips) // count for k in range(count + 1)]
        parts = [partial(self._part, a, b) for a, b in pairwise(ends)]
        total = Canvas(self._pixels)
        for canvas in in_order(parts, 16 * math.prod(self._pixels), threads):
            if canvas is not None:
                total.add(canvas)
            del canvas  # frees memory before the next image
            yield self._done / len(self._strips)
        self.rays, flux, emitted = total.rays, total.flux(), self._train.source.emitted
        beside = max(total.passed - float(flux.sum()), 0.0)
        entered = total.passed + sum(total.lost.values())
        total.lose(self._train.missed, max(emitted - entered, 0.0))
        total.lose("off_screen", beside)
        self.lost = {name: each / emitted for name, each in total.lost.items()}
        return flux / emitted

    def _part(self, begin: int, end: int, left: Event) -> Canvas:
        canvas = Canvas(self._pixels)
        for strip in self._strips[begin:end]:
            if left.is_set():  # the image is not wanted
                break
            self._fill(canvas, *strip)
            self._done += 1
        return canvas

    def _arrive(self, origin: int, u: Array, v: Array) -> tuple[Array, Array, dict[str, Array]]:
        """Hits (m, 2) in pixels, flux per cell (m,), 0 for lost light, and losses (m,) by name.

        ``u`` and ``v`` broadcast.
        """
        rays, area = self._through(origin, u, v)
        rays = rays._replace(flux=rays.flux * area)
        places, flux = np.zeros((len(rays.flux), 2)), np.empty(len(rays.flux))
        lost: dict[str, Array] = {}
        self._train.hits(rays, places, flux, lost)
        beside = ~(np.abs(places) < _FAR).all(axis=1)  # also NaN
        lost["off_screen"] = np.where(beside, flux, 0.0)
        places[beside], flux[beside] = 0.0, 0.0
        return places, flux, lost

    def _through(self, origin: int, u: Array, v: Array) -> tuple[TracedRays, Array]:
        """Rays through points of the square, and the areas of the cells there."""
        along: Array | float = 1.0
        if self._grading is not None:
            (u, along_u), (v, along_v) = (
                grade(part) for grade, part in zip(self._grading[origin], (u, v), strict=True)
            )
            along = along_u * along_v
        x, y = (np.ravel(part) for part in self._outline.from_square(u, v))
        area = (self._outline.stretch(u, v) * along).ravel() * math.prod(self._width)
        return self._train.source.through(origin, x, y), area

    def _count(self, canvas: Canvas, rays: TracedRays) -> None:
        """Add light ray by ray."""
        tally = Tally(1, canvas.here.size)
        self._train.follow(rays, tally)
        canvas.rays += len(rays.flux)
        canvas.passed += float(tally.flux.sum() + tally.beside.sum())
        for name, flux in tally.lost.items():
            canvas.lose(name, flux)
        canvas.here += tally.flux.reshape(canvas.here.shape)


def shifts(i: Index, j: Index) -> tuple[Array, Array]:
    """Shifts in [0, 1) of the samples of cells: errors at an edge along the cells cancel."""
    return (_STEP[0] * i + _STEP[1] * j) % 1, (_STEP[1] * i + _STEP[0] * j) % 1


_BEYOND = 16.0  # distance in half-widths from which light counts as collimated: cells are equal
_LEAST = 1e-15  # distance of a point in the plane of the face or behind it


class Grading:
    """Map from equal nodes on [-1, 1] to nodes on [-1, 1] that are dense near a point source.

    `distance`, `foot`: distance of the source to the face and its coordinate, half-widths.

    Examples
    --------
    >>> place, stretch = Grading(0.1, 0.0)(np.array([-1.0, 0.0, 1.0]))
    >>> place.round(12).tolist(), (stretch[0] / stretch[1]).round(2).item()
    ([-1.0, 0.0, 1.0], 10.05)
    """

    def __init__(self, distance: float, foot: float) -> None:
        self._even = distance > _BEYOND
        self._distance, self._foot = distance, foot
        low, high = (float(np.arcsinh((end - foot) / distance)) for end in (-1, 1))
        self._middle, self._half = (low + high) / 2, (high - low) / 2

    @classmethod
    def of(cls, place: Array, half_width: tuple[float, float]) -> tuple[Self, Self]:
        """Gradings along x and y for a point before a face in the plane z = 0."""
        away = max(-place[2], _LEAST * max(half_width))
        x, y = (cls(away / r, foot / r) for r, foot in zip(half_width, place[:2], strict=True))
        return x, y

    def __call__(self, even: Array) -> tuple[Array, Array]:
        """Return the positions of equal nodes of any shape, and the stretch there."""
        if self._even:
            return even, np.ones_like(even)
        angle = self._middle + self._half * even
        place = self._foot + self._distance * np.sinh(angle)
        return place.clip(-1, 1), self._distance * self._half * np.cosh(angle)
