"""Light of origins at samples of a freeform entrance face: slopes, flux, and how both go with z.

All that the light before a face depends on at a sample is the height z of the face there, so the
derivatives by it are taken on the way.
"""

from typing import Any, NamedTuple

import numpy as np

from workbench.arrays import AnyArray
from workbench.compiled import jit
from workbench.optics.kernels.taps import FAST
from workbench.optics.train.patterns import weigh
from workbench.optics.train.registers import (
    BRIGHT,
    BY_WAY,
    D_BRIGHT,
    D_S_X,
    D_S_Y,
    NARROWED,
    S_X,
    S_Y,
    Z,
)

Number = np.floating[Any]


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
    # (k or 0, n, n), see `workbench.optics.patterns.tabulated`; none where intensity is even or
    # Lambertian.
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
