"""Images of a lens from places of its first face, by as many threads as there are cores."""

import math
from abc import ABC, abstractmethod
from functools import partial
from itertools import pairwise
from threading import Event
from typing import Self

import numpy as np

from workbench.analysis.cells.triangles import Canvas
from workbench.analysis.tracing.elements import TracedRays
from workbench.analysis.tracing.in_order import in_order
from workbench.analysis.tracing.train import OpticalTrain, Tally
from workbench.arrays import Array
from workbench.geometry.outlines import outline_of
from workbench.progress import Steps
from workbench.scene import Scene

# Parts into which the work is divided whatever the number of threads: rounding depends on them.
_PARTS = 16
# Light farther off than so many pixels counts as lost: it would have no useful size.
_FAR = 1e7


class Drawing(ABC):
    """What is common to images by cells of the entrance face.

    The cells are equal on a square. `Grading` draws them together where an origin is near, and
    `workbench.geometry.outlines` maps them onto the outline of the lens: no cell is cut by it.

    Parameters
    ----------
    scene : Scene
        Lens and screen.
    train : OpticalTrain
        Its elements, with one screen.
    cells : tuple[int, int]
        Cells along x and y.

    Attributes
    ----------
    rays : int
        Rays followed; known once all is traced.
    """

    def __init__(self, scene: Scene, train: OpticalTrain, cells: tuple[int, int]) -> None:
        self._train, self._pixels = train, scene.receiver.pixels
        self._outline = outline_of(scene.optic)
        places, half_width = train.source.places, scene.optic.half_width
        self._grading = None if places is None else [Grading.of(p, half_width) for p in places]
        self._width = tuple(2 / n for n in cells)
        self._strips: list[tuple[int, int]] = []
        self.rays = self._done = 0

    @abstractmethod
    def _fill(self, canvas: Canvas, origin: int, first: int) -> None:
        """Add the light of one of the strips."""

    def tracing(self, threads: int | None = None) -> Steps[Array]:
        """Trace all of it; yields the part that is done now and then.

        Parameters
        ----------
        threads : int, optional
            How many trace; as many as there are cores by default. Results do not depend on it.

        Returns
        -------
        ndarray, shape (n_y, n_x)
            Part of the emitted flux in each pixel.
        """
        count = min(_PARTS, len(self._strips))
        ends = [k * len(self._strips) // count for k in range(count + 1)]
        parts = [partial(self._part, a, b) for a, b in pairwise(ends)]
        total = Canvas(self._pixels)
        for canvas in in_order(parts, 16 * math.prod(self._pixels), threads):
            if canvas is not None:
                total.add(canvas)
            del canvas  # large images must not wait for the next ones
            yield self._done / len(self._strips)
        self.rays = total.rays
        return total.flux() / self._train.source.emitted

    def _part(self, begin: int, end: int, left: Event) -> Canvas:
        canvas = Canvas(self._pixels)
        for strip in self._strips[begin:end]:
            if left.is_set():  # nobody takes this image
                break
            self._fill(canvas, *strip)
            self._done += 1
        return canvas

    def _arrive(self, origin: int, u: Array, v: Array) -> tuple[Array, Array]:
        """Where light meets the screen, in pixels, and its flux per cell; 0 for what is lost.

        Places (m, 2) and flux (m,) of all pairs of u and v, which broadcast.
        """
        rays, area = self._through(origin, u, v)
        places, flux = np.zeros((len(rays.flux), 2)), np.empty(len(rays.flux))
        self._train.hits(rays, places, flux)
        lost = ~(np.abs(places) < _FAR).all(axis=1)  # also where there is no number
        places[lost], flux[lost] = 0.0, 0.0
        return places, flux * area

    def _through(self, origin: int, u: Array, v: Array) -> tuple[TracedRays, Array]:
        """Rays through places of the square, and the areas of cells there."""
        along: Array | float = 1.0
        if self._grading is not None:
            (u, along_u), (v, along_v) = (
                grade(part) for grade, part in zip(self._grading[origin], (u, v), strict=True)
            )
            along = along_u * along_v
        x, y = (np.ravel(part) for part in self._outline.from_square(u, v))
        area = (self._outline.stretch(u, v) * along).ravel() * math.prod(self._width)
        return self._train.lit(origin, x, y), area

    def _count(self, canvas: Canvas, rays: TracedRays) -> None:
        """Add light ray by ray."""
        tally = Tally(1, canvas.here.size)
        self._train.walk(rays, tally)
        canvas.rays += len(rays.flux)
        canvas.here += tally.flux.reshape(canvas.here.shape)


# Light from farther than so many half-widths away is as good as parallel: cells are equal.
_BEYOND = 16.0
# A point in the plane of the face, or behind it where the face leans, gives no light.
_LEAST = 1e-15


class Grading:
    """The map from [-1, 1], where nodes are even, onto [-1, 1], where they are not.

    `distance`, `foot`: how far a point of light is from the face and where its foot is,
    half-widths.

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
        """Those along x and y for a point before a face in the plane z = 0."""
        away = max(-place[2], _LEAST * max(half_width))
        x, y = (cls(away / r, foot / r) for r, foot in zip(half_width, place[:2], strict=True))
        return x, y

    def __call__(self, even: Array) -> tuple[Array, Array]:
        """Places of even ones, and how much longer the way there is; any shape."""
        if self._even:
            return even, np.ones_like(even)
        angle = self._middle + self._half * even
        place = self._foot + self._distance * np.sinh(angle)
        return place.clip(-1, 1), self._distance * self._half * np.cosh(angle)
