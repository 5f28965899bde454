"""One pass from rays behind the entrance face to light on the screen, and its adjoint.

Batches of rays go all the way while they are in the first-level cache. The adjoint keeps nothing
of the trace but the depth of each ray: it computes the rest again.
"""

import math
from typing import Any, NamedTuple

import numpy as np

from workbench.compiled import jit
from workbench.optics.kernels.point_meet import MET, meet
from workbench.optics.kernels.point_patches import (
    COLUMN,
    D_COLUMN,
    D_ROW,
    D_S,
    D_T,
    D_WEIGHT,
    D_Z,
    DEPTH,
    FLUX,
    PASSES,
    ROW,
    ROWS,
    SLOPE_X,
    SLOPE_Y,
    STATE,
    WEIGHT,
    Z_S,
    Z_SS,
    Z_ST,
    Z_T,
    Z_TT,
    X,
    Y,
    Z,
    at,
    collect,
    evaluate_to_second_order,
    fill,
    make_columns,
    place,
)
from workbench.optics.kernels.spread import BATCH, gather, scatter, workspace
from workbench.optics.kernels.taps import FAST
from workbench.optics.kernels.transmittance import transmittance, transmittance_slopes
from workbench.optics.transmittance import TransmittanceLaw

# Sums that a trace returns: flux on the screen, beside it, totally reflected, reflected by Fresnel,
# left through the side, absorbed; and the number of runs of rays that began in the same patch.
ON_SCREEN, BESIDE, TOTAL, FRESNEL, SIDE, ABSORBED, RUNS = range(7)
SUMS = 7


class Glass(NamedTuple):
    """What a trace needs to know of the lens but its face; numbers in the trace's float type.

    Attributes
    ----------
    eta, tilt : floating
        Refractive index η, and 1 − η².
    critical : floating
        Squared cosines up to here count as total reflection.
    distance : floating
        From the entrance face to the screen.
    absorption : floating
        Of the glass, per length.
    start : floating
        Where the glass begins, counted as depths are.
    law : TransmittanceLaw
        How the exit face refracts.
    """

    eta: np.floating[Any]
    tilt: np.floating[Any]
    critical: np.floating[Any]
    distance: np.floating[Any]
    absorption: np.floating[Any]
    start: np.floating[Any]
    law: TransmittanceLaw


def make_glass(
    law: TransmittanceLaw,
    distance: float,
    absorption: float,
    start: float,
    kind: type[np.floating[Any]],
) -> Glass:
    """Prepare a lens, and a screen at some distance, for kernels of a float type."""
    critical = 16 * float(np.finfo(kind).eps)
    numbers = (law.ratio, 1 - law.ratio**2, critical, distance, absorption, start)
    return Glass._make([*map(kind, numbers), law.cast(kind)])


@jit(fastmath=FAST, error_model="numpy")
def trace(net, bounds, table, glass, spread, bundle, last, first, end, depths, canvas):  # type: ignore[no-untyped-def]
    """Trace rays to the screen.

    Parameters
    ----------
    net, bounds, table
        The face.
    glass, spread
        The lens, and the screen with its filter.
    bundle : array, shape (5, rays)
        x, y, slopes and flux of the rays.
    last : array, shape (rays,)
        Depths from which to start.
    first, end : int
        Which of the rays to trace.
    depths : array, shape (rays,)
        The depths of the roots; infinite for rays that left through the side.
    canvas : array
        Where the light is added.

    Returns
    -------
    array of float64, shape (SUMS,)
    """
    kind = bundle.dtype.type
    w = np.empty(ROWS * BATCH, bundle.dtype)
    columns = make_columns(table)
    patch, before = np.zeros(BATCH, np.int32), np.empty(BATCH, np.int32)
    work = workspace(spread, bundle)
    column, row, weight = _row(w, COLUMN), _row(w, ROW), _row(w, WEIGHT)
    sums = np.zeros(SUMS)
    for start in range(first, end, BATCH):
        count = min(BATCH, end - start)
        _load(bundle, start, count, w)
        depth = last[start : start + count]
        for ray in range(count):
            w[at(DEPTH, ray)] = depth[ray]
        sums[RUNS] += meet(net, bounds, table, w, count, patch, before, columns)
        polish(net, w, count)
        if glass.absorption > kind(0):
            sums[ABSORBED] += _absorb(glass, w, count)
        _hit(net, glass, spread, w, count)
        _account(w, count, sums)
        on_screen, beside = scatter(spread, column, row, weight, count, work, canvas)
        sums[ON_SCREEN] += on_screen
        sums[BESIDE] += beside
        depth = depths[start : start + count]
        for ray in range(count):
            met = w[at(STATE, ray)] == kind(MET)
            depth[ray] = w[at(DEPTH, ray)] if met else kind(np.inf)
    return sums


@jit(fastmath=FAST, error_model="numpy")
def adjoint(net, table, glass, spread, bundle, depths, first, end, cotangent, d_table):  # type: ignore[no-untyped-def]
    """Add to the cotangents of a table of patches what comes from some rays.

    Parameters
    ----------
    net, table, glass, spread, bundle, first, end
        As for `trace`.
    depths : array, shape (rays,)
        The depths that it found.
    cotangent : array
        Cotangent of the canvas.
    d_table : array of float64, shape (patches, p + 1, q + 1)
        Cotangents of the coefficients; changed.
    """
    kind = bundle.dtype.type
    w = np.empty(ROWS * BATCH, bundle.dtype)
    columns = make_columns(table)
    patch = np.zeros(BATCH, np.int32)
    work = workspace(spread, bundle)
    column, row, weight = _row(w, COLUMN), _row(w, ROW), _row(w, WEIGHT)
    d_column, d_row, d_weight = _row(w, D_COLUMN), _row(w, D_ROW), _row(w, D_WEIGHT)
    for start in range(first, end, BATCH):
        count = min(BATCH, end - start)
        _load(bundle, start, count, w)
        depth = depths[start : start + count]
        for ray in range(count):
            met = depth[ray] < kind(np.inf)
            w[at(DEPTH, ray)] = depth[ray] if met else kind(0)
            w[at(STATE, ray)] = kind(MET) if met else kind(MET - 1)
        place(net, w, count, patch)
        fill(table, patch, count, columns)
        evaluate_to_second_order(columns, w, count)
        if glass.absorption > kind(0):
            _absorb(glass, w, count)
        _hit(net, glass, spread, w, count)
        gather(spread, column, row, weight, count, work, cotangent, d_column, d_row, d_weight)
        _hit_adjoint(net, glass, spread, w, count)
        collect(w, count, patch, columns, d_table)


@jit()
def _row(w, row):  # type: ignore[no-untyped-def]
    return w[row * BATCH : (row + 1) * BATCH]


@jit()
def _load(bundle, start, count, w):  # type: ignore[no-untyped-def]
    for row in (X, Y, SLOPE_X, SLOPE_Y, FLUX):
        source = bundle[row, start : start + count]
        for ray in range(count):
            w[at(row, ray)] = source[ray]


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def polish(net, w, count):  # type: ignore[no-untyped-def]
    """One more step, as the reference makes it: it moves the depth by rounding at most."""
    kind = w.dtype.type
    for ray in range(count):
        slope = w[at(Z_S, ray)] * net.per_x * w[at(SLOPE_X, ray)]
        slope += w[at(Z_T, ray)] * net.per_y * w[at(SLOPE_Y, ray)] - kind(1)
        step = (w[at(Z, ray)] - w[at(DEPTH, ray)]) / min(slope, kind(-1e-3))
        w[at(DEPTH, ray)] -= step if w[at(STATE, ray)] == kind(MET) else kind(0)


@jit(fastmath=FAST, error_model="numpy", forceinline=True)
def _snell(net, glass, w, ray):  # type: ignore[no-untyped-def]
    """Snell's law for one ray; see `refraction.refract`.

    Returns
    -------
    tuple
        Slopes of the face and 1 / |(−z_x, −z_y, 1)|, cosines in and out, factor of the normal,
        whether the light passes, and whether it does so towards the screen.
    """
    kind = w.dtype.type
    one = kind(1)
    a, b = w[at(SLOPE_X, ray)], w[at(SLOPE_Y, ray)]
    z_x, z_y = w[at(Z_S, ray)] * net.per_x, w[at(Z_T, ray)] * net.per_y
    d_z = one / math.sqrt(one + a * a + b * b)
    length = one / math.sqrt(one + z_x * z_x + z_y * z_y)
    cos_in = (one - a * z_x - b * z_y) * d_z * length
    square = one - glass.eta * glass.eta * (one - cos_in * cos_in)
    passes = (square > glass.critical) & (w[at(STATE, ray)] == kind(MET))
    cos_out = math.sqrt(square if passes else one)
    along = glass.tilt / (cos_out + glass.eta * cos_in)
    onward = passes & (glass.eta * d_z + along * length > kind(1e-6))
    return d_z, z_x, z_y, length, cos_in, cos_out, along, passes, onward


@jit(fastmath=FAST, error_model="numpy")
def _hit(net, glass, spread, w, count):  # type: ignore[no-untyped-def]
    """Columns, rows and weights of rays on the screen."""
    kind = w.dtype.type
    for ray in range(count):
        d_z, z_x, z_y, length, cos_in, cos_out, along, passes, onward = _snell(net, glass, w, ray)
        depth = w[at(DEPTH, ray)]
        a, b = w[at(SLOPE_X, ray)], w[at(SLOPE_Y, ray)]
        by_normal = along * length
        out_z = glass.eta * d_z + by_normal
        path = (glass.distance - depth) / (out_z if onward else kind(1))
        x = w[at(X, ray)] + a * depth + (glass.eta * d_z * a - by_normal * z_x) * path
        y = w[at(Y, ray)] + b * depth + (glass.eta * d_z * b - by_normal * z_y) * path
        w[at(COLUMN, ray)] = spread.column_0 + spread.per_x * x if onward else kind(np.inf)
        w[at(ROW, ray)] = spread.row_0 + spread.per_y * y if onward else kind(np.inf)
        weight = w[at(FLUX, ray)] * transmittance(glass.law, cos_in, cos_out)
        w[at(WEIGHT, ray)] = weight if passes else kind(0)
        w[at(PASSES, ray)] = kind(1) if passes else kind(0)


@jit(fastmath=FAST, error_model="numpy")
def _absorb(glass, w, count):  # type: ignore[no-untyped-def]
    """Take from rays that met the face what the glass absorbs; gives that flux."""
    kind = w.dtype.type
    one, absorbed = kind(1), kind(0)
    for ray in range(count):
        a, b = w[at(SLOPE_X, ray)], w[at(SLOPE_Y, ray)]
        way = abs(w[at(DEPTH, ray)] - glass.start) * math.sqrt(one + a * a + b * b)
        met = w[at(STATE, ray)] == kind(MET)
        left = w[at(FLUX, ray)] * math.exp(-glass.absorption * way) if met else w[at(FLUX, ray)]
        absorbed += w[at(FLUX, ray)] - left
        w[at(FLUX, ray)] = left
    return np.float64(absorbed)


@jit(fastmath=FAST, error_model="numpy")
def _account(w, count, sums):  # type: ignore[no-untyped-def]
    """Where the light of a batch stays that does not leave the exit face."""
    kind = w.dtype.type
    total, fresnel, side = kind(0), kind(0), kind(0)
    for ray in range(count):
        flux, weight = w[at(FLUX, ray)], w[at(WEIGHT, ray)]
        passing = flux * w[at(PASSES, ray)]
        arriving = flux if w[at(STATE, ray)] == kind(MET) else kind(0)
        fresnel += passing - weight
        total += arriving - passing
        side += flux - arriving
    sums[TOTAL] += total
    sums[FRESNEL] += fresnel
    sums[SIDE] += side


@jit(fastmath=FAST, error_model="numpy")
def _hit_adjoint(net, glass, spread, w, count):  # type: ignore[no-untyped-def]
    """Cotangents of height and local slopes of the face from those of hits.

    By the implicit function theorem a ray's root moves by −δz / f' where the face rises by δz.
    """
    kind = w.dtype.type
    for ray in range(count):
        d_z, z_x, z_y, length, cos_in, cos_out, along, _, onward = _snell(net, glass, w, ray)
        a, b = w[at(SLOPE_X, ray)], w[at(SLOPE_Y, ray)]
        d_x, d_y = a * d_z, b * d_z
        by_normal = along * length
        out_x = glass.eta * d_x - by_normal * z_x
        out_y = glass.eta * d_y - by_normal * z_y
        over_z = kind(1) / (glass.eta * d_z + by_normal if onward else kind(1))
        path = (glass.distance - w[at(DEPTH, ray)]) * over_z

        c_x, c_y = w[at(D_COLUMN, ray)] * spread.per_x, w[at(D_ROW, ray)] * spread.per_y
        c_path = c_x * out_x + c_y * out_y
        c_depth = c_x * a + c_y * b - c_path * over_z
        c_out_x, c_out_y, c_out_z = c_x * path, c_y * path, -c_path * path * over_z
        c_by_normal = c_out_z - c_out_x * z_x - c_out_y * z_y
        c_z_x, c_z_y = -c_out_x * by_normal, -c_out_y * by_normal
        c_length = c_by_normal * along
        c_cosines = -c_by_normal * by_normal / (cos_out + glass.eta * cos_in)
        by_in, by_out = transmittance_slopes(glass.law, cos_in, cos_out)
        c_part = w[at(D_WEIGHT, ray)] * w[at(FLUX, ray)]
        c_cos_out = c_cosines + c_part * by_out
        c_cos_in = glass.eta * (c_cosines + c_cos_out * glass.eta * cos_in / cos_out)
        c_cos_in += c_part * by_in
        per_depth = glass.absorption / d_z
        forward = w[at(DEPTH, ray)] > glass.start
        c_absorbed = w[at(D_WEIGHT, ray)] * w[at(WEIGHT, ray)] * per_depth
        c_depth += -c_absorbed if forward else c_absorbed
        c_length += c_cos_in * cos_in / length
        c_normal = c_length * length * length * length
        c_z_x -= c_cos_in * d_x * length + c_normal * z_x
        c_z_y -= c_cos_in * d_y * length + c_normal * z_y

        c_s, c_t = c_z_x * net.per_x, c_z_y * net.per_y
        s_depth, t_depth = a * net.per_x, b * net.per_y
        c_depth += c_s * (w[at(Z_SS, ray)] * s_depth + w[at(Z_ST, ray)] * t_depth)
        c_depth += c_t * (w[at(Z_ST, ray)] * s_depth + w[at(Z_TT, ray)] * t_depth)
        slope = min(a * z_x + b * z_y - kind(1), kind(-1e-3))
        w[at(D_Z, ray)] = -c_depth / slope if onward else kind(0)
        w[at(D_S, ray)] = c_s if onward else kind(0)
        w[at(D_T, ray)] = c_t if onward else kind(0)
