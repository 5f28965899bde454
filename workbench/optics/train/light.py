"""Light at a batch of samples of the first face, or given rays on their way to it."""

import numpy as np

from workbench.compiled import jit
from workbench.optics.kernels.taps import FAST
from workbench.optics.train.free_light import from_far, from_near, stop
from workbench.optics.train.glass_light import from_point, from_sky
from workbench.optics.train.numbers import EVEN, FAR, POINTS, SKY
from workbench.optics.train.registers import (
    ABSORBED,
    BRIGHT,
    BY_Z_X,
    BY_Z_Y,
    D_BRIGHT,
    FLUX,
    O_X,
    O_Y,
    O_Z,
    P_X,
    P_Y,
    P_Z,
    RIM,
    Z,
)


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def begin_given(given, row, i, lanes, t):  # type: ignore[no-untyped-def]
    """Load rays of a row, from column ``i`` on, into the registers of the first face."""
    one = t.dtype.type(1)
    x, y, z = given.values[0, row, i:], given.values[1, row, i:], given.values[2, row, i:]
    a, b, flux = given.values[3, row, i:], given.values[4, row, i:], given.values[5, row, i:]
    for lane in range(np.uintp(lanes)):
        t[P_X + lane] = x[lane]
        t[P_Y + lane] = y[lane]
        t[P_Z + lane] = z[lane]
    for lane in range(np.uintp(lanes)):
        t[O_X + lane] = a[lane]
        t[O_Y + lane] = b[lane]
        t[O_Z + lane] = one
        t[FLUX + lane] = flux[lane]
    if len(given.rims):
        rim = given.rims[row, i:]
        for lane in range(np.uintp(lanes)):
            t[RIM + lane] = rim[lane]


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def shine(light, k, samples, i, j, face, lanes, t):  # type: ignore[no-untyped-def]
    """Slopes and flux of the light at samples, and their derivatives by the height of the face.

    `light`: the light; `k`: which of its origins; `samples`: all samples along x and y, and the
    outline; `i`, `j`: the first sample of the batch along x; that along y; `face`: the first face;
    `lanes`: how many samples there are; `t`: registers of the first face, with its heights and
    slopes; those of light are 0 at first.
    """
    across, up, outline = samples
    if light.kind == EVEN:
        _even(light.even, i, j, face, lanes, t)
        return
    if light.kind == SKY:
        from_sky(light.sky, k, across, i, up, j, outline, face, lanes, t)
    elif light.kind == POINTS:
        from_point(light.points, k, across, i, up, j, outline, face, lanes, t)
    else:
        x, y = across.place[i:], up.place[j]
        if light.kind == FAR:
            from_far(light.far, k, x, y, lanes, t)
        else:
            from_near(light.near, k, x, y, lanes, t)
        stop(light.aperture, x, y, i, j, lanes, t)
        _weigh(light.areas[j, i:], t.dtype.type(1), lanes, t)
    if len(light.share_y):
        _weigh(light.share_x[i:], light.share_y[j], lanes, t)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _even(even, i, j, face, lanes, t):  # type: ignore[no-untyped-def]
    kind = t.dtype.type
    across, row = even.across[i:], even.inside[j if len(even.inside) > 1 else 0, i:]
    flux = even.flux * even.up[j]
    for lane in range(np.uintp(lanes)):
        t[BRIGHT + lane] = across[lane] * row[lane] * flux  # the other registers stay 0
    if face.absorption > kind(0):
        for lane in range(np.uintp(lanes)):
            depth, bright = t[Z + lane] + face.lift, t[BRIGHT + lane]
            left = np.exp(-face.absorption * abs(depth))
            per_depth = face.absorption if depth > kind(0) else -face.absorption
            t[ABSORBED + lane] = bright * (kind(1) - left)
            t[BRIGHT + lane] = bright * left
            t[D_BRIGHT + lane] = -per_depth * bright * left


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _weigh(part, whole, lanes, t):  # type: ignore[no-untyped-def]
    """Multiply the flux of samples by factors, with its derivatives."""
    for lane in range(np.uintp(lanes)):
        factor = part[lane] * whole
        t[BRIGHT + lane] *= factor
        t[D_BRIGHT + lane] *= factor
        t[ABSORBED + lane] *= factor
        t[BY_Z_X + lane] *= factor
        t[BY_Z_Y + lane] *= factor
