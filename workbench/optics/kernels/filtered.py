"""Images of rays by a reconstruction filter, which spreads the flux of each over some pixels."""

from typing import Any

import numpy as np
import torch
from torch import Tensor
from torch.autograd.function import once_differentiable

from workbench.compiled import jit
from workbench.optics.kernels import threads
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
from workbench.optics.kernels.tensors import as_array, kind_of
from workbench.scene import Filter


def filtered(hits: Tensor, pixels: tuple[int, int], filter: Filter) -> tuple[Tensor, float, float]:
    """Image of rays.

    Parameters
    ----------
    hits : Tensor, shape (3, n, m)
        Columns, rows and flux of the rays, on the CPU; columns and rows of those that do not arrive
        are not finite.
    pixels : tuple[int, int]
        (n_x, n_y).
    filter : BoxFilter or GaussianFilter
        How the flux of a ray is spread.

    Returns
    -------
    tuple of Tensor, shape (n_y, n_x), and two floats
        Flux in each pixel, differentiable; and that of rays on the receiver, and beside it.
    """
    spread = make_spread(pixels, filter, kind_of(hits.dtype))
    sums: list[float] = []
    image = _Filtered.apply(spread, sums, hits.flatten(1))  # type: ignore[no-untyped-call]
    return image, sums[0], sums[1]


class _Filtered(torch.autograd.Function):
    @staticmethod
    def forward(ctx: Any, spread: Spread, sums: list[float], hits: Tensor) -> Tensor:
        ctx.spread = spread
        ctx.save_for_backward(hits)
        rays = as_array(hits)
        bounds = threads.bounds(rays.shape[1], threads.parts(rays.shape[1]))
        parts = len(bounds) - 1
        canvases, landed = make_canvases(spread, parts), np.zeros((parts, 2))
        threads.run(
            lambda k: _scatter(spread, rays, bounds[k], bounds[k + 1], canvases[k], landed[k]),
            parts,
        )
        sums.extend(landed.sum(axis=0).tolist())
        return torch.from_numpy(np.ascontiguousarray(add_up(spread, canvases)))

    @staticmethod
    @once_differentiable
    def backward(ctx: Any, cotangent: Tensor) -> tuple[None, None, Tensor]:
        (hits,) = ctx.saved_tensors
        rays = as_array(hits)
        canvas, found = pad(ctx.spread, as_array(cotangent)), np.empty_like(rays)
        bounds = threads.bounds(rays.shape[1], threads.parts(rays.shape[1]))
        threads.run(
            lambda k: _gather(ctx.spread, rays, bounds[k], bounds[k + 1], canvas, found),
            len(bounds) - 1,
        )
        return None, None, torch.from_numpy(found)


@jit(fastmath=FAST, error_model="numpy")
def _scatter(spread, rays, begin, end, canvas, landed):  # type: ignore[no-untyped-def]
    work = workspace(spread, rays)
    for i in range(begin, end, BATCH):
        count = min(BATCH, end - i)
        column, row, flux = rays[0, i : i + count], rays[1, i : i + count], rays[2, i : i + count]
        on_receiver, beside = scatter(spread, column, row, flux, count, work, canvas)
        landed[0] += on_receiver
        landed[1] += beside


@jit(fastmath=FAST, error_model="numpy")
def _gather(spread, rays, begin, end, canvas, found):  # type: ignore[no-untyped-def]
    work = workspace(spread, rays)
    for i in range(begin, end, BATCH):
        j = min(i + BATCH, end)
        gather(
            spread, rays[0, i:j], rays[1, i:j], rays[2, i:j], j - i, work, canvas,
            found[0, i:j], found[1, i:j], found[2, i:j],
        )  # fmt: skip
