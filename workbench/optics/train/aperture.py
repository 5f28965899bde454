"""What of the light of a sample of the first face comes through the aperture before it.

The twin of `workbench.optics.aperture`; the derivatives by the height of the face are taken on the
way.
"""

from typing import Any, NamedTuple

import numpy as np

from workbench.arrays import AnyArray
from workbench.compiled import jit
from workbench.optics.kernels.taps import FAST
from workbench.optics.train.outlines import held
from workbench.optics.train.registers import (
    BRIGHT,
    BY_WAY,
    BY_Z_X,
    BY_Z_Y,
    D_BRIGHT,
    NARROWED,
    S_X,
    S_Y,
    Z_X,
    Z_Y,
    Z,
)

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
