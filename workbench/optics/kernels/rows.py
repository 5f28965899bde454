"""The loops over a tensor grid of rays, whatever the light does between face and screen.

A batch is up to ``BATCH`` rays with one v and neighbouring u. For a block of so many u the control
heights are contracted with the basis along x once, into rows that lie side by side; each v then
blends q + 1 of these rows. So all loops run along u over neighbouring numbers, and vectorise.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from workbench.compiled import jit
from workbench.optics.kernels.grid import blend, blend_back, contract, contract_back, make_rows
from workbench.optics.kernels.spread import BATCH, gather, scatter, workspace
from workbench.optics.kernels.taps import FAST

# The numbers of a batch, after height and slopes of the face, whose cotangents take their place;
# those of the kind of light come behind.
COLUMN, ROW, WEIGHT, D_COLUMN, D_ROW, D_WEIGHT, OWN = (np.uintp(BATCH * k) for k in range(3, 10))


class Loops(NamedTuple):
    """Kernels for one kind of light.

    Attributes
    ----------
    trace : callable
        Takes (heights, bases, light, spread, begin, end, canvas, sums): traces the rays from
        number ``begin`` to ``end`` along u, and all along v, and adds their light to the canvas
        and to the sums: what is on the screen, what is beside it, and what ``ahead`` gives.
    trace_back : callable
        Its adjoint, with the cotangent of the canvas in its place, and the gradient with respect
        to the heights (n_u, n_v), float64, in that of the sums.
    land : callable
        As ``trace``, but no image is made: columns, rows and flux of the rays are put in place of
        the canvas, an array of shape (3, rays along v, rays along u). The first of the sums is
        all flux, the second is 0.
    land_back : callable
        Its adjoint.
    """

    trace: Callable[..., None]
    trace_back: Callable[..., None]
    land: Callable[..., None]
    land_back: Callable[..., None]


def make_loops(name: str, ahead: Any, back: Any, own: int) -> Loops:
    """Loops for a kind of light.

    Parameters
    ----------
    name : str
        Tells its kernels from those of other kinds.
    ahead : compiled function
        Takes (light, spread, i, j, lanes, t) and goes from height and slopes of a batch, whose
        first ray is (i, j), to its columns, rows and weights on the screen. ``light`` is a tuple
        of what the kind needs to know. Gives a tuple of sums of flux.
    back : compiled function
        Its adjoint.
    own : int
        How many numbers of a batch it wants for itself, from ``OWN`` on.
    """
    numbers = int(OWN) + own * BATCH

    def ahead_to(take: Any, called: str) -> Any:
        @jit(name=f"{name}_{called}", fastmath=FAST, error_model="numpy")
        def loop(heights, bases, light, spread, begin, end, taken, sums):  # type: ignore[no-untyped-def]
            (across, up), rows = bases, make_rows(heights)
            t = np.empty(numbers, heights.dtype)
            work = workspace(spread, heights)
            blocks = (end - begin + BATCH - 1) // BATCH
            for block in range(blocks):
                i = begin + (end - begin) * block // blocks
                lanes = begin + (end - begin) * (block + 1) // blocks - i
                contract(heights, across, i, lanes, rows)
                for j in range(len(up.first)):
                    blend(rows, up, j, lanes, t)
                    found = ahead(light, spread, i, j, lanes, t)
                    on_screen, beside = take(spread, t, i, j, lanes, work, taken)
                    sums[0] += on_screen
                    sums[1] += beside
                    for k in range(len(found)):
                        sums[2 + k] += found[k]

        return loop

    def back_from(give: Any, called: str) -> Any:
        @jit(name=f"{name}_{called}", fastmath=FAST, error_model="numpy")
        def loop(heights, bases, light, spread, begin, end, cotangent, gradient):  # type: ignore[no-untyped-def]
            kind = heights.dtype.type
            (across, up), rows = bases, make_rows(heights)
            d_rows = make_rows(heights)
            t = np.empty(numbers, heights.dtype)
            work = workspace(spread, heights)
            blocks = (end - begin + BATCH - 1) // BATCH
            for block in range(blocks):
                i = begin + (end - begin) * block // blocks
                lanes = begin + (end - begin) * (block + 1) // blocks - i
                contract(heights, across, i, lanes, rows)
                d_rows[:] = kind(0)
                for j in range(len(up.first)):
                    blend(rows, up, j, lanes, t)
                    ahead(light, spread, i, j, lanes, t)
                    give(spread, t, i, j, lanes, work, cotangent)
                    back(light, spread, i, j, lanes, t)
                    blend_back(d_rows, up, j, lanes, t)
                contract_back(d_rows, across, i, lanes, gradient)

        return loop

    return Loops(
        ahead_to(_to_image, "trace"),
        back_from(_from_image, "trace_back"),
        ahead_to(_to_nodes, "land"),
        back_from(_from_nodes, "land_back"),
    )


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _to_image(spread, t, i, j, lanes, work, canvas):  # type: ignore[no-untyped-def]
    """Add a batch to a canvas."""
    column, row, weight = t[COLUMN:ROW], t[ROW:WEIGHT], t[WEIGHT:D_COLUMN]
    return scatter(spread, column, row, weight, lanes, work, canvas)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _from_image(spread, t, i, j, lanes, work, cotangent):  # type: ignore[no-untyped-def]
    """Adjoint of `_to_image`."""
    column, row, weight = t[COLUMN:ROW], t[ROW:WEIGHT], t[WEIGHT:D_COLUMN]
    d_column, d_row, d_weight = t[D_COLUMN:D_ROW], t[D_ROW:D_WEIGHT], t[D_WEIGHT:OWN]
    gather(spread, column, row, weight, lanes, work, cotangent, d_column, d_row, d_weight)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _to_nodes(spread, t, i, j, lanes, work, nodes):  # type: ignore[no-untyped-def]
    """Put a batch among the nodes; its flux, and none beside."""
    return put(t, i, j, lanes, nodes), 0.0


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _from_nodes(spread, t, i, j, lanes, work, cotangent):  # type: ignore[no-untyped-def]
    """Adjoint of `_to_nodes`."""
    take(cotangent, i, j, lanes, t)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def put(t, i, row, lanes, nodes):  # type: ignore[no-untyped-def]
    """Put columns, rows and flux of a batch into the nodes, from number ``i`` of a row on.

    Returns
    -------
    float64
        All its flux.
    """
    columns, rows, flux = nodes[0, row, i:], nodes[1, row, i:], nodes[2, row, i:]
    total = 0.0
    for lane in range(np.uintp(lanes)):
        columns[lane] = t[COLUMN + lane]
        rows[lane] = t[ROW + lane]
        flux[lane] = t[WEIGHT + lane]
        total += t[WEIGHT + lane]
    return total


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def take(cotangent, i, row, lanes, t):  # type: ignore[no-untyped-def]
    """Take the cotangents of these, the adjoint of `put`."""
    columns, rows, flux = cotangent[0, row, i:], cotangent[1, row, i:], cotangent[2, row, i:]
    for lane in range(np.uintp(lanes)):
        t[D_COLUMN + lane] = columns[lane]
        t[D_ROW + lane] = rows[lane]
        t[D_WEIGHT + lane] = flux[lane]
