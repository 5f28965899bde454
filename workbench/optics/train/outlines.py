"""How much of what a sample stands for is inside a curved outline."""

import numpy as np

from workbench.compiled import jit
from workbench.optics.kernels.taps import FAST

# In the middle of the lens no distance to an outline has a direction.
_CENTRE = 1e-12


@jit(fastmath=FAST, error_model="numpy", forceinline=True)
def held(x, y, d_x, d_y, wide, high, outline):  # type: ignore[no-untyped-def]
    """About how much of a sample's part is inside a curved outline, and its derivative."""
    kind = type(x)
    zero, one, two, centre = kind(0), kind(1), kind(2), kind(_CENTRE)
    level = np.sqrt(max(x * x * outline.by_x2 + y * y * outline.by_y2, centre))
    d_level = (x * d_x * outline.by_x2 + y * d_y * outline.by_y2) / level
    wide, high = wide * outline.by_x2, high * outline.by_y2
    across = max(abs(x) * wide + abs(y) * high, centre)
    d_across = (d_x if x > zero else -d_x) * wide + (d_y if y > zero else -d_y) * high
    over = level * (one - level) / across
    rise = (d_level * (one - two * level) - over * d_across) / across
    held = kind(0.5) + over
    partly = (held > zero) & (held < one)
    return min(max(held, zero), one), rise if partly else zero
