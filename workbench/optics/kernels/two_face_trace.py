"""From samples of a freeform entrance face through the glass and the exit face to the receiver.

A batch of samples has its light refracted at the entrance face, meets the exit face by
`workbench.optics.kernels.point_meet`, and leaves; the way back takes the depths that were found.
By the implicit function theorem a ray's root moves by −δf / f' where the face, or the ray, moves.
"""

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from workbench.compiled import jit
from workbench.optics.kernels.aperture import Aperture
from workbench.optics.kernels.front_light import (
    BRIGHT,
    BY_Z_X,
    BY_Z_Y,
    D_BRIGHT,
    D_S_X,
    D_S_Y,
    NEXT,
    S_X,
    S_Y,
)
from workbench.optics.kernels.grid import Z_X, Z_Y
from workbench.optics.kernels.grid import Z as FRONT
from workbench.optics.kernels.origin_receive import (
    by_direction,
    by_direction_back,
    on_plane,
    on_plane_back,
)
from workbench.optics.kernels.point_meet import MET
from workbench.optics.kernels.point_patches import (
    D_S,
    D_T,
    D_Z,
    DEPTH,
    FLUX,
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
)
from workbench.optics.kernels.rows import COLUMN, D_COLUMN, D_ROW, D_WEIGHT, ROW, WEIGHT
from workbench.optics.kernels.snell import snell, snell_back
from workbench.optics.kernels.spread import BATCH
from workbench.optics.kernels.taps import FAST
from workbench.optics.kernels.transmittance import transmittance, transmittance_slopes
from workbench.optics.transmittance import TransmittanceLaw

Number = np.floating[Any]

# Numbers of a batch: what the glass lets through, how far within the rim rays leave and its
# cotangent, cotangents of slopes, start and flux in the glass, and sums over origins of the
# cotangents of the entrance face.
_FADE, ROOM, D_ROOM, _D_A, _D_B, _D_START, _D_FLUX, SUM_Z, SUM_Z_X, SUM_Z_Y, END = (
    NEXT + np.uintp(BATCH * k) for k in range(11)
)
# A refracted ray goes on to +z if it goes at least so far up.
_ONWARD = 1e-6
# Stands for the flux of a ray that does not enter. One without flux may: its place at the receiver
# bounds the light of those beside it.
_NO_RAY = -1.0
# Sums: flux that meets the entrance face, that enters, that is absorbed, that meets the exit face,
# that is not totally reflected there, that leaves; and the steepest slopes in the glass.
MET_FRONT, ENTERED, ABSORBED, MET_EXIT, PASSED, LEFT_LENS, STEEP_X, STEEP_Y = range(8)
SUMS = 8


class Body(NamedTuple):
    """The lens but for the shapes of its faces, in the trace's float type.

    Attributes
    ----------
    aperture : Aperture
        Before the entrance face.
    areas : ndarray, shape (samples along y, samples along x)
        What each sample stands for, as seen along the axis.
    lift : floating
        Level of the entrance face's heights, above that of the exit face's.
    critical : floating
        Squared cosines below this count as total reflection.
    absorption : floating
        Of the glass, per length.
    curved : bool
        Whether the outline is an ellipse.
    by_x2, by_y2 : floating
        One by the squares of its semi-axes.
    rim : floating
        `workbench.optics.intersection.RIM`.
    law_in, law_out : TransmittanceLaw
        Of both faces.
    """

    aperture: Aperture
    areas: npt.NDArray[Number]
    lift: Number
    critical: Number
    absorption: Number
    curved: bool
    by_x2: Number
    by_y2: Number
    rim: Number
    law_in: TransmittanceLaw
    law_out: TransmittanceLaw


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _at_entrance(body, lane, t):  # type: ignore[no-untyped-def]
    """Of `snell` at the entrance face; the direction behind it, and whether light enters."""
    law = body.law_in
    ratio2_minus_1 = law.ratio * law.ratio - t.dtype.type(1)
    s_x, s_y, z_x, z_y = t[S_X + lane], t[S_Y + lane], t[Z_X + lane], t[Z_Y + lane]
    refracted = snell(law.ratio, ratio2_minus_1, body.critical, s_x, s_y, z_x, z_y)
    gamma = refracted[2]
    o_x, o_y, o_z = law.ratio * s_x - gamma * z_x, law.ratio * s_y - gamma * z_y, law.ratio + gamma
    enters = refracted[4] & (o_z > t.dtype.type(_ONWARD))
    return refracted, o_x, o_y, o_z, enters


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def enter(body, x, y, areas, lanes, t, w, sums):  # type: ignore[no-untyped-def]
    """Rays in the glass of a batch of samples, as lines from the level of the exit face."""
    kind = t.dtype.type
    zero, one = kind(0), kind(1)
    met_flux, entered, steep_x, steep_y = zero, zero, zero, zero
    for lane in range(np.uintp(lanes)):
        refracted, o_x, o_y, o_z, enters = _at_entrance(body, lane, t)
        lean, q, _, by_both, _ = refracted
        met = t[BRIGHT + lane] * lean * areas[lane] if lean > zero else zero
        transmitted = transmittance(body.law_in, abs(lean) * by_both, q * by_both)
        by_z = one / (o_z if enters else one)
        a, b = o_x * by_z if enters else zero, o_y * by_z if enters else zero
        start = t[FRONT + lane] + body.lift
        flux = met * transmitted if enters else zero
        w[at(X, lane)] = x[lane] - a * start
        w[at(Y, lane)] = y - b * start
        w[at(SLOPE_X, lane)] = a
        w[at(SLOPE_Y, lane)] = b
        w[at(FLUX, lane)] = flux if enters else _NO_RAY
        met_flux += met
        entered += flux
        steep_x, steep_y = max(steep_x, abs(a)), max(steep_y, abs(b))
    sums[MET_FRONT] += met_flux
    sums[ENTERED] += entered
    sums[STEEP_X] = max(sums[STEEP_X], steep_x)
    sums[STEEP_Y] = max(sums[STEEP_Y], steep_y)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _radius(body, x, y):  # type: ignore[no-untyped-def]
    """How far from the axis a place is, as a part of the way to the rim."""
    x2, y2 = x * x * body.by_x2, y * y * body.by_y2
    return np.sqrt(x2 + y2 if body.curved else max(x2, y2))


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _at_exit(net, body, ray, t, w):  # type: ignore[no-untyped-def]
    """Where a ray meets the exit face, slopes there, `snell`, whether it passes, and its room.

    See `workbench.optics.rim` for the room.
    """
    kind = w.dtype.type
    law = body.law_out
    a, b, depth = w[at(SLOPE_X, ray)], w[at(SLOPE_Y, ray)], w[at(DEPTH, ray)]
    x, y = w[at(X, ray)] + a * depth, w[at(Y, ray)] + b * depth
    enters = w[at(FLUX, ray)] >= kind(0)
    met = (w[at(STATE, ray)] == kind(MET)) & enters
    room = body.rim - _radius(body, x, y)
    if body.curved:
        start = t[FRONT + np.uintp(ray)] + body.lift
        x_0, y_0 = w[at(X, ray)] + a * start, w[at(Y, ray)] + b * start
        room += (max(_radius(body, x_0, y_0), kind(1)) - kind(1)) * body.rim
        met = met & (room >= kind(0))
    room = max(room, kind(0)) if met else (kind(-1) if enters else kind(0))
    z_x, z_y = w[at(Z_S, ray)] * net.per_x, w[at(Z_T, ray)] * net.per_y
    ratio2_minus_1 = law.ratio * law.ratio - kind(1)
    refracted = snell(law.ratio, ratio2_minus_1, body.critical, a, b, z_x, z_y)
    return x, y, z_x, z_y, refracted, met, met & refracted[4], room


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _fade(body, lanes, t, w):  # type: ignore[no-untyped-def]
    """What the glass lets through of each ray; in a loop of its own, exp does not vectorise."""
    one = t.dtype.type(1)
    if body.absorption == t.dtype.type(0):
        for lane in range(np.uintp(lanes)):
            t[_FADE + lane] = one
        return
    for lane in range(np.uintp(lanes)):
        a, b = w[at(SLOPE_X, lane)], w[at(SLOPE_Y, lane)]
        deep = abs(w[at(DEPTH, lane)] - t[FRONT + lane] - body.lift)
        t[_FADE + lane] = np.exp(-body.absorption * deep * np.sqrt(one + a * a + b * b))


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def leave(net, body, landing, lanes, t, w, sums):  # type: ignore[no-untyped-def]
    """Columns, rows and flux of a batch on the receiver; those of lost light are infinite."""
    kind = t.dtype.type
    zero, inf = kind(0), kind(np.inf)
    absorbed, met_flux, passed, left = zero, zero, zero, zero
    _fade(body, lanes, t, w)
    for lane in range(np.uintp(lanes)):
        x, y, z_x, z_y, refracted, met, passes, room = _at_exit(net, body, lane, t, w)
        lean, q, gamma, by_both, _ = refracted
        n, a, b = body.law_out.ratio, w[at(SLOPE_X, lane)], w[at(SLOPE_Y, lane)]
        flux = w[at(FLUX, lane)] if met else zero
        arriving = flux * t[_FADE + lane]
        weight = arriving * transmittance(body.law_out, abs(lean) * by_both, q * by_both)
        weight = weight if passes else zero
        o_x, o_y, o_z = n * a - gamma * z_x, n * b - gamma * z_y, n + gamma
        if landing.far:
            column, row = by_direction(landing, o_x, o_y, o_z)
        else:
            column, row = on_plane(landing, x, y, w[at(DEPTH, lane)], o_x, o_y, o_z)
        t[COLUMN + lane] = column if passes else inf
        t[ROW + lane] = row if passes else inf
        t[WEIGHT + lane] = weight
        t[ROOM + lane] = room
        absorbed += flux - arriving
        met_flux += arriving
        passed += arriving if passes else zero
        left += weight
    sums[ABSORBED] += absorbed
    sums[MET_EXIT] += met_flux
    sums[PASSED] += passed
    sums[LEFT_LENS] += left


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def leave_back(net, body, landing, lanes, t, w):  # type: ignore[no-untyped-def]
    """Adjoint of `leave`: cotangents of the exit face, and of the rays in the glass."""
    kind = t.dtype.type
    zero, one = kind(0), kind(1)
    _fade(body, lanes, t, w)
    for lane in range(np.uintp(lanes)):
        x, y, z_x, z_y, refracted, _, passes, room = _at_exit(net, body, lane, t, w)
        lean, q, gamma, by_both, _ = refracted
        n, a, b = body.law_out.ratio, w[at(SLOPE_X, lane)], w[at(SLOPE_Y, lane)]
        depth = w[at(DEPTH, lane)]
        deep = depth - t[FRONT + lane] - body.lift
        arriving = w[at(FLUX, lane)] * t[_FADE + lane]
        o_x, o_y, o_z = n * a - gamma * z_x, n * b - gamma * z_y, n + gamma
        d_column, d_row = t[D_COLUMN + lane], t[D_ROW + lane]
        if landing.far:
            d_p_x, d_p_y, d_p_z = zero, zero, zero
            d_o_x, d_o_y, d_o_z = by_direction_back(landing, o_x, o_y, o_z, d_column, d_row)
        else:
            (d_p_x, d_p_y, d_p_z), (d_o_x, d_o_y, d_o_z) = on_plane_back(
                landing, x, y, depth, o_x, o_y, o_z, d_column, d_row
            )
        cos_in, cos_out = lean * by_both, q * by_both
        d_weight = t[D_WEIGHT + lane]
        d_arriving = d_weight * transmittance(body.law_out, cos_in, cos_out)
        by_in, by_out = transmittance_slopes(body.law_out, cos_in, cos_out)
        d_transmitted = d_weight * arriving
        ratio2_minus_1 = n * n - one
        d_a, d_b, d_z_x, d_z_y = snell_back(
            n, ratio2_minus_1, a, b, z_x, z_y, refracted, zero, d_o_x, d_o_y, d_o_z,
            d_transmitted * by_in, d_transmitted * by_out,
        )  # fmt: skip
        radius = _radius(body, x, y)
        d_room = -t[D_ROOM + lane] / radius if (room > zero) & (radius > zero) else zero
        by_x = x * x * body.by_x2 >= y * y * body.by_y2
        d_p_x += d_room * x * body.by_x2 if body.curved | by_x else zero
        d_p_y += d_room * y * body.by_y2 if body.curved | (not by_x) else zero
        # Slopes of the face at a place that moves with the ray.
        d_s, d_t = d_z_x * net.per_x, d_z_y * net.per_y
        d_p_x += (d_s * w[at(Z_SS, lane)] + d_t * w[at(Z_ST, lane)]) * net.per_x
        d_p_y += (d_s * w[at(Z_ST, lane)] + d_t * w[at(Z_TT, lane)]) * net.per_y
        stretch = np.sqrt(one + a * a + b * b)
        d_way = -body.absorption * arriving * d_arriving
        d_way = d_way if deep > zero else -d_way
        d_depth = d_p_z + d_p_x * a + d_p_y * b + d_way * stretch
        slope = min(a * z_x + b * z_y - one, kind(-1e-3))
        d_root = -d_depth / slope
        d_p_x += d_root * z_x
        d_p_y += d_root * z_y
        by_stretch = d_way * deep / stretch
        w[at(D_Z, lane)] = d_root if passes else zero
        w[at(D_S, lane)] = d_s if passes else zero
        w[at(D_T, lane)] = d_t if passes else zero
        t[_D_A + lane] = d_a + d_p_x * deep + by_stretch * a if passes else zero
        t[_D_B + lane] = d_b + d_p_y * deep + by_stretch * b if passes else zero
        t[_D_START + lane] = -d_p_x * a - d_p_y * b - d_way * stretch if passes else zero
        t[_D_FLUX + lane] = d_arriving * t[_FADE + lane] if passes else zero


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def enter_back(body, areas, lanes, t):  # type: ignore[no-untyped-def]
    """Adjoint of `enter`; adds to the cotangents of the entrance face."""
    kind = t.dtype.type
    zero, one = kind(0), kind(1)
    law = body.law_in
    for lane in range(np.uintp(lanes)):
        refracted, o_x, o_y, o_z, enters = _at_entrance(body, lane, t)
        lean, q, _, by_both, _ = refracted
        s_x, s_y, z_x, z_y = t[S_X + lane], t[S_Y + lane], t[Z_X + lane], t[Z_Y + lane]
        cos_in, cos_out = lean * by_both, q * by_both
        transmitted, bright = transmittance(law, abs(cos_in), cos_out), t[BRIGHT + lane]
        by_in, by_out = transmittance_slopes(law, abs(cos_in), cos_out)
        d_flux = t[_D_FLUX + lane] * areas[lane]
        d_transmitted = d_flux * bright * lean
        by_z = one / (o_z if enters else one)
        d_o_x, d_o_y = t[_D_A + lane] * by_z, t[_D_B + lane] * by_z
        d_o_z = -(d_o_x * o_x + d_o_y * o_y) * by_z
        d_s_x, d_s_y, d_z_x, d_z_y = snell_back(
            law.ratio, law.ratio * law.ratio - one, s_x, s_y, z_x, z_y, refracted,
            d_flux * bright * transmitted, d_o_x, d_o_y, d_o_z,
            d_transmitted * by_in, d_transmitted * by_out,
        )  # fmt: skip
        d_z = t[_D_START + lane] + d_s_x * t[D_S_X + lane] + d_s_y * t[D_S_Y + lane]
        d_z += d_flux * lean * transmitted * t[D_BRIGHT + lane]
        t[SUM_Z + lane] += d_z if enters else zero
        d_z_x += d_flux * lean * transmitted * t[BY_Z_X + lane]
        d_z_y += d_flux * lean * transmitted * t[BY_Z_Y + lane]
        t[SUM_Z_X + lane] += d_z_x if enters else zero
        t[SUM_Z_Y + lane] += d_z_y if enters else zero
