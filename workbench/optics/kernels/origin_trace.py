"""From light in the glass to where it lands: the exit face for `workbench.optics.kernels.origins`.

Both directions are scaled so that no unit vector is needed: light goes along (s_x, s_y, 1)/L,
L² = 1 + s², and the face's normal is (−z_x, −z_y, 1)/S. With m = 1 − s·∇z Snell's law then reads

    Q² = n² m² − (n² − 1) L² S²,  Γ = −(n² − 1) L² / (Q + n m),

and the light goes on along o = (n s − Γ ∇z, n + Γ), as long as L; the cosines at the face are
m / (L S) before it and Q / (L S) behind.
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
    one, zero, n = kind(1), kind(0), medium.ratio
    absorbed, met_flux, passed_flux, on_flux = zero, zero, zero, zero
    for lane in range(np.uintp(lanes)):
        s_x, s_y, z_x, z_y = t[S_X + lane], t[S_Y + lane], t[Z_X + lane], t[Z_Y + lane]
        lean = one - s_x * z_x - s_y * z_y
        met = lean > zero
        flux = t[BRIGHT + lane] * lean if met else zero
        length2 = one + s_x * s_x + s_y * s_y
        both2 = length2 * (one + z_x * z_x + z_y * z_y)
        square = n * n * lean * lean - medium.excess * both2
        passes = met & (square > medium.critical * both2)
        q = np.sqrt(square if passes else both2)
        gamma = -medium.excess * length2 / (q + n * abs(lean))
        by_both = one / np.sqrt(both2)
        part = transmittance(medium.law, abs(lean) * by_both, q * by_both)
        weight = flux * part if passes else zero
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
    one, two, half, zero = kind(1), kind(2), kind(0.5), kind(0)
    n, excess = medium.ratio, medium.excess
    for lane in range(np.uintp(lanes)):
        s_x, s_y, z_x, z_y = t[S_X + lane], t[S_Y + lane], t[Z_X + lane], t[Z_Y + lane]
        q, gamma, bright = t[_Q + lane], t[_GAMMA + lane], t[BRIGHT + lane]
        lean = one - s_x * z_x - s_y * z_y
        length2, face2 = one + s_x * s_x + s_y * s_y, one + z_x * z_x + z_y * z_y
        both2 = length2 * face2
        by_both = one / np.sqrt(both2)
        cos_in, cos_out = lean * by_both, q * by_both
        part = transmittance(medium.law, cos_in, cos_out)
        by_in, by_out = transmittance_slopes(medium.law, cos_in, cos_out)

        d_weight = t[D_WEIGHT + lane]
        d_flux = d_weight * part
        d_part = d_weight * bright * lean
        d_cos_in, d_cos_out = d_part * by_in, d_part * by_out
        d_o_x, d_o_y, d_o_z = t[D_O_X + lane], t[D_O_Y + lane], t[D_O_Z + lane]
        d_gamma = d_o_z - d_o_x * z_x - d_o_y * z_y
        # Γ and Q, by L², S² and m.
        shared = d_gamma * gamma / (q + n * lean)
        d_q = d_cos_out * by_both - shared
        d_square = half * d_q / q
        d_length2 = -d_square * excess * face2 + d_gamma * gamma / length2
        d_face2 = -d_square * excess * length2
        d_both2 = -half * (d_cos_in * cos_in + d_cos_out * cos_out) / both2
        d_length2 += d_both2 * face2
        d_face2 += d_both2 * length2
        d_lean = two * d_square * n * n * lean - n * shared + d_cos_in * by_both + d_flux * bright
        # Slopes of the light and of the face.
        d_s_x = n * d_o_x - d_lean * z_x + two * s_x * d_length2
        d_s_y = n * d_o_y - d_lean * z_y + two * s_y * d_length2
        d_z = t[D_P_Z + lane] + d_s_x * t[D_S_X + lane] + d_s_y * t[D_S_Y + lane]
        d_z += d_flux * lean * t[D_BRIGHT + lane]
        # Also where no flux is: the light of neighbours is spread up to this hit.
        passes = t[O_Z + lane] > zero
        t[SUM_Z + lane] += d_z if passes else zero
        t[SUM_Z_X + lane] += two * z_x * d_face2 - gamma * d_o_x - d_lean * s_x if passes else zero
        t[SUM_Z_Y + lane] += two * z_y * d_face2 - gamma * d_o_y - d_lean * s_y if passes else zero
