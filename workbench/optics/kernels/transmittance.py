"""Twins of `workbench.optics.transmittance.TransmittanceLaw.at` for compiled kernels.

A law holds for all lanes of a loop, so its branches are selections that vectorise.
"""

from workbench.compiled import jit
from workbench.optics.kernels.taps import FAST


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def transmittance(law, cos_in, cos_out):  # type: ignore[no-untyped-def]
    """Part of the light that is refracted.

    `law`: in the kernel's float type; see `TransmittanceLaw.cast`; `cos_in`, `cos_out`: cosines of
    the angles of incidence and refraction, in the same type; of light that is totally reflected any
    positive stand-ins.
    """
    kind = type(cos_in)
    one = kind(1)
    across = law.ratio * cos_in + cos_out
    within = cos_in + law.ratio * cos_out
    both = across * within
    squares = across * across + within * within
    exact = kind(2) * law.ratio * cos_in * cos_out * squares / (both * both)
    off = one - (cos_in if law.ratio < one else cos_out)
    fourth = off * off * (off * off)
    return exact if law.exact else law.passing * (one - law.grazing * fourth * off)


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
