"""From light in the glass to where it lands: the exit face for `workbench.optics.kernels.origins`.

Directions and Snell's law are those of `workbench.optics.kernels.snell`.
"""

import numpy as np

from workbench.compiled import jit
from workbench.optics.kernels.grid import Z_X, Z_Y
from workbench.optics.kernels.origin_glass import (
    ABSORBED,
    BRIGHT,
    D_BRIGHT,
    D_S_X,
    D_S_Y,
    NEXT,
    S_X,
    S_Y,
)
from workbench.optics.kernels.rows import D_WEIGHT, WEIGHT
from workbench.optics.kernels.snell import snell, snell_back
from workbench.optics.kernels.spread import BATCH
from workbench.optics.kernels.taps import FAST
from workbench.optics.kernels.transmittance import transmittance, transmittance_slopes

O_X, O_Y, O_Z, _Q, _GAMMA, D_O_X, D_O_Y, D_O_Z, D_P_Z, SUM_Z, SUM_Z_X, SUM_Z_Y, END = (
    NEXT + np.uintp(BATCH * k) for k in range(13)
)


@jit(fastmath=FAST, error_model="numpy", forceinline=True)
def refract(medium, lanes, t):  # type: ignore[no-untyped-def]
    """Directions behind the face, and flux.

    Returns
    -------
    tuple of four float64
        Flux that was absorbed on its way to the face, that met it, that was not totally reflected,
        and that went on.
    """
    kind = t.dtype.type
    zero, n = kind(0), medium.ratio
    absorbed, met_flux, passed_flux, on_flux = zero, zero, zero, zero
    for lane in range(np.uintp(lanes)):
        s_x, s_y, z_x, z_y = t[S_X + lane], t[S_Y + lane], t[Z_X + lane], t[Z_Y + lane]
        lean, q, gamma, by_both, passes = snell(
            n, medium.ratio2_minus_1, medium.critical, s_x, s_y, z_x, z_y
        )
        met = lean > zero
        flux = t[BRIGHT + lane] * lean if met else zero
        transmitted = transmittance(medium.law, abs(lean) * by_both, q * by_both)
        weight = flux * transmitted if passes else zero
        # Light that is totally reflected goes nowhere: it lands on no plane, however tilted.
        t[O_X + lane] = n * s_x - gamma * z_x if passes else zero
        t[O_Y + lane] = n * s_y - gamma * z_y if passes else zero
        t[O_Z + lane] = n + gamma if passes else zero
        t[_Q + lane] = q
        t[_GAMMA + lane] = gamma
        t[WEIGHT + lane] = weight
        absorbed += t[ABSORBED + lane] * lean if met else zero
        met_flux += flux
        passed_flux += flux if passes else zero
        on_flux += weight
    return np.float64(absorbed), np.float64(met_flux), np.float64(passed_flux), np.float64(on_flux)


@jit(fastmath=FAST, error_model="numpy", forceinline=True)
def refract_back(medium, lanes, t):  # type: ignore[no-untyped-def]
    """Adjoint of `refract`, and of what came before; adds to the cotangents of the face."""
    kind = t.dtype.type
    one, zero = kind(1), kind(0)
    n, ratio2_minus_1 = medium.ratio, medium.ratio2_minus_1
    for lane in range(np.uintp(lanes)):
        s_x, s_y, z_x, z_y = t[S_X + lane], t[S_Y + lane], t[Z_X + lane], t[Z_Y + lane]
        q, gamma, bright = t[_Q + lane], t[_GAMMA + lane], t[BRIGHT + lane]
        # Also where no flux is: the light of neighbours is spread up to this hit.
        passes = t[O_Z + lane] > zero
        lean = one - s_x * z_x - s_y * z_y
        length2, face2 = one + s_x * s_x + s_y * s_y, one + z_x * z_x + z_y * z_y
        by_both = one / np.sqrt(length2 * face2)
        cos_in, cos_out = lean * by_both, q * by_both
        transmitted = transmittance(medium.law, cos_in, cos_out)
        by_in, by_out = transmittance_slopes(medium.law, cos_in, cos_out)

        d_weight = t[D_WEIGHT + lane]
        d_flux = d_weight * transmitted
        d_transmitted = d_weight * bright * lean
        d_s_x, d_s_y, d_z_x, d_z_y = snell_back(
            n, ratio2_minus_1, s_x, s_y, z_x, z_y, (lean, q, gamma, by_both, passes),
            d_flux * bright, t[D_O_X + lane], t[D_O_Y + lane], t[D_O_Z + lane],
            d_transmitted * by_in, d_transmitted * by_out,
        )  # fmt: skip
        d_z = t[D_P_Z + lane] + d_s_x * t[D_S_X + lane] + d_s_y * t[D_S_Y + lane]
        d_z += d_flux * lean * t[D_BRIGHT + lane]
        t[SUM_Z + lane] += d_z if passes else zero
        t[SUM_Z_X + lane] += d_z_x if passes else zero
        t[SUM_Z_Y + lane] += d_z_y if passes else zero
