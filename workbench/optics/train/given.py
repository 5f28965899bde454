"""Rays that were followed up to the first freeform face, as a batch of rays."""

import numpy as np

from workbench.compiled import jit
from workbench.optics.kernels.taps import FAST
from workbench.optics.train.registers import FLUX, O_X, O_Y, O_Z, P_X, P_Y, P_Z, RIM


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
