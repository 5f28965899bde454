"""Where rays meet the faces of further elements, and the way back to the patches of B-splines."""

import numpy as np

from workbench.compiled import jit
from workbench.optics.kernels.intersection import MET, meet, polish
from workbench.optics.kernels.patches import (
    DEPTH,
    HIGH,
    LOW,
    SLOPE_X,
    SLOPE_Y,
    STATE,
    Z_S,
    Z_SS,
    Z_ST,
    Z_T,
    Z_TT,
    S,
    T,
    X,
    Y,
    Z,
    at,
    collect,
    evaluate_to_second_order,
    fill,
    place,
)
from workbench.optics.kernels.taps import FAST
from workbench.optics.train.numbers import ASPHERE, BSPLINE

# Steps to an asphere: of Newton's method, and then of bisection.
_NEWTON_STEPS, _BISECTIONS = 20, 60
# Rows of the search for an asphere, which those of B-splines are free for: r², the polynomial
# q = a₄ + a₆ r² + … with its derivatives by r².
R2, Q, Q_1, Q_2 = S, T, Z, Z_SS


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def search(element, tables, e, w, depths, lanes, patch, before, columns):  # type: ignore[no-untyped-def]
    """Where rays meet the face: depth, state and slopes.

    `element`, `e`: the element and its number; `tables`: patches of all B-splines, and aspheric
    coefficients of all elements; `w`: its registers; `depths`: of the batch for the last train:
    where the search for a B-spline begins. Changed: infinite for rays that do not meet it; `lanes`:
    how many rays there are; `patch`, `before`, `columns`: see
    `workbench.optics.kernels.intersection.meet`. Returns how many runs of rays there were that
    began in the same patch of a B-spline.
    """
    kind, (table, coefficients), runs = w.dtype.type, tables, 0
    if element.kind == BSPLINE:
        for lane in range(lanes):
            w[at(DEPTH, lane)] = depths[lane]
        runs = meet(element.net, element.bounds, table, w, lanes, patch, before, columns)
        polish(element.net, w, lanes)
        for lane in range(lanes):
            met = w[at(STATE, lane)] == kind(MET)
            depths[lane] = w[at(DEPTH, lane)] if met else kind(np.inf)
    else:
        _meet_conic(element, w, lanes)
        if element.kind == ASPHERE:
            _meet_asphere(element, coefficients, e, w, lanes)
            for lane in range(lanes):
                depths[lane] = w[at(DEPTH, lane)]
    return runs


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def search_again(element, tables, e, w, depths, lanes, patch, columns):  # type: ignore[no-untyped-def]
    """The same with the depths that were found, and the second derivatives of the face."""
    kind, (table, coefficients) = w.dtype.type, tables
    if element.kind == BSPLINE:
        for lane in range(lanes):
            met = depths[lane] < kind(np.inf)
            w[at(DEPTH, lane)] = depths[lane] if met else kind(0)
            w[at(STATE, lane)] = kind(MET) if met else kind(MET - 1)
            # Far beside the face polynomials overflow.
            w[at(X, lane)] = w[at(X, lane)] if met else kind(0)
            w[at(Y, lane)] = w[at(Y, lane)] if met else kind(0)
        place(element.net, w, lanes, patch)
        fill(table, patch, lanes, columns)
        evaluate_to_second_order(columns, w, lanes)
    elif element.kind == ASPHERE:
        for lane in range(lanes):
            w[at(DEPTH, lane)] = depths[lane]
        _polynomial(element, coefficients, e, w, lanes)
        _at_asphere(element, w, lanes)
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
        depth = first / root if there else zero
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
def _meet_asphere(element, coefficients, e, w, lanes):  # type: ignore[no-untyped-def]
    """Where lines meet a conic with aspheric terms; begins at the conic.

    Bracket, steps and tolerance are those of `workbench.optics.surfaces.Conic`.
    """
    kind = w.dtype.type
    for lane in range(lanes):
        w[at(DEPTH, lane)] = min(max(w[at(DEPTH, lane)], element.low), element.high)
        w[at(LOW, lane)] = element.low
        w[at(HIGH, lane)] = element.high
    for number in range(_NEWTON_STEPS + _BISECTIONS):
        _polynomial(element, coefficients, e, w, lanes)
        if _step(element, number < _NEWTON_STEPS, w, lanes) <= element.tolerance:
            break
    # One more step, as the reference makes it: it moves the depth by rounding at most.
    _polynomial(element, coefficients, e, w, lanes)
    for lane in range(lanes):
        f, slope = _height_above(element, w, lane)
        w[at(DEPTH, lane)] -= f / min(slope, kind(-1e-3))
    _polynomial(element, coefficients, e, w, lanes)
    _at_asphere(element, w, lanes)


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def _polynomial(element, coefficients, e, w, lanes):  # type: ignore[no-untyped-def]
    """The square of the radius at the depth of each ray, and the polynomial there."""
    kind = w.dtype.type
    last = coefficients.shape[1] - 1
    for lane in range(lanes):
        depth = w[at(DEPTH, lane)]
        x = w[at(X, lane)] + w[at(SLOPE_X, lane)] * depth
        y = w[at(Y, lane)] + w[at(SLOPE_Y, lane)] * depth
        w[at(R2, lane)] = min(x * x + y * y, element.reach2)
        w[at(Q, lane)] = coefficients[e, last]
        w[at(Q_1, lane)] = kind(0)
        w[at(Q_2, lane)] = kind(0)
    for number in range(last - 1, -1, -1):
        term = coefficients[e, number]
        for lane in range(lanes):
            r2, q, q_1 = w[at(R2, lane)], w[at(Q, lane)], w[at(Q_1, lane)]
            w[at(Q_2, lane)] = w[at(Q_2, lane)] * r2 + kind(2) * q_1
            w[at(Q_1, lane)] = q_1 * r2 + q
            w[at(Q, lane)] = q * r2 + term


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _height_above(element, w, lane):  # type: ignore[no-untyped-def]
    """How far the face is above a line at its depth, and how this changes with the depth."""
    kind = w.dtype.type
    zero, one, two = kind(0), kind(1), kind(2)
    a, b, depth = w[at(SLOPE_X, lane)], w[at(SLOPE_Y, lane)], w[at(DEPTH, lane)]
    x, y = w[at(X, lane)] + a * depth, w[at(Y, lane)] + b * depth
    r2, q, q_1 = w[at(R2, lane)], w[at(Q, lane)], w[at(Q_1, lane)]
    c = element.curvature
    root = np.sqrt(one - (one + element.conic) * c * c * r2)
    rise = c / (two * root) + r2 * (two * q + r2 * q_1)
    slope = two * rise * (a * x + b * y) if x * x + y * y <= element.reach2 else zero
    return c * r2 / (one + root) + r2 * r2 * q - depth, slope - one


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def _step(element, newton, w, lanes):  # type: ignore[no-untyped-def]
    """A step of Newton's method, or of bisection, for all rays; says how far they moved at most."""
    kind = w.dtype.type
    most = kind(0)
    for lane in range(lanes):
        f, slope = _height_above(element, w, lane)
        depth, low, high = w[at(DEPTH, lane)], w[at(LOW, lane)], w[at(HIGH, lane)]
        low, high = depth if f > kind(0) else low, high if f > kind(0) else depth
        step = depth - f / slope
        good = (abs(step - depth) <= element.tolerance) | (newton & (step > low) & (step < high))
        new = step if good else (low + high) * kind(0.5)
        w[at(DEPTH, lane)] = new
        w[at(LOW, lane)] = low
        w[at(HIGH, lane)] = high
        most = max(most, abs(new - depth))
    return most


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def _at_asphere(element, w, lanes):  # type: ignore[no-untyped-def]
    """Whether lines meet the asphere within its reach, and derivatives of the face there."""
    kind = w.dtype.type
    zero, one, two, half = kind(0), kind(1), kind(2), kind(0.5)
    c, k_1 = element.curvature, one + element.conic
    for lane in range(lanes):
        depth = w[at(DEPTH, lane)]
        x = w[at(X, lane)] + w[at(SLOPE_X, lane)] * depth
        y = w[at(Y, lane)] + w[at(SLOPE_Y, lane)] * depth
        there = x * x + y * y <= element.reach2
        r2, q, q_1, q_2 = (
            w[at(R2, lane)], w[at(Q, lane)], w[at(Q_1, lane)], w[at(Q_2, lane)]
        )  # fmt: skip
        bend = half * c / np.sqrt(one - k_1 * c * c * r2)
        # First and second derivative of the sag by r².
        rise = bend + r2 * (two * q + r2 * q_1)
        bends = two * k_1 * bend * bend * bend + two * q + r2 * (kind(4) * q_1 + r2 * q_2)
        x, y = x if there else zero, y if there else zero
        w[at(STATE, lane)] = kind(MET) if there else kind(MET - 1)
        w[at(Z_S, lane)] = two * rise * x
        w[at(Z_T, lane)] = two * rise * y
        w[at(Z_SS, lane)] = two * rise + kind(4) * bends * x * x
        w[at(Z_ST, lane)] = kind(4) * bends * x * y
        w[at(Z_TT, lane)] = two * rise + kind(4) * bends * y * y


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def face_back(element, w, lanes, patch, columns, d_table, touched):  # type: ignore[no-untyped-def]
    """Add the cotangents of a B-spline to those of its patches.

    `d_table` (patches, p, q): cotangents of the patches; changed; `touched` (2,): the first and the
    last patch of this element that was changed so far; changed.
    """
    if element.kind == BSPLINE:
        first, last = collect(w, lanes, patch, columns, d_table)
        touched[0] = min(touched[0], first)
        touched[1] = max(touched[1], last)
