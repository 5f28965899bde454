"""The order in which rays of points are traced: those of a patch of the exit face side by side."""

from typing import NamedTuple

import numpy as np

from workbench.arrays import AnyArray
from workbench.compiled import jit
from workbench.optics.intersection import Bundle
from workbench.optics.kernels.point_meet import depth_of_side
from workbench.optics.kernels.point_patches import Net, span_of

# Cells of the order are at least so many along each axis, so that rays of a large patch that
# follow each other light the same part of the screen.
_CELLS = 64


class Sorted(NamedTuple):
    """Rays in the order in which they are traced; never changed, only replaced.

    Attributes
    ----------
    drawn : Bundle or None
        The rays as they were drawn.
    bundle : ndarray, shape (5, rays)
        Their x, y, slopes and flux, sorted.
    steepest : ndarray, shape (2,)
        The most that the slopes are.
    depths : ndarray, shape (rays,)
        Where to start the search; infinite for rays that left the last lens through its side.
    fewest : int
        How many runs of rays in the same patch there were at first; 0 while that is not known.
    interruptions : int
        How many more there were in all traces since.
    """

    drawn: Bundle | None
    bundle: AnyArray
    steepest: AnyArray
    depths: AnyArray
    fewest: int = 0
    interruptions: int = 0


def arrange(net: Net, drawn: Bundle | None, bundle: AnyArray, depths: AnyArray) -> Sorted:
    """Sort rays by where they are at these depths, or where they left the lens before."""
    finer_x, finer_y = (-(-_CELLS // spans) for spans in net.spans)
    order = _order(net, finer_x, finer_y, bundle, depths)
    bundle = np.stack([part[order] for part in bundle])
    steepest = np.abs(bundle[2:4]).max(axis=1, initial=0)
    return Sorted(drawn, bundle, steepest, depths[order])


@jit(error_model="numpy")
def _order(net, finer_x, finer_y, bundle, depths):  # type: ignore[no-untyped-def]
    """Numbers of the rays, cell by cell of the face; by counting."""
    cells_x, cells_y = net.spans[0] * finer_x, net.spans[1] * finer_y
    count = bundle.shape[1]
    cells = np.empty(count, np.int32)
    ends = np.zeros(cells_x * cells_y + 1, np.int64)
    for ray in range(count):
        x, y, slope_x, slope_y = bundle[0, ray], bundle[1, ray], bundle[2, ray], bundle[3, ray]
        depth = min(depths[ray], depth_of_side(net, x, y, slope_x, slope_y))
        if depth < np.inf:
            x, y = x + slope_x * depth, y + slope_y * depth
        u = (x + net.half_x) * net.per_x * finer_x
        v = (y + net.half_y) * net.per_y * finer_y
        cell = int(span_of(u, cells_x - 1)) * cells_y + int(span_of(v, cells_y - 1))
        cells[ray] = cell
        ends[cell + 1] += 1
    for cell in range(cells_x * cells_y):
        ends[cell + 1] += ends[cell]
    order = np.empty(count, np.int64)
    for ray in range(count):
        cell = cells[ray]
        order[ends[cell]] = ray
        ends[cell] += 1
    return order
