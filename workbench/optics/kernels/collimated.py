"""Collimated light in one pass from control heights to the image: `optics.collimated`'s twin.

A batch is up to ``BATCH`` rays with one v and neighbouring u. For a block of so many u the control
heights are contracted with the basis along x once, into rows that lie side by side; each v then
blends q + 1 of these rows. So all loops run along u over neighbouring numbers, and vectorise.

Nothing is kept for the way back: it traces the same batch again, which costs less than memory.
"""

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt
import torch
from numba import njit
from torch import Tensor

from workbench.geometry.surface import ControlNet
from workbench.optics.kernels import threads
from workbench.optics.kernels.function import Sums, kind_of, trace
from workbench.optics.kernels.grid import (
    Z_X,
    Z_Y,
    Z,
    blend,
    blend_back,
    contract,
    contract_back,
    make_axis,
    make_rows,
)
from workbench.optics.kernels.locked import Mask, Rays, count, split
from workbench.optics.kernels.spread import (
    BATCH,
    Spread,
    add_up,
    gather,
    make_canvases,
    make_spread,
    pad,
    scatter,
    workspace,
)
from workbench.optics.kernels.taps import FAST
from workbench.optics.light import Light, sum_of
from workbench.optics.refraction import normal_reflectance
from workbench.scene import Filter, GaussianFilter, Scene, Screen

AnyArray = npt.NDArray[np.floating[Any]]


class Optics(NamedTuple):
    """Numbers of a trace, in its float type.

    Attributes
    ----------
    ratio : floating
        Refractive index n.
    excess : floating
        n² − 1.
    drop : floating
        How far the screen is above the level that heights are counted from.
    critical : floating
        Squared cosines below this count as total reflection.
    arriving : floating
        Flux of a ray before the exit face.
    head_on : floating
        Flux of a ray that leaves at a right angle.
    """

    ratio: np.floating[Any]
    excess: np.floating[Any]
    drop: np.floating[Any]
    critical: np.floating[Any]
    arriving: np.floating[Any]
    head_on: np.floating[Any]


class FusedCollimatedRays:
    """A tensor grid of rays; the same rays as `workbench.optics.collimated.CollimatedRays`.

    Parameters
    ----------
    scene : Scene
        The scene; the source is collimated.
    net : ControlNet
        Where the control heights sit.
    samples : tuple[int, int]
        Numbers of rays along x and y.
    mirrored : tuple[bool, bool]
        Whether heights, lens and locks are mirror images of themselves in x, in y: then the rays
        of one half are traced alone, if their number is even.
    locked : ndarray of bool, shape (n_u, n_v), optional
        Control points whose heights are the same in all lenses to come; rays that see none of the
        others are traced for the first lens alone.
    dtype : torch.dtype
        Float type of the trace.
    """

    emitted = 1.0
    missed_lens = 0.0

    def __init__(
        self,
        scene: Scene,
        net: ControlNet,
        samples: tuple[int, int],
        mirrored: tuple[bool, bool] = (False, False),
        dtype: torch.dtype = torch.float32,
        locked: Mask | None = None,
    ) -> None:
        self._dtype = dtype
        kind = self._kind = kind_of(dtype)
        self.mirrored = tuple(
            wanted and along % 2 == 0 for wanted, along in zip(mirrored, samples, strict=True)
        )
        across, up = (
            make_axis(net, axis, along, halved, kind)
            for axis, (along, halved) in enumerate(zip(samples, self.mirrored, strict=True))
        )
        self._moving, self._still = split((across, up), locked)
        self._still_light: tuple[Screen, Filter, Light] | None = None
        self.traced = count(self._moving) / count((across, up))
        self._level = scene.lens.base.height
        n = scene.lens.index
        self.fresnel_entrance = normal_reflectance(n) * self.emitted
        arriving = (self.emitted - self.fresnel_entrance) / (samples[0] * samples[1])
        self._optics = Optics(
            kind(n),
            kind(n * n - 1),
            kind(scene.screen.z - self._level),
            kind(16 * np.finfo(kind).eps),
            kind(arriving),
            kind(arriving * (1 - normal_reflectance(n))),
        )

    def image(self, heights: Tensor, screen: Screen, filter: Filter) -> Light:
        """Trace a lens; see `workbench.optics.light.Tracer`."""
        spread = make_spread(screen, filter, self._kind)
        light = trace(heights, self._level, self._dtype, _Passes(self, self._moving, spread))
        if not self._still:
            return light
        if self._still_light is None or self._still_light[:2] != (screen, filter):
            with torch.no_grad():
                parts = [
                    trace(heights, self._level, self._dtype, _Passes(self, rays, spread))
                    for rays in self._still
                ]
            self._still_light = screen, filter, sum_of(parts)
        return sum_of([light, self._still_light[2]])


def compile_for(dtype: torch.dtype) -> None:
    """Compile the kernels for a float type by tracing a few rays."""
    kind = kind_of(dtype)
    net = ControlNet((2, 2), (1, 1), (1.0, 1.0))
    across, up = (make_axis(net, axis, 2, False, kind) for axis in (0, 1))
    across, up = (axis._replace(place=axis.place.astype(kind)) for axis in (across, up))
    numbers = Optics(*(kind(1.5) for _ in Optics._fields))
    screen = Screen(z=1.0, half_width=(1.0, 1.0), pixels=(2, 2))
    spread = make_spread(screen, GaussianFilter(), kind)
    canvas = make_canvases(spread, 1)[0]
    heights, gradient = np.zeros(net.shape, kind), np.zeros(net.shape)
    trace_rows(heights, across, up, numbers, spread, 0, 2, canvas, np.zeros(3))
    trace_rows_back(
        heights, across, up, numbers, spread, 0, 2, pad(spread, np.zeros((2, 2), kind)), gradient
    )


class _Passes:
    """The trace of one set of rays onto one screen, and its adjoint."""

    def __init__(self, source: FusedCollimatedRays, rays: Rays, spread: Spread) -> None:
        across, up = rays
        columns = spread.column_0 + spread.per_x * across.place
        rows = spread.row_0 + spread.per_y * up.place
        self._across = across._replace(place=columns.astype(spread.per_x.dtype))
        self._up = up._replace(place=rows.astype(spread.per_x.dtype))
        self._optics, self._spread = source._optics, spread
        self._mirrored = source.mirrored
        self._rays = count(rays)
        self._parts = min(threads.parts(self._rays), max(1, len(across.place)))
        self._bounds = threads.bounds(len(across.place), self._parts)

    def forward(self, heights: AnyArray) -> tuple[AnyArray, Sums]:
        """See `workbench.optics.kernels.function.Passes`."""
        canvases = make_canvases(self._spread, self._parts)
        sums = np.zeros((self._parts, 3))

        def work(part: int) -> None:
            trace_rows(
                heights,
                self._across,
                self._up,
                self._optics,
                self._spread,
                self._bounds[part],
                self._bounds[part + 1],
                canvases[part],
                sums[part],
            )

        threads.run(work, self._parts)
        image, around = add_up(self._spread, canvases)
        copies = 1
        for axis, mirrored in enumerate(self._mirrored):
            if mirrored:
                image = image + np.flip(image, 1 - axis)
                copies *= 2
        beside, passed, light = sums.sum(axis=0)
        arriving = float(self._optics.arriving)
        return np.ascontiguousarray(image), Sums(
            off_screen=copies * (beside + around),
            total_reflection=copies * (self._rays - passed) * arriving,
            fresnel_exit=copies * (passed * arriving - light),
        )

    def backward(self, heights: AnyArray, cotangent: AnyArray) -> AnyArray:
        """See `workbench.optics.kernels.function.Passes`."""
        for axis, mirrored in enumerate(self._mirrored):
            if mirrored:
                cotangent = cotangent + np.flip(cotangent, 1 - axis)
        canvas = pad(self._spread, cotangent)
        gradients = np.zeros((self._parts, *heights.shape))

        def work(part: int) -> None:
            trace_rows_back(
                heights,
                self._across,
                self._up,
                self._optics,
                self._spread,
                self._bounds[part],
                self._bounds[part + 1],
                canvas,
                gradients[part],
            )

        threads.run(work, self._parts)
        gradient: AnyArray = gradients.sum(axis=0)
        for axis, mirrored in enumerate(self._mirrored):
            if mirrored:  # the other half of the rays would have given the mirror image of this
                gradient = (gradient + np.flip(gradient, axis)) / 2
        return gradient


# The numbers of a batch, after height and slopes.
_Q, _BEND, _COLUMN, _ROW, _WEIGHT, _D_COLUMN, _D_ROW, _D_WEIGHT = (
    np.uintp(BATCH * k) for k in range(3, 11)
)
_NUMBERS = 11 * BATCH
_STEP = np.uintp(BATCH)


@njit(cache=True, nogil=True, fastmath=FAST, error_model="numpy")
def trace_rows(  # type: ignore[no-untyped-def]
    heights, across, up, optics, spread, begin, end, canvas, sums
):
    """Trace the rays from number ``begin`` to ``end`` along u, and all along v.

    Parameters
    ----------
    heights : array, shape (n_u, n_v)
        Control heights above the level.
    across, up : Axis
        Rays along x and y; ``place`` in columns and rows.
    optics : Optics
        Numbers of the trace.
    spread : Spread
        Screen and filter.
    begin, end : int
        Which rays.
    canvas : array, shape (rows, columns)
        Where their light goes; changed.
    sums : array of float64, shape (3,)
        Results: light beside the canvas, number of refracted rays, light of these.
    """
    rows = make_rows(heights)
    t = np.empty(_NUMBERS, heights.dtype)
    work = workspace(spread, heights)
    column = t[_COLUMN : _COLUMN + _STEP]
    row = t[_ROW : _ROW + _STEP]
    weight = t[_WEIGHT : _WEIGHT + _STEP]
    blocks = (end - begin + BATCH - 1) // BATCH
    for block in range(blocks):
        i = begin + (end - begin) * block // blocks
        lanes = begin + (end - begin) * (block + 1) // blocks - i
        place = across.place[i : i + lanes]
        contract(heights, across, i, lanes, rows)
        for j in range(len(up.place)):
            blend(rows, up, j, lanes, t)
            passed, light = _refract(place, up.place[j], optics, spread, lanes, t)
            sums[1] += passed
            sums[2] += light
            sums[0] += scatter(spread, column, row, weight, lanes, work, canvas)


@njit(cache=True, nogil=True, fastmath=FAST, error_model="numpy")
def trace_rows_back(  # type: ignore[no-untyped-def]
    heights, across, up, optics, spread, begin, end, cotangent, gradient
):
    """Adjoint of `trace_rows`.

    Parameters
    ----------
    heights, across, up, optics, spread, begin, end
        As for `trace_rows`.
    cotangent : array, shape (rows, columns)
        Cotangent of the canvas.
    gradient : array of float64, shape (n_u, n_v)
        Cotangent of the heights; added to.
    """
    kind = heights.dtype.type
    rows = make_rows(heights)
    d_rows = make_rows(heights)
    t = np.empty(_NUMBERS, heights.dtype)
    work = workspace(spread, heights)
    column = t[_COLUMN : _COLUMN + _STEP]
    row = t[_ROW : _ROW + _STEP]
    weight = t[_WEIGHT : _WEIGHT + _STEP]
    d_column = t[_D_COLUMN : _D_COLUMN + _STEP]
    d_row = t[_D_ROW : _D_ROW + _STEP]
    d_weight = t[_D_WEIGHT : _D_WEIGHT + _STEP]
    blocks = (end - begin + BATCH - 1) // BATCH
    for block in range(blocks):
        i = begin + (end - begin) * block // blocks
        lanes = begin + (end - begin) * (block + 1) // blocks - i
        place = across.place[i : i + lanes]
        contract(heights, across, i, lanes, rows)
        d_rows[:] = kind(0)
        for j in range(len(up.place)):
            blend(rows, up, j, lanes, t)
            _refract(place, up.place[j], optics, spread, lanes, t)
            gather(
                spread,
                column,
                row,
                weight,
                lanes,
                work,
                cotangent,
                d_column,
                d_row,
                d_weight,
            )
            _refract_back(optics, spread, lanes, t)
            blend_back(d_rows, up, j, lanes, t)
        contract_back(d_rows, across, i, lanes, gradient)


@njit(cache=True, nogil=True, fastmath=FAST, error_model="numpy", forceinline=True)
def _refract(place, row, optics, spread, lanes, t):  # type: ignore[no-untyped-def]
    """Where rays hit, and their flux; how many are refracted, and the flux of all together.

    The formulas are those of `optics.collimated`.
    """
    kind = t.dtype.type
    one = kind(1)
    passed, light = kind(0), kind(0)
    for lane in range(np.uintp(lanes)):
        z_x, z_y = t[Z_X + lane], t[Z_Y + lane]
        k = z_x * z_x + z_y * z_y
        square = one - optics.excess * k
        passes = square > optics.critical
        q = np.sqrt(square if passes else one)
        bend = (optics.drop - t[Z + lane]) * optics.excess / (one + optics.ratio * q)
        grazing = one - q / np.sqrt(one + k)
        fourth = grazing * grazing * (grazing * grazing)
        weight = optics.head_on * (one - fourth * grazing) if passes else kind(0)
        t[_Q + lane] = q
        t[_BEND + lane] = bend
        t[_COLUMN + lane] = place[lane] + spread.per_x * z_x * bend
        t[_ROW + lane] = row + spread.per_y * z_y * bend
        t[_WEIGHT + lane] = weight
        passed += one if passes else kind(0)
        light += weight
    return np.float64(passed), np.float64(light)


@njit(cache=True, nogil=True, fastmath=FAST, error_model="numpy", forceinline=True)
def _refract_back(optics, spread, lanes, t):  # type: ignore[no-untyped-def]
    """Adjoint of `_refract`; the cotangents of z, z_x, z_y take the place of these."""
    kind = t.dtype.type
    one, two, half = kind(1), kind(2), kind(0.5)
    for lane in range(np.uintp(lanes)):
        z_x, z_y = t[Z_X + lane], t[Z_Y + lane]
        q, bend = t[_Q + lane], t[_BEND + lane]
        passes = t[_WEIGHT + lane] > kind(0)
        d_x = t[_D_COLUMN + lane] * spread.per_x
        d_y = t[_D_ROW + lane] * spread.per_y
        share = one / (one + optics.ratio * q)
        d_bend = d_x * z_x + d_y * z_y
        # weight = head_on (1 − g⁵), g = 1 − q s, s = 1 / √(1 + k)
        s = one / np.sqrt(one + z_x * z_x + z_y * z_y)
        grazing = one - q * s
        fourth = grazing * grazing * (grazing * grazing)
        d_cos = kind(5) * fourth * optics.head_on * t[_D_WEIGHT + lane]
        d_q = d_cos * s - d_bend * bend * optics.ratio * share
        # q = √(1 − (n² − 1) k)
        d_k = -half * (d_cos * q * s * s * s + d_q * optics.excess / q)
        d_z_x = d_x * bend + two * z_x * d_k
        d_z_y = d_y * bend + two * z_y * d_k
        d_z = -d_bend * optics.excess * share
        t[Z + lane] = d_z if passes else kind(0)
        t[Z_X + lane] = d_z_x if passes else kind(0)
        t[Z_Y + lane] = d_z_y if passes else kind(0)
