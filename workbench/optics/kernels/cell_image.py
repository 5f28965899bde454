"""The image of cells of light between rays as a step that torch differentiates.

Beams and boxes draw cells, each in its own way; see `workbench.optics.images.beams` and
`workbench.optics.images.beams`.
"""

from collections.abc import Callable
from typing import Any

import numpy as np
import torch
from torch import Tensor
from torch.autograd.function import once_differentiable

from workbench.arrays import AnyArray, Array

Splits = tuple[Array, Array]

Back = Callable[[AnyArray, Array], AnyArray]
"""Cotangent of the nodes from these and that of the image."""

Draw = Callable[[AnyArray, tuple[int, int], Splits], tuple[Array, float, Back]]
"""The image of nodes, the flux that lands on its plane, and the way back."""


def repeated(along: Array, rows: int) -> Array:
    """Splits of so many rows of nodes, from those of one of several grids that are alike."""
    return np.tile(along, (rows // len(along), 1))


def cell_image(
    draw: Draw, nodes: Tensor, pixels: tuple[int, int], splits: Splits
) -> tuple[Tensor, float]:
    """Draw cells, on the CPU; parameters and results are those of `beam_image` and `box_image`."""
    lands: list[float] = []
    image = _CellImage.apply(draw, nodes, pixels, splits, lands)  # type: ignore[no-untyped-call]
    return image, lands[0]


class _CellImage(torch.autograd.Function):
    @staticmethod
    def forward(
        ctx: Any,
        draw: Draw,
        nodes: Tensor,
        pixels: tuple[int, int],
        splits: Splits,
        lands: list[float],
    ) -> Tensor:
        hits = nodes.detach().contiguous().numpy()
        image, landed, ctx.back = draw(hits, pixels, splits)
        lands.append(landed)
        ctx.save_for_backward(nodes)
        return torch.from_numpy(image.astype(hits.dtype))

    @staticmethod
    @once_differentiable
    def backward(ctx: Any, cotangent: Tensor) -> tuple[None, Tensor, None, None, None]:
        (nodes,) = ctx.saved_tensors
        hits, seen = nodes.detach().contiguous().numpy(), cotangent.double().contiguous().numpy()
        return None, torch.from_numpy(ctx.back(hits, seen)), None, None, None
