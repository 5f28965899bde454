"""Where rays arrive, in pixels: on a plane, or by their direction alone."""

from typing import Any, NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.compiled import jit
from workbench.geometry.frames import Frame
from workbench.optics.kernels.taps import FAST
from workbench.optics.receivers import ACROSS, Receiver
from workbench.optics.train.registers import (
    COLUMN,
    D_COLUMN,
    D_O_X,
    D_O_Y,
    D_O_Z,
    D_OUT,
    D_P_X,
    D_P_Y,
    D_P_Z,
    D_ROW,
    D_WEIGHT,
    FLUX,
    O_X,
    O_Y,
    O_Z,
    P_X,
    P_Y,
    P_Z,
    ROW,
    WEIGHT,
)

_ACROSS2 = ACROSS**2
Number = np.floating[Any]
Triple = tuple[Number, Number, Number]


class Landing(NamedTuple):
    """A receiver in the coordinates of the last face, in the trace's float type."""

    far: bool  # whether it counts light by its direction alone
    normal: Triple  # of a plane; of a far field the direction from which H and V are counted
    beyond: Number  # distance of a plane from the origin along its normal
    # Columns and rows for each length along x, y and z of a place on a plane. Of a far field the
    # directions in which H and V grow.
    column: Triple
    row: Triple
    # Those of the origin; or of the direction along the axis.
    column_0: Number
    row_0: Number
    # Of a far field: columns for each radian of H, rows for each of V.
    per_h: Number
    per_v: Number


def landing_of(receiver: Receiver, to_receiver: Frame, kind: type[Number]) -> Landing:
    """A receiver for kernels of a float type.

    `to_receiver`: change from the coordinates of the last face to those of the receiver; `kind`:
    float type.
    """
    numbers, turn = receiver.numbers(), to_receiver.rotation
    per_h = per_v = beyond = 0.0
    column_0, row_0 = numbers.column_0, numbers.row_0
    if numbers.far:
        per_h, per_v = numbers.column[0], numbers.row[0]
        column, row, normal = turn[0], turn[1], numbers.onwards * turn[2]
    else:
        column, row, normal = (
            np.array(part) @ turn for part in (numbers.column, numbers.row, numbers.normal)
        )
        point = turn.T @ (np.array(numbers.point) - to_receiver.position)
        beyond = float(normal @ point)
        column_0, row_0 = column_0 - float(column @ point), row_0 - float(row @ point)
    return Landing(
        numbers.far,
        _triple(normal, kind),
        kind(beyond),
        _triple(column, kind),
        _triple(row, kind),
        kind(column_0),
        kind(row_0),
        kind(per_h),
        kind(per_v),
    )


def _triple(vector: Array, kind: type[Number]) -> Triple:
    x, y, z = map(kind, vector)
    return x, y, z


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _approach(landing, x, y, z, o_x, o_y, o_z):  # type: ignore[no-untyped-def]
    """Whether light meets the plane, how fast it comes nearer, and how far off the plane is."""
    zero, across2 = type(z)(0), type(z)(_ACROSS2)
    n_x, n_y, n_z = landing.normal
    speed = n_x * o_x + n_y * o_y + n_z * o_z
    length2 = o_x * o_x + o_y * o_y + o_z * o_z
    gap = landing.beyond - (n_x * x + n_y * y + n_z * z)
    return (speed > zero) & (gap > zero) & (speed * speed > across2 * length2), speed, gap


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def on_plane(landing, x, y, z, o_x, o_y, o_z):  # type: ignore[no-untyped-def]
    """Column and row of light at a place and with a direction of any length, on a plane.

    Both are infinite for light that does not get there.
    """
    one, inf = type(z)(1), type(z)(np.inf)
    (c_x, c_y, c_z), (r_x, r_y, r_z) = landing.column, landing.row
    arrives, speed, gap = _approach(landing, x, y, z, o_x, o_y, o_z)
    way = gap / (speed if arrives else one)
    h_x, h_y, h_z = x + o_x * way, y + o_y * way, z + o_z * way
    column = landing.column_0 + c_x * h_x + c_y * h_y + c_z * h_z
    row = landing.row_0 + r_x * h_x + r_y * h_y + r_z * h_z
    return column if arrives else inf, row if arrives else inf


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def on_plane_back(landing, x, y, z, o_x, o_y, o_z, d_column, d_row):  # type: ignore[no-untyped-def]
    """Adjoint of `on_plane`: cotangents of the place, and of the direction."""
    zero, one = type(z)(0), type(z)(1)
    (n_x, n_y, n_z), (c_x, c_y, c_z), (r_x, r_y, r_z) = landing.normal, landing.column, landing.row
    arrives, speed, gap = _approach(landing, x, y, z, o_x, o_y, o_z)
    by_speed = (one if arrives else zero) / (speed if arrives else one)
    way = gap * by_speed
    d_h_x = d_column * c_x + d_row * r_x
    d_h_y = d_column * c_y + d_row * r_y
    d_h_z = d_column * c_z + d_row * r_z
    d_gap = (d_h_x * o_x + d_h_y * o_y + d_h_z * o_z) * by_speed
    d_speed = -d_gap * way
    d_place = (
        (d_h_x if arrives else zero) - d_gap * n_x,
        (d_h_y if arrives else zero) - d_gap * n_y,
        (d_h_z if arrives else zero) - d_gap * n_z,
    )
    return d_place, (
        way * d_h_x + d_speed * n_x,
        way * d_h_y + d_speed * n_y,
        way * d_h_z + d_speed * n_z,
    )


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _goes_on(o_x, o_y, o_z):  # type: ignore[no-untyped-def]
    """Whether light does not go across or back."""
    zero, across2 = type(o_z)(0), type(o_z)(_ACROSS2)
    return (o_z > zero) & (o_z * o_z > across2 * (o_x * o_x + o_y * o_y + o_z * o_z))


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def by_direction(landing, direction):  # type: ignore[no-untyped-def]
    """As `on_plane`, of a far field."""
    o_x, o_y, o_z = _in_far_field(landing, direction)
    aside = np.sqrt(o_x * o_x + o_z * o_z)
    column = landing.column_0 + landing.per_h * np.arctan2(o_x, o_z)
    row = landing.row_0 + landing.per_v * np.arctan2(o_y, aside)
    inf, arrives = type(o_z)(np.inf), _goes_on(o_x, o_y, o_z)
    return column if arrives else inf, row if arrives else inf


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def by_direction_back(landing, direction, d_column, d_row):  # type: ignore[no-untyped-def]
    """Adjoint of `by_direction`: cotangents of the direction."""
    (h_x, h_y, h_z), (v_x, v_y, v_z) = landing.column, landing.row
    n_x, n_y, n_z = landing.normal
    o_x, o_y, o_z = _in_far_field(landing, direction)
    one, arrives = type(o_z)(1), _goes_on(o_x, o_y, o_z)
    aside2 = o_x * o_x + o_z * o_z
    aside = np.sqrt(aside2)
    d_h = d_column * landing.per_h / (aside2 if arrives else one)
    d_v = d_row * landing.per_v / (aside2 + o_y * o_y if arrives else one)
    d_aside = -d_v * o_y / (aside if arrives else one)
    d_x, d_y, d_z = d_h * o_z + d_aside * o_x, d_v * aside, d_aside * o_z - d_h * o_x
    return (
        h_x * d_x + v_x * d_y + n_x * d_z,
        h_y * d_x + v_y * d_y + n_y * d_z,
        h_z * d_x + v_z * d_y + n_z * d_z,
    )


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _in_far_field(landing, direction):  # type: ignore[no-untyped-def]
    """A direction along those in which H and V grow, and that from which they are counted."""
    (h_x, h_y, h_z), (v_x, v_y, v_z) = landing.column, landing.row
    (n_x, n_y, n_z), (x, y, z) = landing.normal, direction
    return (
        h_x * x + h_y * y + h_z * z,
        v_x * x + v_y * y + v_z * z,
        n_x * x + n_y * y + n_z * z,
    )


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def receive(landing, w, lanes, t):  # type: ignore[no-untyped-def]
    """Columns, rows and flux of a batch at the receiver; see `on_plane`.

    `w`, `t`: registers of the last face, and of the first; `lanes`: how many rays there are.
    """
    zero = t.dtype.type(0)
    if landing.far:
        for lane in range(np.uintp(lanes)):
            direction = w[O_X + lane], w[O_Y + lane], w[O_Z + lane]
            column, row = by_direction(landing, direction)
            t[COLUMN + lane] = column
            t[ROW + lane] = row
    else:
        for lane in range(np.uintp(lanes)):
            x, y, z = w[P_X + lane], w[P_Y + lane], w[P_Z + lane]
            o_x, o_y, o_z = w[O_X + lane], w[O_Y + lane], w[O_Z + lane]
            column, row = on_plane(landing, x, y, z, o_x, o_y, o_z)
            t[COLUMN + lane] = column
            t[ROW + lane] = row
    for lane in range(np.uintp(lanes)):
        t[WEIGHT + lane] = max(w[FLUX + lane], zero)


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def receive_back(landing, w, lanes, t):  # type: ignore[no-untyped-def]
    """Adjoint of `receive`: cotangents of the rays behind the last face."""
    zero = t.dtype.type(0)
    if landing.far:
        for lane in range(np.uintp(lanes)):
            direction = w[O_X + lane], w[O_Y + lane], w[O_Z + lane]
            d_column, d_row = t[D_COLUMN + lane], t[D_ROW + lane]
            d_x, d_y, d_z = by_direction_back(landing, direction, d_column, d_row)
            w[D_O_X + lane] = d_x
            w[D_O_Y + lane] = d_y
            w[D_O_Z + lane] = d_z
            w[D_P_X + lane] = zero
            w[D_P_Y + lane] = zero
            w[D_P_Z + lane] = zero
    else:
        for lane in range(np.uintp(lanes)):
            x, y, z = w[P_X + lane], w[P_Y + lane], w[P_Z + lane]
            o_x, o_y, o_z = w[O_X + lane], w[O_Y + lane], w[O_Z + lane]
            d_column, d_row = t[D_COLUMN + lane], t[D_ROW + lane]
            (p_x, p_y, p_z), (d_x, d_y, d_z) = on_plane_back(
                landing, x, y, z, o_x, o_y, o_z, d_column, d_row
            )
            w[D_O_X + lane] = d_x
            w[D_O_Y + lane] = d_y
            w[D_O_Z + lane] = d_z
            w[D_P_X + lane] = p_x
            w[D_P_Y + lane] = p_y
            w[D_P_Z + lane] = p_z
    for lane in range(np.uintp(lanes)):
        w[D_OUT + lane] = t[D_WEIGHT + lane]
