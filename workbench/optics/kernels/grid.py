"""The face on a tensor grid of rays, a block of neighbouring u at a time; see `collimated`."""

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from workbench.arrays import AnyArray, Array
from workbench.compiled import jit
from workbench.geometry.basis import local_basis
from workbench.geometry.surface import ControlNet
from workbench.optics.kernels.spread import BATCH
from workbench.optics.kernels.taps import FAST

# The numbers of a batch lie in one array, at fixed distances: the compiler then sees that they do
# not overlap, and vectorises. These are the first three, height and slopes.
Z, Z_X, Z_Y = (np.uintp(BATCH * k) for k in range(3))
# Likewise the rows of a block: those of z and z_x take turns. They are read across, too: at a
# power of two all would fall on the same cache lines.
_PITCH = BATCH + 16
_NEXT, _PAIR, _THREE_PAIRS = np.uintp(_PITCH), np.uintp(2 * _PITCH), np.uintp(6 * _PITCH)


class Axis(NamedTuple):
    """Rays along one axis, and the basis functions there."""

    place: AnyArray  # (m,), x or y of the rays, in columns or rows of the image
    first: npt.NDArray[np.uintp]  # (m,), first control point that matters for each
    # (m, p + 1), basis functions and their derivatives with respect to x or y.
    value: AnyArray
    slope: AnyArray
    share: AnyArray  # (m,), part of a cell that each stands for


def make_axis(
    net: ControlNet,
    axis: int,
    t: Array,
    kind: type[np.floating[Any]],
    share: AnyArray | None = None,
) -> Axis:
    """Rays at parts ``t`` of the way along one axis, shape (m,), each for a whole cell or less."""
    knots, degree, r = net.knots[axis], net.degree[axis], net.half_width[axis]
    first, value = local_basis(knots, degree, t)
    slope = local_basis(knots, degree, t, derivative=1)[1] / (2 * r)
    wide = np.ones(len(t), kind) if share is None else share.astype(kind)
    place = (2 * t - 1) * r
    return Axis(place, first.astype(np.uintp), value.astype(kind), slope.astype(kind), wide)


@jit()
def make_rows(heights):  # type: ignore[no-untyped-def]
    """Rows for a block of rays, all 0."""
    return np.zeros(2 * heights.shape[1] * _PITCH, heights.dtype)


@jit(fastmath=FAST, error_model="numpy")
def contract(heights, across, i, lanes, rows):  # type: ignore[no-untyped-def]
    """Control values along v of z and z_x, for each u of a block."""
    count = heights.shape[1]
    line, line_x = np.empty(count, heights.dtype), np.empty(count, heights.dtype)
    kind = heights.dtype.type
    for lane in range(lanes):
        line[:] = kind(0)
        line_x[:] = kind(0)
        first = across.first[i + lane]
        for a in range(across.value.shape[1]):
            near = heights[first + np.uintp(a)]
            value, slope = across.value[i + lane, a], across.slope[i + lane, a]
            for b in range(count):
                line[b] += value * near[b]
                line_x[b] += slope * near[b]
        at = np.uintp(lane)
        for b in range(count):
            rows[at] = line[b]
            rows[at + _NEXT] = line_x[b]
            at += _PAIR


@jit(fastmath=FAST, error_model="numpy")
def contract_back(d_rows, across, i, lanes, gradient):  # type: ignore[no-untyped-def]
    """Adjoint of `contract`."""
    count = gradient.shape[1]
    line, line_x = np.empty(count, d_rows.dtype), np.empty(count, d_rows.dtype)
    for lane in range(lanes):
        at = np.uintp(lane)
        for b in range(count):
            line[b] = d_rows[at]
            line_x[b] = d_rows[at + _NEXT]
            at += _PAIR
        first = across.first[i + lane]
        for a in range(across.value.shape[1]):
            near = gradient[first + np.uintp(a)]
            value, slope = across.value[i + lane, a], across.slope[i + lane, a]
            for b in range(count):
                near[b] += np.float64(value * line[b] + slope * line_x[b])


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def blend(rows, up, j, lanes, t):  # type: ignore[no-untyped-def]
    """Height and slopes of the face at all u of a block and one v."""
    kind = t.dtype.type
    count = np.uintp(lanes)
    start = up.first[j] * _PAIR
    two, six = _PAIR, _THREE_PAIRS
    taps = up.value.shape[1]
    if taps == 4:  # the usual degree, without an inner loop
        v0, v1, v2, v3 = up.value[j, 0], up.value[j, 1], up.value[j, 2], up.value[j, 3]
        s0, s1, s2, s3 = up.slope[j, 0], up.slope[j, 1], up.slope[j, 2], up.slope[j, 3]
        for lane in range(count):
            at = start + lane
            a0, a1, a2, a3 = rows[at], rows[at + two], rows[at + two + two], rows[at + six]
            t[Z + lane] = v0 * a0 + v1 * a1 + v2 * a2 + v3 * a3
            t[Z_Y + lane] = s0 * a0 + s1 * a1 + s2 * a2 + s3 * a3
            t[Z_X + lane] = (
                v0 * rows[at + _NEXT]
                + v1 * rows[at + two + _NEXT]
                + v2 * rows[at + two + two + _NEXT]
                + v3 * rows[at + six + _NEXT]
            )
        return
    for lane in range(count):
        t[Z + lane] = kind(0)
        t[Z_X + lane] = kind(0)
        t[Z_Y + lane] = kind(0)
    for b in range(taps):
        value, slope = up.value[j, b], up.slope[j, b]
        for lane in range(count):
            t[Z + lane] += value * rows[start + lane]
            t[Z_Y + lane] += slope * rows[start + lane]
            t[Z_X + lane] += value * rows[start + _NEXT + lane]
        start += two


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def blend_back(d_rows, up, j, lanes, t):  # type: ignore[no-untyped-def]
    """Adjoint of `blend`; the cotangents of z, z_x, z_y are where these were."""
    count = np.uintp(lanes)
    start = up.first[j] * _PAIR
    for b in range(up.value.shape[1]):
        value, slope = up.value[j, b], up.slope[j, b]
        for lane in range(count):
            d_rows[start + lane] += value * t[Z + lane] + slope * t[Z_Y + lane]
            d_rows[start + _NEXT + lane] += value * t[Z_X + lane]
        start += _PAIR
