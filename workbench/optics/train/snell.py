"""Refraction of one ray at one face for compiled kernels, and its adjoint.

Directions are scaled so that no unit vector is needed: light goes along (s_x, s_y, 1)/L,
L² = 1 + s², and the face's normal is (−z_x, −z_y, 1)/S. With η the refractive index before the face
over that behind it, and m = 1 − s·∇z, Snell's law then reads

    Q² = η² m² − (η² − 1) L² S²,  Γ = −(η² − 1) L² / (Q + η m),

and the light goes on along o = (η s − Γ ∇z, η + Γ), as long as L; the cosines at the face are
m / (L S) before it and Q / (L S) behind.
"""

import numpy as np

from workbench.compiled import jit
from workbench.optics.kernels.taps import FAST


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def snell(ratio, ratio2_minus_1, critical, s_x, s_y, z_x, z_y):  # type: ignore[no-untyped-def]
    """Snell's law.

    `ratio`, `ratio2_minus_1`: η, and η² − 1; `critical`: squared cosines up to here count as total
    reflection; `s_x`, `s_y`: slopes of the ray before the face; `z_x`, `z_y`: slopes of the face.
    Returns m, Q, Γ, 1 / (L S), and whether the ray meets the face from before and passes it; of
    others Q is L S.
    """
    one = type(s_x)(1)
    lean = one - s_x * z_x - s_y * z_y
    length2 = one + s_x * s_x + s_y * s_y
    both2 = length2 * (one + z_x * z_x + z_y * z_y)
    square = ratio * ratio * lean * lean - ratio2_minus_1 * both2
    passes = (lean > type(s_x)(0)) & (square > critical * both2)
    q = np.sqrt(square if passes else both2)
    gamma = -ratio2_minus_1 * length2 / (q + ratio * abs(lean))
    return lean, q, gamma, one / np.sqrt(both2), passes


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def snell_back(  # type: ignore[no-untyped-def]
    ratio, ratio2_minus_1, s_x, s_y, z_x, z_y, refracted, d_lean, d_o_x, d_o_y, d_o_z,
    d_cos_in, d_cos_out,
):  # fmt: skip
    """Adjoint of `snell`, for a ray that passes.

    `ratio`, `ratio2_minus_1`, `s_x`, `s_y`, `z_x`, `z_y`: as there; `refracted`: what it gave;
    `d_lean`, `d_o_x`, `d_o_y`, `d_o_z`, `d_cos_in`, `d_cos_out`: cotangents of m, of the direction
    o and of the cosines. Returns cotangents of the slopes of the ray, and of those of the face.
    """
    one, two, half = type(s_x)(1), type(s_x)(2), type(s_x)(0.5)
    lean, q, gamma, by_both, _ = refracted
    length2, face2 = one + s_x * s_x + s_y * s_y, one + z_x * z_x + z_y * z_y
    d_gamma = d_o_z - d_o_x * z_x - d_o_y * z_y
    shared = d_gamma * gamma / (q + ratio * lean)
    d_square = half * (d_cos_out * by_both - shared) / q
    d_both2 = -half * (d_cos_in * lean + d_cos_out * q) * by_both * by_both * by_both
    d_both2 -= d_square * ratio2_minus_1
    d_length2 = d_both2 * face2 + d_gamma * gamma / length2
    d_face2 = d_both2 * length2
    d_lean += two * d_square * ratio * ratio * lean - ratio * shared + d_cos_in * by_both
    return (
        ratio * d_o_x - d_lean * z_x + two * s_x * d_length2,
        ratio * d_o_y - d_lean * z_y + two * s_y * d_length2,
        two * z_x * d_face2 - gamma * d_o_x - d_lean * s_x,
        two * z_y * d_face2 - gamma * d_o_y - d_lean * s_y,
    )
