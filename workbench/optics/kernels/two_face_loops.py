"""The loops over samples of a freeform entrance face, and at each batch of them over all origins.

What a batch sees of the entrance face is found once, whatever the number of origins; see
`workbench.optics.kernels.rows` for how.
"""

from typing import Any

import numpy as np

from workbench.compiled import jit
from workbench.optics.kernels.aperture import stop
from workbench.optics.kernels.front_light import from_far, from_near
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
from workbench.optics.kernels.origin_loops import OriginLoops
from workbench.optics.kernels.point_meet import MET, meet
from workbench.optics.kernels.point_patches import (
    DEPTH,
    ROWS,
    STATE,
    at,
    collect,
    evaluate_to_second_order,
    fill,
    make_columns,
    place,
)
from workbench.optics.kernels.point_trace import polish
from workbench.optics.kernels.rows import put, take
from workbench.optics.kernels.spread import BATCH
from workbench.optics.kernels.taps import FAST
from workbench.optics.kernels.two_face_trace import (
    D_ROOM,
    END,
    ROOM,
    SUM_Z,
    SUM_Z_X,
    SUM_Z_Y,
    enter,
    enter_back,
    leave,
    leave_back,
)

_NUMBERS = int(END)


def _make(name: str, shine: Any) -> OriginLoops:
    return OriginLoops(_make_land(f"{name}_land", shine), _make_back(f"{name}_back", shine))


def _make_land(name: str, shine: Any) -> Any:
    @jit(name=name, fastmath=FAST, error_model="numpy")
    def land(  # type: ignore[no-untyped-def]
        heights, bases, exit_face, light, body, landing, depths, begin, end, nodes, rooms, sums
    ):
        (across, up), (net, bounds, table) = bases, exit_face
        rows, t = make_rows(heights), np.empty(_NUMBERS, heights.dtype)
        w, columns = np.empty(ROWS * BATCH, heights.dtype), make_columns(table)
        patch, before = np.zeros(BATCH, np.int32), np.empty(BATCH, np.int32)
        count = len(up.first)
        blocks = (end - begin + BATCH - 1) // BATCH
        for block in range(blocks):
            i = begin + (end - begin) * block // blocks
            lanes = begin + (end - begin) * (block + 1) // blocks - i
            contract(heights, across, i, lanes, rows)
            x = across.place[i:]
            for j in range(count):
                blend(rows, up, j, lanes, t)
                for k in range(len(light.flux)):
                    shine(light, k, x, up.place[j], lanes, t)
                    stop(body.aperture, x, up.place[j], i, j, lanes, t)
                    enter(body, x, up.place[j], body.areas[j, i:], lanes, t, w, sums)
                    _begin(depths, i, k * count + j, lanes, w)
                    meet(net, bounds, table, w, lanes, patch, before, columns)
                    polish(net, w, lanes)
                    leave(net, body, landing, lanes, t, w, sums)
                    put(t, i, k * count + j, lanes, nodes)
                    _keep(t, w, i, k * count + j, lanes, rooms, depths)

    return land


def _make_back(name: str, shine: Any) -> Any:
    @jit(name=name, fastmath=FAST, error_model="numpy")
    def back(  # type: ignore[no-untyped-def]
        heights, bases, exit_face, light, body, landing, depths, begin, end, cotangents, gradients
    ):
        (across, up), (net, _, table), (gradient, d_table) = bases, exit_face, gradients
        cotangent, d_rooms = cotangents
        kind = heights.dtype.type
        rows, d_rows = make_rows(heights), make_rows(heights)
        # Where all light passes the aperture, its slopes by those of the face stay 0.
        t, sums = np.zeros(_NUMBERS, heights.dtype), np.zeros(8)
        w, columns = np.empty(ROWS * BATCH, heights.dtype), make_columns(table)
        patch = np.zeros(BATCH, np.int32)
        count = len(up.first)
        blocks = (end - begin + BATCH - 1) // BATCH
        for block in range(blocks):
            i = begin + (end - begin) * block // blocks
            lanes = begin + (end - begin) * (block + 1) // blocks - i
            contract(heights, across, i, lanes, rows)
            d_rows[:] = kind(0)
            x = across.place[i:]
            for j in range(count):
                blend(rows, up, j, lanes, t)
                t[SUM_Z:] = kind(0)
                for k in range(len(light.flux)):
                    areas = body.areas[j, i:]
                    shine(light, k, x, up.place[j], lanes, t)
                    stop(body.aperture, x, up.place[j], i, j, lanes, t)
                    enter(body, x, up.place[j], areas, lanes, t, w, sums)
                    _met(depths, i, k * count + j, lanes, w)
                    place(net, w, lanes, patch)
                    fill(table, patch, lanes, columns)
                    evaluate_to_second_order(columns, w, lanes)
                    take(cotangent, i, k * count + j, lanes, t)
                    _take_rooms(d_rooms, i, k * count + j, lanes, t)
                    leave_back(net, body, landing, lanes, t, w)
                    enter_back(body, areas, lanes, t)
                    collect(w, lanes, patch, columns, d_table)
                for lane in range(np.uintp(lanes)):
                    t[Z + lane] = t[SUM_Z + lane]
                    t[Z_X + lane] = t[SUM_Z_X + lane]
                    t[Z_Y + lane] = t[SUM_Z_Y + lane]
                blend_back(d_rows, up, j, lanes, t)
            contract_back(d_rows, across, i, lanes, gradient)

    return back


@jit(allocates=False, forceinline=True)
def _begin(depths, i, row, lanes, w):  # type: ignore[no-untyped-def]
    """Let the search of a batch begin where rays met the exit face of the last lens."""
    depth = depths[row, i:]
    for lane in range(lanes):
        w[at(DEPTH, lane)] = depth[lane]


@jit(allocates=False, forceinline=True)
def _keep(t, w, i, row, lanes, rooms, depths):  # type: ignore[no-untyped-def]
    """Keep the rooms of a batch, and the depths that were found: infinite for rays that miss."""
    kind = w.dtype.type
    room, depth = rooms[row, i:], depths[row, i:]
    for lane in range(lanes):
        room[lane] = t[ROOM + np.uintp(lane)]
        met = w[at(STATE, lane)] == kind(MET)
        depth[lane] = w[at(DEPTH, lane)] if met else kind(np.inf)


@jit(allocates=False, forceinline=True)
def _met(depths, i, row, lanes, w):  # type: ignore[no-untyped-def]
    """Take kept depths back."""
    kind = w.dtype.type
    depth = depths[row, i:]
    for lane in range(lanes):
        met = depth[lane] < kind(np.inf)
        w[at(DEPTH, lane)] = depth[lane] if met else kind(0)
        w[at(STATE, lane)] = kind(MET) if met else kind(MET - 1)


@jit(allocates=False, forceinline=True)
def _take_rooms(d_rooms, i, row, lanes, t):  # type: ignore[no-untyped-def]
    """Take the cotangents of rooms."""
    d_room = d_rooms[row, i:]
    for lane in range(np.uintp(lanes)):
        t[D_ROOM + lane] = d_room[lane]


FROM_FAR = _make("two_faces_far", from_far)
"""As `workbench.optics.kernels.origin_loops.OriginLoops`, for light from infinitely far.

They take (heights, bases, exit face, light, body, landing, depths, begin, end, nodes, rooms, sums)
and (…, cotangents, gradients): the heights are those of the entrance face, the exit face is a
control net with bounds and table of its patches, the depths of the last lens are where the search
begins and those found take their place, the rooms are as in `workbench.optics.light.Nodes`, and the
gradients are that of the heights and that of the table.
"""
FROM_NEAR = _make("two_faces_near", from_near)
"""The same for light of points."""
