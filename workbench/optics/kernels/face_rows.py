"""Samples of the exit face, row by row: what the threads of `kernels.face` run."""

import numpy as np

from workbench.compiled import jit
from workbench.optics.kernels.face_trace import (
    COLUMN,
    D_COLUMN,
    D_ROW,
    D_WEIGHT,
    NUMBERS,
    ROW,
    WEIGHT,
    find_part,
    refract,
    refract_back,
    see_points,
)
from workbench.optics.kernels.grid import blend, blend_back, contract, contract_back, make_rows
from workbench.optics.kernels.spread import BATCH, gather, scatter, workspace
from workbench.optics.kernels.taps import FAST


@jit(fastmath=FAST, error_model="numpy")
def trace_rows(  # type: ignore[no-untyped-def]
    heights, bases, across, up, optics, steps, spread, begin, end, canvas, sums
):
    """Trace the samples from number ``begin`` to ``end`` along u, and all along v.

    Parameters
    ----------
    heights : array, shape (n_u, n_v)
        Control heights above the level.
    bases : tuple of two `grid.Axis`
        Basis functions at the samples.
    across, up, optics
        Samples along x and y, and numbers of the trace.
    steps : int
        Steps of Newton's method.
    spread : Spread
        Screen and filter.
    begin, end : int
        Which samples.
    canvas : array, shape (rows, columns)
        Where their light goes; changed.
    sums : array of float64, shape (4,)
        Results: light on the screen and beside it, light that met the face and that was not
        totally reflected there.
    """
    rows = make_rows(heights)
    t = np.empty(NUMBERS, heights.dtype)
    work = workspace(spread, heights)
    column, row, weight = t[COLUMN:ROW], t[ROW:WEIGHT], t[WEIGHT:D_COLUMN]
    blocks = (end - begin + BATCH - 1) // BATCH
    for block in range(blocks):
        i = begin + (end - begin) * block // blocks
        lanes = begin + (end - begin) * (block + 1) // blocks - i
        contract(heights, bases[0], i, lanes, rows)
        for j in range(len(up.place)):
            blend(rows, bases[1], j, lanes, t)
            find_part(across.away[i:], up.away[j], optics, steps, lanes, t)
            see_points(across, i, up, j, optics, lanes, t)
            met, passed = refract(across, i, up, j, optics, spread, lanes, t)
            on_screen, beside = scatter(spread, column, row, weight, lanes, work, canvas)
            sums[0] += on_screen
            sums[1] += beside
            sums[2] += met
            sums[3] += passed


@jit(fastmath=FAST, error_model="numpy")
def trace_rows_back(  # type: ignore[no-untyped-def]
    heights, bases, across, up, optics, steps, spread, begin, end, cotangent, gradient
):
    """Adjoint of `trace_rows`.

    Parameters
    ----------
    heights, bases, across, up, optics, steps, spread, begin, end
        As for `trace_rows`.
    cotangent : array, shape (rows, columns)
        Cotangent of the canvas.
    gradient : array of float64, shape (n_u, n_v)
        Cotangent of the heights; added to.
    """
    kind = heights.dtype.type
    rows = make_rows(heights)
    d_rows = make_rows(heights)
    t = np.empty(NUMBERS, heights.dtype)
    work = workspace(spread, heights)
    column, row, weight = t[COLUMN:ROW], t[ROW:WEIGHT], t[WEIGHT:D_COLUMN]
    d_column, d_row, d_weight = t[D_COLUMN:D_ROW], t[D_ROW:D_WEIGHT], t[D_WEIGHT:]
    blocks = (end - begin + BATCH - 1) // BATCH
    for block in range(blocks):
        i = begin + (end - begin) * block // blocks
        lanes = begin + (end - begin) * (block + 1) // blocks - i
        contract(heights, bases[0], i, lanes, rows)
        d_rows[:] = kind(0)
        for j in range(len(up.place)):
            blend(rows, bases[1], j, lanes, t)
            find_part(across.away[i:], up.away[j], optics, steps, lanes, t)
            see_points(across, i, up, j, optics, lanes, t)
            refract(across, i, up, j, optics, spread, lanes, t)
            gather(spread, column, row, weight, lanes, work, cotangent, d_column, d_row, d_weight)
            refract_back(across, i, up, j, optics, spread, lanes, t)
            blend_back(d_rows, bases[1], j, lanes, t)
        contract_back(d_rows, bases[0], i, lanes, gradient)
