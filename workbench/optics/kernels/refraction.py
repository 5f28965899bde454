"""Refraction of one ray at one face, its transmittance, and the adjoints; for compiled loops.

Directions are scaled so that no unit vector is needed: light goes along (s_x, s_y, 1)/L,
L² = 1 + s², and the face's normal is (−z_x, −z_y, 1)/S. With η the refractive index before the face
over that behind it, and m = 1 − s·∇z, Snell's law then reads

    Q² = η² m² − (η² − 1) L² S²,  Γ = −(η² − 1) L² / (Q + η m),

and the light goes on along o = (η s − Γ ∇z, η + Γ), as long as L; the cosines at the face are
m / (L S) before it and Q / (L S) behind.
"""

from typing import Any

import numpy as np

from workbench.compiled import jit
from workbench.optics.kernels.taps import FAST


def fresnel(ratio: Any, cos_in: Any, cos_out: Any) -> Any:
    """Part of unpolarised light that a bare face refracts; of tensors, arrays or numbers.

    With η the ratio, 1 − r² of both polarisations is 4 η cos θ_i cos θ_t over a squared sum of
    positive numbers: nothing cancels, and its slope is finite up to grazing incidence.
    """
    across = ratio * cos_in + cos_out
    within = cos_in + ratio * cos_out
    both = across * within
    squares = across * across + within * within
    return (ratio + ratio) * cos_in * cos_out * squares / (both * both)


def schlick(one: Any, passing: Any, grazing: Any, cos: Any) -> Any:
    """Schlick's approximation of `fresnel`, with 1 in the type of the others."""
    off = one - cos
    fourth = off * off * (off * off)
    return passing * (one - grazing * fourth * off)


_inlined = jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
_fresnel, _schlick = _inlined(fresnel), _inlined(schlick)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def transmittance(law, cos_in, cos_out):  # type: ignore[no-untyped-def]
    """Part of the light that is refracted, as `TransmittanceLaw.at`, without branches.

    The law is in the kernel's float type. Cosines of light that is totally reflected are any
    positive stand-ins.
    """
    one = type(cos_in)(1)
    exact = _fresnel(law.ratio, cos_in, cos_out)
    cos = cos_in if law.ratio < one else cos_out
    return exact if law.exact else _schlick(one, law.passing, law.grazing, cos)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def transmittance_slopes(law, cos_in, cos_out):  # type: ignore[no-untyped-def]
    """Derivatives of `transmittance` by both cosines, each as if the other were fixed.

    Returns by ``cos_in`` and by ``cos_out``.
    """
    kind = type(cos_in)
    one, two, zero = kind(1), kind(2), kind(0)
    across = law.ratio * cos_in + cos_out
    within = cos_in + law.ratio * cos_out
    # Of cosines that grow together the transmittance stays the same: one factor for both slopes.
    shared = (cos_out - law.ratio * cos_in) * (within * within * within)
    shared += (law.ratio * cos_out - cos_in) * (across * across * across)
    both = across * within
    shared *= two * law.ratio / (both * both * both)
    off = one - (cos_in if law.ratio < one else cos_out)
    rise = kind(5) * law.passing * law.grazing * (off * off * (off * off))
    rise_in = rise if law.ratio < one else zero
    by_in = cos_out * shared if law.exact else rise_in
    by_out = -cos_in * shared if law.exact else rise - rise_in
    return by_in, by_out


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
