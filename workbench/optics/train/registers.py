"""The registers of a batch of rays: rows of one flat array, a block for each face of the train.

Row k of a block begins at k BATCH. Distances between rows that the compiler knows let it vectorise
loops over rays without checks. Block 0 belongs to the first face, where rays begin; block e to the
e-th further element, whose first rows are those of `workbench.optics.kernels.patches`. Rays
that leave a face are in the same rows of every block.
"""

import numpy as np

from workbench.compiled import jit
from workbench.optics.kernels.spread import BATCH
from workbench.optics.kernels.taps import FAST

# The first face: height and slopes (as in `workbench.optics.kernels.grid`).
Z, Z_X, Z_Y = (np.uintp(BATCH * k) for k in range(3))
# Where rays arrive at the receiver in pixels, their flux, and the cotangents.
COLUMN, ROW, WEIGHT, D_COLUMN, D_ROW, D_WEIGHT = (np.uintp(BATCH * k) for k in range(3, 9))
# Incident light: slopes, flux of a level sample, flux absorbed before the face, and derivatives
# of slopes and flux by the height of the face.
S_X, S_Y, BRIGHT, ABSORBED, D_S_X, D_S_Y, D_BRIGHT = (np.uintp(BATCH * k) for k in range(9, 16))
# 1 over the distance to a point along z; width of the light in the aperture over that at the
# sample; derivatives of the flux by the slopes of the face.
BY_WAY, NARROWED, BY_Z_X, BY_Z_Y = (np.uintp(BATCH * k) for k in range(16, 20))
# Q and Γ of `workbench.optics.kernels.refraction`.
Q, GAMMA = (np.uintp(BATCH * k) for k in range(20, 22))
# Sums over origins of the cotangents of height and slopes.
SUM_Z, SUM_Z_X, SUM_Z_Y = (np.uintp(BATCH * k) for k in range(22, 25))

# An element: transmittance of the medium before it, cotangents of the line in the element's frame,
# of its slopes, of where it begins and of its flux. Then where it begins along z of that frame.
FADE, D_X, D_Y, D_A, D_B, D_START, D_FLUX = (np.uintp(BATCH * k) for k in range(26, 33))
START = np.uintp(BATCH * 33)
# Flux of rays that meet a face: what the medium before it absorbs, what is left there, of that what
# is not totally reflected, and what goes on. On the way back other numbers take their place.
ABSORBS, MEETS, PASSES, GOES = D_X, D_Y, D_A, D_B
# Rays behind a face: position, direction of any length, flux (below 0: no ray), and distance
# within the rims of the elements so far; then the cotangents.
P_X, P_Y, P_Z, O_X, O_Y, O_Z, FLUX, RIM = (np.uintp(BATCH * k) for k in range(34, 42))
D_P_X, D_P_Y, D_P_Z, D_O_X, D_O_Y, D_O_Z, D_OUT, D_RIM = (
    np.uintp(BATCH * k) for k in range(42, 50)
)
BLOCK = np.uintp(BATCH * 50)
"""Length of a block."""


@jit()
def make_registers(elements, like):  # type: ignore[no-untyped-def]
    """Registers of a batch for so many further elements: 0, but for the rims before the first."""
    t = np.zeros((elements + 1) * int(BLOCK), like.dtype)
    for lane in range(np.uintp(BATCH)):
        t[RIM + lane] = like.dtype.type(np.inf)
    return t


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def total(t, row, lanes):  # type: ignore[no-untyped-def]
    """Sum of a row. A loop that chooses what it adds does not vectorise, one of a row does."""
    found = t.dtype.type(0)
    for lane in range(np.uintp(lanes)):
        found += t[row + lane]
    return np.float64(found)
