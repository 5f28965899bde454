"""Nodes moved so that what is linear between them errs without a mean."""

import numpy as np

from workbench.compiled import jit


@jit(error_model="numpy")
def lift(nodes, flux, along):  # type: ignore[no-untyped-def]
    """Subtract a twelfth of the second differences along both axes.

    A linear interpolant of f on cells of width h errs by h² (f_uu + f_vv) / 12 in the mean, which
    shifts all light of a cell to one side. Without that, the light of a cell is only spread a
    little too wide or too narrow, which is even out over a pixel and more.

    At a rim of the light, only the difference along it is subtracted: the mean error of a chord of
    a curve is the same twelfth, so that the outline of the light keeps its place.

    Parameters
    ----------
    nodes : array, shape (m, n, 2)
        Places.
    flux : array, shape (m, n)
        Their flux; there is no place without it.
    along : tuple[bool, bool]
        Along which axes.

    Returns
    -------
    array, shape (m, n, 2)
        The moved places.
    """
    m, n = flux.shape
    lifted = np.empty_like(nodes)
    for i in range(m):
        for j in range(n):
            x, y = nodes[i, j, 0], nodes[i, j, 1]
            d_x = d_y = 0.0
            if along[0] and 0 < i < m - 1 and flux[i - 1, j] > 0 and flux[i + 1, j] > 0:
                d_x += nodes[i - 1, j, 0] - 2 * x + nodes[i + 1, j, 0]
                d_y += nodes[i - 1, j, 1] - 2 * y + nodes[i + 1, j, 1]
            if along[1] and 0 < j < n - 1 and flux[i, j - 1] > 0 and flux[i, j + 1] > 0:
                d_x += nodes[i, j - 1, 0] - 2 * x + nodes[i, j + 1, 0]
                d_y += nodes[i, j - 1, 1] - 2 * y + nodes[i, j + 1, 1]
            lifted[i, j, 0], lifted[i, j, 1] = x - d_x / 12, y - d_y / 12
    return lifted
