"""What `workbench.optics.kernels.face` runs: its light from the face to the screen.

The light in the glass is that of `workbench.optics.glass`, with ρ the sample's distance from its
point's axis, p = r = ρ_e / ρ and c = n d. Both directions are scaled so that no unit vector is
needed: with s = p g, light goes along L (s_x, s_y, 1)/L, L² = 1 + ρ² s², and the face's normal is
(−z_x, −z_y, 1)/S. With m = 1 − s·∇z Snell's law then reads

    Q² = n² m² − (n² − 1) L² S²,  Γ = −(n² − 1) L² / (Q + n m),

and the light goes on along (n s − Γ ∇z, n + Γ); the cosine behind the face is Q / (L S).
"""

import numpy as np

from workbench.compiled import jit
from workbench.optics.kernels.grid import Z_X, Z_Y, Z
from workbench.optics.kernels.rows import (
    COLUMN,
    D_COLUMN,
    D_ROW,
    D_WEIGHT,
    OWN,
    ROW,
    WEIGHT,
    make_loops,
)
from workbench.optics.kernels.spread import BATCH
from workbench.optics.kernels.taps import FAST
from workbench.optics.kernels.transmittance import transmittance, transmittance_slopes

# Numbers of a batch beside those of all kinds.
_DEPTH, _RADIUS_RATIO, _BRIGHT, _D_BRIGHT, _G, _COS, _NARROW, _Q, _GAMMA, _AHEAD, _FLUX, _WAY = (
    OWN + np.uintp(BATCH * k) for k in range(12)
)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _newton(radius_ratio, depth, widening, apparent):  # type: ignore[no-untyped-def]
    """One step towards the root of p (1 + t g) = 1."""
    one = type(radius_ratio)(1)
    g = one / np.sqrt(apparent * apparent + radius_ratio * radius_ratio * widening)
    apparent_g = apparent * g
    off = radius_ratio * (one + depth * g) - one
    return radius_ratio - off / (one + depth * (apparent_g * apparent_g) * g)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _find_radius_ratio(away_x, away_y, optics, steps, lanes, t):  # type: ignore[no-untyped-def]
    """Depths of samples, and their p."""
    kind = t.dtype.type
    one, zero, c = kind(1), kind(0), optics.apparent
    count = np.uintp(lanes)
    for lane in range(count):
        depth = max(t[Z + lane] + optics.lift, zero)
        t[_DEPTH + lane] = depth
        t[_RADIUS_RATIO + lane] = c / (c + depth)
    if optics.near:
        for lane in range(count):
            widening = optics.ratio2_minus_1 * (away_x[lane] * away_x[lane] + away_y * away_y)
            steep = one - t[_DEPTH + lane] / np.sqrt(widening) if widening > zero else zero
            t[_RADIUS_RATIO + lane] = max(t[_RADIUS_RATIO + lane], steep)
    for _ in range(steps):
        for lane in range(count):
            widening = optics.ratio2_minus_1 * (away_x[lane] * away_x[lane] + away_y * away_y)
            before = t[_RADIUS_RATIO + lane]
            t[_RADIUS_RATIO + lane] = _newton(before, t[_DEPTH + lane], widening, c)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _see_points(across, i, up, j, optics, lanes, t):  # type: ignore[no-untyped-def]
    """Brightness of each sample's point as far as it is seen through the entrance face."""
    kind = t.dtype.type
    bright, width = across.bright[i:], up.width[j]
    for lane in range(np.uintp(lanes)):
        t[_BRIGHT + lane] = bright[lane] * width
        t[_D_BRIGHT + lane] = kind(0)
    if not optics.rims:
        return
    rim_from_point, rim_from_place = across.rim_from_point[i:], across.rim_from_place[i:]
    away = across.away[i:]
    away_y, c = up.away[j], optics.apparent
    for lane in range(np.uintp(lanes)):
        radius_ratio = t[_RADIUS_RATIO + lane]
        enters2 = radius_ratio * radius_ratio * (away[lane] * away[lane] + away_y * away_y)
        depth_g = t[_DEPTH + lane] / np.sqrt(c * c + optics.ratio2_minus_1 * enters2)
        seen_x, rise_x = _seen(rim_from_point[lane], rim_from_place[lane], across.per_cell, depth_g)
        seen_y, rise_y = _seen(up.rim_from_point[j], up.rim_from_place[j], up.per_cell, depth_g)
        t[_D_BRIGHT + lane] = t[_BRIGHT + lane] * (rise_x * seen_y + seen_x * rise_y)
        t[_BRIGHT + lane] *= seen_x * seen_y


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _absorb(away_x, away_y, optics, lanes, t):  # type: ignore[no-untyped-def]
    """Take from the brightness of points what the glass absorbs on the way to each sample.

    The way is t L. Its slope by the depth is (1 + (L² − 1) dρ_e/dρ) / L.
    """
    kind = t.dtype.type
    one, c2 = kind(1), optics.apparent * optics.apparent
    for lane in range(np.uintp(lanes)):
        depth, radius_ratio = t[_DEPTH + lane], t[_RADIUS_RATIO + lane]
        enters2 = radius_ratio * radius_ratio * (away_x[lane] * away_x[lane] + away_y * away_y)
        g2 = one / (c2 + optics.ratio2_minus_1 * enters2)
        g, length2 = np.sqrt(g2), one + enters2 * g2
        narrow = one / (one + depth * (c2 * g2) * g)
        length = np.sqrt(length2)
        way = optics.absorption * depth * length
        rise = optics.absorption * (one + (length2 - one) * narrow) / length
        by_radius_ratio = rise / (radius_ratio * g * narrow)  # since dp/dt = −p g dρ_e/dρ
        left = np.exp(-way)
        t[_WAY + lane] = way
        t[_D_BRIGHT + lane] = left * (t[_D_BRIGHT + lane] + t[_BRIGHT + lane] * by_radius_ratio)
        t[_BRIGHT + lane] *= left


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _absorbed(lanes, t):  # type: ignore[no-untyped-def]
    """Flux that the glass has taken from what met the face."""
    kind = t.dtype.type
    absorbed = kind(0)
    for lane in range(np.uintp(lanes)):
        # Behind glass that is as good as black the numbers end before the light does.
        absorbed += t[_FLUX + lane] * (np.exp(min(t[_WAY + lane], kind(60))) - kind(1))
    return np.float64(absorbed)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _seen(rim_from_point, rim_from_place, per_cell, depth_g):  # type: ignore[no-untyped-def]
    """Part of a sample's cell that sees its point along one axis, and its slope by p.

    ``depth_g`` is t g = 1/p − 1.
    """
    kind = type(depth_g)
    one_by = kind(1) + depth_g
    seen = kind(0.5) + (rim_from_place + rim_from_point * depth_g) * per_cell
    partly = (seen > kind(0)) & (seen < kind(1))
    rise = -rim_from_point * one_by * one_by * per_cell if partly else kind(0)
    return min(max(seen, kind(0)), kind(1)), rise


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _refract(across, i, up, j, optics, spread, lanes, t):  # type: ignore[no-untyped-def]
    """Where light hits, and its flux.

    Returns
    -------
    tuple of two float64
        Flux that met the face, and that was not totally reflected.
    """
    kind = t.dtype.type
    one, zero, n, c = kind(1), kind(0), optics.ratio, optics.apparent
    met_flux, passed_flux = zero, zero
    place, away = across.place[i:], across.away[i:]
    y, away_y = up.place[j], up.away[j]
    plain = one - optics.lambert
    for lane in range(np.uintp(lanes)):
        z, z_x, z_y = t[Z + lane], t[Z_X + lane], t[Z_Y + lane]
        depth, radius_ratio = t[_DEPTH + lane], t[_RADIUS_RATIO + lane]
        away_x = away[lane]
        enters2 = radius_ratio * radius_ratio * (away_x * away_x + away_y * away_y)
        g2 = one / (c * c + optics.ratio2_minus_1 * enters2)
        g = np.sqrt(g2)
        narrow = one / (one + depth * (c * c * g2) * g)  # dρ_e/dρ
        cos2 = optics.distance2 / (optics.distance2 + enters2)
        cos = np.sqrt(cos2)
        length2 = one + enters2 * g2
        entering = transmittance(optics.entering, cos, one / np.sqrt(length2))
        behind = cos2 * cos * (plain + optics.lambert * cos) * entering
        slope = radius_ratio * g
        s_x, s_y = away_x * slope, away_y * slope
        lean = one - s_x * z_x - s_y * z_y
        met = (depth > zero) & (lean > zero)
        flux = t[_BRIGHT + lane] * behind * radius_ratio * narrow * lean if met else zero

        both2 = length2 * (one + z_x * z_x + z_y * z_y)
        square = n * n * lean * lean - optics.ratio2_minus_1 * both2
        passes = met & (square > optics.critical * both2)
        q = np.sqrt(square if passes else both2)
        gamma = -optics.ratio2_minus_1 * length2 / (q + n * abs(lean))
        onward = n + gamma
        goes_on = (onward > zero) & (onward * onward > kind(1e-12) * length2)
        ahead = one / (onward if goes_on else one)
        path = (optics.drop - z) * ahead
        one_by_both = one / np.sqrt(both2)
        leaving = transmittance(optics.leaving, lean * one_by_both, q * one_by_both)
        weight = flux * leaving if passes else zero
        arrives = passes & goes_on
        column = place[lane] + spread.per_x * (n * s_x - gamma * z_x) * path
        row = y + spread.per_y * (n * s_y - gamma * z_y) * path
        t[COLUMN + lane] = column if arrives else kind(np.inf)
        t[ROW + lane] = row if arrives else kind(np.inf)
        t[WEIGHT + lane] = weight
        t[_FLUX + lane] = flux
        t[_G + lane] = g
        t[_COS + lane] = cos
        t[_NARROW + lane] = narrow
        t[_Q + lane] = q
        t[_GAMMA + lane] = gamma
        t[_AHEAD + lane] = ahead
        met_flux += flux
        passed_flux += flux if passes else zero
    return np.float64(met_flux), np.float64(passed_flux)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _refract_back(across, i, up, j, optics, spread, lanes, t):  # type: ignore[no-untyped-def]
    """Adjoint of `_refract`, `_see_points` and `_find_radius_ratio` together."""
    kind = t.dtype.type
    one, two, zero, n = kind(1), kind(2), kind(0), optics.ratio
    away, away_y = across.away[i:], up.away[j]
    for lane in range(np.uintp(lanes)):
        # Again what `_refract` had, but for its roots and quotients.
        z, z_x, z_y = t[Z + lane], t[Z_X + lane], t[Z_Y + lane]
        depth, radius_ratio, g = t[_DEPTH + lane], t[_RADIUS_RATIO + lane], t[_G + lane]
        q, gamma, ahead = t[_Q + lane], t[_GAMMA + lane], t[_AHEAD + lane]
        bright = t[_BRIGHT + lane]
        away_x = away[lane]
        radius2 = away_x * away_x + away_y * away_y
        slope = radius_ratio * g
        s_x, s_y = away_x * slope, away_y * slope
        lean = one - s_x * z_x - s_y * z_y
        length2, face2 = one + radius2 * slope * slope, one + z_x * z_x + z_y * z_y
        path = (optics.drop - z) * ahead
        one_by_both = one / np.sqrt(length2 * face2)
        cos_in, cos_out = lean * one_by_both, q * one_by_both
        density, density_rise, slope_rise, radius_ratio_rise = _density(
            optics, depth, radius_ratio, g, t[_COS + lane], t[_NARROW + lane], length2
        )
        flux = bright * density * lean

        # The light's weight.
        d_weight = t[D_WEIGHT + lane]
        d_flux = d_weight * transmittance(optics.leaving, cos_in, cos_out)
        d_cos_in, d_cos_out = transmittance_slopes(optics.leaving, cos_in, cos_out)
        d_cos_in *= d_weight * flux
        d_cos_out *= d_weight * flux
        # The hit.
        d_x, d_y = t[D_COLUMN + lane] * spread.per_x, t[D_ROW + lane] * spread.per_y
        d_path = d_x * (n * s_x - gamma * z_x) + d_y * (n * s_y - gamma * z_y)
        d_x *= path
        d_y *= path
        d_z = -d_path * ahead
        d_gamma = -(d_x * z_x + d_y * z_y) - d_path * path * ahead
        d_lean, d_length2, d_face2 = _snell_back(
            optics, lean, length2, face2, q, gamma, one_by_both, d_gamma, d_cos_in, d_cos_out
        )
        d_lean += d_flux * bright * density
        # Slopes of the light and of the face, and the depth through p.
        d_s_x, d_s_y = n * d_x - d_lean * z_x, n * d_y - d_lean * z_y
        d_slope = d_s_x * away_x + d_s_y * away_y + two * radius2 * slope * d_length2
        d_z_x = two * z_x * d_face2 - gamma * d_x - d_lean * s_x
        d_z_y = two * z_y * d_face2 - gamma * d_y - d_lean * s_y
        flux_rise = bright * density_rise + t[_D_BRIGHT + lane] * radius_ratio_rise * density
        d_z += d_slope * slope_rise + d_flux * lean * flux_rise
        # Also where no flux is: the light of neighbours is spread up to this hit.
        both2 = length2 * face2
        square = n * n * lean * lean - optics.ratio2_minus_1 * both2
        passes = (depth > zero) & (lean > zero) & (square > optics.critical * both2)
        t[Z + lane] = d_z if passes else zero
        t[Z_X + lane] = d_z_x if passes else zero
        t[Z_Y + lane] = d_z_y if passes else zero


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _density(optics, depth, radius_ratio, g, cos, narrow, length2):  # type: ignore[no-untyped-def]
    """Flux on a level part of the face over its point's brightness, and what the depth does to it.

    Returns
    -------
    tuple of four floating
        The flux, and derivatives by the depth: its own, that of the light's slope p g, and that of
        p, which is that of the root: −p g dρ_e/dρ.
    """
    kind, n = type(depth), optics.ratio
    one, three = kind(1), kind(3)
    cos_glass = one / np.sqrt(length2)
    enters = transmittance(optics.entering, cos, cos_glass)
    enters_slope, glass_slope = transmittance_slopes(optics.entering, cos, cos_glass)
    enters_slope += glass_slope * cos / (n * n * cos_glass)
    cosines = cos * cos * cos * (one - optics.lambert + optics.lambert * cos)
    g2, radius_ratio_rise = g * g, -radius_ratio * g * narrow
    apparent2_g2 = optics.apparent * optics.apparent * g2
    spread_rise = apparent2_g2 * (g + three * depth * (one - apparent2_g2) * g2 * narrow)
    power = three + optics.lambert
    behind_rise = (one - cos * cos) * (power * enters + enters_slope * cos) * g * narrow
    by_radius_ratio = enters * (radius_ratio_rise - radius_ratio * narrow * spread_rise)
    density_rise = cosines * narrow * (behind_rise * radius_ratio + by_radius_ratio)
    density = cosines * enters * radius_ratio * narrow
    slope_rise = g * apparent2_g2 * radius_ratio_rise
    return density, density_rise, slope_rise, radius_ratio_rise


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _snell_back(  # type: ignore[no-untyped-def]
    optics, lean, length2, face2, q, gamma, one_by_both, d_gamma, d_cos_in, d_cos_out
):
    """Cotangents of m, L² and S² from those of Γ and of the cosines before and behind the face."""
    kind, n = type(lean), optics.ratio
    half, two = kind(0.5), kind(2)
    cos_in, cos_out = lean * one_by_both, q * one_by_both
    shared = d_gamma * gamma / (q + n * lean)
    d_square = half * (d_cos_out * one_by_both - shared) / q
    half_cos = half * (d_cos_in * cos_in + d_cos_out * cos_out) * (one_by_both * one_by_both)
    d_length2 = (
        d_gamma * gamma / length2 - d_square * optics.ratio2_minus_1 * face2 - half_cos * face2
    )
    d_face2 = -d_square * optics.ratio2_minus_1 * length2 - half_cos * length2
    d_lean = two * d_square * n * n * lean - n * shared + d_cos_in * one_by_both
    return d_lean, d_length2, d_face2


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _ahead(light, spread, i, j, lanes, t):  # type: ignore[no-untyped-def]
    """From the face to the screen.

    Returns
    -------
    tuple of three float64
        Flux that met the face, that was not totally reflected, and that was absorbed before.
    """
    across, up, optics, steps = light
    _find_radius_ratio(across.away[i:], up.away[j], optics, steps, lanes, t)
    _see_points(across, i, up, j, optics, lanes, t)
    absorbs = optics.absorption > t.dtype.type(0)
    if absorbs:
        _absorb(across.away[i:], up.away[j], optics, lanes, t)
    met, passed = _refract(across, i, up, j, optics, spread, lanes, t)
    return met, passed, _absorbed(lanes, t) if absorbs else 0.0


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _back(light, spread, i, j, lanes, t):  # type: ignore[no-untyped-def]
    """Adjoint of `_ahead`."""
    across, up, optics, _ = light
    _refract_back(across, i, up, j, optics, spread, lanes, t)


LOOPS = make_loops("face", _ahead, _back, own=12)
"""For light of samples ``across`` and ``up``, numbers of the trace and steps of Newton's method."""
