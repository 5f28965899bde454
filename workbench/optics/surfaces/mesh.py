"""Where rays in the lens meet a triangle mesh that stands for the exit face.

The method of de Koning et al. (2023): each knot span is divided into equal rectangles, each of them
into a lower-left and an upper-right triangle, with the vertices on the B-spline. In grid
coordinates, where the rectangles are unit squares, a ray is g(t) = a + b t at height t above the
entrance face. Then

1. boxes: a ray is free below the lowest control height that bears on its knot span;
2. candidates: from there it walks from triangle to triangle, across the nearest of the three edges;
3. triangles: the first one at whose far edge the ray is not below the plane any more holds the hit.

No ray is lost between triangles or hits two: the far edge of one triangle is the near edge of the
next, and its height is computed once. Where a walk begins, a point belongs to one triangle:
diagonals to the upper one, other edges to the square after them, u = 1 and v = 1 to the last
square. A triangle is known by its corner at the right angle and the sign s with which it extends
from there: +1 for lower-left, −1 for upper-right. A walk across any edge flips s.

The depth has the derivative of the triangle's plane. The slopes that refract the ray are those of
the B-spline at the hit: planes would make a lens of flat facets. So the mesh errs in the place of
the hit alone, by 5.8e-5 with 1 rectangle a span, 3.7e-6 with 4, where heights are about 1/2
(float32); it saves a quarter of the time of the exact method, which is the default.
"""

from typing import NamedTuple

import numpy as np
import torch
from torch import Tensor

from workbench.geometry.surface import ControlNet
from workbench.optics.surfaces.intersection import Bundle, Met

# How slowly a ray may come through a triangle's plane, per depth, before the derivative of its hit
# is held down: a ray that grazes it has none.
_GRAZING = 1e-3


class TriangleMesh:
    """The mesh of one control net: all that is known of it but the heights.

    `net`: the control net; `subdivisions`: rectangles in each knot span, along x and y; `dtype`,
    `device`: float type and device of the mesh.
    """

    def __init__(
        self,
        net: ControlNet,
        subdivisions: tuple[int, int],
        dtype: torch.dtype,
        device: torch.device | str = "cpu",
    ) -> None:
        self.half_width = net.half_width
        self.spans = (net.shape[0] - net.degree[0], net.shape[1] - net.degree[1])
        self.cells = (self.spans[0] * subdivisions[0], self.spans[1] * subdivisions[1])
        self._support = (net.degree[0] + 1, net.degree[1] + 1)
        u, v = (np.arange(count + 1) / count for count in self.cells)
        basis = net.grid(u, v)
        self._along_x = torch.as_tensor(basis.along_x, dtype=dtype, device=device)
        self._along_y = torch.as_tensor(basis.along_y, dtype=dtype, device=device)

    def vertices(self, heights: Tensor) -> Tensor:
        """Heights of the vertices, shape ((cells_x + 1)(cells_y + 1),)."""
        return (self._along_x @ heights @ self._along_y).flatten()

    def lower_bounds(self, heights: Tensor) -> Tensor:
        """Lowest control height that bears on each knot span, shape (spans_x spans_y,)."""
        p, q = self._support
        return heights.unfold(0, p, 1).amin(-1).unfold(1, q, 1).amin(-1).flatten()


class _Walk(NamedTuple):
    """Rays on a grid of unit squares, all of shape (m,): g(t) = a + b t."""

    a_x: Tensor
    a_y: Tensor
    b_x: Tensor
    b_y: Tensor

    @classmethod
    def along(
        cls, bundle: Bundle, half_width: tuple[float, float], count: tuple[int, int]
    ) -> "_Walk":
        """Rays on a grid of so many squares; a start on the far rim is exactly on its last line."""
        (r_x, r_y), (n_x, n_y) = half_width, count
        return cls(
            (bundle.x + r_x) / (2 * r_x) * n_x,
            (bundle.y + r_y) / (2 * r_y) * n_y,
            bundle.slope_x * (n_x / (2 * r_x)),
            bundle.slope_y * (n_y / (2 * r_y)),
        )

    def of(self, rays: Tensor) -> "_Walk":
        """Some of the rays."""
        return _Walk(*(part[rays] for part in self))

    def leaves(self, k: Tensor, m: Tensor) -> tuple[Tensor, Tensor]:
        """When the rays leave the unit square at (k, m), along x and along y."""
        return (
            _when(k + (self.b_x > 0), self.a_x, self.b_x, self.b_x != 0),
            _when(m + (self.b_y > 0), self.a_y, self.b_y, self.b_y != 0),
        )

    def edges(self, c_x: Tensor, c_y: Tensor, s: Tensor) -> tuple[Tensor, Tensor, Tensor]:
        """When the rays leave triangles by the edges x = c_x, y = c_y, and by the diagonal."""
        both = self.b_x + self.b_y
        return (
            _when(c_x, self.a_x, self.b_x, s * self.b_x < 0),
            _when(c_y, self.a_y, self.b_y, s * self.b_y < 0),
            _when(c_x + c_y + s, self.a_x + self.a_y, both, s * both > 0),
        )

    def cell(self, t: Tensor, count: tuple[int, int]) -> tuple[Tensor, Tensor]:
        """The square of each ray at t; those of the far rim are in the last one."""
        return (
            (self.a_x + self.b_x * t).floor().clamp(0, count[0] - 1),
            (self.a_y + self.b_y * t).floor().clamp(0, count[1] - 1),
        )


def _when(line: Tensor, a: Tensor, b: Tensor, crosses: Tensor) -> Tensor:
    """When a + b t comes to the line; infinite for what does not cross it."""
    return torch.where(crosses, (line - a) / b, torch.inf)


class _Hits(NamedTuple):
    """Triangles in which rays end, all of shape (m,): corner, sign, depth, and whether found."""

    corner_x: Tensor
    corner_y: Tensor
    sign: Tensor
    depth: Tensor
    found: Tensor


class MeshIntersection:
    """Finds where one set of rays meets the meshes of lens after lens.

    `mesh`: the mesh, of the bundle's float type and device.
    """

    def __init__(self, bundle: Bundle, mesh: TriangleMesh) -> None:
        self._mesh = mesh
        self._in_spans = _Walk.along(bundle, mesh.half_width, mesh.spans)
        self._in_cells = _Walk.along(bundle, mesh.half_width, mesh.cells)
        whole = _Walk.along(bundle, mesh.half_width, (1, 1))
        corner = torch.zeros_like(bundle.x)
        self._side = torch.minimum(*whole.leaves(corner, corner))

    def meet(self, heights: Tensor, table: Tensor) -> Met:
        """Hits on the mesh of a lens.

        `heights` (n_u, n_v): control heights above the entrance face; `table`: their table of
        patches, which a mesh does not need.
        """
        vertices = self._mesh.vertices(heights)
        with torch.no_grad():
            still = heights.detach()
            start, inside = self._rise(still)
            hit = self._cross(vertices.detach(), start, inside, still.max())
        walk, s = self._in_cells, hit.sign
        height, rise_x, rise_y = self._planes(vertices, hit.corner_x, hit.corner_y, s)
        e_x = s * (walk.a_x + walk.b_x * hit.depth - hit.corner_x)
        e_y = s * (walk.a_y + walk.b_y * hit.depth - hit.corner_y)
        plane = height + rise_x * e_x + rise_y * e_y
        falls = 1 - s * (rise_x.detach() * walk.b_x + rise_y.detach() * walk.b_y)
        # The value is the hit's; its derivative is the plane's, by the implicit function theorem.
        moves = (plane - plane.detach()) / falls.clamp_min(_GRAZING)
        return Met(hit.depth + torch.where(hit.found, moves, 0.0), hit.found)

    def _rise(self, heights: Tensor) -> tuple[Tensor, Tensor]:
        """Phase 1: height up to which boxes let each ray pass, and whether it stays inside."""
        n_x, n_y = self._mesh.spans
        lowest = self._mesh.lower_bounds(heights)
        height = torch.full_like(self._side, heights.min().item())
        inside = self._side >= height
        rays = inside.nonzero().squeeze(1)
        walk, t = self._in_spans.of(rays), height[rays]
        k, m = walk.cell(t, self._mesh.spans)
        for _ in range(n_x + n_y + 1):
            if not len(rays):
                break
            low = lowest[k.long() * n_y + m.long()]
            leaves_x, leaves_y = walk.leaves(k, m)
            leaves = torch.maximum(torch.minimum(leaves_x, leaves_y), t)
            goes_on = low > leaves
            height[rays] = torch.where(goes_on, leaves, torch.maximum(low, t))
            across = leaves_x <= leaves_y
            k = torch.where(across, k + walk.b_x.sign(), k)
            m = torch.where(across, m, m + walk.b_y.sign())
            within = (k >= 0) & (k < n_x) & (m >= 0) & (m < n_y)
            inside[rays[goes_on & ~within]] = False
            keep = (goes_on & within).nonzero().squeeze(1)
            rays, walk, t, k, m = rays[keep], walk.of(keep), leaves[keep], k[keep], m[keep]
        return height, inside

    def _cross(self, vertices: Tensor, start: Tensor, inside: Tensor, highest: Tensor) -> _Hits:
        """Phases 2 and 3: walk across triangles to the first one that is hit."""
        n_x, n_y = self._mesh.cells
        hits = _Hits(
            torch.zeros_like(start),
            torch.zeros_like(start),
            torch.ones_like(start),
            torch.minimum(self._side, highest),
            torch.zeros_like(inside),
        )
        rays = inside.nonzero().squeeze(1)
        walk, t = self._in_cells.of(rays), start[rays]
        i, j = walk.cell(t, self._mesh.cells)
        upper = walk.a_x + walk.b_x * t - i + (walk.a_y + walk.b_y * t - j) >= 1
        c_x, c_y, s = i + upper.to(i), j + upper.to(j), 1 - 2 * upper.to(i)
        gap = self._gap(vertices, walk, c_x, c_y, s, t)
        # Each line of the grid, and each diagonal, is crossed once at most.
        for _ in range(2 * (n_x + n_y) + 1):
            if not len(rays):
                break
            far_x, far_y, far_d = walk.edges(c_x, c_y, s)
            far = torch.minimum(torch.minimum(far_x, far_y), far_d)
            # Above the highest control height there is no mesh, whatever rounding says.
            beyond = far >= highest
            far = torch.minimum(torch.maximum(far, t), highest)
            far_gap = self._gap(vertices, walk, c_x, c_y, s, far)
            far_gap = torch.where(beyond, far_gap.clamp_max(0), far_gap)

            found = far_gap <= 0
            near_gap = gap.clamp_min(0)
            share = near_gap / (near_gap - far_gap).clamp_min(torch.finfo(t.dtype).tiny)
            here = rays[found]
            for into, value in zip(hits, (c_x, c_y, s, t + (far - t) * share, found), strict=True):
                into[here] = value[found]

            by_x = (far_x <= far_y) & (far_x <= far_d)
            by_y = ~by_x & (far_y <= far_d)
            out = (by_x & ((c_x == 0) | (c_x == n_x))) | (by_y & ((c_y == 0) | (c_y == n_y)))
            # Across the edge at x = c_x lies the triangle whose corner is at the edge's other end.
            c_x, c_y, s = torch.where(by_x, c_x, c_x + s), torch.where(by_y, c_y, c_y + s), -s
            keep = (~found & ~out).nonzero().squeeze(1)
            rays, walk, t, gap = rays[keep], walk.of(keep), far[keep], far_gap[keep]
            c_x, c_y, s = c_x[keep], c_y[keep], s[keep]
        return hits

    def _gap(
        self, vertices: Tensor, walk: _Walk, c_x: Tensor, c_y: Tensor, s: Tensor, t: Tensor
    ) -> Tensor:
        """How far the triangles' planes are above the rays at t."""
        height, rise_x, rise_y = self._planes(vertices, c_x, c_y, s)
        e_x, e_y = s * (walk.a_x + walk.b_x * t - c_x), s * (walk.a_y + walk.b_y * t - c_y)
        return height + rise_x * e_x + rise_y * e_y - t

    def _planes(
        self, vertices: Tensor, c_x: Tensor, c_y: Tensor, s: Tensor
    ) -> tuple[Tensor, Tensor, Tensor]:
        """Height at the corner of triangles, and the rises from there along x and y."""
        row = self._mesh.cells[1] + 1
        corner, step = c_x.long() * row + c_y.long(), s.long()
        height = vertices[corner]
        return height, vertices[corner + step * row] - height, vertices[corner + step] - height
