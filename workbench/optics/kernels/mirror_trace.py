"""What `workbench.optics.kernels.mirror` runs: parallel light from the mirror to the receiver."""

from typing import NamedTuple

import numpy as np

from workbench.arrays import AnyArray
from workbench.compiled import jit
from workbench.optics.kernels.grid import Z_X, Z_Y, Z
from workbench.optics.kernels.origin_receive import receive, receive_back
from workbench.optics.kernels.origin_trace import D_O_X, D_O_Y, D_O_Z, D_P_Z, END, O_X, O_Y, O_Z
from workbench.optics.kernels.rows import OWN, WEIGHT, make_loops
from workbench.optics.kernels.spread import BATCH
from workbench.optics.kernels.taps import FAST


class Along(NamedTuple):
    """Rays along an axis.

    Attributes
    ----------
    place : ndarray, shape (m,)
        Where they are, scene units, in the trace's float type.
    """

    place: AnyArray


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _ahead(light, spread, i, j, lanes, t):  # type: ignore[no-untyped-def]
    """Where rays land, and their flux; gives the flux that comes to the mirror.

    With d = (0, 0, 1) and N = (−z_x, −z_y, 1) the law of reflection leaves
    d − 2 (d·N / N²) N, along (2 z_x, 2 z_y, k − 1) with k = z_x² + z_y². Far fields count their
    angles from where light goes back.
    """
    across, up, wide, high, arriving, landing = light
    wide = wide[j if len(wide) > 1 else 0][i:]
    kind = t.dtype.type
    one, two, each, met = kind(1), kind(2), arriving * high[j], kind(0)
    back = -one if landing.far else one
    for lane in range(np.uintp(lanes)):
        z_x, z_y = t[Z_X + lane], t[Z_Y + lane]
        t[O_X + lane], t[O_Y + lane] = two * z_x, two * z_y
        t[O_Z + lane] = back * (z_x * z_x + z_y * z_y - one)
        t[WEIGHT + lane] = wide[lane] * each
        met += wide[lane]
    receive(landing, across, i, up, j, lanes, t)
    return (np.float64(met * each),)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _back(light, spread, i, j, lanes, t):  # type: ignore[no-untyped-def]
    """Adjoint of `_ahead`; the cotangents of z, z_x, z_y take the place of these."""
    across, up, landing = light[0], light[1], light[5]
    kind = t.dtype.type
    two, back = kind(2), kind(-2) if landing.far else kind(2)
    receive_back(landing, across, i, up, j, lanes, t)
    for lane in range(np.uintp(lanes)):
        z_x, z_y, d_o_z = t[Z_X + lane], t[Z_Y + lane], t[D_O_Z + lane]
        t[Z + lane] = t[D_P_Z + lane]
        t[Z_X + lane] = two * t[D_O_X + lane] + back * z_x * d_o_z
        t[Z_Y + lane] = two * t[D_O_Y + lane] + back * z_y * d_o_z


LOOPS = make_loops("mirror", _ahead, _back, own=int(END - OWN) // BATCH)
"""For light of rays along x and y, the shares of a cell for which they stand along u, as one row
for all v or a row for each, and along v, their flux, and the receiver."""
