"""What is wanted of light whose source blurs it: the target, and what has to fall beside it.

Light of a source of some size that makes a bright border also falls beyond it. Where that counted
as an error, borders would be left dark.
"""

from functools import lru_cache

import numpy as np

from workbench.arrays import Array
from workbench.extended.blur import Blur


def wanted_light(target: Array, blur: Blur, margin: tuple[int, int]) -> Array:
    """The light that is wanted on a receiver and around it.

    Parameters
    ----------
    target : ndarray, shape (n_y, n_x)
        The wanted image in any scale, as light in each pixel; not negative and not dark.
    blur : Blur
        What the source makes of light.
    margin : tuple[int, int]
        Pixels (m_x, m_y) around the receiver.

    Returns
    -------
    ndarray, shape (n_y + 2 m_y, n_x + 2 m_x)
        Sums to 1. On the receiver it is the target; beside it, what falls there of the light that,
        blurred, comes closest to the target.

    Examples
    --------
    Of a bright border, as much as half of the blur falls beyond:

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
    """All of the closest light, blurred; a second or so, and several images want it."""
    # Late: these take long to import, and light from points or from one direction wants none of it.
    from scipy.signal import fftconvolve

    from workbench.extended.deblur import spread_light

    light = spread_light(np.frombuffer(target).reshape(shape), blur)
    return np.asarray(fftconvolve(light, blur.spread()[0]).clip(min=0))
