"""The loops over samples of the exit face, and at each batch of them over all origins of the light.

What a batch sees of the face is found once, whatever the number of origins; see
`workbench.optics.kernels.rows` for how.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from workbench.compiled import jit
from workbench.optics.kernels.grid import (
    Z_X,
    Z_Y,
    Z,
    blend,
    blend_back,
    contract,
    contract_back,
    make_rows,
)
from workbench.optics.kernels.origin_glass import from_point, from_sky
from workbench.optics.kernels.origin_receive import receive, receive_back
from workbench.optics.kernels.origin_trace import (
    END,
    SUM_Z,
    SUM_Z_X,
    SUM_Z_Y,
    refract,
    refract_back,
)
from workbench.optics.kernels.rows import put, take
from workbench.optics.kernels.spread import BATCH
from workbench.optics.kernels.taps import FAST

_NUMBERS = int(END)


class OriginLoops(NamedTuple):
    """Kernels for one kind of origins.

    Attributes
    ----------
    land : callable
        Takes (heights, bases, lines, origins, medium, landing, begin, end, nodes, sums), with the
        outline behind the two lines: traces the samples from number ``begin`` to ``end`` along u,
        and all along v. Columns, rows and flux are put into the nodes, shape (3, origins × samples
        along v, samples along u); what `workbench.optics.kernels.origin_trace.refract` gives is
        added to the sums.
    back : callable
        Its adjoint, with the cotangent of the nodes in their place, and the gradient with respect
        to the heights (n_u, n_v), float64, in that of the sums.
    """

    land: Callable[..., None]
    back: Callable[..., None]


def _make(name: str, enter: Any) -> OriginLoops:
    @jit(name=f"{name}_land", fastmath=FAST, error_model="numpy")
    def land(  # type: ignore[no-untyped-def]
        heights, bases, lines, origins, medium, landing, begin, end, nodes, sums
    ):
        across, up, outline = lines
        rows = make_rows(heights)
        t = np.empty(_NUMBERS, heights.dtype)
        count = len(bases[1].first)
        blocks = (end - begin + BATCH - 1) // BATCH
        for block in range(blocks):
            i = begin + (end - begin) * block // blocks
            lanes = begin + (end - begin) * (block + 1) // blocks - i
            contract(heights, bases[0], i, lanes, rows)
            for j in range(count):
                blend(rows, bases[1], j, lanes, t)
                for k in range(len(origins.flux)):
                    enter(origins, k, across, i, up, j, outline, medium, lanes, t)
                    found = refract(medium, lanes, t)
                    receive(landing, across, i, up, j, lanes, t)
                    put(t, i, k * count + j, lanes, nodes)
                    for number in range(4):
                        sums[number] += found[number]

    @jit(name=f"{name}_back", fastmath=FAST, error_model="numpy")
    def back(  # type: ignore[no-untyped-def]
        heights, bases, lines, origins, medium, landing, begin, end, cotangent, gradient
    ):
        across, up, outline = lines
        rows, d_rows = make_rows(heights), make_rows(heights)
        t = np.empty(_NUMBERS, heights.dtype)
        count = len(bases[1].first)
        blocks = (end - begin + BATCH - 1) // BATCH
        for block in range(blocks):
            i = begin + (end - begin) * block // blocks
            lanes = begin + (end - begin) * (block + 1) // blocks - i
            contract(heights, bases[0], i, lanes, rows)
            d_rows[:] = heights.dtype.type(0)
            for j in range(count):
                blend(rows, bases[1], j, lanes, t)
                t[SUM_Z:] = heights.dtype.type(0)
                for k in range(len(origins.flux)):
                    enter(origins, k, across, i, up, j, outline, medium, lanes, t)
                    refract(medium, lanes, t)
                    take(cotangent, i, k * count + j, lanes, t)
                    receive_back(landing, across, i, up, j, lanes, t)
                    refract_back(medium, lanes, t)
                for lane in range(np.uintp(lanes)):
                    t[Z + lane] = t[SUM_Z + lane]
                    t[Z_X + lane] = t[SUM_Z_X + lane]
                    t[Z_Y + lane] = t[SUM_Z_Y + lane]
                blend_back(d_rows, bases[1], j, lanes, t)
            contract_back(d_rows, bases[0], i, lanes, gradient)

    return OriginLoops(land, back)


FROM_SKY = _make("sky", from_sky)
FROM_POINTS = _make("points", from_point)
