"""The light of a lens on a lattice of one size, by as many threads as there are cores."""

import math
from collections.abc import Generator
from functools import partial
from itertools import pairwise
from threading import Event

import numpy as np
import numpy.typing as npt

from workbench.analysis.cells.grading import Grading
from workbench.analysis.cells.lift import lift
from workbench.analysis.cells.triangles import Array, Canvas, fill_cells
from workbench.analysis.tracing.elements import TracedRays
from workbench.analysis.tracing.in_order import in_order
from workbench.analysis.tracing.train import OpticalTrain, Tally
from workbench.geometry.outlines import outline_of
from workbench.geometry.surface import freeform_nets
from workbench.scene import Scene

Index = npt.NDArray[np.intp]

# Nodes traced together: what is made of them stays within the cache.
_AT_ONCE = 1 << 15
# Parts into which the work is divided whatever the number of threads: rounding depends on them.
_PARTS = 16
# Rays along each side of a cell of which only a part comes to the screen: as a rule, and where so
# many origins or more look at it, each in a way of its own.
_SAMPLES, _FEWER, _MANY = 8, 4, 16
# Light farther off than so many pixels counts as lost: its cells would have no useful size.
_FAR = 1e7


class Lattice:
    """Cells that cover the entrance face, lit from each origin of the light.

    They are equal on a square. `Grading` draws them together where the light is near, and
    `workbench.geometry.outlines` maps them onto the outline of the lens: no cell is cut by it.

    Parameters
    ----------
    scene : Scene
        Lens and screen.
    train : OpticalTrain
        Its elements, with one screen.
    cells : tuple[int, int]
        Cells along x and y.
    lifted : tuple[bool, bool], optional
        Along which axes nodes are moved so that the error of cells has no mean; see `lift`. By
        default where the face has no kinks in its slope, which differences would take for bends.

    Attributes
    ----------
    rays : int
        Rays followed; known once all nodes are traced.
    """

    def __init__(
        self,
        scene: Scene,
        train: OpticalTrain,
        cells: tuple[int, int],
        lifted: tuple[bool, bool] | None = None,
    ) -> None:
        self._train, self._pixels = train, scene.receiver.pixels
        nets = freeform_nets(scene.optic).values()
        p, q = (min(degrees) for degrees in zip(*(net.degree for net in nets), strict=True))
        self._lifted = (p > 2, q > 2) if lifted is None else lifted
        self._outline, self._grading = outline_of(scene.optic), Grading.of(scene)
        self._samples = _SAMPLES if train.source.origins < _MANY else _FEWER
        self.rays = 0
        self._u, self._v = (np.linspace(-1, 1, n + 1) for n in cells)
        self._width = tuple(2 / n for n in cells)
        self._rows = max(_AT_ONCE // (cells[1] + 1) - 3, 4)  # of cells traced together
        self._strips = [
            (origin, first)
            for origin in range(train.source.origins)
            for first in range(0, cells[0], self._rows)
        ]
        self._done = 0

    def tracing(self, threads: int | None = None) -> Generator[float, None, Array]:
        """Trace all nodes; yields the part that is done now and then.

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
        for origin, first in self._strips[begin:end]:
            if left.is_set():  # nobody takes this image
                break
            self._fill(canvas, origin, first)
            self._done += 1
        return canvas

    def _fill(self, canvas: Canvas, origin: int, first: int) -> None:
        """Add the light of one origin through a strip of cells."""
        last = min(first + self._rows, len(self._u) - 1)
        # With a row of nodes on both sides, for second differences.
        before, behind = max(first - 1, 0), min(last + 1, len(self._u) - 1)
        nodes, flux = self._nodes(origin, self._u[before : behind + 1, None], self._v)
        canvas.rays += flux.size
        nodes = lift(nodes, flux, self._lifted)
        strip = slice(first - before, last - before + 1)
        mixed = np.empty((last - first, len(self._v) - 1), dtype=bool)
        fill_cells(nodes[strip], flux[strip], first % 2, (canvas.here, canvas.behind), mixed)
        i, j = np.nonzero(mixed)
        at_once = max(_AT_ONCE // self._samples**2, 1)
        for some in range(0, len(i), at_once):
            self._sample(canvas, origin, first + i[some:][:at_once], j[some:][:at_once])

    def _nodes(self, origin: int, u: Array, v: Array) -> tuple[Array, Array]:
        """Where light meets the screen, in pixels, and its flux per cell; 0 for what is lost."""
        rays, area = self._through(origin, u, v)
        places, flux = np.zeros((len(rays.flux), 2)), np.empty(len(rays.flux))
        self._train.hits(rays, places, flux)
        lost = ~(np.abs(places) < _FAR).all(axis=1)  # also where there is no number
        places[lost], flux[lost] = 0.0, 0.0
        shape = len(u), len(v)
        return places.reshape(*shape, 2), (flux * area).reshape(shape)

    def _through(self, origin: int, u: Array, v: Array) -> tuple[TracedRays, Array]:
        """Rays through places of the square, and the areas of cells there."""
        (u, along_u), (v, along_v) = (
            grade(part) for grade, part in zip(self._grading, (u, v), strict=True)
        )
        x, y = (np.ravel(part) for part in self._outline.from_square(u, v))
        area = (self._outline.stretch(u, v) * along_u * along_v).ravel() * math.prod(self._width)
        return self._train.lit(origin, x, y), area

    def _sample(self, canvas: Canvas, origin: int, i: Index, j: Index) -> None:
        """Add the light of cells of which a part is lost, ray by ray."""
        count = self._samples
        within = (np.arange(count) + 0.5) / count
        u = self._u[i][:, None, None] + within[:, None] * self._width[0]
        v = self._v[j][:, None, None] + within * self._width[1]
        rays, area = self._through(origin, u, v)
        tally = Tally(1, canvas.here.size)
        self._train.walk(rays._replace(flux=rays.flux * area / count**2), tally)
        canvas.rays += len(rays.flux)
        canvas.here += tally.flux.reshape(canvas.here.shape)
