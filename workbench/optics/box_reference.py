"""The image of boxes of light in plain torch: the twin of `workbench.optics.kernels.box_image`.

Slow, on any device, and differentiated by torch.
"""

import torch
from torch import Tensor

from workbench.optics.beam_reference import cell_flux, shifted_hits
from workbench.optics.kernels.beam_raster import ROUNDING
from workbench.optics.kernels.box_cells import NARROWEST
from workbench.optics.kernels.cell_image import Splits

_Sides = tuple[Tensor, Tensor, Tensor]
"""Middles of cells along one axis of the image, and from side to side of them along it."""

_End = tuple[Tensor, Tensor]
"""Number of a pixel for each box, and what its interval adds from there on."""


def reference_box_image(
    nodes: Tensor, pixels: tuple[int, int], splits: Splits
) -> tuple[Tensor, float]:
    """As `workbench.optics.boxes.box_image`."""
    n_x, n_y = pixels
    columns, rows = (_sides(hits) for hits in shifted_hits(nodes, splits))
    flux = cell_flux(nodes, splits)
    lands = torch.stack([*columns, *rows]).isfinite().all(0)
    flux = flux[lands]
    along_x, along_y = _ends(columns, lands, n_x), _ends(rows, lands, n_y)
    steps = flux.new_zeros((n_y + 2) * (n_x + 2))
    for i, part_y in along_y:
        for j, part_x in along_x:
            steps = steps.index_add(0, i * (n_x + 2) + j, flux * part_x * part_y)
    image = steps.view(n_y + 2, n_x + 2).cumsum(0).cumsum(1)[:n_y, :n_x]
    landed = flux.sum().item()
    return torch.where(image < ROUNDING * landed, 0.0, image).to(nodes.dtype), landed


def _sides(hits: Tensor) -> _Sides:
    """What there is along one axis of the sides of cells."""
    a, b, c, d = hits[:-1, :-1], hits[:-1, 1:], hits[1:, :-1], hits[1:, 1:]
    return (a + b + c + d) / 4, (b + d - a - c) / 2, (c + d - a - b) / 2


def _ends(sides: _Sides, lands: Tensor, last: int) -> list[_End]:
    """What intervals of boxes add along an axis of so many pixels: sums of it are their parts."""
    middle, along, across = (part[lands] for part in sides)
    square = along.square() + across.square()
    wide = square > NARROWEST**2
    width = torch.where(wide, torch.where(wide, square, 1.0).sqrt(), NARROWEST)
    ends: list[_End] = []
    for sign in (1, -1):
        place = (middle - sign * width / 2).clamp(0, last)
        pixel = place.detach().floor()
        part = place - pixel
        ends += [
            (pixel.long(), sign * (1 - part) / width),
            (pixel.long() + 1, sign * part / width),
        ]
    return ends
