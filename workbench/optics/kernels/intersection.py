"""Where a batch of rays meets a B-spline face, as `workbench.optics.surfaces.intersection`.

Where f(t) = Z(x(t), y(t)) − z_in − t can only fall, all rays of a batch take steps of Newton's
method together, from the roots of the last lens. The few that do not rest after some steps go on
alone, safeguarded. Rays with several roots go alone from the start: they walk up to the first root
in steps proven not to pass it. Bounds, tolerances and results are those of the reference.
"""

import math

import numpy as np
import numpy.typing as npt

from workbench.arrays import AnyArray
from workbench.compiled import jit
from workbench.optics.kernels.patches import (
    BUSY,
    DEPTH,
    HIGH,
    LOW,
    SLOPE_X,
    SLOPE_Y,
    STATE,
    Z_S,
    Z_T,
    Net,
    X,
    Y,
    Z,
    at,
    evaluate,
    fill,
    place,
    refill,
    span_of,
)
from workbench.optics.kernels.taps import FAST

# Steps that a batch takes together; three or four are usual, five or six for the first lens.
_TOGETHER = 8
_NEWTON_STEPS, _BISECTIONS, _WALK_STEPS = 20, 60, 2000
# f counts as falling where it surely falls at least this fast.
FALLS_BY = 0.1
# States of a ray: on its way to the one root that it may have, met, does not meet the face. Before
# the search, `MET` are those that may have several roots.
FALLS, MET, LEFT = 1, 0, -1


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def meet(net, bounds, table, w, count, patch, before, columns):  # type: ignore[no-untyped-def]
    """Depth, state, place, height and slopes of a batch of rays.

    `w` (ROWS BATCH,): the batch: rays and the depths to start from; changed; `count`: how many rays
    there are; `patch`, `before` (BATCH,): their patches in the end, and room for those of the step
    before; `columns` (p + 1, (q + 1) BATCH): the coefficients of these patches in the end. Returns
    how many runs of rays there were that began in the same patch.
    """
    alone = _bracket(net, bounds, w, count)
    if alone > 0:
        for ray in range(count):
            if w[at(STATE, ray)] == MET:
                _walk(net, bounds, table, w, ray)
    place(net, w, count, patch)
    for ray in range(count):
        before[ray] = patch[ray]
    runs = fill(table, patch, count, columns)
    evaluate(columns, w, count)
    for _ in range(_TOGETHER):
        if _step(net, bounds, w, count) == 0:
            break
        _again(net, table, w, count, patch, before, columns)
    else:
        if _step(net, bounds, w, count) > 0:
            for ray in range(count):
                if w[at(BUSY, ray)] != 0:
                    _newton(net, bounds, table, w, ray)
            _again(net, table, w, count, patch, before, columns)
    _settle(bounds, w, count)
    return runs


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def _bracket(net, bounds, w, count):  # type: ignore[no-untyped-def]
    """Ends of what is searched, where rays start, and how many may have several roots."""
    kind = w.dtype.type
    several = kind(0)
    for ray in range(count):
        x, slope = w[at(X, ray)], w[at(SLOPE_X, ray)]
        y, rise = w[at(Y, ray)], w[at(SLOPE_Y, ray)]
        enters, leaves = depths_of_side(net, x, y, slope, rise)
        low, high = max(enters, bounds.low), min(leaves, bounds.high)
        over = low <= high
        low, high = low if over else bounds.low, high if over else bounds.low
        w[at(LOW, ray)] = low
        w[at(HIGH, ray)] = high
        w[at(DEPTH, ray)] = min(max(w[at(DEPTH, ray)], low), high)
        steep = bounds.slope_x * abs(slope) + bounds.slope_y * abs(rise)
        falls = steep < kind(1 - FALLS_BY)
        state = kind(FALLS) if falls else kind(MET)
        w[at(STATE, ray)] = state if over else kind(LEFT)
        several += kind(0) if falls else kind(1)
    return several


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def depths_of_side(net, x, y, slope_x, slope_y):  # type: ignore[no-untyped-def]
    """Depths at which a ray comes in over the aperture, and leaves it.

    Infinite for one along the axis; one that is never over it leaves before it comes in.
    """
    # Start on the right in a mirror where the ray goes left.
    along_x, along_y = math.copysign(x, x * slope_x), math.copysign(y, y * slope_y)
    steep_x, steep_y = abs(slope_x), abs(slope_y)
    enters = max((-net.rim_x - along_x) / steep_x, (-net.rim_y - along_y) / steep_y)
    return enters, min((net.rim_x - along_x) / steep_x, (net.rim_y - along_y) / steep_y)


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def _again(net, table, w, count, patch, before, columns):  # type: ignore[no-untyped-def]
    """Evaluate the face where the rays have gone."""
    if place(net, w, count, patch) > 0:
        refill(table, patch, before, count, columns)
    evaluate(columns, w, count)


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def _step(net, bounds, w, count):  # type: ignore[no-untyped-def]
    """A step of Newton's method for rays that do not rest yet; says how many these are."""
    kind = w.dtype.type
    busy = kind(0)
    for ray in range(count):
        depth, low, high = w[at(DEPTH, ray)], w[at(LOW, ray)], w[at(HIGH, ray)]
        f = w[at(Z, ray)] - depth
        slope = w[at(Z_S, ray)] * net.per_x * w[at(SLOPE_X, ray)]
        slope += w[at(Z_T, ray)] * net.per_y * w[at(SLOPE_Y, ray)] - kind(1)
        step = f / slope
        # At the ends f has another sign than there only where the side cuts the ray off.
        beyond = (depth >= high) & (high < bounds.high) & (f > 0)
        behind = (depth <= low) & (low > bounds.lowest) & (f <= 0)
        alone = w[at(STATE, ray)] != kind(FALLS)
        rests = (abs(step) <= bounds.tolerance) | beyond | behind | alone
        w[at(DEPTH, ray)] = depth if rests else min(max(depth - step, low), high)
        w[at(BUSY, ray)] = kind(0) if rests else kind(1)
        busy += kind(0) if rests else kind(1)
    return busy


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def _settle(bounds, w, count):  # type: ignore[no-untyped-def]
    """Tell rays that met the face from those that the side cut off."""
    kind = w.dtype.type
    for ray in range(count):
        depth, state = w[at(DEPTH, ray)], w[at(STATE, ray)]
        low, high, z = w[at(LOW, ray)], w[at(HIGH, ray)], w[at(Z, ray)]
        beyond = (depth >= high) & (high < bounds.high) & (z > depth)
        behind = (depth <= low) & (low > bounds.lowest) & (z <= depth)
        settled = kind(LEFT) if beyond | behind else kind(MET)
        w[at(STATE, ray)] = settled if state == kind(FALLS) else state


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def polish(net, w, count):  # type: ignore[no-untyped-def]
    """One more step, as the reference makes it: it moves the depth by rounding at most."""
    kind = w.dtype.type
    for ray in range(count):
        slope = w[at(Z_S, ray)] * net.per_x * w[at(SLOPE_X, ray)]
        slope += w[at(Z_T, ray)] * net.per_y * w[at(SLOPE_Y, ray)] - kind(1)
        step = (w[at(Z, ray)] - w[at(DEPTH, ray)]) / min(slope, kind(-1e-3))
        w[at(DEPTH, ray)] -= step if w[at(STATE, ray)] == kind(MET) else kind(0)


@jit(allocates=False, error_model="numpy")
def _f(net, table, w, ray, depth):  # type: ignore[no-untyped-def]
    """The function f and its slope, for one ray."""
    kind = w.dtype.type
    u = (w[at(X, ray)] + w[at(SLOPE_X, ray)] * depth + net.half_x) * net.per_x
    v = (w[at(Y, ray)] + w[at(SLOPE_Y, ray)] * depth + net.half_y) * net.per_y
    span_x = span_of(u, kind(net.spans[0] - 1))
    span_y = span_of(v, kind(net.spans[1] - 1))
    s, t = u - (span_x + kind(0.5)), v - (span_y + kind(0.5))
    patch = np.int32(span_x) * np.int32(net.spans[1]) + np.int32(span_y)
    coefficients = table[patch + np.int32(net.first)]
    z, z_s, z_t = kind(0), kind(0), kind(0)
    for a in range(coefficients.shape[0] - 1, -1, -1):
        inner, inner_t = kind(0), kind(0)
        for b in range(coefficients.shape[1] - 1, -1, -1):
            inner_t = inner_t * t + inner
            inner = inner * t + coefficients[a, b]
        z_s = z_s * s + z
        z = z * s + inner
        z_t = z_t * s + inner_t
    slope = z_s * net.per_x * w[at(SLOPE_X, ray)] + z_t * net.per_y * w[at(SLOPE_Y, ray)]
    return z - depth, slope - kind(1)


@jit(allocates=False, error_model="numpy")
def _newton(net, bounds, table, w, ray):  # type: ignore[no-untyped-def]
    """The root of one ray whose f falls, safeguarded by the bracket."""
    kind = w.dtype.type
    low, high = w[at(LOW, ray)], w[at(HIGH, ray)]
    depth = high
    if low > bounds.lowest and _f(net, table, w, ray, low)[0] <= 0:
        depth = low
    elif high == bounds.high or _f(net, table, w, ray, high)[0] <= 0:
        depth = (low + high) * kind(0.5)
        for number in range(_NEWTON_STEPS + _BISECTIONS):
            f, slope = _f(net, table, w, ray, depth)
            if f > 0:
                low = depth
            else:
                high = depth
            step = depth - f / slope
            # An end of the bracket is no new place: a step to it may go to and fro for ever.
            near = abs(step - depth) <= bounds.tolerance
            good = near or (number < _NEWTON_STEPS and low < step < high)
            new = step if good else (low + high) * kind(0.5)
            moved, depth = abs(new - depth), new
            if moved <= bounds.tolerance:
                break
    w[at(DEPTH, ray)] = depth


@jit(allocates=False, error_model="numpy")
def _walk(net, bounds, table, w, ray):  # type: ignore[no-untyped-def]
    """The first root of one ray.

    With f' ≥ −L and f'' ≥ −M ahead, f stays positive for f / L, and for as long as the parabola
    f + f' δ − M δ² / 2 does.
    """
    kind = w.dtype.type
    low, high = w[at(LOW, ray)], w[at(HIGH, ray)]
    eps = kind(np.finfo(w.dtype).eps)  # keeps a product with an infinite bound infinite
    across = max(abs(w[at(SLOPE_X, ray)]), eps)
    up = max(abs(w[at(SLOPE_Y, ray)]), eps)
    steepest = kind(1) + bounds.slope_x * across + bounds.slope_y * up
    curvature = bounds.curvature_xx * across * across + bounds.curvature_yy * up * up
    curvature += kind(2) * bounds.curvature_xy * across * up
    depth = low
    state = LEFT
    late = low > bounds.lowest and _f(net, table, w, ray, low)[0] <= 0
    if high >= bounds.lowest and not late:
        for _ in range(_WALK_STEPS):
            f, slope = _f(net, table, w, ray, depth)
            if f <= 0:
                state = MET
                break
            parabola = kind(2) * f / (math.sqrt(slope * slope + kind(2) * curvature * f) - slope)
            step = max(f / steepest, parabola)
            if step <= bounds.tolerance:
                state = MET
                break
            if depth >= high:
                break
            depth = min(depth + step, high)
    w[at(DEPTH, ray)] = depth
    w[at(STATE, ray)] = kind(state)


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
