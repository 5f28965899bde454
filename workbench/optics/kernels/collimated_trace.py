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
from workbench.optics.kernels.transmittance import transmittance, transmittance_slopes
from workbench.optics.transmittance import TransmittanceLaw

# Numbers of a batch beside those of all kinds.
_Q, _DEFLECTION, _FADE = (OWN + np.uintp(BATCH * k) for k in range(3))


class Optics(NamedTuple):
    """Numbers of a trace, in its float type.

    Attributes
    ----------
    ratio : floating
        Refractive index n.
    ratio2_minus_1 : floating
        n² − 1.
    drop : floating
        How far the screen is above the level that heights are counted from.
    critical : floating
        Squared cosines below this count as total reflection.
    arriving : floating
        Flux of a ray before the exit face.
    lift : floating
        That level, above the entrance face.
    absorption : floating
        Of the glass, per length.
    law : TransmittanceLaw
        How the exit face refracts.
    """

    ratio: np.floating[Any]
    ratio2_minus_1: np.floating[Any]
    drop: np.floating[Any]
    critical: np.floating[Any]
    arriving: np.floating[Any]
    lift: np.floating[Any]
    absorption: np.floating[Any]
    law: TransmittanceLaw


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _refract(light, spread, i, j, lanes, t):  # type: ignore[no-untyped-def]
    """Where rays hit, and their flux; says how many are refracted.

    Snell's law with d = (0, 0, 1) and N = (−z_x, −z_y, 1)/s, s² = 1 + k, k = z_x² + z_y², leaves
    one root: q = s cos θ_t = √(1 − (n² − 1) k); per unit of z the refracted ray moves sideways by
    (z_x, z_y) (n² − 1) / (1 + n q).
    """
    columns, rows, wide, high, optics = light
    wide = wide[j if len(wide) > 1 else 0][i:]
    place, row, arriving = columns[i:], rows[j], optics.arriving * high[j]
    kind = t.dtype.type
    one = kind(1)
    passed = kind(0)
    for lane in range(np.uintp(lanes)):
        z_x, z_y = t[Z_X + lane], t[Z_Y + lane]
        k = z_x * z_x + z_y * z_y
        square = one - optics.ratio2_minus_1 * k
        passes = square > optics.critical
        q = np.sqrt(square if passes else one)
        deflection = (optics.drop - t[Z + lane]) * optics.ratio2_minus_1 / (one + optics.ratio * q)
        cos_in = one / np.sqrt(one + k)
        transmitted = transmittance(optics.law, cos_in, q * cos_in)
        weight = wide[lane] * arriving * transmitted if passes else kind(0)
        t[_Q + lane] = q
        t[_DEFLECTION + lane] = deflection
        column = place[lane] + spread.per_x * z_x * deflection
        t[COLUMN + lane] = column if passes else kind(np.inf)
        t[ROW + lane] = row + spread.per_y * z_y * deflection if passes else kind(np.inf)
        t[WEIGHT + lane] = weight
        passed += wide[lane] if passes else kind(0)
    return np.float64(passed * high[j])


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _absorb(light, i, j, lanes, t):  # type: ignore[no-untyped-def]
    """Take from the flux of rays what the glass absorbs.

    Returns
    -------
    tuple of two float64
        Flux that is refracted then, as `_refract` says it, and flux that is absorbed.
    """
    wide, high, optics = light[2], light[3][j], light[4]
    wide = wide[j if len(wide) > 1 else 0][i:]
    kind = t.dtype.type
    passed, absorbed = kind(0), kind(0)
    for lane in range(np.uintp(lanes)):
        passes = t[COLUMN + lane] < kind(np.inf)
        left = np.exp(-optics.absorption * abs(t[Z + lane] + optics.lift))
        t[WEIGHT + lane] = t[WEIGHT + lane] * left if passes else kind(0)
        passed += wide[lane] * left if passes else kind(0)
        absorbed += wide[lane] * (kind(1) - left)
        t[_FADE + lane] = left
    return np.float64(passed * high), np.float64(absorbed * high)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _ahead(light, spread, i, j, lanes, t):  # type: ignore[no-untyped-def]
    """From the face to the screen; flux that is refracted, and that was absorbed before."""
    passed, absorbed = _refract(light, spread, i, j, lanes, t), 0.0
    if light[4].absorption > t.dtype.type(0):
        passed, absorbed = _absorb(light, i, j, lanes, t)
    return passed, absorbed


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _back(light, spread, i, j, lanes, t):  # type: ignore[no-untyped-def]
    """Adjoint of `_ahead`."""
    absorption, lift = light[4].absorption, light[4].lift
    if not absorption > t.dtype.type(0):
        _refract_back(light, spread, i, j, lanes, t)
        return
    for lane in range(np.uintp(lanes)):
        left = t[_FADE + lane]
        per_depth = absorption if t[Z + lane] + lift > t.dtype.type(0) else -absorption
        t[_FADE + lane] = per_depth * t[D_WEIGHT + lane] * t[WEIGHT + lane]
        t[D_WEIGHT + lane] *= left
    _refract_back(light, spread, i, j, lanes, t)
    for lane in range(np.uintp(lanes)):
        t[Z + lane] -= t[_FADE + lane]


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _refract_back(light, spread, i, j, lanes, t):  # type: ignore[no-untyped-def]
    """Adjoint of `_refract`; the cotangents of z, z_x, z_y take the place of these."""
    wide, arriving, optics = light[2], light[4].arriving * light[3][j], light[4]
    wide = wide[j if len(wide) > 1 else 0][i:]
    kind = t.dtype.type
    one, two, half = kind(1), kind(2), kind(0.5)
    for lane in range(np.uintp(lanes)):
        z_x, z_y = t[Z_X + lane], t[Z_Y + lane]
        q, deflection = t[_Q + lane], t[_DEFLECTION + lane]
        k = z_x * z_x + z_y * z_y
        passes = one - optics.ratio2_minus_1 * k > optics.critical
        d_x = t[D_COLUMN + lane] * spread.per_x
        d_y = t[D_ROW + lane] * spread.per_y
        share = one / (one + optics.ratio * q)
        d_deflection = d_x * z_x + d_y * z_y
        # weight = arriving T(s, q s), s = 1 / √(1 + k)
        s = one / np.sqrt(one + k)
        d_cos_in, d_cos_out = transmittance_slopes(optics.law, s, q * s)
        d_transmitted = wide[lane] * arriving * t[D_WEIGHT + lane]
        d_q = d_transmitted * d_cos_out * s - d_deflection * deflection * optics.ratio * share
        # q = √(1 − (n² − 1) k)
        d_s = d_transmitted * (d_cos_in + d_cos_out * q)
        d_k = -half * (d_s * s * s * s + d_q * optics.ratio2_minus_1 / q)
        d_z_x = d_x * deflection + two * z_x * d_k
        d_z_y = d_y * deflection + two * z_y * d_k
        d_z = -d_deflection * optics.ratio2_minus_1 * share
        t[Z + lane] = d_z if passes else kind(0)
        t[Z_X + lane] = d_z_x if passes else kind(0)
        t[Z_Y + lane] = d_z_y if passes else kind(0)


LOOPS = make_loops("collimated", _ahead, _back, own=3)
"""For light of rays with these columns and rows, the shares of a cell for which they stand along u,
as one row for all v or a row for each, and along v, and numbers of the trace."""
