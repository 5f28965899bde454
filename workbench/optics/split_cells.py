"""Light of cells of which some rays are totally reflected and others are not.

An image of beams leaves such cells out, as nothing says where the light of their reflected corners
would land. Where much light is near total reflection that is 1 % of all light, and the run would
count it as reflected. What the other corners have of it lands where these do.
"""

import torch
from torch import Tensor

from workbench.optics.beam_reference import first_lines
from workbench.optics.kernels.beam_image import repeated
from workbench.optics.kernels.cell_image import Splits

# Corners a, b, c, d around a cell that make its triangles; see `workbench.optics.beam_reference`.
_EVEN, _ODD = ((0, 1, 2), (0, 2, 3)), ((0, 1, 3), (1, 2, 3))


def split_light(
    nodes: Tensor, room: Tensor | None, pixels: tuple[int, int], splits: Splits, triangles: bool
) -> tuple[Tensor, float]:
    """Light of split cells, corner by corner.

    `room` (n, m): see `workbench.optics.rim`; cells that it cuts are drawn there; `triangles`:
    whether triangles between three corners that land are in the image already, as with beams; of
    boxes all four corners are. Returns (n_y, n_x): flux in each pixel, row 0 at the top, without
    gradients; and all of it, on the image or beside it.
    """
    with torch.no_grad():
        lands, (i, j) = _cells(nodes, room)
        along_v = torch.as_tensor(splits[0], device=nodes.device)
        along_u = torch.as_tensor(repeated(splits[1], nodes.shape[1]), device=nodes.device)
        before_u, behind_u = along_u[i, 1], along_u[i + 1, 0]
        before_v, behind_v = along_v[j, 1], along_v[j + 1, 0]
        parts = [
            before_u * before_v,
            behind_u * before_v,
            behind_u * behind_v,
            before_u * behind_v,
        ]
        at = torch.stack([i, i + 1, i + 1, i]), torch.stack([j, j, j + 1, j + 1])
        flux = torch.where(lands, nodes[2][at].double() * torch.stack(parts), 0.0)
        if triangles:
            even = (i - first_lines(along_u)[i] + j) % 2 == 0
            drawn = torch.where(even, _drawn(lands, _EVEN), _drawn(lands, _ODD))
            flux = flux * (1 - drawn)
        column, row = (nodes[axis][at][lands].double() for axis in (0, 1))
        light = flux[lands]
        return _spread(column, row, light, pixels).to(nodes.dtype), light.sum().item()


def _cells(nodes: Tensor, room: Tensor | None) -> tuple[Tensor, tuple[Tensor, Tensor]]:
    """Which corners of split cells land, shape (4, cells), and the numbers of the cells."""
    hits = nodes[:2].isfinite().all(0)
    corners = _corners(hits)
    split = corners.any(0) & ~corners.all(0)
    if room is not None:
        beside = _corners(room < 0)
        split &= ~(beside.any(0) & (corners | beside).all(0))
    i, j = split.nonzero().unbind(1)
    return corners[:, i, j], (i, j)


def _corners(values: Tensor) -> Tensor:
    """Values at the corners a, b, c, d of cells."""
    return torch.stack([values[:-1, :-1], values[1:, :-1], values[1:, 1:], values[:-1, 1:]])


def _drawn(lands: Tensor, corners: tuple[tuple[int, ...], tuple[int, ...]]) -> Tensor:
    """Which part of cells is in triangles all of whose corners land."""
    one, other = (lands[list(triangle)].all(0).double() for triangle in corners)
    return (one + other) / 2


def _spread(column: Tensor, row: Tensor, light: Tensor, pixels: tuple[int, int]) -> Tensor:
    """Light of hits as that of squares of a pixel about them."""
    n_x, n_y = pixels
    image = light.new_zeros(n_y * n_x)
    left, top = (column - 0.5).floor(), (row - 0.5).floor()
    right, below = column - 0.5 - left, row - 0.5 - top
    for step_x, part_x in ((0, 1 - right), (1, right)):
        for step_y, part_y in ((0, 1 - below), (1, below)):
            x, y = left + step_x, top + step_y
            seen = (x >= 0) & (x < n_x) & (y >= 0) & (y < n_y)
            at = (y * n_x + x)[seen].long()
            image = image.index_add(0, at, (light * part_x * part_y)[seen])
    return image.view(n_y, n_x)
