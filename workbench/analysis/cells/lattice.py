"""Images by the cells of a lattice of rays from each origin, with uniform light in a cell."""

from itertools import product

import numpy as np

from workbench.analysis.cells.drawing import Canvas, Drawing, shifts
from workbench.analysis.cells.kernels import fill_cells, lift
from workbench.analysis.tracing.train import OpticalTrain
from workbench.arrays import Array, Index, Mask
from workbench.geometry.surface import nets_of
from workbench.scene import Scene

_AT_ONCE = 1 << 15  # nodes traced together, which fit into the cache
# Rays along each side of a partly lost cell; fewer for at least 16 origins.
_SAMPLES, _FEWER, _MANY = 8, 4, 16


class CellLattice(Drawing):
    """Cells of the front face, lit from each origin; see `Drawing`.

    `lifted`: axes along which `lift` moves nodes; by default those of a smooth slope.
    """

    def __init__(
        self,
        scene: Scene,
        train: OpticalTrain,
        cells: tuple[int, int],
        lifted: tuple[bool, bool] | None = None,
    ) -> None:
        super().__init__(scene, train, cells)
        if lifted is None:
            nets = nets_of(scene).values()
            lifted = min(n.degree[0] for n in nets) > 2, min(n.degree[1] for n in nets) > 2
        self._lifted = lifted
        self._samples = _SAMPLES if train.source.origins < _MANY else _FEWER
        self._u, self._v = (np.linspace(-1, 1, n + 1) for n in cells)
        self._rows = max(_AT_ONCE // (cells[1] + 1) - 3, 4)  # of cells traced together
        self._strips = [
            (origin, first)
            for origin in range(train.source.origins)
            for first in range(0, cells[0], self._rows)
        ]

    def _fill(self, canvas: Canvas, origin: int, first: int) -> None:
        """Add the light of one origin through a strip of cells."""
        last = min(first + self._rows, len(self._u) - 1)
        # With a row on both sides, for second differences.
        before, behind = max(first - 1, 0), min(last + 1, len(self._u) - 1)
        u = self._u[before : behind + 1, None]
        places, flux, lost = self._arrive(origin, u, self._v)
        canvas.rays += flux.size
        flux = flux.reshape(len(u), len(self._v))
        nodes = lift(places.reshape(*flux.shape, 2), flux, self._lifted)
        strip = slice(first - before, last - before + 1)
        mixed = np.empty((last - first, len(self._v) - 1), dtype=bool)
        fill_cells(nodes[strip], flux[strip], first % 2, (canvas.here, canvas.behind), mixed)
        shape = len(u), len(self._v)
        own = {name: each.reshape(shape)[strip] for name, each in lost.items()}
        canvas.record(_weights(~mixed, first % 2), flux[strip], own)
        i, j = np.nonzero(mixed)
        at_once = max(_AT_ONCE // self._samples**2, 1)
        for some in range(0, len(i), at_once):
            self._sample(canvas, origin, first + i[some:][:at_once], j[some:][:at_once])

    def _sample(self, canvas: Canvas, origin: int, i: Index, j: Index) -> None:
        """Add the light of partly lost cells, ray by ray."""
        count = self._samples
        along_u, along_v = (shift[:, None, None] for shift in shifts(i, j))
        within = np.arange(count)
        u = self._u[i][:, None, None] + (within[:, None] + along_u) / count * self._width[0]
        v = self._v[j][:, None, None] + (within + along_v) / count * self._width[1]
        rays, area = self._through(origin, u, v)
        self._count(canvas, rays._replace(flux=rays.flux * area / count**2))


def _weights(counted: Mask, odd: int) -> Array:
    """Weights (m + 1, n + 1) of nodes for sums over cells (m, n), as their triangles have them."""
    m, n = counted.shape
    even = (np.add.outer(np.arange(m), np.arange(n)) + odd) % 2 == 0
    weights = np.zeros((m + 1, n + 1))
    for corner, (i, j) in enumerate(product((0, 1), repeat=2)):
        on_diagonal = even == (corner in (1, 2))
        weights[i : m + i, j : n + j] += np.where(on_diagonal, 1 / 3, 1 / 6) * counted
    return weights
