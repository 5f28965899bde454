"""Patches of B-spline faces for batches of rays.

Each ray of a batch has the coefficients of its patch in a column of its own, where the steps of
Newton's method find them without an index. Rays are kept sorted by patch, so that a column is one
of a run of equal ones, filled quickly; nothing but speed depends on it.

A batch lives in one flat array of rows of ``BATCH`` numbers, row k from k BATCH on. With distances
between rows that the compiler knows, and indices that it knows not to be negative, its loops
vectorise without any check.
"""

from typing import Any, NamedTuple

import numpy as np

from workbench.compiled import jit
from workbench.geometry.surface import ControlNet
from workbench.optics.kernels.spread import BATCH
from workbench.optics.kernels.taps import FAST
from workbench.optics.surfaces.intersection import RIM

# Where runs are shorter than this, coefficients are better looked up ray by ray.
_SHORT_RUN = 10

# Rows of a batch. First what is known of the rays, and how deep they are.
X, Y, SLOPE_X, SLOPE_Y, FLUX, DEPTH = 0, 1, 2, 3, 4, 5
# Local coordinates in their patches, the face there and its derivatives, in local coordinates too.
S, T, Z, Z_S, Z_T, Z_SS, Z_ST, Z_TT = 6, 7, 8, 9, 10, 11, 12, 13
# Search: ends of the bracket, state, and whether the ray is still on its way.
LOW, HIGH, STATE, BUSY = 14, 15, 16, 17
# Cotangents of height and slopes.
D_Z, D_S, D_T = 18, 19, 20
# A polynomial of t and its derivatives, and a power of s with its derivative.
_INNER, _INNER_T, _INNER_TT, _POWER, _POWER_S = 21, 22, 23, 24, 25
ROWS = 26


class Net(NamedTuple):
    """A control net as the kernels want it; numbers in the trace's float type."""

    # Half-widths of the aperture.
    half_x: np.floating[Any]
    half_y: np.floating[Any]
    # How far from the axis rays meet the face: see `workbench.optics.surfaces.intersection.RIM`.
    rim_x: np.floating[Any]
    rim_y: np.floating[Any]
    # Knot spans per unit of length.
    per_x: np.floating[Any]
    per_y: np.floating[Any]
    spans: tuple[int, int]  # numbers of knot spans
    first: int = 0  # number of the first patch in a table that holds those of several faces


def make_net(net: ControlNet, kind: type[np.floating[Any]]) -> Net:
    """Prepare a control net for kernels of a float type."""
    (n_u, n_v), (p, q), (r_x, r_y) = net.shape, net.degree, net.half_width
    spans = n_u - p, n_v - q
    per_x, per_y = kind(spans[0] / (2 * r_x)), kind(spans[1] / (2 * r_y))
    rim_x, rim_y = kind(r_x * RIM), kind(r_y * RIM)
    return Net(kind(r_x), kind(r_y), rim_x, rim_y, per_x, per_y, spans)


@jit(inline="always")
def at(row, ray):  # type: ignore[no-untyped-def]
    """Where a ray's number is in the flat array of a batch."""
    return np.uintp(row) * np.uintp(BATCH) + np.uintp(ray)


@jit()
def make_columns(table):  # type: ignore[no-untyped-def]
    """Room for the coefficients of a batch."""
    return np.empty((table.shape[1], table.shape[2] * BATCH), table.dtype)


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def span_of(u, last):  # type: ignore[no-untyped-def]
    """Knot span of a coordinate, the nearest one for those beyond; what is not a number has one."""
    inside = u if u > type(u)(0) else type(u)(0)
    return np.floor(inside if inside < last else last)


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def place(net, w, count, patch):  # type: ignore[no-untyped-def]
    """Patches and local coordinates of a batch of rays; says how many changed their patch."""
    kind = w.dtype.type
    half = kind(0.5)
    last_x, last_y = kind(net.spans[0] - 1), kind(net.spans[1] - 1)
    up = np.int32(net.spans[1])
    changed = np.int32(0)
    for ray in range(count):
        depth = w[at(DEPTH, ray)]
        u = (w[at(X, ray)] + w[at(SLOPE_X, ray)] * depth + net.half_x) * net.per_x
        v = (w[at(Y, ray)] + w[at(SLOPE_Y, ray)] * depth + net.half_y) * net.per_y
        span_x, span_y = span_of(u, last_x), span_of(v, last_y)
        w[at(S, ray)] = u - (span_x + half)
        w[at(T, ray)] = v - (span_y + half)
        new = np.int32(span_x) * up + np.int32(span_y) + np.int32(net.first)
        changed += np.int32(new != patch[ray])
        patch[ray] = new
    return changed


@jit(allocates=False)
def fill(table, patch, count, columns):  # type: ignore[no-untyped-def]
    """Give all rays the coefficients of their patches; says how many runs of equal ones there are.

    `table` (patches, p + 1, q + 1): coefficients; `patch` (BATCH,): patches of the rays; `count`:
    how many rays there are; `columns` (p + 1, (q + 1) BATCH).
    """
    runs = 1
    for ray in range(1, count):
        runs += patch[ray] != patch[ray - 1]
    if runs * _SHORT_RUN > count:
        _look_up(table, patch, count, columns)
    else:
        _repeat(table, patch, count, columns)
    return runs


@jit(allocates=False)
def _look_up(table, patch, count, columns):  # type: ignore[no-untyped-def]
    flat = table.reshape(-1)
    terms = np.uintp(table.shape[1] * table.shape[2])
    for a in range(table.shape[1]):
        for b in range(table.shape[2]):
            row, term = columns[a, b * BATCH : (b + 1) * BATCH], np.uintp(a * table.shape[2] + b)
            for ray in range(count):
                row[ray] = flat[np.uintp(patch[ray]) * terms + term]


@jit(allocates=False)
def _repeat(table, patch, count, columns):  # type: ignore[no-untyped-def]
    start = 0
    while start < count:
        stop = start + 1
        while stop < count and patch[stop] == patch[start]:
            stop += 1
        coefficients = table[patch[start]]
        for a in range(coefficients.shape[0]):
            row = columns[a]
            for b in range(coefficients.shape[1]):
                value = coefficients[a, b]
                for ray in range(start, stop):
                    row[at(b, ray)] = value
        start = stop


@jit(allocates=False)
def refill(table, patch, before, count, columns):  # type: ignore[no-untyped-def]
    """The same for those rays alone that were in another patch before."""
    for ray in range(count):
        if patch[ray] != before[ray]:
            before[ray] = patch[ray]
            coefficients = table[patch[ray]]
            for a in range(coefficients.shape[0]):
                for b in range(coefficients.shape[1]):
                    columns[a, at(b, ray)] = coefficients[a, b]


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def evaluate(columns, w, count):  # type: ignore[no-untyped-def]
    """Heights and slopes of the face, by Horner's rule."""
    kind = w.dtype.type
    for row in (Z, Z_S, Z_T):
        for ray in range(count):
            w[at(row, ray)] = kind(0)
    for a in range(columns.shape[0] - 1, -1, -1):
        _polynomial(columns[a], w, count)
        for ray in range(count):
            s = w[at(S, ray)]
            w[at(Z_S, ray)] = w[at(Z_S, ray)] * s + w[at(Z, ray)]
            w[at(Z, ray)] = w[at(Z, ray)] * s + w[at(_INNER, ray)]
            w[at(Z_T, ray)] = w[at(Z_T, ray)] * s + w[at(_INNER_T, ray)]


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def evaluate_to_second_order(columns, w, count):  # type: ignore[no-untyped-def]
    """The same, and the second derivatives."""
    kind = w.dtype.type
    for row in (Z, Z_S, Z_T, Z_SS, Z_ST, Z_TT):
        for ray in range(count):
            w[at(row, ray)] = kind(0)
    for a in range(columns.shape[0] - 1, -1, -1):
        _polynomial(columns[a], w, count)
        for ray in range(count):
            s = w[at(S, ray)]
            w[at(Z_SS, ray)] = w[at(Z_SS, ray)] * s + kind(2) * w[at(Z_S, ray)]
            w[at(Z_S, ray)] = w[at(Z_S, ray)] * s + w[at(Z, ray)]
            w[at(Z, ray)] = w[at(Z, ray)] * s + w[at(_INNER, ray)]
            w[at(Z_ST, ray)] = w[at(Z_ST, ray)] * s + w[at(Z_T, ray)]
            w[at(Z_T, ray)] = w[at(Z_T, ray)] * s + w[at(_INNER_T, ray)]
            w[at(Z_TT, ray)] = w[at(Z_TT, ray)] * s + w[at(_INNER_TT, ray)]


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def _polynomial(coefficients, w, count):  # type: ignore[no-untyped-def]
    """A polynomial of t and its derivatives; the usual degree at one go."""
    q = len(coefficients) // BATCH - 1
    if q == 3:
        _cubic(coefficients, w, count)
        return
    kind = w.dtype.type
    for ray in range(count):
        w[at(_INNER, ray)] = coefficients[at(q, ray)]
        w[at(_INNER_T, ray)] = kind(0)
        w[at(_INNER_TT, ray)] = kind(0)
    for b in range(q - 1, -1, -1):
        term = coefficients[b * BATCH : (b + 1) * BATCH]
        for ray in range(count):
            t = w[at(T, ray)]
            w[at(_INNER_TT, ray)] = w[at(_INNER_TT, ray)] * t + kind(2) * w[at(_INNER_T, ray)]
            w[at(_INNER_T, ray)] = w[at(_INNER_T, ray)] * t + w[at(_INNER, ray)]
            w[at(_INNER, ray)] = w[at(_INNER, ray)] * t + term[ray]


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def _cubic(coefficients, w, count):  # type: ignore[no-untyped-def]
    kind = w.dtype.type
    two, three = kind(2), kind(3)
    for ray in range(count):
        t = w[at(T, ray)]
        c0, c1 = coefficients[at(0, ray)], coefficients[at(1, ray)]
        c2, c3 = coefficients[at(2, ray)], coefficients[at(3, ray)]
        w[at(_INNER, ray)] = ((c3 * t + c2) * t + c1) * t + c0
        w[at(_INNER_T, ray)] = (three * c3 * t + two * c2) * t + c1
        w[at(_INNER_TT, ray)] = two * (three * c3 * t + c2)


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def collect(w, count, patch, columns, d_table):  # type: ignore[no-untyped-def]
    """Add the cotangents of a batch of rays to those of the coefficients, evaluate's adjoint.

    `w`, `count`, `patch`: the rays, with the cotangents of height and local slopes; `columns` (p +
    1, (q + 1) BATCH): room for intermediate results; `d_table` (patches, p + 1, q + 1): cotangents
    of the coefficients; changed. Returns the first and the last patch of the rays.
    """
    kind = w.dtype.type
    for ray in range(count):
        w[at(_POWER, ray)] = kind(1)
        w[at(_POWER_S, ray)] = kind(0)
    for a in range(d_table.shape[1]):
        _terms(w, count, columns[a])
        for ray in range(count):
            s = w[at(S, ray)]
            w[at(_POWER_S, ray)] = w[at(_POWER_S, ray)] * s + w[at(_POWER, ray)]
            w[at(_POWER, ray)] *= s
    start, first, last = 0, patch[0], patch[0]
    while start < count:
        stop = start + 1
        while stop < count and patch[stop] == patch[start]:
            stop += 1
        first, last = min(first, patch[start]), max(last, patch[start])
        sums = d_table[patch[start]]
        for a in range(d_table.shape[1]):
            row = columns[a]
            for b in range(d_table.shape[2]):
                total = kind(0)
                for ray in range(start, stop):
                    total += row[at(b, ray)]
                sums[a, b] += total
        start = stop
    return first, last


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def _terms(w, count, terms):  # type: ignore[no-untyped-def]
    """Each ray's part of the cotangents of the coefficients of a power of s."""
    kind = w.dtype.type
    for ray in range(count):
        power, power_s = w[at(_POWER, ray)], w[at(_POWER_S, ray)]
        # t^b and its derivative, times what they are a factor of.
        w[at(_INNER, ray)] = w[at(D_Z, ray)] * power + w[at(D_S, ray)] * power_s
        w[at(_INNER_T, ray)] = w[at(D_T, ray)] * power
        w[at(_INNER_TT, ray)] = kind(0)
    for b in range(len(terms) // BATCH):
        term = terms[b * BATCH : (b + 1) * BATCH]
        for ray in range(count):
            t = w[at(T, ray)]
            term[ray] = w[at(_INNER, ray)] + w[at(_INNER_TT, ray)]
            w[at(_INNER_TT, ray)] = w[at(_INNER_TT, ray)] * t + w[at(_INNER_T, ray)]
            w[at(_INNER_T, ray)] *= t
            w[at(_INNER, ray)] *= t
