"""The image of beams of light in plain torch: the twin of `workbench.optics.kernels.beam_image`.

Slow, on any device, and differentiated by torch. Edges are cut where they cross borders of pixels;
see `workbench.optics.kernels.beam_raster` for what each piece adds.
"""

import torch
from torch import Tensor

from workbench.optics.kernels.beam_image import repeated
from workbench.optics.kernels.beam_raster import FARTHEST, ROUNDING, SLIVER
from workbench.optics.kernels.cell_image import Splits


def reference_beam_image(
    nodes: Tensor, pixels: tuple[int, int], splits: Splits
) -> tuple[Tensor, float]:
    """As `workbench.optics.beams.beam_image`."""
    n_x, n_y = pixels
    along_u, _ = _splits(nodes, splits)
    column, row = shifted_hits(nodes, splits)
    flux = cell_flux(nodes, splits)
    edges, densities, image, landed = [], [], flux.new_zeros(n_y * n_x), 0.0
    for corners, here in _triangles(column.shape, along_u):
        x, y = (hits.flatten()[corners] for hits in (column, row))  # [triangles, 3]
        half = 0.5 * flux[here]
        hit = (x + y).isfinite().all(1)
        x, y, half = x[hit], y[hit], half[hit]
        landed += half.sum().item()
        sides = torch.stack([x[:, 1:] - x[:, :1], y[:, 1:] - y[:, :1]])
        (x_1, x_2), (y_1, y_2) = (side.unbind(1) for side in sides)
        area = 0.5 * (x_1 * y_2 - x_2 * y_1)
        wide = area.abs() > SLIVER * sides.abs().amax((0, 2)).clamp_min(1)
        densities.append(half[wide] / area[wide])
        edges.append(torch.stack([x[wide], y[wide]]))
        j, i = (hits[~wide].mean(1).detach().floor() for hits in (x, y))
        seen = (j >= 0) & (j < n_x) & (i >= 0) & (i < n_y)
        image = image.index_add(0, (i * n_x + j)[seen].long(), half[~wide][seen])
    x, y = torch.cat(edges, 1)
    image = image.view(n_y, n_x) + drawn(x, y, torch.cat(densities), pixels, landed)
    return image.to(nodes.dtype), landed


def shifted_hits(nodes: Tensor, splits: Splits) -> tuple[Tensor, Tensor]:
    """Columns and rows of nodes in float64; see `workbench.optics.kernels.beam_nodes`."""
    each = _splits(nodes, splits)
    column, row = (_shifted(hits.double(), each) for hits in nodes[:2])
    return column, row


def cell_flux(nodes: Tensor, splits: Splits) -> Tensor:
    """Flux of the cells between nodes in float64, one less along each axis."""
    along_u, along_v = _splits(nodes, splits)
    flux = nodes[2].double()
    flux = flux[:-1] * along_u[:-1, 1:2] + flux[1:] * along_u[1:, :1]
    return flux[:, :-1] * along_v[:-1, 1] + flux[:, 1:] * along_v[1:, 0]


def drawn(x: Tensor, y: Tensor, density: Tensor, pixels: tuple[int, int], landed: float) -> Tensor:
    """Flux in each pixel, shape (n_y, n_x), of polygons of even light.

    `x`, `y` (polygons, corners): their corners, in pixels; `density` (polygons,): flux per area,
    negative for polygons that are turned over; `pixels`: (n_x, n_y); `landed`: flux of all; pixels
    with next to none of it are dark.
    """
    to_x, to_y = x.roll(-1, 1), y.roll(-1, 1)
    some = (x != to_x) | (y != to_y)
    each = density[:, None].expand_as(x)
    steps = _steps(x[some], y[some], to_x[some], to_y[some], each[some], pixels)
    image = -steps.cumsum(1)[:, : pixels[0]]
    return torch.where(image < ROUNDING * landed, 0.0, image)


def first_lines(along: Tensor) -> Tensor:
    """For each line of nodes the number of the first one of its grid, of several side by side."""
    lines = torch.arange(len(along), device=along.device)
    return torch.where(along[:, 0] == 0, lines, 0).cummax(0).values


def _splits(nodes: Tensor, splits: Splits) -> tuple[Tensor, Tensor]:
    """Splits along the first axis of the nodes, and along the second."""
    each = repeated(splits[1], nodes.shape[1]), splits[0]
    along_u, along_v = (torch.as_tensor(split, device=nodes.device) for split in each)
    return along_u, along_v


def _shifted(hits: Tensor, parts: tuple[Tensor, Tensor]) -> Tensor:
    """See `workbench.optics.kernels.beam_nodes`."""
    shift = torch.zeros_like(hits)
    for axis in (0, 1):
        lines, moved = hits.transpose(0, axis), shift.transpose(0, axis)
        second_diff = lines[2:] + lines[:-2] - 2 * lines[1:-1]
        inner = parts[axis][1:-1, 2:] > 0
        moved[1:-1] += torch.where(inner & (second_diff.abs() < FARTHEST), second_diff, 0.0)
    return torch.where(hits.isfinite(), (hits - shift / 12).clamp(-FARTHEST, FARTHEST), torch.inf)


def _triangles(shape: torch.Size, along_u: Tensor) -> list[tuple[Tensor, Tensor]]:
    """Nodes of the triangles 0, and of the triangles 1, of even and of odd cells; and the cells.

    Cells are counted anew in each grid of several that lie side by side.
    """
    n, m = (count - 1 for count in shape)
    lines = (torch.arange(count, device=along_u.device) for count in (n, m))
    i, j = torch.meshgrid(*lines, indexing="ij")
    a = i * (m + 1) + j
    b, c, d = a + m + 1, a + m + 2, a + 1  # the corners in turn
    even = (i - first_lines(along_u)[:n, None] + j) % 2 == 0
    return [
        (torch.stack([corner[cells] for corner in corners], 1), cells)
        for cells, corners in (
            (even, (a, b, c)),
            (even, (a, c, d)),
            (~even, (a, b, d)),
            (~even, (b, c, d)),
        )
    ]


def _steps(
    x: Tensor, y: Tensor, to_x: Tensor, to_y: Tensor, density: Tensor, pixels: tuple[int, int]
) -> Tensor:
    """What each pixel has more than its left neighbour, shape (n_y, n_x + 1), times −1."""
    n_x, n_y = pixels
    cuts = [_crossings(x, to_x, n_x), _crossings(y, to_y, n_y)]
    number = torch.arange(len(x), device=x.device)
    edge = torch.cat([number, cuts[0][0], cuts[1][0]])
    begin = torch.cat([torch.zeros_like(x), cuts[0][1], cuts[1][1]])
    # Pieces of the same edge one after the other; each ends where the next one begins.
    order = torch.argsort(edge.detach().double() * 2 + begin.detach())
    edge, begin = edge[order], begin[order]
    last = torch.cat([edge[1:] != edge[:-1], edge.new_ones(1, dtype=torch.bool)])
    end = torch.where(last, 1.0, begin.roll(-1))
    way_x, way_y = (to_x - x)[edge], (to_y - y)[edge]
    middle_x = x[edge] + way_x * (begin + end) / 2
    middle_y = y[edge] + way_y * (begin + end) / 2
    light = (end - begin) * way_y * density[edge]
    j, i = middle_x.detach().floor(), middle_y.detach().floor()
    seen = (i >= 0) & (i < n_y) & (j < n_x)
    left = j < 0
    j = torch.where(left, -1, j)
    beyond = torch.where(left, 1.0, middle_x - j)[seen]
    at = (i * (n_x + 1) + j)[seen].long()
    steps = x.new_zeros(n_y * (n_x + 1) + 1)
    light = light[seen]
    steps = steps.index_add(0, at.clamp_min(0), torch.where(left[seen], 0.0, light * (1 - beyond)))
    return steps.index_add(0, at + 1, light * beyond)[:-1].view(n_y, n_x + 1)


def _crossings(start: Tensor, to: Tensor, last: int) -> tuple[Tensor, Tensor]:
    """Borders 0 to ``last`` of pixels that edges cross: numbers of edges, parts of their way."""
    with torch.no_grad():
        low, high = torch.minimum(start, to), torch.maximum(start, to)
        first = (low.floor() + 1).clamp(0, last + 1)
        count = ((high.ceil() - 1).clamp(-1, last) - first + 1).clamp_min(0).long()
        edge = torch.repeat_interleave(torch.arange(len(start), device=start.device), count)
        before = torch.cat([count.new_zeros(1), count.cumsum(0)[:-1]])
        border = first[edge] + (torch.arange(len(edge), device=start.device) - before[edge])
    return edge, (border - start[edge]) / (to - start)[edge]
