"""Images of light whose rays are nodes of a grid, by beams or by boxes; the references in torch.

Beams: the beam between four neighbouring rays is split into two triangles of equal flux. Each
spreads its flux evenly over the area between its three hits; see
`workbench.optics.kernels.beam_raster`. Neighbours share their hits, so the
image has neither gaps nor noise and is exact in each pixel. 9 beams a pixel are 0.1 to 0.3 % off;
36 points a pixel under a filter are 1.5 to 3 % off.

Boxes: an extended source stands as many origins, whose images are added up. There a rectangle
along rows and columns of pixels replaces each beam: with the same middle, flux and variance along
both axes, (a_x² + b_x²) / 12 along columns, where a and b join the middles of opposite sides of
the cell. With 64 origins boxes differ from beams by 0.4 to 0.9 % of the light, and take a third of
the time.

The compiled twins are `workbench.optics.kernels.beam_image` and `box_image` beside it.
"""

import torch
from torch import Tensor
from torch.nn.functional import pad

from workbench.optics import ready
from workbench.optics.kernels.beam_edge import SLIVER
from workbench.optics.kernels.beam_image import compiled_beam_image
from workbench.optics.kernels.beam_raster import ROUNDING
from workbench.optics.kernels.box_image import compiled_box_image
from workbench.optics.kernels.box_raster import NARROWEST
from workbench.optics.kernels.cell_image import Splits, repeated
from workbench.optics.kernels.node_shift import FARTHEST


def reference_beam_image(
    nodes: Tensor, pixels: tuple[int, int], splits: Splits
) -> tuple[Tensor, float]:
    """As `beam_image`."""
    n_x, n_y = pixels
    along_u, _ = _splits(nodes, splits)
    column, row = shifted_hits(nodes, splits)
    flux, cut = cell_flux(nodes, splits), _cut_cells(column, row, pixels)
    edges, densities, image, landed = [], [], flux.new_zeros(n_y * n_x), 0.0
    for corners, here in _triangles(column.shape, along_u):
        x, y = (hits.flatten()[corners] for hits in (column, row))  # [triangles, 3]
        half, narrow = 0.5 * flux[here], cut[here]
        at, parts = _in_two_pixels(x[narrow], y[narrow], n_x)
        image = image.index_add(0, at.flatten(), (half[narrow] * parts).flatten())
        landed += half[narrow].sum().item()
        hit = (x + y).isfinite().all(1) & ~narrow
        x, y, half = x[hit], y[hit], half[hit]
        landed += half.sum().item()
        triangles, half = _without_slivers(torch.stack([x, y]), half)
        densities.append(half / _area(triangles))
        edges.append(triangles)
    x, y = torch.cat(edges, 1)
    image = image.view(n_y, n_x) + drawn(x, y, torch.cat(densities), pixels, landed)
    return image.to(nodes.dtype), landed


def _cut_cells(column: Tensor, row: Tensor, pixels: tuple[int, int]) -> Tensor:
    """Whether the corners of cells are in one pixel, or in two neighbouring ones."""
    on, apart = torch.ones_like(column[1:, 1:], dtype=torch.bool), torch.zeros_like(column[1:, 1:])
    for hits, count in zip((column.detach(), row.detach()), pixels, strict=True):
        corners = torch.stack([hits[:-1, :-1], hits[:-1, 1:], hits[1:, :-1], hits[1:, 1:]]).floor()
        on &= ((corners >= 0) & (corners < count)).all(0)
        apart += torch.where(on, corners.amax(0) - corners.amin(0), 0.0)
    return on & (apart <= 1)


def _in_two_pixels(x: Tensor, y: Tensor, n_x: int) -> tuple[Tensor, Tensor]:
    """Numbers (2, n) of the pixels of triangles (n, 3) in one or two, and the parts of their light.

    `n_x`: pixels along x.
    """
    j, i = x.detach().floor(), y.detach().floor()
    along_x = (j.amax(1) > j.amin(1))[:, None]
    place = torch.where(along_x, x, y)
    distance = place - place.detach().amax(1, keepdim=True).floor()
    over = distance >= 0
    alone = torch.where((over.sum(1) == 1)[:, None], over, ~over).int().argmax(1)
    turns = (alone[:, None] + torch.arange(3, device=x.device)) % 3
    first, second, third = distance.gather(1, turns).unbind(1)
    part = first.square() / torch.where(over.all(1), torch.inf, (first - second) * (first - third))
    at = (i * n_x + j).long().gather(1, turns[:, :2]).T
    return at, torch.stack([part, 1 - part])


def _without_slivers(corners: Tensor, flux: Tensor) -> tuple[Tensor, Tensor]:
    """Triangles (2, n, 3) and their flux (n,), with two wider triangles in place of each sliver.

    See `workbench.optics.kernels.beam_edge.SLIVER`.
    """
    with torch.no_grad():
        sides = corners[:, :, 1:] - corners[:, :, :1]
        length = sides.abs().amax((0, 2))
        narrow = _area(corners).abs() <= SLIVER * length * length.clamp_min(1)
        sides, length = sides[:, narrow], length[narrow]
        least = sides.new_tensor([[SLIVER, 0.0], [0.0, 0.0]])[:, None]
        wide = torch.where((length < SLIVER)[:, None], least, sides)
        part = 4 * SLIVER * length.clamp_min(SLIVER).reciprocal().clamp_min(1)
        one, two = (part * torch.stack([-wide[1], wide[0]])[:, :, k] for k in range(2))
        square = wide.square().sum(0)
        first = square[:, 0] >= square[:, 1]
        across = torch.stack([torch.where(first, 0.0, -two), torch.where(first, one, 0.0)], 2)
    slivers, half = corners[:, narrow], 0.5 * flux[narrow]
    pair = [slivers + pad(wide - sides + side * across, (1, 0)) for side in (-1, 1)]
    return torch.cat([corners[:, ~narrow], *pair], 1), torch.cat([flux[~narrow], half, half])


def _area(corners: Tensor) -> Tensor:
    x, y = corners.unbind()
    side_x, side_y = x[:, 1:] - x[:, :1], y[:, 1:] - y[:, :1]
    return 0.5 * (side_x[:, 0] * side_y[:, 1] - side_x[:, 1] * side_y[:, 0])


def shifted_hits(nodes: Tensor, splits: Splits) -> tuple[Tensor, Tensor]:
    """Columns and rows of nodes in float64; see `workbench.optics.kernels.beam_image`."""
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
    each = repeated(splits[1], nodes.shape[1]), splits[0]
    along_u, along_v = (torch.as_tensor(split, device=nodes.device) for split in each)
    return along_u, along_v


def _shifted(hits: Tensor, parts: tuple[Tensor, Tensor]) -> Tensor:
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


_Sides = tuple[Tensor, Tensor, Tensor]
"""Middles of cells along one axis of the image, and from side to side of them along it."""

_End = tuple[Tensor, Tensor]
"""Number of a pixel for each box, and what its interval adds from there on."""


def reference_box_image(
    nodes: Tensor, pixels: tuple[int, int], splits: Splits
) -> tuple[Tensor, float]:
    """As `box_image`."""
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


def beam_image(
    nodes: Tensor, pixels: tuple[int, int], splits: Splits, fused: bool = True
) -> tuple[Tensor, float]:
    """Flux in each pixel of beams between rays.

    `nodes` (3, n, m): columns and rows of the image in which rays hit, infinite for those that
    never do; and their flux: a ray inside the grid stands for a cell around it, one at its rim for
    a half or a quarter of one. Rays are neighbours in the grid as they are in the lens; `splits`
    (m, 3) and (n, 3): which parts of the flux of a ray belong to the cells before and behind it,
    along the last axis and along the one before; and 1 for rays between two cells of equal width.
    Several grids may lie side by side: no flux belongs to the cells between them. Where there are
    so many times as many rows of rays, all grids are alike; `pixels`: (n_x, n_y); `fused`: False
    asks for the reference. Returns (n_y, n_x): flux in each pixel, row 0 at the top,
    differentiable; and the flux of all beams whose rays hit the plane of the image, on it or beside
    it.
    """
    compiled = fused and nodes.device.type == "cpu" and ready.obtain("beams", nodes.dtype)
    return (compiled_beam_image if compiled else reference_beam_image)(nodes, pixels, splits)


def box_image(
    nodes: Tensor, pixels: tuple[int, int], splits: Splits, fused: bool = True
) -> tuple[Tensor, float]:
    """Flux in each pixel of boxes between rays.

    Parameters and results are those of `beam_image`. A cell of which a ray
    hits nowhere is dark.
    """
    compiled = fused and nodes.device.type == "cpu" and ready.obtain("boxes", nodes.dtype)
    return (compiled_box_image if compiled else reference_box_image)(nodes, pixels, splits)
