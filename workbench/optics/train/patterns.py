"""Light weighed with the intensity of its point, which stands in a table by place."""

import numpy as np

from workbench.compiled import jit
from workbench.optics.kernels.taps import FAST
from workbench.optics.train.registers import BRIGHT, D_BRIGHT

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
