"""The loops of `workbench.optics.kernels.collimated`, and their adjoints.

A batch is up to ``BATCH`` rays with one v and neighbouring u. For a block of so many u the control
heights are contracted with the basis along x once, into rows that lie side by side; each v then
blends q + 1 of these rows. So all loops run along u over neighbouring numbers, and vectorise.
"""

from typing import Any, NamedTuple

import numpy as np

from workbench.compiled import jit
from workbench.optics.kernels.grid import (
    Z_X,
    Z_Y,
    Z,
    blend,
    blend_back,
    contract,
    contract_back,
    make_rows,
)
from workbench.optics.kernels.spread import BATCH, gather, scatter, workspace
from workbench.optics.kernels.taps import FAST

# The numbers of a batch, after height and slopes.
_Q, _BEND, _COLUMN, _ROW, _WEIGHT, _D_COLUMN, _D_ROW, _D_WEIGHT = (
    np.uintp(BATCH * k) for k in range(3, 11)
)
_NUMBERS = 11 * BATCH
_STEP = np.uintp(BATCH)


class Optics(NamedTuple):
    """Numbers of a trace, in its float type.

    Attributes
    ----------
    ratio : floating
        Refractive index n.
    excess : floating
        n² − 1.
    drop : floating
        How far the screen is above the level that heights are counted from.
    critical : floating
        Squared cosines below this count as total reflection.
    arriving : floating
        Flux of a ray before the exit face.
    head_on : floating
        Flux of a ray that leaves at a right angle.
    """

    ratio: np.floating[Any]
    excess: np.floating[Any]
    drop: np.floating[Any]
    critical: np.floating[Any]
    arriving: np.floating[Any]
    head_on: np.floating[Any]


@jit(fastmath=FAST, error_model="numpy")
def trace_rows(  # type: ignore[no-untyped-def]
    heights, across, up, optics, spread, begin, end, canvas, sums
):
    """Trace the rays from number ``begin`` to ``end`` along u, and all along v.

    Parameters
    ----------
    heights : array, shape (n_u, n_v)
        Control heights above the level.
    across, up : Axis
        Rays along x and y; ``place`` in columns and rows.
    optics : Optics
        Numbers of the trace.
    spread : Spread
        Screen and filter.
    begin, end : int
        Which rays.
    canvas : array, shape (rows, columns)
        Where their light goes; changed.
    sums : array of float64, shape (3,)
        Results: light on the screen and beside it, number of refracted rays.
    """
    rows = make_rows(heights)
    t = np.empty(_NUMBERS, heights.dtype)
    work = workspace(spread, heights)
    column = t[_COLUMN : _COLUMN + _STEP]
    row = t[_ROW : _ROW + _STEP]
    weight = t[_WEIGHT : _WEIGHT + _STEP]
    blocks = (end - begin + BATCH - 1) // BATCH
    for block in range(blocks):
        i = begin + (end - begin) * block // blocks
        lanes = begin + (end - begin) * (block + 1) // blocks - i
        place = across.place[i : i + lanes]
        contract(heights, across, i, lanes, rows)
        for j in range(len(up.place)):
            blend(rows, up, j, lanes, t)
            sums[2] += _refract(place, up.place[j], optics, spread, lanes, t)
            on_screen, beside = scatter(spread, column, row, weight, lanes, work, canvas)
            sums[0] += on_screen
            sums[1] += beside


@jit(fastmath=FAST, error_model="numpy")
def trace_rows_back(  # type: ignore[no-untyped-def]
    heights, across, up, optics, spread, begin, end, cotangent, gradient
):
    """Adjoint of `trace_rows`.

    Parameters
    ----------
    heights, across, up, optics, spread, begin, end
        As for `trace_rows`.
    cotangent : array, shape (rows, columns)
        Cotangent of the canvas.
    gradient : array of float64, shape (n_u, n_v)
        Cotangent of the heights; added to.
    """
    kind = heights.dtype.type
    rows = make_rows(heights)
    d_rows = make_rows(heights)
    t = np.empty(_NUMBERS, heights.dtype)
    work = workspace(spread, heights)
    column = t[_COLUMN : _COLUMN + _STEP]
    row = t[_ROW : _ROW + _STEP]
    weight = t[_WEIGHT : _WEIGHT + _STEP]
    d_column = t[_D_COLUMN : _D_COLUMN + _STEP]
    d_row = t[_D_ROW : _D_ROW + _STEP]
    d_weight = t[_D_WEIGHT : _D_WEIGHT + _STEP]
    blocks = (end - begin + BATCH - 1) // BATCH
    for block in range(blocks):
        i = begin + (end - begin) * block // blocks
        lanes = begin + (end - begin) * (block + 1) // blocks - i
        place = across.place[i : i + lanes]
        contract(heights, across, i, lanes, rows)
        d_rows[:] = kind(0)
        for j in range(len(up.place)):
            blend(rows, up, j, lanes, t)
            _refract(place, up.place[j], optics, spread, lanes, t)
            gather(
                spread,
                column,
                row,
                weight,
                lanes,
                work,
                cotangent,
                d_column,
                d_row,
                d_weight,
            )
            _refract_back(optics, spread, lanes, t)
            blend_back(d_rows, up, j, lanes, t)
        contract_back(d_rows, across, i, lanes, gradient)


@jit(fastmath=FAST, error_model="numpy", forceinline=True)
def _refract(place, row, optics, spread, lanes, t):  # type: ignore[no-untyped-def]
    """Where rays hit, and their flux; says how many are refracted.

    The formulas are those of `optics.collimated`.
    """
    kind = t.dtype.type
    one = kind(1)
    passed = kind(0)
    for lane in range(np.uintp(lanes)):
        z_x, z_y = t[Z_X + lane], t[Z_Y + lane]
        k = z_x * z_x + z_y * z_y
        square = one - optics.excess * k
        passes = square > optics.critical
        q = np.sqrt(square if passes else one)
        bend = (optics.drop - t[Z + lane]) * optics.excess / (one + optics.ratio * q)
        grazing = one - q / np.sqrt(one + k)
        fourth = grazing * grazing * (grazing * grazing)
        weight = optics.head_on * (one - fourth * grazing) if passes else kind(0)
        t[_Q + lane] = q
        t[_BEND + lane] = bend
        t[_COLUMN + lane] = place[lane] + spread.per_x * z_x * bend
        t[_ROW + lane] = row + spread.per_y * z_y * bend
        t[_WEIGHT + lane] = weight
        passed += one if passes else kind(0)
    return np.float64(passed)


@jit(fastmath=FAST, error_model="numpy", forceinline=True)
def _refract_back(optics, spread, lanes, t):  # type: ignore[no-untyped-def]
    """Adjoint of `_refract`; the cotangents of z, z_x, z_y take the place of these."""
    kind = t.dtype.type
    one, two, half = kind(1), kind(2), kind(0.5)
    for lane in range(np.uintp(lanes)):
        z_x, z_y = t[Z_X + lane], t[Z_Y + lane]
        q, bend = t[_Q + lane], t[_BEND + lane]
        passes = t[_WEIGHT + lane] > kind(0)
        d_x = t[_D_COLUMN + lane] * spread.per_x
        d_y = t[_D_ROW + lane] * spread.per_y
        share = one / (one + optics.ratio * q)
        d_bend = d_x * z_x + d_y * z_y
        # weight = head_on (1 − g⁵), g = 1 − q s, s = 1 / √(1 + k)
        s = one / np.sqrt(one + z_x * z_x + z_y * z_y)
        grazing = one - q * s
        fourth = grazing * grazing * (grazing * grazing)
        d_cos = kind(5) * fourth * optics.head_on * t[_D_WEIGHT + lane]
        d_q = d_cos * s - d_bend * bend * optics.ratio * share
        # q = √(1 − (n² − 1) k)
        d_k = -half * (d_cos * q * s * s * s + d_q * optics.excess / q)
        d_z_x = d_x * bend + two * z_x * d_k
        d_z_y = d_y * bend + two * z_y * d_k
        d_z = -d_bend * optics.excess * share
        t[Z + lane] = d_z if passes else kind(0)
        t[Z_X + lane] = d_z_x if passes else kind(0)
        t[Z_Y + lane] = d_z_y if passes else kind(0)
