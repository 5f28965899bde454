"""What `workbench.optics.kernels.collimated` runs: its light from the face to the screen."""

from typing import Any, NamedTuple

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

# Numbers of a batch beside those of all kinds.
_Q, _BEND = (OWN + np.uintp(BATCH * k) for k in range(2))


class Optics(NamedTuple):
    """Numbers of a trace, in its float type.

    Attributes
    ----------
    ratio : floating
        Refractive index n.
    excess : floating
        n² − 1.
    drop : floating
        How far the screen is above the level that heights are counted from.
    critical : floating
        Squared cosines below this count as total reflection.
    arriving : floating
        Flux of a ray before the exit face.
    head_on : floating
        Flux of a ray that leaves at a right angle.
    """

    ratio: np.floating[Any]
    excess: np.floating[Any]
    drop: np.floating[Any]
    critical: np.floating[Any]
    arriving: np.floating[Any]
    head_on: np.floating[Any]


@jit(fastmath=FAST, error_model="numpy", forceinline=True)
def _refract(light, spread, i, j, lanes, t):  # type: ignore[no-untyped-def]
    """Where rays hit, and their flux; says how many are refracted.

    Snell's law with d = (0, 0, 1) and N = (−z_x, −z_y, 1)/s, s² = 1 + k, k = z_x² + z_y², leaves
    one root: q = s cos θ_t = √(1 − (n² − 1) k); per unit of z the refracted ray moves sideways by
    (z_x, z_y) (n² − 1) / (1 + n q).
    """
    columns, rows, wide, high, optics = light
    wide = wide[j if len(wide) > 1 else 0][i:]
    place, row, head_on = columns[i:], rows[j], optics.head_on * high[j]
    kind = t.dtype.type
    one = kind(1)
    passed = kind(0)
    for lane in range(np.uintp(lanes)):
        z_x, z_y = t[Z_X + lane], t[Z_Y + lane]
        k = z_x * z_x + z_y * z_y
        square = one - optics.excess * k
        passes = square > optics.critical
        q = np.sqrt(square if passes else one)
        bend = (optics.drop - t[Z + lane]) * optics.excess / (one + optics.ratio * q)
        grazing = one - q / np.sqrt(one + k)
        fourth = grazing * grazing * (grazing * grazing)
        weight = wide[lane] * head_on * (one - fourth * grazing) if passes else kind(0)
        t[_Q + lane] = q
        t[_BEND + lane] = bend
        column = place[lane] + spread.per_x * z_x * bend
        t[COLUMN + lane] = column if passes else kind(np.inf)
        t[ROW + lane] = row + spread.per_y * z_y * bend
        t[WEIGHT + lane] = weight
        passed += wide[lane] if passes else kind(0)
    return (np.float64(passed * high[j]),)


@jit(fastmath=FAST, error_model="numpy", forceinline=True)
def _refract_back(light, spread, i, j, lanes, t):  # type: ignore[no-untyped-def]
    """Adjoint of `_refract`; the cotangents of z, z_x, z_y take the place of these."""
    wide, head_on, optics = light[2], light[4].head_on * light[3][j], light[4]
    wide = wide[j if len(wide) > 1 else 0][i:]
    kind = t.dtype.type
    one, two, half = kind(1), kind(2), kind(0.5)
    for lane in range(np.uintp(lanes)):
        z_x, z_y = t[Z_X + lane], t[Z_Y + lane]
        q, bend = t[_Q + lane], t[_BEND + lane]
        k = z_x * z_x + z_y * z_y
        passes = one - optics.excess * k > optics.critical
        d_x = t[D_COLUMN + lane] * spread.per_x
        d_y = t[D_ROW + lane] * spread.per_y
        share = one / (one + optics.ratio * q)
        d_bend = d_x * z_x + d_y * z_y
        # weight = head_on (1 − g⁵), g = 1 − q s, s = 1 / √(1 + k)
        s = one / np.sqrt(one + k)
        grazing = one - q * s
        fourth = grazing * grazing * (grazing * grazing)
        d_cos = kind(5) * fourth * wide[lane] * head_on * t[D_WEIGHT + lane]
        d_q = d_cos * s - d_bend * bend * optics.ratio * share
        # q = √(1 − (n² − 1) k)
        d_k = -half * (d_cos * q * s * s * s + d_q * optics.excess / q)
        d_z_x = d_x * bend + two * z_x * d_k
        d_z_y = d_y * bend + two * z_y * d_k
        d_z = -d_bend * optics.excess * share
        t[Z + lane] = d_z if passes else kind(0)
        t[Z_X + lane] = d_z_x if passes else kind(0)
        t[Z_Y + lane] = d_z_y if passes else kind(0)


LOOPS = make_loops("collimated", _refract, _refract_back, own=2)
"""For light of rays with these columns and rows, the shares of a cell for which they stand along u,
as one row for all v or a row for each, and along v, and numbers of the trace."""
