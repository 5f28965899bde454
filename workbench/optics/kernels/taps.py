"""The normalised taps of a reconstruction filter as short series, which vectorise.

A tap is a smooth function of the offset o ∈ [−½, ½) of a hit from the centre of its pixel, and
tap −k at o is tap k at −o. So both come from two even functions,

    tap ±k = E_k(x) ± o F_k(x)   with x = 8 o² − 1 ∈ [−1, 1],

and so do their slopes, ± G_k(x) + o H_k(x). Each is a Chebyshev series, cut off where it is below
rounding. The middle tap is what the others leave of 1, so that light is conserved.

Filters that are nearly steps (a large α) would need long series. They are computed from their
exponentials, one ray after the other: right, but slow.
"""

import math
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from workbench.arrays import AnyArray, Array
from workbench.compiled import jit

# No 'nnan' or 'ninf': rays that go nowhere have such numbers.
FAST = {"contract", "reassoc", "arcp", "nsz"}
# Longest series; a step of a filter with α = 16 takes 21 terms in float32, 43 in float64.
_LONGEST = 48
# Steps of a larger α are too steep for any such series, and fall between the samples of a fit.
_STEEPEST = 64.0
_SAMPLES = 64
# So many terms the common filters need in float32; a fixed number lets the compiler unroll.
SHORT = 6


class Taps(NamedTuple):
    """Filter weights along one axis."""

    half_size: int  # pixels on each side of that of the hit, (ν − 1) / 2
    alpha: np.floating[Any]  # α of the Gaussian, per pixel², in the trace's float type
    # (half_size, 4, terms), chebyshev coefficients of E_k, F_k, G_k and H_k for k = 1 ...
    # half_size; no terms where the exponentials are to be taken.
    series: AnyArray


def make_taps(alpha: float, size: int, kind: type[np.floating[Any]]) -> Taps:
    """Taps of a Gaussian filter (size > 1), or of a box (size 1)."""
    half_size = size // 2
    series = np.zeros((half_size, 4, SHORT))
    if half_size > 0:
        series = _fit(alpha, half_size, float(np.finfo(kind).eps))
    return Taps(half_size, kind(alpha), np.ascontiguousarray(series.astype(kind)))


@lru_cache(maxsize=32)
def _fit(alpha: float, half_size: int, eps: float) -> Array:
    if alpha > _STEEPEST:
        return np.zeros((half_size, 4, 0))
    angle = np.pi * (np.arange(_SAMPLES) + 0.5) / _SAMPLES
    functions = _even_functions(np.sqrt((np.cos(angle) + 1) / 8), alpha, half_size)
    series = functions @ np.cos(np.outer(angle, np.arange(_SAMPLES))) * (2 / _SAMPLES)
    series[..., 0] /= 2
    # Slopes may be steep; taps are not above 1.
    scale = np.maximum(1, np.abs(functions).max(axis=(0, 2)))[:, None]
    # In float64 the coefficients have some rounding of their own, which is no reason to keep them.
    kept = (np.abs(series) / scale > max(eps / 4, 4e-16)).any(axis=(0, 1)).nonzero()[0]
    terms = int(kept[-1]) + 1
    if terms > _LONGEST:
        return np.zeros((half_size, 4, 0))
    return np.asarray(series[:, :, : max(SHORT, terms + terms % 2)])


def _even_functions(o: Array, alpha: float, half_size: int) -> Any:
    """E_k, F_k, G_k and H_k at offsets above 0, shape (half_size, 4, m); without cancellation."""
    k = np.arange(1, half_size + 1)[:, None]
    rim2 = (half_size + 0.5) ** 2
    # As in `irradiance._taps`, scaled by e^(α o²).
    rim = np.exp(alpha * (np.square(o) - rim2))
    bell = np.exp(2 * alpha * k * o - alpha * k * k)
    bell_below = np.exp(-2 * alpha * k * o - alpha * k * k)
    difference = -bell * np.expm1(-4 * alpha * k * o)
    pair = -bell * np.expm1(alpha * (np.square(o - k) - rim2))
    pair -= bell_below * np.expm1(alpha * (np.square(o + k) - rim2))
    total = pair.sum(axis=0) - np.expm1(alpha * (np.square(o) - rim2))
    pair_rise = 2 * alpha * k * difference / o - 4 * alpha * rim  # over o, like the next
    total_rise = pair_rise.sum(axis=0) - 2 * alpha * rim
    difference_rise = 2 * alpha * k * (bell + bell_below)
    return np.stack(
        [
            pair,
            difference / o,
            difference_rise - difference * o * (total_rise / total),
            pair_rise - pair * (total_rise / total),
        ],
        axis=1,
    ) / (2 * total)


# Arrays that are made or handed on inside a kernel cost some 10 ns each, for the count of their
# references. So the numbers of a batch lie in one array, and functions take offsets in it.


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def fill_taps(taps, numbers, batch, offset, count, slopes, state, value, slope):  # type: ignore[no-untyped-def]
    """Taps of rays, and their slopes too if these are wanted.

    `taps`: the filter; `numbers`: holds everything; all that follows but ``slopes`` is of type
    uintp; `batch`: room between tap and tap; `offset`: where the offsets of the hits begin;
    `count`: how many of them there are; `slopes`: whether slopes are wanted; `state`: where there
    is room for 4 batches of intermediate results; `value`, `slope`: where the results begin, those
    for tap −half_size first.
    """
    kind = numbers.dtype.type
    half_size, terms = taps.half_size, taps.series.shape[2]
    if half_size > 0 and terms == 0:
        for ray in range(count):
            here = numbers[offset + ray]
            _from_exponentials(
                taps.alpha, half_size, here, numbers, batch, slopes, value + ray, slope + ray
            )
        return
    middle = value + np.uintp(half_size) * batch
    middle_slope = slope + np.uintp(half_size) * batch
    for ray in range(count):
        numbers[middle + ray] = kind(1)
    if slopes:
        for ray in range(count):
            numbers[middle_slope + ray] = kind(0)
    for k in range(half_size):
        away = np.uintp(k + 1) * batch
        if terms == SHORT:
            _pair_short(taps.series, k, numbers, offset, count, middle, away)
            if slopes:
                _slopes_short(taps.series, k, numbers, offset, count, middle_slope, away)
        else:
            first, second = state, state + batch
            rest = second + batch
            _sum_long(taps.series, k, 0, numbers, batch, offset, count, rest, first)
            _sum_long(taps.series, k, 1, numbers, batch, offset, count, rest, second)
            for ray in range(count):
                even = numbers[first + ray]
                odd = numbers[offset + ray] * numbers[second + ray]
                one, other = max(even + odd, kind(0)), max(even - odd, kind(0))
                numbers[middle + away + ray] = one
                numbers[middle - away + ray] = other
                numbers[middle + ray] -= one + other
            if slopes:
                _sum_long(taps.series, k, 2, numbers, batch, offset, count, rest, first)
                _sum_long(taps.series, k, 3, numbers, batch, offset, count, rest, second)
                for ray in range(count):
                    even = numbers[first + ray]
                    odd = numbers[offset + ray] * numbers[second + ray]
                    numbers[middle_slope + away + ray] = odd + even
                    numbers[middle_slope - away + ray] = odd - even
                    numbers[middle_slope + ray] -= odd + odd


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _pair_short(series, k, numbers, offset, count, middle, away):  # type: ignore[no-untyped-def]
    kind = numbers.dtype.type
    e0, e1, e2, e3, e4, e5 = _six(series, k, 0)
    f0, f1, f2, f3, f4, f5 = _six(series, k, 1)
    for ray in range(count):
        o = numbers[offset + ray]
        x2 = kind(16) * o * o - kind(2)
        even = _short(x2, e0, e1, e2, e3, e4, e5)
        odd = o * _short(x2, f0, f1, f2, f3, f4, f5)
        # The series may miss a tap of 0 by its rounding; light is never negative.
        one, other = max(even + odd, kind(0)), max(even - odd, kind(0))
        numbers[middle + away + ray] = one
        numbers[middle - away + ray] = other
        numbers[middle + ray] -= one + other


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _slopes_short(series, k, numbers, offset, count, middle, away):  # type: ignore[no-untyped-def]
    kind = numbers.dtype.type
    g0, g1, g2, g3, g4, g5 = _six(series, k, 2)
    h0, h1, h2, h3, h4, h5 = _six(series, k, 3)
    for ray in range(count):
        o = numbers[offset + ray]
        x2 = kind(16) * o * o - kind(2)
        even = _short(x2, g0, g1, g2, g3, g4, g5)
        odd = o * _short(x2, h0, h1, h2, h3, h4, h5)
        numbers[middle + away + ray] = odd + even
        numbers[middle - away + ray] = odd - even
        numbers[middle + ray] -= odd + odd


@jit(error_model="numpy", forceinline=True)
def _six(series, k, which):  # type: ignore[no-untyped-def]
    return (
        series[k, which, 0],
        series[k, which, 1],
        series[k, which, 2],
        series[k, which, 3],
        series[k, which, 4],
        series[k, which, 5],
    )


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _short(x2, c0, c1, c2, c3, c4, c5):  # type: ignore[no-untyped-def]
    """Sum of six Chebyshev polynomials by Clenshaw's recurrence; x2 is 2 x."""
    b4 = c4 + x2 * c5
    b3 = c3 + x2 * b4 - c5
    b2 = c2 + x2 * b3 - b4
    b1 = c1 + x2 * b2 - b3
    return c0 + (x2 * b1) * type(x2)(0.5) - b2


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def _sum_long(series, k, which, numbers, batch, offset, count, state, total):  # type: ignore[no-untyped-def]
    """Sum of an even number of Chebyshev polynomials, two terms a pass."""
    kind = numbers.dtype.type
    later, latest = state, state + batch
    for ray in range(count):
        numbers[later + ray] = kind(0)
        numbers[latest + ray] = kind(0)
    for m in range(series.shape[2] - 1, 1, -2):
        high, low = series[k, which, m], series[k, which, m - 1]
        for ray in range(count):
            o = numbers[offset + ray]
            x2 = kind(16) * o * o - kind(2)
            after = high + x2 * numbers[latest + ray] - numbers[later + ray]
            numbers[latest + ray] = low + x2 * after - numbers[latest + ray]
            numbers[later + ray] = after
    c0, c1 = series[k, which, 0], series[k, which, 1]
    for ray in range(count):
        o = numbers[offset + ray]
        x2 = kind(16) * o * o - kind(2)
        b1 = c1 + x2 * numbers[latest + ray] - numbers[later + ray]
        numbers[total + ray] = c0 + (x2 * b1) * kind(0.5) - numbers[latest + ray]


@jit(error_model="numpy")
def _from_exponentials(alpha, half_size, offset, numbers, batch, slopes, value, slope):  # type: ignore[no-untyped-def]
    """The taps of one ray, as in `irradiance._taps`."""
    kind = numbers.dtype.type
    square, two = offset * offset, kind(2)
    half_width = kind(half_size) + kind(0.5)
    edge = half_width * half_width
    rim = math.exp(alpha * (square - edge))
    total, total_rise = kind(0), kind(0)
    for tap in range(2 * half_size + 1):
        k, at = kind(tap - half_size), np.uintp(tap) * batch
        distance = offset - k
        bell = math.exp(two * alpha * k * offset - alpha * k * k)
        share = -bell * math.expm1(alpha * (distance * distance - edge))
        numbers[value + at] = share
        total += share
        if slopes:
            rise = two * alpha * (k * bell - offset * rim)
            numbers[slope + at] = rise
            total_rise += rise
    for tap in range(2 * half_size + 1):
        at = np.uintp(tap) * batch
        numbers[value + at] /= total
        if slopes:
            numbers[slope + at] -= numbers[value + at] * total_rise
            numbers[slope + at] /= total
