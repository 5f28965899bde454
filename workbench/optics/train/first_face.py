"""The first face of a compiled train: what it does to the light at samples of it, and the adjoint.

Directions and Snell's law are those of `workbench.optics.kernels.refraction`. The flux of a sample
is that of a level one times m = 1 − s·∇z, as the face leans to the light or away from it.
"""

import numpy as np

from workbench.compiled import jit
from workbench.optics.kernels.refraction import (
    snell,
    snell_back,
    transmittance,
    transmittance_slopes,
)
from workbench.optics.kernels.taps import FAST
from workbench.optics.train.registers import (
    ABSORBED,
    ABSORBS,
    BRIGHT,
    BY_Z_X,
    BY_Z_Y,
    D_BRIGHT,
    D_O_X,
    D_O_Y,
    D_O_Z,
    D_OUT,
    D_P_Z,
    D_S_X,
    D_S_Y,
    FLUX,
    GAMMA,
    GOES,
    MEETS,
    O_X,
    O_Y,
    O_Z,
    PASSES,
    S_X,
    S_Y,
    SUM_Z,
    SUM_Z_X,
    SUM_Z_Y,
    Z_X,
    Z_Y,
    Q,
    total,
)

# Flux of a ray that does not exist. One without flux may exist: where it arrives bounds the light
# of its neighbours.
NO_RAY = -1.0
# What the first face does: it refracts, light along the axis too, or it reflects.
REFRACTS, REFRACTS_STRAIGHT, REFLECTS = range(3)


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def pass_first(face, lanes, t):  # type: ignore[no-untyped-def]
    """Rays behind the first face.

    `lanes`: how many samples there are; `t`: registers of the first face, with the light and the
    positions of samples. Returns flux absorbed before the face, that meets it, that is not totally
    reflected, and that goes on.
    """
    if face.kind == REFRACTS_STRAIGHT:
        return _refract_straight(face, lanes, t)
    if face.kind == REFRACTS:
        return _refract(face, lanes, t)
    return _reflect(face, lanes, t)


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def pass_first_back(face, lanes, t):  # type: ignore[no-untyped-def]
    """Adjoint of `pass_first` and of the light before it; adds to the sums of cotangents."""
    if face.kind == REFRACTS_STRAIGHT:
        _refract_straight_back(face, lanes, t)
    elif face.kind == REFRACTS:
        _refract_back(face, lanes, t)
    else:
        _reflect_back(face, lanes, t)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _refract_straight(face, lanes, t):  # type: ignore[no-untyped-def]
    """As `_refract`, of light along the axis.

    Snell's law with s = 0 leaves one root: q = √(1 − (n² − 1) k), k = z_x² + z_y²; per unit of z
    the refracted ray moves sideways by (z_x, z_y) (n² − 1) / (1 + n q).
    """
    kind = t.dtype.type
    zero, one = kind(0), kind(1)
    absorbed, met, passed, on = zero, zero, zero, zero
    for lane in range(np.uintp(lanes)):
        z_x, z_y, bright = t[Z_X + lane], t[Z_Y + lane], t[BRIGHT + lane]
        k = z_x * z_x + z_y * z_y
        square = one - face.ratio2_minus_1 * k
        passes = square > face.critical
        q = np.sqrt(square if passes else one)
        aside = face.ratio2_minus_1 / (one + face.law.ratio * q)
        cos_in = one / np.sqrt(one + k)
        flux = bright * transmittance(face.law, cos_in, q * cos_in)
        t[Q + lane] = q
        t[O_X + lane] = z_x * aside
        t[O_Y + lane] = z_y * aside
        t[O_Z + lane] = one if passes else zero
        t[FLUX + lane] = flux if passes else kind(NO_RAY)
        met += bright
        passed += bright if passes else zero
        on += flux if passes else zero
    if face.absorption > zero:
        for lane in range(np.uintp(lanes)):
            absorbed += t[ABSORBED + lane]
    return np.float64(absorbed), np.float64(met), np.float64(passed), np.float64(on)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _refract_straight_back(face, lanes, t):  # type: ignore[no-untyped-def]
    kind = t.dtype.type
    zero, one, two, half = kind(0), kind(1), kind(2), kind(0.5)
    n, ratio2_minus_1 = face.law.ratio, face.ratio2_minus_1
    for lane in range(np.uintp(lanes)):
        z_x, z_y, q = t[Z_X + lane], t[Z_Y + lane], t[Q + lane]
        passes = t[O_Z + lane] > zero
        share = one / (one + n * q)
        aside = ratio2_minus_1 * share
        d_o_x, d_o_y, d_flux = t[D_O_X + lane], t[D_O_Y + lane], t[D_OUT + lane]
        d_aside = d_o_x * z_x + d_o_y * z_y
        cos_in = one / np.sqrt(one + z_x * z_x + z_y * z_y)
        transmitted = transmittance(face.law, cos_in, q * cos_in)
        by_in, by_out = transmittance_slopes(face.law, cos_in, q * cos_in)
        d_transmitted = d_flux * t[BRIGHT + lane]
        d_q = d_transmitted * by_out * cos_in - d_aside * aside * n * share
        d_cos_in = d_transmitted * (by_in + by_out * q)
        d_k = -half * (d_cos_in * cos_in * cos_in * cos_in + d_q * ratio2_minus_1 / q)
        d_z = t[D_P_Z + lane] + d_flux * transmitted * t[D_BRIGHT + lane]
        t[SUM_Z + lane] += d_z if passes else zero
        t[SUM_Z_X + lane] += d_o_x * aside + two * z_x * d_k if passes else zero
        t[SUM_Z_Y + lane] += d_o_y * aside + two * z_y * d_k if passes else zero


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _refract(face, lanes, t):  # type: ignore[no-untyped-def]
    kind = t.dtype.type
    zero, n = kind(0), face.law.ratio
    for lane in range(np.uintp(lanes)):
        s_x, s_y, z_x, z_y = t[S_X + lane], t[S_Y + lane], t[Z_X + lane], t[Z_Y + lane]
        lean, q, gamma, by_both, passes = snell(
            n, face.ratio2_minus_1, face.critical, s_x, s_y, z_x, z_y
        )
        met = lean > zero
        flux = t[BRIGHT + lane] * lean if met else zero
        transmitted = transmittance(face.law, abs(lean) * by_both, q * by_both)
        weight = flux * transmitted
        # Light that is totally reflected goes nowhere: it arrives at no plane, however tilted.
        t[O_X + lane] = n * s_x - gamma * z_x if passes else zero
        t[O_Y + lane] = n * s_y - gamma * z_y if passes else zero
        t[O_Z + lane] = n + gamma if passes else zero
        t[Q + lane] = q
        t[GAMMA + lane] = gamma
        t[FLUX + lane] = weight if passes else kind(NO_RAY)
        t[ABSORBS + lane] = t[ABSORBED + lane] * lean if met else zero
        t[MEETS + lane] = flux
        t[PASSES + lane] = flux if passes else zero
        t[GOES + lane] = weight if passes else zero
    absorbed, met_flux = total(t, ABSORBS, lanes), total(t, MEETS, lanes)
    return absorbed, met_flux, total(t, PASSES, lanes), total(t, GOES, lanes)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _refract_back(face, lanes, t):  # type: ignore[no-untyped-def]
    kind = t.dtype.type
    one, zero = kind(1), kind(0)
    n, ratio2_minus_1 = face.law.ratio, face.ratio2_minus_1
    for lane in range(np.uintp(lanes)):
        s_x, s_y, z_x, z_y = t[S_X + lane], t[S_Y + lane], t[Z_X + lane], t[Z_Y + lane]
        q, gamma, bright = t[Q + lane], t[GAMMA + lane], t[BRIGHT + lane]
        passes = t[FLUX + lane] >= zero
        lean = one - s_x * z_x - s_y * z_y
        length2, face2 = one + s_x * s_x + s_y * s_y, one + z_x * z_x + z_y * z_y
        by_both = one / np.sqrt(length2 * face2)
        cos_in, cos_out = lean * by_both, q * by_both
        transmitted = transmittance(face.law, abs(cos_in), cos_out)
        by_in, by_out = transmittance_slopes(face.law, abs(cos_in), cos_out)
        d_weight = t[D_OUT + lane]
        d_flux = d_weight * transmitted
        d_transmitted = d_weight * bright * lean
        d_s_x, d_s_y, d_z_x, d_z_y = snell_back(
            n, ratio2_minus_1, s_x, s_y, z_x, z_y, (lean, q, gamma, by_both, passes),
            d_flux * bright, t[D_O_X + lane], t[D_O_Y + lane], t[D_O_Z + lane],
            d_transmitted * by_in, d_transmitted * by_out,
        )  # fmt: skip
        d_flux *= lean
        d_z = t[D_P_Z + lane] + d_s_x * t[D_S_X + lane] + d_s_y * t[D_S_Y + lane]
        d_z += d_flux * t[D_BRIGHT + lane]
        d_z_x += d_flux * t[BY_Z_X + lane]
        d_z_y += d_flux * t[BY_Z_Y + lane]
        t[SUM_Z + lane] += d_z if passes else zero
        t[SUM_Z_X + lane] += d_z_x if passes else zero
        t[SUM_Z_Y + lane] += d_z_y if passes else zero


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _reflect(face, lanes, t):  # type: ignore[no-untyped-def]
    """The law of reflection: d − 2 (d·N / N²) N with d = (s, 1) and N = (−∇z, 1), times N²."""
    kind = t.dtype.type
    zero, one, two = kind(0), kind(1), kind(2)
    absorbed, met_flux, on = zero, zero, zero
    for lane in range(np.uintp(lanes)):
        s_x, s_y, z_x, z_y = t[S_X + lane], t[S_Y + lane], t[Z_X + lane], t[Z_Y + lane]
        lean, face2 = one - s_x * z_x - s_y * z_y, one + z_x * z_x + z_y * z_y
        met = lean > zero
        flux = t[BRIGHT + lane] * lean if met else zero
        t[O_X + lane] = s_x * face2 + two * lean * z_x if met else zero
        t[O_Y + lane] = s_y * face2 + two * lean * z_y if met else zero
        t[O_Z + lane] = face2 - two * lean if met else zero
        t[FLUX + lane] = face.reflectance * flux if met else kind(NO_RAY)
        met_flux += flux
        on += face.reflectance * flux
    return np.float64(absorbed), np.float64(met_flux), np.float64(met_flux), np.float64(on)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _reflect_back(face, lanes, t):  # type: ignore[no-untyped-def]
    kind = t.dtype.type
    zero, one, two = kind(0), kind(1), kind(2)
    for lane in range(np.uintp(lanes)):
        s_x, s_y, z_x, z_y = t[S_X + lane], t[S_Y + lane], t[Z_X + lane], t[Z_Y + lane]
        lean, face2 = one - s_x * z_x - s_y * z_y, one + z_x * z_x + z_y * z_y
        met = t[FLUX + lane] >= zero
        d_o_x, d_o_y, d_o_z = t[D_O_X + lane], t[D_O_Y + lane], t[D_O_Z + lane]
        d_flux, bright = face.reflectance * t[D_OUT + lane], t[BRIGHT + lane]
        d_face2 = d_o_x * s_x + d_o_y * s_y + d_o_z
        d_lean = two * (d_o_x * z_x + d_o_y * z_y - d_o_z) + d_flux * bright
        d_flux *= lean
        d_s_x, d_s_y = d_o_x * face2 - d_lean * z_x, d_o_y * face2 - d_lean * z_y
        d_z_x = two * (lean * d_o_x + z_x * d_face2) - d_lean * s_x + d_flux * t[BY_Z_X + lane]
        d_z_y = two * (lean * d_o_y + z_y * d_face2) - d_lean * s_y + d_flux * t[BY_Z_Y + lane]
        d_z = t[D_P_Z + lane] + d_s_x * t[D_S_X + lane] + d_s_y * t[D_S_Y + lane]
        d_z += d_flux * t[D_BRIGHT + lane]
        t[SUM_Z + lane] += d_z if met else zero
        t[SUM_Z_X + lane] += d_z_x if met else zero
        t[SUM_Z_Y + lane] += d_z_y if met else zero
