"""Light in the glass at samples of the exit face: slopes, flux, and their derivatives by the depth.

All that a sample's light in the glass depends on is its depth t below the entrance face, so the
derivatives by it are computed at once, and the adjoint is three products.

Light from infinitely far has one slope s everywhere: through the entrance face a sample's part of
the exit face is seen shifted by −s t. For light of points see `workbench.optics.glass`: with ρ the
sample's distance from its point's axis and p = ρ_e / ρ, the slope is p g, and the sample's part is
seen narrowed by p.
"""

import numpy as np

from workbench.compiled import jit
from workbench.optics.kernels.refraction import transmittance, transmittance_slopes
from workbench.optics.kernels.taps import FAST
from workbench.optics.train.free_light import held, weigh
from workbench.optics.train.registers import (
    ABSORBED,
    BRIGHT,
    D_BRIGHT,
    D_S_X,
    D_S_Y,
    S_X,
    S_Y,
    Z,
)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _weigh(points, k, x, y, medium, lanes, t):  # type: ignore[no-untyped-def]
    """Weigh light with the pattern of its point."""
    pattern, zero = points.patterns[k], t.dtype.type(0)
    for lane in range(np.uintp(lanes)):
        depth = max(t[Z + lane] + medium.lift, zero)
        s_x, s_y = t[S_X + lane], t[S_Y + lane]
        u = (x[lane] - s_x * depth) * points.per_x + points.first_x
        v = (y - s_y * depth) * points.per_y + points.first_y
        d_u = -(s_x + depth * t[D_S_X + lane]) * points.per_x
        d_v = -(s_y + depth * t[D_S_Y + lane]) * points.per_y
        weigh(pattern, u, v, d_u, d_v, lane, t)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _seen(low, high, d_low, d_high, half_width):  # type: ignore[no-untyped-def]
    """What of an interval lies within the entrance face, and its derivative."""
    zero = type(low)(0)
    within = min(high, half_width) - max(low, -half_width)
    rise = (d_high if high < half_width else zero) - (d_low if low > -half_width else zero)
    return max(within, zero), rise if within > zero else zero


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def from_sky(sky, k, across, i, up, j, outline, medium, lanes, t):  # type: ignore[no-untyped-def]
    """Light of one direction at a batch of samples."""
    zero = t.dtype.type(0)
    s_x, s_y, flux = sky.slope_x[k], sky.slope_y[k], sky.flux[k]
    low, high, low_y, high_y = across.low[i:], across.high[i:], up.low[j], up.high[j]
    r_x, r_y = across.half_width, up.half_width
    for lane in range(np.uintp(lanes)):
        depth = t[Z + lane] + medium.lift
        shift_x, shift_y = s_x * depth, s_y * depth
        wide_x, rise_x = _seen(low[lane] - shift_x, high[lane] - shift_x, -s_x, -s_x, r_x)
        wide_y, rise_y = _seen(low_y - shift_y, high_y - shift_y, -s_y, -s_y, r_y)
        lit = depth > zero
        t[S_X + lane] = s_x
        t[S_Y + lane] = s_y
        t[D_S_X + lane] = zero
        t[D_S_Y + lane] = zero
        t[BRIGHT + lane] = flux * wide_x * wide_y if lit else zero
        t[D_BRIGHT + lane] = flux * (rise_x * wide_y + wide_x * rise_y) if lit else zero
    if sky.narrowing > zero:
        _narrow(sky, k, across.place[i:], up.place[j], medium, lanes, t)
    _leave_out(across, i, up, j, outline, medium, lanes, t)
    _absorb(medium, lanes, t)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _narrow(sky, k, x, y, medium, lanes, t):  # type: ignore[no-untyped-def]
    """Let the flux of a beam fall from its middle: in a loop of its own, exp does not vectorise."""
    two = t.dtype.type(2)
    s_x, s_y, a_x, a_y = sky.slope_x[k], sky.slope_y[k], sky.air_x[k], sky.air_y[k]
    for lane in range(np.uintp(lanes)):
        depth = t[Z + lane] + medium.lift
        e_x, e_y = x[lane] - s_x * depth, y - s_y * depth
        along = e_x * a_x + e_y * a_y
        beside2 = e_x * e_x + e_y * e_y - along * along
        rise = -two * (e_x * s_x + e_y * s_y - along * (s_x * a_x + s_y * a_y))
        left = np.exp(-sky.narrowing * beside2)
        bright = t[BRIGHT + lane] * left
        t[BRIGHT + lane] = bright
        t[D_BRIGHT + lane] = t[D_BRIGHT + lane] * left - bright * sky.narrowing * rise


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _leave_out(across, i, up, j, outline, medium, lanes, t):  # type: ignore[no-untyped-def]
    """What a curved outline keeps off: at the exit face by area, and at the entrance face."""
    if not outline.curved:
        return
    zero, one = t.dtype.type(0), t.dtype.type(1)
    x, low, high, inside = across.place[i:], across.low[i:], across.high[i:], outline.inside[j, i:]
    y, tall = up.place[j], up.high[j] - up.low[j]
    for lane in range(np.uintp(lanes)):
        depth = max(t[Z + lane] + medium.lift, zero)
        s_x, s_y, wide = t[S_X + lane], t[S_Y + lane], high[lane] - low[lane]
        d_x, d_y = -s_x - depth * t[D_S_X + lane], -s_y - depth * t[D_S_Y + lane]
        here, _ = held(x[lane], y, zero, zero, wide, tall, outline)
        there, rise = held(x[lane] - s_x * depth, y - s_y * depth, d_x, d_y, wide, tall, outline)
        whole = there >= here
        by_here = one / (here if here > zero else one)
        left = inside[lane] * (one if whole else there * by_here)
        d_left = inside[lane] * (zero if whole else rise * by_here)
        bright = t[BRIGHT + lane]
        t[BRIGHT + lane] = bright * left
        t[D_BRIGHT + lane] = t[D_BRIGHT + lane] * left + bright * d_left


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _absorb(medium, lanes, t):  # type: ignore[no-untyped-def]
    """What the glass takes on the way to the face."""
    one, zero = t.dtype.type(1), t.dtype.type(0)
    if medium.absorption == zero:
        for lane in range(np.uintp(lanes)):
            t[ABSORBED + lane] = zero
        return
    for lane in range(np.uintp(lanes)):
        depth = max(t[Z + lane] + medium.lift, zero)
        s_x, s_y = t[S_X + lane], t[S_Y + lane]
        stretch = np.sqrt(one + s_x * s_x + s_y * s_y)
        longer = stretch + depth * (s_x * t[D_S_X + lane] + s_y * t[D_S_Y + lane]) / stretch
        left = np.exp(-medium.absorption * depth * stretch)
        bright = t[BRIGHT + lane]
        t[ABSORBED + lane] = bright * (one - left)
        t[BRIGHT + lane] = bright * left
        t[D_BRIGHT + lane] = left * (t[D_BRIGHT + lane] - bright * medium.absorption * longer)


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def from_point(points, k, across, i, up, j, outline, medium, lanes, t):  # type: ignore[no-untyped-def]
    """Light of one point at a batch of samples."""
    kind = t.dtype.type
    zero, one, three = kind(0), kind(1), kind(3)
    c, ratio2_minus_1 = points.apparent, medium.ratio2_minus_1
    p_x, p_y, flux = points.x[k], points.y[k], points.flux[k]
    place, low, high = across.place[i:], across.low[i:], across.high[i:]
    away_y, low_y, high_y = up.place[j] - p_y, up.low[j] - p_y, up.high[j] - p_y
    r_x, r_y = across.half_width, up.half_width
    _find_radius_ratio(points, place, p_x, away_y, medium, lanes, t)
    for lane in range(np.uintp(lanes)):
        depth, radius_ratio = max(t[Z + lane] + medium.lift, zero), t[BRIGHT + lane]
        away_x = place[lane] - p_x
        radius2 = away_x * away_x + away_y * away_y
        enters2 = radius_ratio * radius_ratio * radius2
        g2 = one / (c * c + ratio2_minus_1 * enters2)
        g = np.sqrt(g2)
        c2_g3 = c * c * g2 * g
        narrow = one / (one + depth * c2_g3)  # dρ_e/dρ
        rise = -g * narrow  # dp/dt over p
        d_radius_ratio = radius_ratio * rise
        d_g = -g * g2 * ratio2_minus_1 * enters2 * rise
        d_narrow = -narrow * narrow * (c2_g3 + three * depth * c * c * g2 * d_g)
        behind, d_behind = _behind(points, medium.ratio, enters2, rise)

        slope = radius_ratio * g
        d_slope = d_radius_ratio * g + radius_ratio * d_g
        # p_x + p (x − p_x), without the cancellation for a point far beside the lens: 1 − p is
        # the slope times the depth.
        way, d_way = slope * depth, d_slope * depth + slope
        from_x, to_x = low[lane] - p_x, high[lane] - p_x
        wide_x, rise_x = _seen(
            low[lane] - way * from_x, high[lane] - way * to_x, -d_way * from_x, -d_way * to_x, r_x
        )
        wide_y, rise_y = _seen(
            up.low[j] - way * low_y, up.high[j] - way * high_y, -d_way * low_y, -d_way * high_y, r_y
        )
        # What is seen of the sample's part is its width on the entrance face over p, and light of
        # a ring around the axis is on 1 / (p dρ_e/dρ) of its area.
        area, d_area = wide_x * wide_y, rise_x * wide_y + wide_x * rise_y
        ring = narrow / radius_ratio
        d_ring = d_narrow / radius_ratio - ring * rise
        t[S_X + lane] = away_x * slope
        t[S_Y + lane] = away_y * slope
        t[D_S_X + lane] = away_x * d_slope
        t[D_S_Y + lane] = away_y * d_slope
        seen = t[Z + lane] + medium.lift > zero
        t[BRIGHT + lane] = flux * behind * area * ring if seen else zero
        d_seen = d_area * ring + area * d_ring
        t[D_BRIGHT + lane] = flux * d_behind * area * ring + flux * behind * d_seen
    if len(points.patterns):
        _weigh(points, k, across.place[i:], up.place[j], medium, lanes, t)
    _leave_out(across, i, up, j, outline, medium, lanes, t)
    _absorb(medium, lanes, t)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _find_radius_ratio(points, place, p_x, away_y, medium, lanes, t):  # type: ignore[no-untyped-def]
    """Find p of samples, in place of their flux."""
    kind = t.dtype.type
    zero, one, c, ratio2_minus_1 = kind(0), kind(1), points.apparent, medium.ratio2_minus_1
    for lane in range(np.uintp(lanes)):
        # p is between the two lower bounds of it and 1, and Newton's steps from below never fail.
        depth = max(t[Z + lane] + medium.lift, zero)
        away_x = place[lane] - p_x
        widening = ratio2_minus_1 * (away_x * away_x + away_y * away_y)
        steep = one - depth / np.sqrt(widening) if widening > zero else zero
        t[BRIGHT + lane] = max(c / (c + depth), steep)
    for _ in range(points.steps):
        for lane in range(np.uintp(lanes)):
            depth = max(t[Z + lane] + medium.lift, zero)
            away_x = place[lane] - p_x
            widening = ratio2_minus_1 * (away_x * away_x + away_y * away_y)
            radius_ratio = t[BRIGHT + lane]
            g = one / np.sqrt(c * c + radius_ratio * radius_ratio * widening)
            c_g = c * g
            off = radius_ratio * (one + depth * g) - one
            t[BRIGHT + lane] = radius_ratio - off / (one + depth * (c_g * c_g) * g)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _behind(points, n, enters2, rise):  # type: ignore[no-untyped-def]
    """Light behind the entrance face at ρ_e² over that straight ahead, and its slope by the depth.

    ``rise`` is dp/dt over p.
    """
    kind = type(enters2)
    one, three, lambert = kind(1), kind(3), points.lambert
    cos2 = points.distance2 / (points.distance2 + enters2)
    cos = np.sqrt(cos2)
    d_cos = -cos * (one - cos2) * rise
    # Behind the face the cosine to the axis is n d g over what the slope makes of 1.
    cos_glass = np.sqrt(one - (one - cos2) / (n * n))
    enters = transmittance(points.law, cos, cos_glass)
    by_in, by_out = transmittance_slopes(points.law, cos, cos_glass)
    d_enters = (by_in + by_out * cos / (n * n * cos_glass)) * d_cos
    lit = cos2 * cos * (one - lambert + lambert * cos)
    d_lit = cos2 * (three * (one - lambert) + kind(4) * lambert * cos) * d_cos
    return lit * enters, d_lit * enters + lit * d_enters
