"""The further elements of a compiled train: what their faces do to rays, and the adjoints.

Each face has a frame in which light comes from below, and z counts from its vertex, or from near
the mean height of a B-spline. Most frames follow each other along z; between others a change of
coordinates, composed in float64, turns and shifts the rays. A ray is a line (X + a z, Y + b z, z)
there. By the implicit function theorem a ray's depth moves by −δf / f' where the face, or the ray,
moves.
"""

import numpy as np

from workbench.compiled import jit
from workbench.optics.kernels.intersection import MET
from workbench.optics.kernels.patches import (
    D_S,
    D_T,
    D_Z,
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
)
from workbench.optics.kernels.patches import (
    FLUX as ARRIVING,
)
from workbench.optics.kernels.refraction import (
    snell,
    snell_back,
    transmittance,
    transmittance_slopes,
)
from workbench.optics.kernels.taps import FAST
from workbench.optics.train.first_face import NO_RAY
from workbench.optics.train.registers import (
    ABSORBS,
    BLOCK,
    D_A,
    D_B,
    D_FLUX,
    D_O_X,
    D_O_Y,
    D_O_Z,
    D_OUT,
    D_P_X,
    D_P_Y,
    D_P_Z,
    D_RIM,
    D_START,
    D_X,
    D_Y,
    FADE,
    FLUX,
    GOES,
    MEETS,
    O_X,
    O_Y,
    O_Z,
    P_X,
    P_Y,
    P_Z,
    PASSES,
    RIM,
    START,
    total,
)

# A ray goes on to +z if it goes at least so far up.
_ONWARD = 1e-6
# Sums of an element: flux absorbed before it, that meets it, that is not totally reflected, that
# goes on; the steepest slopes of its rays; and the runs of rays that began in the same patch.
ABSORBED, MET_FLUX, PASSED, LEFT, STEEP_X, STEEP_Y, RUNS = range(7)
SUMS = 7


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def transfer(element, pair, lanes):  # type: ignore[no-untyped-def]
    """Rays of a batch as lines in the frame of an element.

    `pair`: registers of the face before it, and behind them its own; `lanes`: how many rays there
    are.
    """
    if element.moves:
        for lane in range(np.uintp(lanes)):
            _begin_line(pair, lane, _moved(element.change, pair, lane))
    else:
        for lane in range(np.uintp(lanes)):
            start = pair[P_Z + lane] + element.change.z
            ray = (
                pair[P_X + lane], pair[P_Y + lane], start,
                pair[O_X + lane], pair[O_Y + lane], pair[O_Z + lane],
            )  # fmt: skip
            _begin_line(pair, lane, ray)


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def count_slopes(pair, lanes, sums):  # type: ignore[no-untyped-def]
    """Keep the steepest slopes of rays before an element in its sums."""
    steep_x = steep_y = pair.dtype.type(0)
    for lane in range(np.uintp(lanes)):
        steep_x = max(steep_x, abs(pair[BLOCK + at(SLOPE_X, lane)]))
        steep_y = max(steep_y, abs(pair[BLOCK + at(SLOPE_Y, lane)]))
    sums[STEEP_X] = max(sums[STEEP_X], steep_x)
    sums[STEEP_Y] = max(sums[STEEP_Y], steep_y)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _moved(change, pair, lane):  # type: ignore[no-untyped-def]
    """Position and direction of a ray in the frame of an element that moves."""
    x, y, z = pair[P_X + lane], pair[P_Y + lane], pair[P_Z + lane]
    o_x, o_y, o_z = pair[O_X + lane], pair[O_Y + lane], pair[O_Z + lane]
    return (
        change.xx * x + change.xy * y + change.xz * z + change.x,
        change.yx * x + change.yy * y + change.yz * z + change.y,
        change.zx * x + change.zy * y + change.zz * z + change.z,
        change.xx * o_x + change.xy * o_y + change.xz * o_z,
        change.yx * o_x + change.yy * o_y + change.yz * o_z,
        change.zx * o_x + change.zy * o_y + change.zz * o_z,
    )


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _begin_line(pair, lane, ray):  # type: ignore[no-untyped-def]
    """The line of a ray in the frame of an element."""
    kind = pair.dtype.type
    zero, one = kind(0), kind(1)
    x, y, start, o_x, o_y, o_z = ray
    exists = (pair[FLUX + lane] >= zero) & (o_z > kind(_ONWARD))
    by_z = one / (o_z if exists else one)
    a = o_x * by_z if exists else zero
    b = o_y * by_z if exists else zero
    # Of rays that do not exist, places may be no numbers: their search would never rest.
    pair[BLOCK + at(X, lane)] = x - a * start if exists else zero
    pair[BLOCK + at(Y, lane)] = y - b * start if exists else zero
    pair[BLOCK + START + lane] = start
    pair[BLOCK + at(SLOPE_X, lane)] = a
    pair[BLOCK + at(SLOPE_Y, lane)] = b
    pair[BLOCK + at(ARRIVING, lane)] = pair[FLUX + lane] if exists else kind(NO_RAY)


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def transfer_back(element, pair, lanes):  # type: ignore[no-untyped-def]
    """Adjoint of `transfer`, with what the length of the way in the medium adds."""
    change = element.change
    if element.moves:
        for lane in range(np.uintp(lanes)):
            o_z = _moved(change, pair, lane)[5]
            d_x, d_y, d_z = _line_back(pair, lane, o_z)
            pair[D_O_X + lane] = change.xx * d_x + change.yx * d_y + change.zx * d_z
            pair[D_O_Y + lane] = change.xy * d_x + change.yy * d_y + change.zy * d_z
            pair[D_O_Z + lane] = change.xz * d_x + change.yz * d_y + change.zz * d_z
        for lane in range(np.uintp(lanes)):
            d_x, d_y = pair[BLOCK + D_X + lane], pair[BLOCK + D_Y + lane]
            d_z = pair[BLOCK + D_START + lane]
            pair[D_P_X + lane] = change.xx * d_x + change.yx * d_y + change.zx * d_z
            pair[D_P_Y + lane] = change.xy * d_x + change.yy * d_y + change.zy * d_z
            pair[D_P_Z + lane] = change.xz * d_x + change.yz * d_y + change.zz * d_z
            pair[D_OUT + lane] = pair[BLOCK + D_FLUX + lane]
    else:
        for lane in range(np.uintp(lanes)):
            d_x, d_y, d_z = _line_back(pair, lane, pair[O_Z + lane])
            pair[D_O_X + lane] = d_x
            pair[D_O_Y + lane] = d_y
            pair[D_O_Z + lane] = d_z
            pair[D_P_X + lane] = pair[BLOCK + D_X + lane]
            pair[D_P_Y + lane] = pair[BLOCK + D_Y + lane]
            pair[D_P_Z + lane] = pair[BLOCK + D_START + lane]
            pair[D_OUT + lane] = pair[BLOCK + D_FLUX + lane]


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _line_back(pair, lane, o_z):  # type: ignore[no-untyped-def]
    """Cotangents of a direction in the frame of an element from those of the slopes of its line."""
    kind = pair.dtype.type
    zero, one = kind(0), kind(1)
    exists = pair[BLOCK + at(ARRIVING, lane)] >= zero
    by_z = one / (o_z if exists else one)
    a, b = pair[BLOCK + at(SLOPE_X, lane)], pair[BLOCK + at(SLOPE_Y, lane)]
    d_a, d_b = pair[BLOCK + D_A + lane] * by_z, pair[BLOCK + D_B + lane] * by_z
    return d_a, d_b, -(d_a * a + d_b * b)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _radius(element, x, y):  # type: ignore[no-untyped-def]
    """Distance from the axis as a part of that of the rim."""
    x2, y2 = x * x * element.by_x2, y * y * element.by_y2
    return np.sqrt(x2 + y2 if element.curved else max(x2, y2))


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _at_face(element, pair, lane):  # type: ignore[no-untyped-def]
    """Place on the face, slopes there, whether it is met, and its distance to the rim.

    See `workbench.optics.images.rim`.
    """
    kind = pair.dtype.type
    a, b = pair[BLOCK + at(SLOPE_X, lane)], pair[BLOCK + at(SLOPE_Y, lane)]
    depth = pair[BLOCK + at(DEPTH, lane)]
    x, y = pair[BLOCK + at(X, lane)] + a * depth, pair[BLOCK + at(Y, lane)] + b * depth
    exists = pair[BLOCK + at(ARRIVING, lane)] >= kind(0)
    met = (pair[BLOCK + at(STATE, lane)] == kind(MET)) & exists
    rim = element.rim - _radius(element, x, y)
    # Samples beside a curved outline stand for parts that it cuts: their rim is where they are.
    s_x, s_y = pair[P_X + lane], pair[P_Y + lane]
    radius2 = s_x * s_x * element.first_x2 + s_y * s_y * element.first_y2
    wider = np.sqrt(max(radius2, kind(1))) - kind(1)
    rim += wider * element.beyond if element.behind_samples else kind(0)
    met = met & (rim >= kind(0))
    rim = max(rim, kind(0)) if met else (kind(-1) if exists else kind(0))
    z_x = pair[BLOCK + at(Z_S, lane)] * element.net.per_x
    z_y = pair[BLOCK + at(Z_T, lane)] * element.net.per_y
    return x, y, depth, a, b, z_x, z_y, met, rim


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _fade(element, pair, lanes):  # type: ignore[no-untyped-def]
    """Transmittance of the medium before the face; in a loop of its own: exp does not vectorise."""
    one = pair.dtype.type(1)
    if element.absorption == pair.dtype.type(0):
        for lane in range(np.uintp(lanes)):
            pair[BLOCK + FADE + lane] = one
        return
    for lane in range(np.uintp(lanes)):
        a, b = pair[BLOCK + at(SLOPE_X, lane)], pair[BLOCK + at(SLOPE_Y, lane)]
        deep = abs(pair[BLOCK + at(DEPTH, lane)] - pair[BLOCK + START + lane])
        way = deep * np.sqrt(one + a * a + b * b)
        pair[BLOCK + FADE + lane] = np.exp(-element.absorption * way)


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def cross(element, pair, lanes):  # type: ignore[no-untyped-def]
    """Rays behind the face; see `transfer`."""
    kind = pair.dtype.type
    zero, one, two = kind(0), kind(1), kind(2)
    n = element.law.ratio
    _fade(element, pair, lanes)
    for lane in range(np.uintp(lanes)):
        x, y, z, a, b, z_x, z_y, met, rim = _at_face(element, pair, lane)
        refracted = snell(n, element.ratio2_minus_1, element.critical, a, b, z_x, z_y)
        lean, q, gamma, by_both, passes = refracted
        passes = met & (passes | element.reflects)
        flux = pair[BLOCK + at(ARRIVING, lane)] if met else zero
        arriving = flux * pair[BLOCK + FADE + lane] if met else zero  # else there may be no way
        part = transmittance(element.law, abs(lean) * by_both, q * by_both)
        on = arriving * (element.reflectance if element.reflects else part)
        twice = two * lean / (one + z_x * z_x + z_y * z_y)
        o_x = a + twice * z_x if element.reflects else n * a - gamma * z_x
        o_y = b + twice * z_y if element.reflects else n * b - gamma * z_y
        o_z = one - twice if element.reflects else n + gamma
        before = pair[RIM + lane]
        pair[BLOCK + P_X + lane] = x
        pair[BLOCK + P_Y + lane] = y
        pair[BLOCK + P_Z + lane] = z
        pair[BLOCK + O_X + lane] = o_x if passes else zero
        pair[BLOCK + O_Y + lane] = o_y if passes else zero
        pair[BLOCK + O_Z + lane] = o_z if passes else zero
        pair[BLOCK + FLUX + lane] = on if passes else kind(NO_RAY)
        pair[BLOCK + RIM + lane] = min(rim, before)
        pair[BLOCK + ABSORBS + lane] = flux - arriving
        pair[BLOCK + MEETS + lane] = arriving
        pair[BLOCK + PASSES + lane] = arriving if passes else zero
        pair[BLOCK + GOES + lane] = on if passes else zero


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def count_flux(pair, lanes, sums):  # type: ignore[no-untyped-def]
    """Add the flux of a batch behind an element to its sums."""
    sums[ABSORBED] += total(pair, BLOCK + ABSORBS, lanes)
    sums[MET_FLUX] += total(pair, BLOCK + MEETS, lanes)
    sums[PASSED] += total(pair, BLOCK + PASSES, lanes)
    sums[LEFT] += total(pair, BLOCK + GOES, lanes)


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def cross_back(element, pair, lanes):  # type: ignore[no-untyped-def]
    """Adjoint of `cross` and of the search: cotangents of the line, and of the face."""
    _fade(element, pair, lanes)
    if element.reflects:
        _reflect_back(element, pair, lanes)
    else:
        _refract_back(element, pair, lanes)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _refract_back(element, pair, lanes):  # type: ignore[no-untyped-def]
    kind = pair.dtype.type
    n = element.law.ratio
    for lane in range(np.uintp(lanes)):
        x, y, _, a, b, z_x, z_y, _, rim = _at_face(element, pair, lane)
        refracted = snell(n, element.ratio2_minus_1, element.critical, a, b, z_x, z_y)
        lean, q, _, by_both, _ = refracted
        passes = pair[BLOCK + FLUX + lane] >= kind(0)
        cos_in, cos_out = lean * by_both, q * by_both
        arriving = pair[BLOCK + at(ARRIVING, lane)] * pair[BLOCK + FADE + lane]
        d_on = pair[BLOCK + D_OUT + lane]
        by_in, by_out = transmittance_slopes(element.law, cos_in, cos_out)
        d_arriving = d_on * transmittance(element.law, cos_in, cos_out)
        slopes = snell_back(
            n, element.ratio2_minus_1, a, b, z_x, z_y, refracted, kind(0),
            pair[BLOCK + D_O_X + lane], pair[BLOCK + D_O_Y + lane], pair[BLOCK + D_O_Z + lane],
            d_on * arriving * by_in, d_on * arriving * by_out,
        )  # fmt: skip
        at_face = x, y, z_x, z_y, rim
        _meeting_back(element, pair, lane, at_face, slopes, arriving, d_arriving, passes)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _reflect_back(element, pair, lanes):  # type: ignore[no-untyped-def]
    kind = pair.dtype.type
    one, two = kind(1), kind(2)
    for lane in range(np.uintp(lanes)):
        x, y, _, a, b, z_x, z_y, _, rim = _at_face(element, pair, lane)
        passes = pair[BLOCK + FLUX + lane] >= kind(0)
        arriving = pair[BLOCK + at(ARRIVING, lane)] * pair[BLOCK + FADE + lane]
        d_arriving = pair[BLOCK + D_OUT + lane] * element.reflectance
        d_o_x, d_o_y = pair[BLOCK + D_O_X + lane], pair[BLOCK + D_O_Y + lane]
        lean, by_face2 = one - a * z_x - b * z_y, one / (one + z_x * z_x + z_y * z_y)
        d_twice = d_o_x * z_x + d_o_y * z_y - pair[BLOCK + D_O_Z + lane]
        twice = two * lean * by_face2
        d_lean, d_face2 = two * by_face2 * d_twice, -twice * by_face2 * d_twice
        slopes = (
            d_o_x - d_lean * z_x,
            d_o_y - d_lean * z_y,
            twice * d_o_x - d_lean * a + two * z_x * d_face2,
            twice * d_o_y - d_lean * b + two * z_y * d_face2,
        )
        at_face = x, y, z_x, z_y, rim
        _meeting_back(element, pair, lane, at_face, slopes, arriving, d_arriving, passes)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _meeting_back(  # type: ignore[no-untyped-def]
    element, pair, lane, at_face, slopes, arriving, d_arriving, passes
):
    """From cotangents at the face to those of the line that meets it, and of the face."""
    kind = pair.dtype.type
    x, y, z_x, z_y, rim = at_face
    zero, one = kind(0), kind(1)
    d_a, d_b, d_z_x, d_z_y = slopes
    a, b = pair[BLOCK + at(SLOPE_X, lane)], pair[BLOCK + at(SLOPE_Y, lane)]
    deep = pair[BLOCK + at(DEPTH, lane)] - pair[BLOCK + START + lane]
    own = rim < pair[RIM + lane]
    radius = _radius(element, x, y)
    d_rim = pair[BLOCK + D_RIM + lane]
    pair[D_RIM + lane] = zero if own else d_rim
    d_radius = -d_rim / radius if own & (rim > zero) & (radius > zero) else zero
    by_x = x * x * element.by_x2 >= y * y * element.by_y2
    d_p_x, d_p_y = pair[BLOCK + D_P_X + lane], pair[BLOCK + D_P_Y + lane]
    d_p_x += d_radius * x * element.by_x2 if element.curved | by_x else zero
    d_p_y += d_radius * y * element.by_y2 if element.curved | (not by_x) else zero
    # Slopes of the face at a place that moves with the ray.
    d_s, d_t = d_z_x * element.net.per_x, d_z_y * element.net.per_y
    z_ss, z_st = pair[BLOCK + at(Z_SS, lane)], pair[BLOCK + at(Z_ST, lane)]
    d_p_x += (d_s * z_ss + d_t * z_st) * element.net.per_x
    d_p_y += (d_s * z_st + d_t * pair[BLOCK + at(Z_TT, lane)]) * element.net.per_y
    stretch = np.sqrt(one + a * a + b * b)
    d_way = -element.absorption * arriving * d_arriving
    d_way = d_way if deep > zero else -d_way
    d_depth = pair[BLOCK + D_P_Z + lane] + d_p_x * a + d_p_y * b + d_way * stretch
    slope = min(a * z_x + b * z_y - one, kind(-1e-3))
    d_root = -d_depth / slope
    d_p_x += d_root * z_x
    d_p_y += d_root * z_y
    by_stretch = d_way * deep / stretch
    pair[BLOCK + at(D_Z, lane)] = d_root if passes else zero
    pair[BLOCK + at(D_S, lane)] = d_s if passes else zero
    pair[BLOCK + at(D_T, lane)] = d_t if passes else zero
    pair[BLOCK + D_X + lane] = d_p_x if passes else zero
    pair[BLOCK + D_Y + lane] = d_p_y if passes else zero
    pair[BLOCK + D_A + lane] = d_a + d_p_x * deep + by_stretch * a if passes else zero
    pair[BLOCK + D_B + lane] = d_b + d_p_y * deep + by_stretch * b if passes else zero
    pair[BLOCK + D_START + lane] = -d_p_x * a - d_p_y * b - d_way * stretch if passes else zero
    pair[BLOCK + D_FLUX + lane] = d_arriving * pair[BLOCK + FADE + lane] if passes else zero
