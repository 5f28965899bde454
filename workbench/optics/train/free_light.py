"""Light of origins at samples of a face that they light directly: slopes, flux, and derivatives.

All that this light depends on at a sample is the height z of the face there, so the derivatives by
it are computed at once. The part that comes through the aperture before the face is the twin of
`workbench.optics.glass_face`.
"""

from typing import Any, NamedTuple

import numpy as np

from workbench.arrays import AnyArray
from workbench.compiled import jit
from workbench.optics.kernels.taps import FAST
from workbench.optics.train.registers import (
    BRIGHT,
    BY_WAY,
    BY_Z_X,
    BY_Z_Y,
    D_BRIGHT,
    D_S_X,
    D_S_Y,
    NARROWED,
    S_X,
    S_Y,
    Z_X,
    Z_Y,
    Z,
)

# In the middle of the lens no distance to an outline has a direction.
_CENTRE = 1e-12


@jit(fastmath=FAST, error_model="numpy", forceinline=True)
def held(x, y, d_x, d_y, wide, high, outline):  # type: ignore[no-untyped-def]
    """About how much of a sample's part is inside a curved outline, and its derivative."""
    kind = type(x)
    zero, one, two, centre = kind(0), kind(1), kind(2), kind(_CENTRE)
    level = np.sqrt(max(x * x * outline.by_x2 + y * y * outline.by_y2, centre))
    d_level = (x * d_x * outline.by_x2 + y * d_y * outline.by_y2) / level
    wide, high = wide * outline.by_x2, high * outline.by_y2
    across = max(abs(x) * wide + abs(y) * high, centre)
    d_across = (d_x if x > zero else -d_x) * wide + (d_y if y > zero else -d_y) * high
    over = level * (one - level) / across
    rise = (d_level * (one - two * level) - over * d_across) / across
    held = kind(0.5) + over
    partly = (held > zero) & (held < one)
    return min(max(held, zero), one), rise if partly else zero


Number = np.floating[Any]


class Aperture(NamedTuple):
    """The outline of an optic in the plane of its front vertex, and what samples stand for."""

    passes: bool  # whether all light goes straight on through it: then the rest plays no part
    front: Number  # height of its plane, counted as those of the face
    # Half-widths.
    r_x: Number
    r_y: Number
    curved: bool  # whether it is an ellipse
    # One by the squares of its semi-axes.
    by_x2: Number
    by_y2: Number
    # Ends of what each sample along x, along y stands for.
    low_x: AnyArray
    high_x: AnyArray
    low_y: AnyArray
    high_y: AnyArray


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _side(low, high, at, slope, face, behind, by_way, narrowed, r):  # type: ignore[no-untyped-def]
    """Part of a sample that is lit along one axis; derivatives by height and slope of the face."""
    kind = type(low)
    zero, one, two = kind(0), kind(1), kind(2)
    u, wide = at - behind * slope, narrowed * (one - slope * face)
    d_wide = -narrowed * by_way * (one - two * slope * face)
    leans = wide > zero
    per_wide = one / (wide if leans else one)
    before, after = (-r - u) * per_wide, (r - u) * per_wide
    begins, ends = at + before > low, at + after < high
    within = (at + after if ends else high) - (at + before if begins else low)
    # How both ends of the aperture move on the face.
    by_height = (slope * narrowed - after * d_wide if ends else zero) - (
        slope * narrowed - before * d_wide if begins else zero
    )
    by_slope = (after if ends else zero) - (before if begins else zero)
    per_size, lit = one / (high - low), leans & (within > zero)
    scale = per_wide * per_size if lit else zero
    part = within * per_size if lit else zero
    if not leans:
        part = one if abs(u) <= r else zero
    return part, by_height * scale, by_slope * narrowed * slope * scale


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def stop(aperture, x, y, i, j, lanes, t):  # type: ignore[no-untyped-def]
    """Take the light from a batch of samples that does not come through the aperture."""
    if aperture.passes:
        return
    low_x, high_x, low_y, high_y = (
        aperture.low_x[i:],
        aperture.high_x[i:],
        aperture.low_y[j],
        aperture.high_y[j],
    )
    if aperture.curved:
        _stop_by_curve(aperture, x, y, low_x, high_x, high_y - low_y, lanes, t)
        return
    front, r_x, r_y = aperture.front, aperture.r_x, aperture.r_y
    for lane in range(np.uintp(lanes)):
        behind, by_way, narrowed = t[Z + lane] - front, t[BY_WAY + lane], t[NARROWED + lane]
        low, high, at, bright = low_x[lane], high_x[lane], x[lane], t[BRIGHT + lane]
        wide, wide_by_z, wide_by_slope = _side(
            low, high, at, t[S_X + lane], t[Z_X + lane], behind, by_way, narrowed, r_x
        )
        tall, tall_by_z, tall_by_slope = _side(
            low_y, high_y, y, t[S_Y + lane], t[Z_Y + lane], behind, by_way, narrowed, r_y
        )
        t[BRIGHT + lane] = bright * wide * tall
        d_part = wide_by_z * tall + wide * tall_by_z
        t[D_BRIGHT + lane] = t[D_BRIGHT + lane] * wide * tall + bright * d_part
        t[BY_Z_X + lane] = bright * wide_by_slope * tall
        t[BY_Z_Y + lane] = bright * wide * tall_by_slope


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _stop_by_curve(aperture, x, y, low_x, high_x, tall, lanes, t):  # type: ignore[no-untyped-def]
    """As `stop`, of an aperture with a curved outline."""
    zero, one = t.dtype.type(0), t.dtype.type(1)
    for lane in range(np.uintp(lanes)):
        behind, narrowed = t[Z + lane] - aperture.front, t[NARROWED + lane]
        s_x, s_y, wide = t[S_X + lane], t[S_Y + lane], high_x[lane] - low_x[lane]
        here, _ = held(x[lane], y, zero, zero, wide, tall, aperture)
        there, rise = held(
            x[lane] - s_x * behind,
            y - s_y * behind,
            -s_x * narrowed,
            -s_y * narrowed,
            wide,
            tall,
            aperture,
        )
        whole = there >= here
        by_here = one / (here if here > zero else one)
        part = one if whole else there * by_here
        bright = t[BRIGHT + lane]
        t[BRIGHT + lane] = bright * part
        t[D_BRIGHT + lane] = t[D_BRIGHT + lane] * part + bright * (
            zero if whole else rise * by_here
        )


_ONE = np.uintp(1)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def weigh(pattern, u, v, d_u, d_v, lane, t):  # type: ignore[no-untyped-def]
    """Multiply the flux of a sample by a bilinear table, constant beyond it.

    `pattern` (n, n); `u`, `v`: where its light crosses the plane of the table, in steps of the
    table; `d_u`, `d_v`: derivatives of both by the height of the face; `lane`: which sample; `t`:
    registers of the first face; its flux and the derivative of that are changed.
    """
    kind = t.dtype.type
    zero, one, last = kind(0), kind(1), kind(len(pattern) - 1)
    d_u, d_v = d_u if zero < u < last else zero, d_v if zero < v < last else zero
    u, v = min(max(u, zero), last), min(max(v, zero), last)
    i, j = np.uintp(min(u, last - one)), np.uintp(min(v, last - one))
    u, v = u - kind(i), v - kind(j)
    a, b = pattern[i, j], pattern[i, j + _ONE]
    c, d = pattern[i + _ONE, j], pattern[i + _ONE, j + _ONE]
    low, high = a + (b - a) * v, c + (d - c) * v
    value = low + (high - low) * u
    rise = (high - low) * d_u + ((b - a) * (one - u) + (d - c) * u) * d_v
    bright = t[BRIGHT + lane]
    t[BRIGHT + lane] = bright * value
    t[D_BRIGHT + lane] = t[D_BRIGHT + lane] * value + bright * rise


class FarLight(NamedTuple):
    """Light from infinitely far; arrays of shape (k,), a number for each direction."""

    # Unit vectors.
    x: AnyArray
    y: AnyArray
    z: AnyArray
    flux: AnyArray  # flux per area across the axis, in the middle of the beam
    # Flux falls with exp(−narrowing × square of the distance to the middle of the beam).
    narrowing: Number
    front: Number  # height of the aperture, where the middle of the beam is


class NearLight(NamedTuple):
    """Points before the face; arrays of shape (k,)."""

    # Where they are, scene units.
    x: AnyArray
    y: AnyArray
    # How far they are before the level of heights, and before the aperture.
    below: AnyArray
    ahead: AnyArray
    flux: AnyArray  # flux per solid angle straight ahead
    lambert: Number  # 1 for Lambertian points, else 0
    # (k or 0, n, n), see `workbench.optics.sources.patterns.tabulated`; none where intensity is
    # even or Lambertian.
    patterns: AnyArray
    # Steps between values of the patterns for each length.
    per_x: Number
    per_y: Number
    # Step at x = 0, at y = 0.
    first_x: Number
    first_y: Number


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def from_far(light, k, x, y, lanes, t):  # type: ignore[no-untyped-def]
    """Light of one direction at a batch of samples."""
    zero, one = t.dtype.type(0), t.dtype.type(1)
    d_x, d_y, d_z, flux = light.x[k], light.y[k], light.z[k], light.flux[k]
    for lane in range(np.uintp(lanes)):
        t[S_X + lane] = d_x / d_z
        t[S_Y + lane] = d_y / d_z
        t[BRIGHT + lane] = flux
        t[D_S_X + lane] = zero
        t[D_S_Y + lane] = zero
        t[D_BRIGHT + lane] = zero
        t[BY_WAY + lane] = zero
        t[NARROWED + lane] = one
    if light.narrowing > zero:  # in a loop of its own: exp does not vectorise
        for lane in range(np.uintp(lanes)):
            z = t[Z + lane] - light.front
            along = x[lane] * d_x + y * d_y + z * d_z
            beside2 = x[lane] * x[lane] + y * y + z * z - along * along
            bright = flux * np.exp(-light.narrowing * beside2)
            t[BRIGHT + lane] = bright
            t[D_BRIGHT + lane] = -t.dtype.type(2) * light.narrowing * bright * (z - along * d_z)


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def from_near(light, k, x, y, lanes, t):  # type: ignore[no-untyped-def]
    """Light of one point at a batch of samples."""
    kind = t.dtype.type
    zero, one, two, power = kind(0), kind(1), kind(2), kind(3) + light.lambert
    p_x, p_y, below, ahead = light.x[k], light.y[k], light.below[k], light.ahead[k]
    flux, lambert = light.flux[k], light.lambert
    for lane in range(np.uintp(lanes)):
        way = t[Z + lane] + below
        by_way = one / way if way > zero else zero  # dark is what does not lie ahead
        s_x, s_y = (x[lane] - p_x) * by_way, (y - p_y) * by_way
        sine2 = s_x * s_x + s_y * s_y
        cos2 = one / (one + sine2)
        cos = np.sqrt(cos2)
        bright = flux * cos2 * cos * (one - lambert + lambert * cos) * by_way * by_way
        t[S_X + lane] = s_x
        t[S_Y + lane] = s_y
        t[BRIGHT + lane] = bright
        t[D_S_X + lane] = -s_x * by_way
        t[D_S_Y + lane] = -s_y * by_way
        t[BY_WAY + lane] = by_way
        t[NARROWED + lane] = ahead * by_way if way > zero else one
        t[D_BRIGHT + lane] = bright * by_way * (power * sine2 * cos2 - two)
    if len(light.patterns):
        _weigh(light, k, lanes, t)


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def _weigh(light, k, lanes, t):  # type: ignore[no-untyped-def]
    """Weigh light with the pattern of its point."""
    pattern, below = light.patterns[k], light.below[k]
    for lane in range(np.uintp(lanes)):
        u = (light.x[k] + t[S_X + lane] * below) * light.per_x + light.first_x
        v = (light.y[k] + t[S_Y + lane] * below) * light.per_y + light.first_y
        d_u = t[D_S_X + lane] * below * light.per_x
        d_v = t[D_S_Y + lane] * below * light.per_y
        weigh(pattern, u, v, d_u, d_v, lane, t)
