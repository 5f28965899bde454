"""Images of an extended source by the spots of light through cells of a lens.

A spot has the light of all origins. Six rays give its shape: the map from the disc of the source to
the receiver is quadratic to sufficient accuracy.
"""

import math

import numpy as np
from scipy.ndimage import binary_dilation, binary_erosion

from workbench.analysis.cells.drawing import Canvas, Drawing, shifts
from workbench.analysis.cells.kernels import fill_spots
from workbench.analysis.tracing.elements import joined
from workbench.analysis.tracing.sources.sampling import in_disc, pairs
from workbench.analysis.tracing.train import OpticalTrain
from workbench.arrays import Array, Index, Mask
from workbench.scene import Scene

_RAYS = 6  # of a spot, to its middle and the corners of a pentagon, for a quadratic map
# Of the outline of a spot. Turned by half a side from cell to cell, their mean has no detail of the
# sides: a disc and it differ by at most 3.5e-4 at any frequency.
_CORNERS = 24
_AT_ONCE, _FEWER = 1 << 15, 1 << 10  # spots traced together, and cells that are partly lost
_SAMPLES = 256  # rays for a cell that is partly lost
_WIDE = 2.0  # pixels; narrower spots leave gaps
_LOOKS = 16  # spots along each axis at which widths are measured


class Spots(Drawing):
    """Spots of light, one through the middle of each cell."""

    work = 2.5
    """Time of a spot in rays of a `CellLattice`."""

    def __init__(self, scene: Scene, train: OpticalTrain, cells: tuple[int, int]) -> None:
        source = train.source.on_disc(*_places())
        assert source is not None
        super().__init__(scene, train.lit_by(source), cells)
        self._origins = source.origins
        self._u, self._v = ((np.arange(n) + 0.5) * 2 / n - 1 for n in cells)
        self._rows = max(_AT_ONCE // cells[1] - 2, 4)  # of places traced together
        self._strips = [(0, first) for first in range(0, cells[0], self._rows)]
        self._rims = _rim(0.0), _rim(0.5)
        # Of the rays in the flux of the triangles of a spot.
        self._weights = 2 / 3 * self._rims[0].mean(axis=0)
        self._weights[0] += 1 / 3

    @classmethod
    def suit(cls, scene: Scene, train: OpticalTrain) -> bool:
        """Whether the spots of a scene are wide enough."""
        if train.source.on_disc(*_places()) is None:
            return False
        some = cls(scene, train, (_LOOKS, _LOOKS))
        places, flux, _ = some._spots(some._u)
        lit = (flux > 0).all(axis=1)
        across = places[lit].max(axis=1) - places[lit].min(axis=1)
        return bool(lit.any()) and float(np.median(across.min(axis=1))) > _WIDE

    def _fill(self, canvas: Canvas, origin: int, first: int) -> None:
        """Add the light of some rows of cells."""
        last = min(first + self._rows, len(self._u))
        # With a row on both sides: neighbours show whether a cell is partly lost.
        before, behind = max(first - 1, 0), min(last + 1, len(self._u))
        u = self._u[before:behind]
        places, flux, lost = self._spots(u)
        canvas.rays += flux.size
        inside = slice(first - before, last - before)
        lit = (flux > 0).reshape(len(u), len(self._v), -1)
        whole, part = (found[inside] for found in _parted(lit))
        rows = slice(inside.start * len(self._v), inside.stop * len(self._v))
        canvas_of = canvas.here, canvas.behind
        odd = (np.add.outer(np.arange(first, last), np.arange(len(self._v))) % 2).astype(bool)
        for turned, rim in zip((odd, ~odd), self._rims, strict=True):
            fill_spots(places[rows], flux[rows], (whole & turned).ravel(), rim, canvas_of)
        for name, each in lost.items():
            lost[name] = each[rows]
        counted = ~part.ravel()[:, None] * self._weights
        canvas.record(counted, flux[rows], lost)
        i, j = np.nonzero(part)
        for some in range(0, len(i), _FEWER):
            self._sample(canvas, first + i[some:][:_FEWER], j[some:][:_FEWER])

    def _spots(self, u: Array) -> tuple[Array, Array, dict[str, Array]]:
        """Hits (m, 6, 2) of the rays of spots, and flux (m, 6) and losses as of the whole spot."""
        places, flux, losses = zip(
            *(self._arrive(origin, u[:, None], self._v) for origin in range(_RAYS)), strict=True
        )
        lost = {
            name: np.stack([each[name] for each in losses], axis=1) * self._origins
            for name in losses[0]
        }
        return np.stack(places, axis=1), np.stack(flux, axis=1) * self._origins, lost

    def _sample(self, canvas: Canvas, i: Index, j: Index) -> None:
        """Add the light of partly lost cells, ray by ray."""
        along_u, along_v = shifts(i, j)
        within = zip(*pairs(np.random.default_rng(0), _SAMPLES), strict=True)
        found = []
        for origin, (a, b) in enumerate(within, _RAYS):
            u, v = i + (a + along_u) % 1, j + (b + along_v) % 1
            rays, area = self._through(origin, u * self._width[0] - 1, v * self._width[1] - 1)
            found.append(rays._replace(flux=rays.flux * area * self._origins / _SAMPLES))
        self._count(canvas, joined(found))


def _parted(lit: Mask) -> tuple[Mask, Mask]:
    """Masks of cells without lost light, and of partly lost cells, by their neighbours."""
    near = np.ones((3, 3), dtype=bool)
    whole = binary_erosion(np.all(lit, axis=2), near)
    return whole, binary_dilation(np.any(lit, axis=2), near) & ~whole


def _places() -> tuple[Array, Array]:
    """Origins on the disc: of a spot's rays, then of the samples of partly lost cells."""
    part, turn = in_disc(_SAMPLES)
    corners = np.arange(_RAYS - 1) / (_RAYS - 1)
    rim = np.ones_like(corners)
    return np.concatenate([[0.0], rim, part]), np.concatenate([[0.0], corners, turn])


def _rim(turn: float) -> Array:
    """Weights (corners, rays) of the rays for the corners of a polygon with the disc's area.

    It is turned by a part of a side.
    """
    angle = 2 * math.pi / _CORNERS
    radius = math.sqrt(angle / math.sin(angle))
    corners = angle * (np.arange(_CORNERS) + turn)
    rays = 2 * math.pi * np.arange(_RAYS - 1) / (_RAYS - 1)
    known = _powers(np.append(0.0, np.cos(rays)), np.append(0.0, np.sin(rays)))
    wanted = _powers(radius * np.cos(corners), radius * np.sin(corners))
    return np.asarray(wanted @ np.linalg.inv(known))


def _powers(x: Array, y: Array) -> Array:
    """Monomials (k, 6) up to the second degree."""
    return np.column_stack([np.ones_like(x), x, y, x * x, x * y, y * y])
