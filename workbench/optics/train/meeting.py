"""Where rays meet the faces of further elements, and the way back to the patches of B-splines."""

import numpy as np

from workbench.compiled import jit
from workbench.optics.kernels.point_meet import MET, meet
from workbench.optics.kernels.point_patches import (
    DEPTH,
    SLOPE_X,
    SLOPE_Y,
    STATE,
    Z_S,
    Z_SS,
    Z_ST,
    Z_T,
    Z_TT,
    X,
    Y,
    at,
    collect,
    evaluate_to_second_order,
    fill,
    place,
)
from workbench.optics.kernels.point_trace import polish
from workbench.optics.kernels.taps import FAST
from workbench.optics.train.numbers import BSPLINE


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def search(element, table, w, depths, lanes, patch, before, columns):  # type: ignore[no-untyped-def]
    """Where rays meet the face: depth, state and slopes.

    Parameters
    ----------
    element, table
        The element, and the patches of all B-splines.
    w : array
        Its registers.
    depths : array
        Of the batch for the last train: where the search for a B-spline begins. Changed: infinite
        for rays that do not meet it.
    lanes : int
        How many rays there are.
    patch, before, columns
        See `workbench.optics.kernels.point_meet.meet`.
    """
    kind = w.dtype.type
    if element.kind == BSPLINE:
        for lane in range(lanes):
            w[at(DEPTH, lane)] = depths[lane]
        meet(element.net, element.bounds, table, w, lanes, patch, before, columns)
        polish(element.net, w, lanes)
        for lane in range(lanes):
            met = w[at(STATE, lane)] == kind(MET)
            depths[lane] = w[at(DEPTH, lane)] if met else kind(np.inf)
    else:
        _meet_conic(element, w, lanes)


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def search_again(element, table, w, depths, lanes, patch, columns):  # type: ignore[no-untyped-def]
    """The same with the depths that were found, and the second derivatives of the face."""
    kind = w.dtype.type
    if element.kind == BSPLINE:
        for lane in range(lanes):
            met = depths[lane] < kind(np.inf)
            w[at(DEPTH, lane)] = depths[lane] if met else kind(0)
            w[at(STATE, lane)] = kind(MET) if met else kind(MET - 1)
        place(element.net, w, lanes, patch)
        fill(table, patch, lanes, columns)
        evaluate_to_second_order(columns, w, lanes)
    else:
        _meet_conic(element, w, lanes)


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def _meet_conic(element, w, lanes):  # type: ignore[no-untyped-def]
    """Where lines meet a conic z = c r² / (1 + √(1 − (1 + k) c² r²)), in closed form.

    Welford, *Aberrations of Optical Systems*, section 4.3. A plane has the curvature 0.
    """
    kind = w.dtype.type
    zero, one = kind(0), kind(1)
    c, k_1 = element.curvature, one + element.conic
    for lane in range(lanes):
        x, y = w[at(X, lane)], w[at(Y, lane)]
        a, b = w[at(SLOPE_X, lane)], w[at(SLOPE_Y, lane)]
        half = one - c * (a * x + b * y)
        first = c * (x * x + y * y)
        square = half * half - c * (a * a + b * b + k_1) * first
        root = half + np.sqrt(max(square, zero))
        there = (square > zero) & (root > zero)
        depth = first / (root if there else one)
        x, y = x + a * depth, y + b * depth
        rest = one - k_1 * c * c * (x * x + y * y)
        there = there & (rest > zero) & (one - k_1 * c * depth > zero)
        by_root = one / np.sqrt(rest if there else one)
        bend = c * by_root
        cubed = k_1 * bend * bend * bend
        w[at(DEPTH, lane)] = depth
        w[at(STATE, lane)] = kind(MET) if there else kind(MET - 1)
        w[at(Z_S, lane)] = bend * x
        w[at(Z_T, lane)] = bend * y
        w[at(Z_SS, lane)] = bend + cubed * x * x
        w[at(Z_ST, lane)] = cubed * x * y
        w[at(Z_TT, lane)] = bend + cubed * y * y


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def face_back(element, w, lanes, patch, columns, d_table):  # type: ignore[no-untyped-def]
    """Add the cotangents of a B-spline to those of its patches."""
    if element.kind == BSPLINE:
        collect(w, lanes, patch, columns, d_table)
