"""A B-spline surface, met by rays along the axis or in any direction to +z."""

from collections.abc import Mapping
from typing import Protocol

import numpy as np
import torch
from torch import Tensor

from workbench.geometry.outlines import Outline, Rectangle
from workbench.geometry.patches import Patches
from workbench.geometry.surface import ControlNet, GridBasis
from workbench.optics.rays import RayBundle
from workbench.optics.surfaces.intersection import RIM, Bundle, ExactIntersection, Met
from workbench.optics.surfaces.mesh import MeshIntersection, TriangleMesh
from workbench.optics.surfaces.surface import Meeting


class BSplineSurface:
    """Face whose control heights are free, on a net over a rectangle; a `Surface`.

    `name`: what its heights are called; `net`: where the control heights sit; `datum`: height at
    the origin of its frame: z of the scene from which the path counts z, or 0 in a frame of its
    element; `dtype`, `device`: float type and device of the trace; `subdivisions`: of each knot
    span along x and y: rays then meet triangles, as in the paper, in place of the B-spline itself;
    `outline`: what of the rectangle is glass; all of it by default; `level`: height near its mean
    height, by default the datum: what kernels count heights from, so that float32 keeps the digits
    that make the shape; `behind`: whether all heights but the control heights are of a frame that
    is turned by 180° about its x, see `Surface.from_behind`. `z`: where its level is, counted from
    the origin of its frame.

    Notes
    -----
    Rays that are the same object as for the last lens are the same: what depends on them alone is
    then kept. The search begins at the root of the last lens, also of rays that come from a face
    before this one, a little changed.
    """

    freeform = True

    def __init__(
        self,
        name: str,
        net: ControlNet,
        datum: float,
        dtype: torch.dtype,
        device: torch.device | str = "cpu",
        subdivisions: tuple[int, int] | None = None,
        outline: Outline | None = None,
        level: float | None = None,
        behind: bool = False,
    ) -> None:
        self.name, self.outline = name, outline or Rectangle(net.half_width)
        self.kind = "B-spline" if subdivisions is None else "triangle mesh"
        self.net, self.subdivisions, self.compiled = net, subdivisions, subdivisions is None
        self.level = datum if level is None else level
        self.z, self.behind = self.level - datum, behind
        self._datum, self._dtype, self._device = datum, dtype, device
        self._met_before: tuple[RayBundle, _Way] | None = None
        self._patches: Patches | None = None
        self._last: Tensor | None = None  # heights of the last places on the face

    def meet(self, rays: RayBundle, heights: Mapping[str, Tensor]) -> Meeting:
        """Where rays meet the face; see `Surface.meet`."""
        meeting = self.meet_unbounded(rays, heights)
        x, y, _ = meeting.position
        within = self.outline.contains(x.detach() / RIM, y.detach() / RIM)
        return meeting._replace(met=meeting.met & within)

    def meet_unbounded(self, rays: RayBundle, heights: Mapping[str, Tensor]) -> Meeting:
        """As `meet`, also beside the outline but within the rectangle of the net."""
        # Counted from the datum, float32 keeps the digits that make the shape.
        above = (self.own(heights) - self._datum).to(self._dtype)
        known = self._met_before is not None and self._met_before[0] is rays
        way = self._met_before[1] if self._met_before is not None and known else self._way(rays)
        meeting = way.meet(above)
        self._last = meeting.position[2].detach().flatten()
        # What a whole graph hangs on is not kept.
        self._met_before = None if rays.position[2].requires_grad else (rays, way)
        return meeting

    def own(self, heights: Mapping[str, Tensor]) -> Tensor:
        """Its control heights (n_u, n_v) in its frame."""
        given = heights[self.name]
        return -given.flip(1) if self.behind else given

    def from_behind(self) -> "BSplineSurface":
        """See `Surface.from_behind`."""
        how = self._dtype, self._device, self.subdivisions, self.outline
        return BSplineSurface(
            self.name, self.net, -self._datum, *how, -self.level, behind=not self.behind
        )

    def _way(self, rays: RayBundle) -> "_Way":
        x, y, _ = rays.position
        along_axis = not any(d.count_nonzero() for d in rays.direction[:2])
        if along_axis and x.ndim == 2 and x.shape[1] == 1 and y.shape[0] == 1:
            return _AlongAxis(rays, self.net, self._dtype, self._device)
        return _Searching(rays, self._tables, self.subdivisions, self._last)

    @property
    def _tables(self) -> Patches:
        if self._patches is None:
            self._patches = Patches(self.net, self._dtype, self._device)
        return self._patches


class _Way(Protocol):
    """How one bundle meets faces of one control net."""

    def meet(self, heights: Tensor) -> Meeting:
        """Where it meets the face with control heights (n_u, n_v), counted from the datum."""
        ...


class _AlongAxis:
    """A tensor grid of rays along z: nothing to search for, slopes by small matrix products."""

    def __init__(
        self, rays: RayBundle, net: ControlNet, dtype: torch.dtype, device: torch.device | str
    ) -> None:
        self._rays = rays
        x, y, _ = rays.position
        r_x, r_y = net.half_width
        # By lists: values that were made within a `torch.func` transform have no storage.
        u, v = ((np.array(c.tolist()) / r + 1) / 2 for c, r in ((x[:, 0], r_x), (y[0], r_y)))
        self._basis = GridBasis(
            *(
                torch.as_tensor(part, dtype=dtype, device=device).contiguous()
                for part in vars(net.grid(u, v)).values()
            )
        )

    def meet(self, heights: Tensor) -> Meeting:
        x, y, _ = self._rays.position
        z, slope_x, slope_y = self._basis.evaluate(heights)
        return _met_at((x, y, z), slope_x, slope_y, self._rays.alive)


class _Searching:
    """Scattered rays: the exact intersection, or that with a triangle mesh."""

    def __init__(
        self,
        rays: RayBundle,
        patches: Patches,
        subdivisions: tuple[int, int] | None,
        last: Tensor | None = None,
    ) -> None:
        lines = Bundle.of(rays)
        self._alive, self._shape = rays.alive & (rays.direction[2] > 0), lines.x.shape
        self._lines = Bundle(*(part.flatten() for part in lines))
        self._patches = patches
        self._intersection: ExactIntersection | MeshIntersection
        net = patches.net
        if subdivisions is not None:
            mesh = TriangleMesh(net, subdivisions, lines.x.dtype, lines.x.device)
            self._intersection = MeshIntersection(self._lines, mesh)
        else:
            self._intersection = ExactIntersection(self._lines, net.half_width, patches, last)

    def meet(self, heights: Tensor) -> Meeting:
        table = self._patches.table(heights)
        met: Met = self._intersection.meet(heights, table)
        x = self._lines.x + self._lines.slope_x * met.depth
        y = self._lines.y + self._lines.slope_y * met.depth
        # Polynomials overflow far beside the face, where lines end that do not meet it.
        on_x, on_y = (torch.where(met.found, c, 0.0) for c in (x, y))
        _, slope_x, slope_y = self._patches.evaluate(table, self._patches.place(on_x, on_y))
        x, y, z, slope_x, slope_y = (
            part.view(self._shape) for part in (x, y, met.depth, slope_x, slope_y)
        )
        found = met.found.view(self._shape) & self._alive
        return _met_at((x, y, z), slope_x, slope_y, found)


def _met_at(
    position: tuple[Tensor, Tensor, Tensor], slope_x: Tensor, slope_y: Tensor, met: Tensor
) -> Meeting:
    length = (slope_x.square() + slope_y.square() + 1).rsqrt()
    return Meeting(position, (-slope_x * length, -slope_y * length, length), met)
