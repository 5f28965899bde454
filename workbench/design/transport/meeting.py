"""Where rays meet a face that is straight between the middles of even cells."""

import numpy as np

from workbench.arrays import Array
from workbench.compiled import jit
from workbench.design.transport.between import Pair, located, mixed
from workbench.optics.kernels import threads

Face = tuple[Array, Array, Array]

# Steps of a search, at most, and how near it comes, in cells.
_MOST_STEPS, _NEAR = 40, 0.01
# How fast a face is taken to fall away from a ray, for each height, at least: with less, Newton
# steps of light that comes steeply to a steep face do not settle.
_LEAST_FALL = 0.5


def met(face: Face, cell: tuple[float, float], place: Pair, rise: Pair) -> Face:
    """Where rays meet a face, and its slopes there.

    Parameters
    ----------
    face : tuple of three ndarray, shape (m_0, m_1)
        Its height, and its slopes along both axes, in the middles of cells.
    cell : tuple[float, float]
        Widths of a cell; all cells together have their middle at 0.
    place : tuple of two ndarray, shape (n_0, n_1)
        Where rays are along both axes at height 0.
    rise : tuple of two ndarray, shape (n_0, n_1)
        How far they go along both axes for each height.

    Returns
    -------
    tuple of three ndarray, shape (n_0, n_1)
        Height and slopes where they meet it.
    """
    grids = [np.ascontiguousarray(part, np.float64) for part in face]
    x, y, a, b = (np.ascontiguousarray(part, np.float64) for part in (*place, *rise))
    found = np.empty_like(x), np.empty_like(x), np.empty_like(x)
    start = float(grids[0].mean())

    def work(begin: int, end: int) -> None:
        _met(*grids, *cell, x, y, a, b, start, *found, begin, end)

    threads.run_lines(work, len(x), x.size)
    return found


@jit(allocates=False)
def _met(  # type: ignore[no-untyped-def]
    z, z_x, z_y, width_0, width_1, x, y, a, b, start, height, slope_x, slope_y, begin, end
):
    """The rays of the lines from number ``begin`` to ``end``; see `met`."""
    m_0, m_1 = z.shape
    near = _NEAR * min(width_0, width_1)
    for k in range(begin, end):
        for n in range(x.shape[1]):
            at = start
            for _ in range(_MOST_STEPS):
                place_0 = (x[k, n] + a[k, n] * at) / width_0 + (m_0 - 1) / 2
                place_1 = (y[k, n] + b[k, n] * at) / width_1 + (m_1 - 1) / 2
                i, f = located(place_0, m_0)
                j, g = located(place_1, m_1)
                slope_x[k, n], slope_y[k, n] = mixed(z_x, i, f, j, g), mixed(z_y, i, f, j, g)
                fall = 1.0
                # Beyond the rim the face is level.
                if 0 <= place_0 <= m_0 - 1:
                    fall -= a[k, n] * slope_x[k, n]
                if 0 <= place_1 <= m_1 - 1:
                    fall -= b[k, n] * slope_y[k, n]
                step = (mixed(z, i, f, j, g) - at) / max(fall, _LEAST_FALL)
                at += step
                if abs(step) < near:
                    break
            height[k, n] = at
