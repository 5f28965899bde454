"""The order in which drawn rays are traced: those of a patch of the first face side by side."""

import numpy as np
import numpy.typing as npt

from workbench.arrays import AnyArray
from workbench.compiled import jit
from workbench.optics.kernels.intersection import depths_of_side
from workbench.optics.kernels.patches import Net, span_of

# Cells of the order are at least so many along each axis, so that rays of a large patch that
# follow each other light the same part of the receiver.
_CELLS = 64


def order_of(net: Net, rays: AnyArray, depths: AnyArray) -> npt.NDArray[np.int64]:
    """Numbers of rays, cell by cell of a face.

    `net`: the control net of the face; `rays` (6, rays): see
    `workbench.optics.train.numbers.GivenRays`; `depths` (rays,): where they met it; infinite for
    those that did not.
    """
    finer_x, finer_y = (-(-_CELLS // spans) for spans in net.spans)
    order: npt.NDArray[np.int64] = _order(net, finer_x, finer_y, rays, depths)
    return order


@jit(error_model="numpy")
def _order(net, finer_x, finer_y, rays, depths):  # type: ignore[no-untyped-def]
    """By counting how many are in each cell."""
    cells_x, cells_y = net.spans[0] * finer_x, net.spans[1] * finer_y
    count = rays.shape[1]
    cells = np.empty(count, np.int32)
    ends = np.zeros(cells_x * cells_y + 1, np.int64)
    for ray in range(count):
        slope_x, slope_y = rays[3, ray], rays[4, ray]
        x, y = rays[0, ray] - slope_x * rays[2, ray], rays[1, ray] - slope_y * rays[2, ray]
        depth = min(depths[ray], depths_of_side(net, x, y, slope_x, slope_y)[1])
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
