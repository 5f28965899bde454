"""The loops over samples of the first face of a train, and at each batch of them over all origins.

A batch is up to ``BATCH`` samples with one v and neighbouring u. For a block of so many u the
control heights are contracted with the basis along x once, into rows that lie side by side; each v
then blends q + 1 of these rows. So loops run along u over neighbouring numbers, and vectorise. What
a batch sees of the first face is evaluated once, whatever the number of origins.

Of rays that were followed up to the first freeform face, a batch is up to ``BATCH`` of one row; all
freeform faces are then further elements.
"""

import numpy as np

from workbench.compiled import jit
from workbench.optics.kernels.grid import blend, blend_back, contract, contract_back, make_rows
from workbench.optics.kernels.patches import make_columns
from workbench.optics.kernels.spread import BATCH, gather, scatter, workspace
from workbench.optics.kernels.taps import FAST
from workbench.optics.train.elements import (
    RUNS,
    count_flux,
    count_slopes,
    cross,
    cross_back,
    transfer,
    transfer_back,
)
from workbench.optics.train.first_face import pass_first, pass_first_back
from workbench.optics.train.landing import receive, receive_back
from workbench.optics.train.light import begin_given, shine
from workbench.optics.train.meeting import face_back, search, search_again
from workbench.optics.train.numbers import LINES, element_of
from workbench.optics.train.registers import (
    BLOCK,
    COLUMN,
    D_COLUMN,
    D_RIM,
    D_ROW,
    D_WEIGHT,
    P_X,
    P_Y,
    P_Z,
    RIM,
    ROW,
    SUM_Z,
    SUM_Z_X,
    SUM_Z_Y,
    WEIGHT,
    Z_X,
    Z_Y,
    Z,
    make_registers,
)

# Sums of the first face: flux absorbed before it, that meets it, that is not totally reflected,
# that goes on. Then flux of the rays of an image: on the receiver, and beside it.
FIRST_SUMS = 4
ON_RECEIVER, BESIDE = 4, 5


@jit(name="train_land", fastmath=FAST, error_model="numpy")
def land(  # type: ignore[no-untyped-def]
    heights, bases, samples, light, train, landing, table, depths, spread, begin, end,
    nodes, rims, canvas, sums,
):  # fmt: skip
    """Trace samples to the receiver.

    `heights` (n_u, n_v): of the first face, above its level; as all of it, unused where rays are
    given; `bases`: basis functions at the samples along x and y; `samples`, `light`: see
    `workbench.optics.train.light.shine`; `train`: the faces; `table` (patches, p, q): patches of
    all further B-splines; `depths` (elements, rows, columns): where rays met the elements of the
    last train; changed. Rows are origins × samples along y, columns samples along x; or those of
    given rays; `spread`: the filter of an image; `begin`, `end`: which columns to trace; `nodes`
    (3, rows, columns): columns, rows and flux at the receiver, where no image is wanted; changed;
    `rims` (rows, columns): distances to the rims of the elements, if they are wanted; changed;
    `canvas`: see `workbench.optics.kernels.spread.make_canvases`; empty where no image is wanted.
    Changed; `sums` (elements + 1, SUMS): sums of the faces, see `FIRST_SUMS` and
    `workbench.optics.train.elements`; changed.
    """
    (across, up), (face, elements) = bases, train
    rows, count = make_rows(heights), len(elements.kind)
    t = make_registers(count, heights)
    columns, tables = make_columns(table), (table, elements.coefficients)
    patch, before = np.zeros(BATCH, np.int32), np.empty(BATCH, np.int32)
    lines, sampled, drawn = light.rows, light.kind != LINES, canvas.shape[0] > 0
    work = workspace(spread, heights)
    column, row_at, weight = _row(t, COLUMN), _row(t, ROW), _row(t, WEIGHT)
    blocks = (end - begin + BATCH - 1) // BATCH
    for part in range(blocks):
        i = begin + (end - begin) * part // blocks
        lanes = begin + (end - begin) * (part + 1) // blocks - i
        if sampled:
            contract(heights, across, i, lanes, rows)
        for j in range(lines):
            if sampled:
                blend(rows, up, j, lanes, t)
                _begin(samples[0].place[i:], samples[1].place[j], lanes, t)
            for k in range(light.origins):
                row = k * lines + j
                if sampled:
                    shine(light, k, samples, i, j, face, lanes, t)
                    found = pass_first(face, lanes, t)
                    for number in range(FIRST_SUMS):
                        sums[0, number] += found[number]
                else:
                    begin_given(light.given, row, i, lanes, t)
                for e in range(count):
                    element, pair = element_of(elements, e), t[np.uintp(e) * BLOCK :]
                    w, depth = pair[BLOCK:], depths[e, row, i:]
                    transfer(element, pair, lanes)
                    if sampled or e > 0:  # those of given rays are known
                        count_slopes(pair, lanes, sums[e + 1])
                    runs = search(element, tables, e, w, depth, lanes, patch, before, columns)
                    sums[e + 1, RUNS] += runs
                    cross(element, pair, lanes)
                    count_flux(pair, lanes, sums[e + 1])
                w = t[np.uintp(count) * BLOCK :]
                receive(landing, w, lanes, t)
                if drawn:
                    on, beside = scatter(spread, column, row_at, weight, lanes, work, canvas)
                    sums[0, ON_RECEIVER] += on
                    sums[0, BESIDE] += beside
                else:
                    _put(t, i, row, lanes, nodes)
                if len(rims):
                    _put_rims(w, i, row, lanes, rims)


@jit(name="train_back", fastmath=FAST, error_model="numpy")
def back(  # type: ignore[no-untyped-def]
    heights, bases, samples, light, train, landing, table, depths, spread, begin, end,
    d_nodes, d_rims, canvas, gradient, d_table, touched,
):  # fmt: skip
    """Adjoint of `land`.

    `heights`, `bases`, `samples`, `light`, `train`, `landing`, `table`, `spread`, `begin`, `end`:
    as there; `depths`: those that `land` found; `d_nodes`, `d_rims`: cotangents of nodes and rims;
    `canvas`: cotangent of the image, see `workbench.optics.kernels.spread.pad`; empty where none is
    wanted; `gradient` (n_u, n_v): of the heights; changed; `d_table` (patches, p, q): of the
    patches; changed; `touched` (elements, 2): the first and the last patch of each element that was
    changed; changed.
    """
    (across, up), (face, elements) = bases, train
    rows, d_rows, count = make_rows(heights), make_rows(heights), len(elements.kind)
    t = make_registers(count, heights)
    columns, tables = make_columns(table), (table, elements.coefficients)
    patches = np.zeros((count, BATCH), np.int32)
    lines, sampled, drawn = light.rows, light.kind != LINES, canvas.shape[0] > 0
    work = workspace(spread, heights)
    column, row_at, weight = _row(t, COLUMN), _row(t, ROW), _row(t, WEIGHT)
    d_column, d_row, d_weight = _row(t, D_COLUMN), _row(t, D_ROW), _row(t, D_WEIGHT)
    blocks = (end - begin + BATCH - 1) // BATCH
    for part in range(blocks):
        i = begin + (end - begin) * part // blocks
        lanes = begin + (end - begin) * (part + 1) // blocks - i
        if sampled:
            contract(heights, across, i, lanes, rows)
            d_rows[:] = heights.dtype.type(0)
        for j in range(lines):
            if sampled:
                blend(rows, up, j, lanes, t)
                _begin(samples[0].place[i:], samples[1].place[j], lanes, t)
                _clear_sums(lanes, t)
            for k in range(light.origins):
                row = k * lines + j
                if sampled:
                    shine(light, k, samples, i, j, face, lanes, t)
                    pass_first(face, lanes, t)
                else:
                    begin_given(light.given, row, i, lanes, t)
                for e in range(count):
                    element, pair = element_of(elements, e), t[np.uintp(e) * BLOCK :]
                    transfer(element, pair, lanes)
                    depth, w = depths[e, row, i:], pair[BLOCK:]
                    search_again(element, tables, e, w, depth, lanes, patches[e], columns)
                    cross(element, pair, lanes)
                w = t[np.uintp(count) * BLOCK :]
                if drawn:
                    receive(landing, w, lanes, t)
                    gather(
                        spread, column, row_at, weight, lanes, work, canvas,
                        d_column, d_row, d_weight,
                    )  # fmt: skip
                else:
                    _take(d_nodes, i, row, lanes, t)
                receive_back(landing, w, lanes, t)
                if len(d_rims):
                    _take_rims(d_rims, i, row, lanes, w)
                for e in range(count - 1, -1, -1):
                    element, pair = element_of(elements, e), t[np.uintp(e) * BLOCK :]
                    cross_back(element, pair, lanes)
                    patch, w = patches[e], pair[BLOCK:]
                    face_back(element, w, lanes, patch, columns, d_table, touched[e])
                    transfer_back(element, pair, lanes)
                if sampled:
                    pass_first_back(face, lanes, t)
            if sampled:
                _take_sums(lanes, t)
                blend_back(d_rows, up, j, lanes, t)
        if sampled:
            contract_back(d_rows, across, i, lanes, gradient)


@jit()
def _row(t, row):  # type: ignore[no-untyped-def]
    return t[row : row + np.uintp(BATCH)]


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _begin(x, y, lanes, t):  # type: ignore[no-untyped-def]
    """Positions of rays on the first face: those of the samples."""
    for lane in range(np.uintp(lanes)):
        t[P_X + lane] = x[lane]
        t[P_Y + lane] = y
        t[P_Z + lane] = t[Z + lane]


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _clear_sums(lanes, t):  # type: ignore[no-untyped-def]
    zero = t.dtype.type(0)
    for lane in range(np.uintp(lanes)):
        t[SUM_Z + lane] = zero
        t[SUM_Z_X + lane] = zero
        t[SUM_Z_Y + lane] = zero


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _take_sums(lanes, t):  # type: ignore[no-untyped-def]
    """Cotangents of height and slopes where these were."""
    for lane in range(np.uintp(lanes)):
        t[Z + lane] = t[SUM_Z + lane]
        t[Z_X + lane] = t[SUM_Z_X + lane]
        t[Z_Y + lane] = t[SUM_Z_Y + lane]


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _put(t, i, row, lanes, nodes):  # type: ignore[no-untyped-def]
    columns, rows, flux = nodes[0, row, i:], nodes[1, row, i:], nodes[2, row, i:]
    for lane in range(np.uintp(lanes)):
        columns[lane] = t[COLUMN + lane]
        rows[lane] = t[ROW + lane]
        flux[lane] = t[WEIGHT + lane]


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _take(d_nodes, i, row, lanes, t):  # type: ignore[no-untyped-def]
    columns, rows, flux = d_nodes[0, row, i:], d_nodes[1, row, i:], d_nodes[2, row, i:]
    for lane in range(np.uintp(lanes)):
        t[D_COLUMN + lane] = columns[lane]
        t[D_ROW + lane] = rows[lane]
        t[D_WEIGHT + lane] = flux[lane]


@jit(allocates=False, forceinline=True)
def _put_rims(w, i, row, lanes, rims):  # type: ignore[no-untyped-def]
    rim = rims[row, i:]
    for lane in range(np.uintp(lanes)):
        rim[lane] = w[RIM + lane]


@jit(allocates=False, forceinline=True)
def _take_rims(d_rims, i, row, lanes, w):  # type: ignore[no-untyped-def]
    d_rim = d_rims[row, i:]
    for lane in range(np.uintp(lanes)):
        w[D_RIM + lane] = d_rim[lane]
