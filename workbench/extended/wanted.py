"""Target of blurred light, including the light that must fall beside the receiver.

Light of an extended source that makes a bright border also falls beyond it. If that counted as an
error, borders would be left dark.
"""

from functools import lru_cache

import numpy as np

from workbench.arrays import Array
from workbench.extended.blur import Blur


def wanted_light(target: Array, blur: Blur, margin: tuple[int, int]) -> Array:
    """Return the light wanted on a receiver and around it, (n_y + 2 m_y, n_x + 2 m_x), sum 1.

    On the receiver it is the target (n_y, n_x); beside it, the light there of the light that,
    blurred, is closest to the target.

    Examples
    --------
    Half of the blur of a bright border falls beyond it:

    >>> import numpy as np
    >>> bool(wanted_light(np.ones((40, 40)), Blur((5.0, 5.0)), (2, 2))[0].sum() > 0)
    True
    >>> wanted_light(np.ones((40, 40)), Blur((0.0, 0.0)), (2, 2))[:2].sum().item()
    0.0
    """
    share = target / target.sum()
    m_x, m_y = margin
    if blur.within_a_pixel:
        return np.pad(share, ((m_y, m_y), (m_x, m_x)))
    n_y, n_x = target.shape
    wide = _blurred(target.tobytes(), (n_y, n_x), blur).copy()
    off_y, off_x = ((w - n) // 2 for w, n in zip(wide.shape, target.shape, strict=True))
    receiver = slice(off_y, off_y + n_y), slice(off_x, off_x + n_x)
    wide[receiver] = share * wide[receiver].sum()
    wide = np.pad(wide, ((m_y, m_y), (m_x, m_x)))
    cut = wide[off_y : off_y + n_y + 2 * m_y, off_x : off_x + n_x + 2 * m_x]
    return np.asarray(cut / cut.sum())


@lru_cache(maxsize=4)
def _blurred(target: bytes, shape: tuple[int, int], blur: Blur) -> Array:
    # Slow imports, not needed for point sources and collimated light.
    from scipy.signal import fftconvolve

    from workbench.extended.deblur import spread_light

    light = spread_light(np.frombuffer(target).reshape(shape), blur)
    return np.asarray(fftconvolve(light, blur.spread()[0]).clip(min=0))
