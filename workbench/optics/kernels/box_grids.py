"""Boxes of several grids of rays, one grid after the other in one call; and the adjoint.

What a grid needs on the way stays within a cache, and nothing waits for Python between grids.
"""

from typing import NamedTuple

import numpy as np

from workbench.arrays import AnyArray, Array
from workbench.compiled import jit
from workbench.optics.kernels.beam_image import grids_of, splits_of_grids
from workbench.optics.kernels.beam_nodes import shift, shift_back
from workbench.optics.kernels.box_raster import add_boxes, see_boxes
from workbench.optics.kernels.cell_image import Splits
from workbench.optics.kernels.taps import FAST


class Grids(NamedTuple):
    """Grids that lie side by side along the first axis of their nodes."""

    first: AnyArray  # (grids + 1,), first row of each; behind them the number of all rows
    # (grids,), first row of each in ``along_u``: where all are alike, it has those of one.
    behind: AnyArray
    # (n, 3) and (m, 3), splits along both axes; see
    # `workbench.optics.kernels.beam_raster.densities`.
    along_u: Array
    along_v: Array
    # (2, n) and (2, m), their parts of flux, in the float type of the nodes; see `find_boxes`.
    parts_u: AnyArray
    parts_v: AnyArray

    @classmethod
    def of(cls, nodes: AnyArray, splits: Splits) -> "Grids":
        """Grids of nodes, shape (3, n, m)."""
        rows = grids_of(splits, nodes.shape[1:]) or [slice(0, nodes.shape[1])]
        alike = nodes.shape[1] > len(splits[1])
        along_u, along_v = splits_of_grids(splits, rows[0] if alike else slice(0, nodes.shape[1]))
        parts_u, parts_v = (
            each[:, :2].T.astype(nodes.dtype, order="C") for each in (along_u, along_v)
        )
        first = np.array([*(each.start for each in rows), nodes.shape[1]])
        behind = np.zeros_like(first[:-1]) if alike else first[:-1]
        return cls(first, behind, along_u, along_v, parts_u, parts_v)


@jit(fastmath=FAST, error_model="numpy")
def add_grids(nodes, grids, begin, end, corners):  # type: ignore[no-untyped-def]
    """Add the boxes of some grids.

    `nodes` (3, n, m): columns and rows in which rays hit, and their flux; `grids`: of these;
    `begin`, `end`: which of them; `corners`: see `workbench.optics.kernels.box_raster.add_boxes`;
    changed. Returns flux of all boxes, on the image or beside it.
    """
    landed = 0.0
    for grid in range(begin, end):
        split, parts = _of_grid(grids, grid)
        hits = _moved(nodes, grids, grid, split)
        landed += add_boxes(
            hits, nodes[2, grids.first[grid] : grids.first[grid + 1]], parts, corners
        )
    return landed


@jit(fastmath=FAST, error_model="numpy")
def see_grids(nodes, grids, begin, end, sums, result):  # type: ignore[no-untyped-def]
    """Adjoint of `add_grids`.

    `nodes`, `grids`, `begin`, `end`: as there; `sums`: see
    `workbench.optics.kernels.box_raster.see_boxes`; `result` (3, n, m): cotangents of the nodes;
    those of these grids are changed.
    """
    for grid in range(begin, end):
        first, last = grids.first[grid], grids.first[grid + 1]
        split, parts = _of_grid(grids, grid)
        hits = _moved(nodes, grids, grid, split)
        d_hits, d_flux = np.zeros_like(hits), result[2, first:last]
        d_flux[:] = d_flux.dtype.type(0)
        see_boxes(hits, nodes[2, first:last], parts, sums, d_hits, d_flux)
        for k in range(2):
            shift_back(
                nodes[k, first:last], split, d_hits[k], 0, last - first, result[k, first:last]
            )


@jit(error_model="numpy")
def _moved(nodes, grids, grid, split):  # type: ignore[no-untyped-def]
    """Hits of a grid, shifted."""
    first, last = grids.first[grid], grids.first[grid + 1]
    hits = np.empty((2, last - first, nodes.shape[2]), nodes.dtype)
    for k in range(2):
        shift(nodes[k, first:last], split, 0, last - first, hits[k])
    return hits


@jit(error_model="numpy")
def _of_grid(grids, grid):  # type: ignore[no-untyped-def]
    """Splits of a grid, and its parts of flux."""
    begin = grids.behind[grid]
    here = slice(begin, begin + grids.first[grid + 1] - grids.first[grid])
    return (grids.along_u[here], grids.along_v), (grids.parts_u[:, here], grids.parts_v)
