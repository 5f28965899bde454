"""Where rays meet a B-spline face.

Along a ray at depth t above z = 0 (the entrance face or another datum) the face is met where
f(t) = Z(x(t), y(t)) − t = 0. By the convex-hull property f is not negative where the ray is at the
height of the lowest control point, and not positive at that of the highest. So the root is
bracketed, unless the ray leaves through the side before, or comes in over it later.

Where the slopes of face and ray say that f can only fall: Newton's method, safeguarded by the
bracket, from the root of the last lens. Elsewhere f may have several roots, and the first counts:
the search walks up in steps that the bounds of f' and f'' prove not to pass a root. The gradient
comes from the implicit function theorem.

`workbench.optics.surfaces.mesh` has the triangle mesh of the paper.
"""

from typing import NamedTuple

import torch
from torch import Tensor

from workbench.geometry.patches import Patches
from workbench.optics.rays import RayBundle

RIM = 1 + 1e-6
"""Rays meet the face up to here, in half-widths: by rounding those at its rim are beside it."""

# Newton's method needs some four steps; where it has not come to rest after these, bisection does.
_NEWTON_STEPS, _BISECTIONS = 20, 60
# A walk takes some ten steps, along a degree-1 face (whose f' jumps) some hundred.
_WALK_STEPS = 2000
# f counts as falling where it surely falls at least this fast.
_FALLS = 0.1


class Bundle(NamedTuple):
    """Rays as lines, all of shape (m,): where they cross z = 0, slopes dx/dz, dy/dz, and flux."""

    x: Tensor
    y: Tensor
    slope_x: Tensor
    slope_y: Tensor
    flux: Tensor

    @classmethod
    def of(cls, rays: RayBundle) -> "Bundle":
        """The lines of rays to +z; of those that are lost, or go elsewhere, some finite line."""
        (x, y, z), (d_x, d_y, d_z) = rays.position, rays.direction
        d_z = torch.where(d_z > 0, d_z, 1.0)
        slope_x, slope_y = d_x / d_z, d_y / d_z
        lines = x - slope_x * z, y - slope_y * z, slope_x, slope_y, rays.flux
        shape = (lines[0] + lines[1]).shape  # parallel light has one direction for all
        return cls(*(part.expand(shape) for part in lines))


class Met(NamedTuple):
    """Where rays meet a face."""

    # (m,), height above z = 0; differentiable with respect to the table of patches and the rays.
    depth: Tensor
    found: Tensor  # (m,), False for rays that leave through the side; their depth is a stand-in


class ExactIntersection:
    """Finds roots for one set of rays again and again, while the lens changes a little.

    `half_width`: half-widths of the aperture; `patches`: evaluates the face; heights in its tables
    are counted from where the rays cross z = 0; `last` (m,): depths at which to begin: those of
    almost the same rays on almost the same face.
    """

    def __init__(
        self,
        bundle: Bundle,
        half_width: tuple[float, float],
        patches: Patches,
        last: Tensor | None = None,
    ) -> None:
        self._bundle = bundle
        self._patches = patches
        with torch.no_grad():  # how far a search goes does not move what it finds
            self._enters, self._side = _depths_of_side(bundle, half_width)
        known = last is not None and last.shape == bundle.x.shape
        self._last = last if known else None

    def meet(self, heights: Tensor, table: Tensor) -> Met:
        """Roots for a lens.

        `heights` (n_u, n_v): control heights above z = 0; `table`: their table of patches.
        """
        with torch.no_grad():
            depth, found = self._search(heights.detach(), table.detach())
            self._last = depth
        # One step of Newton's method with a constant slope: it moves the depth by rounding at
        # most, and its derivative is that of the root. Rays that graze the face, where the slope
        # vanishes, are totally reflected there and need but a finite stand-in.
        # Polynomials of faces overflow where lines end that pass far beside them.
        meeting = Bundle(*(torch.where(found, part, 0.0) for part in self._bundle))
        f, slope = self._f(table, meeting, depth)
        depth = depth - torch.where(found, f / slope.detach().clamp_max(-1e-3), 0.0)
        return Met(depth, found)

    def _f(self, table: Tensor, bundle: Bundle, depth: Tensor) -> tuple[Tensor, Tensor]:
        patches = self._patches
        place = patches.place(bundle.x + bundle.slope_x * depth, bundle.y + bundle.slope_y * depth)
        z, z_x, z_y = patches.evaluate(table, place)
        return z - depth, z_x * bundle.slope_x + z_y * bundle.slope_y - 1

    def _search(self, heights: Tensor, table: Tensor) -> tuple[Tensor, Tensor]:
        bundle, dtype = self._bundle, self._bundle.x.dtype
        lowest, highest = heights.min().item(), heights.max().item()
        tolerance = 4 * torch.finfo(dtype).eps * max(abs(lowest), abs(highest))
        # Wider than the hull by more than the rounding of f, which then has its signs at the ends.
        low = self._enters.clamp_min(lowest - 8 * tolerance)
        high = self._side.clamp(min(lowest, 0.0), highest + 8 * tolerance)
        last = (low + high) / 2 if self._last is None else self._last

        bound_x, bound_y = self._patches.slope_bounds(heights)
        rise = bound_x * bundle.slope_x.abs() + bound_y * bundle.slope_y.abs()
        depth, found = high.clone(), (self._side >= lowest) & (low <= high)
        # A ray that comes in over the rim above the face there passes behind it.
        late = (found & (low > lowest)).nonzero().squeeze(1)
        found[late] = self._f(table, _take(bundle, late), low[late])[0] > 0
        falls = found & (rise < 1 - _FALLS)
        # A ray that the side cuts off meets the face before it only where f is not positive there.
        cut = (falls & (self._side <= highest)).nonzero().squeeze(1)
        found[cut] = self._f(table, _take(bundle, cut), high[cut])[0] <= 0

        for part, method in ((falls & found, self._newton), (found & ~falls, self._walk)):
            rays = part.nonzero().squeeze(1)
            if len(rays):
                few = (_take(bundle, rays), low[rays], high[rays], last[rays])
                depth[rays], found[rays] = method(table, heights, *few, tolerance)
        return depth, found

    def _newton(
        self,
        table: Tensor,
        heights: Tensor,
        bundle: Bundle,
        low: Tensor,
        high: Tensor,
        start: Tensor,
        tolerance: float,
    ) -> tuple[Tensor, Tensor]:
        """The root of each ray between low and high, where f falls all the way."""
        depth = torch.minimum(torch.maximum(start, low), high)
        for number in range(_NEWTON_STEPS + _BISECTIONS):
            f, slope = self._f(table, bundle, depth)
            above = f > 0
            low = torch.where(above, depth, low)
            high = torch.where(above, high, depth)
            step = depth - f / slope
            # An end of the bracket is no new place: a step to it may go to and fro for ever.
            good = ((step > low) & (step < high)) | ((step - depth).abs() <= tolerance)
            if number >= _NEWTON_STEPS:
                good = (step - depth).abs() <= tolerance
            new = torch.where(good, step, (low + high) / 2)
            moved = (new - depth).abs().max().item()
            depth = new
            if moved <= tolerance:
                break
        return depth, torch.ones_like(low, dtype=torch.bool)

    def _walk(
        self,
        table: Tensor,
        heights: Tensor,
        bundle: Bundle,
        low: Tensor,
        high: Tensor,
        start: Tensor,
        tolerance: float,
    ) -> tuple[Tensor, Tensor]:
        """The first root of each ray between low and high, and where there is one.

        With f' ≥ −L and f'' ≥ −M ahead, f stays positive for f / L, and for as long as the parabola
        f + f' δ − M δ² / 2 does. The second step is that of Newton's method close to a root.
        """
        (bound_x, bound_y) = self._patches.slope_bounds(heights)
        curvature_xx, curvature_xy, curvature_yy = self._patches.curvature_bounds(heights)
        eps = torch.finfo(low.dtype).eps  # keeps a product with an infinite bound infinite
        across, up = bundle.slope_x.abs().clamp_min(eps), bundle.slope_y.abs().clamp_min(eps)
        steepest = 1 + bound_x * across + bound_y * up
        curvature = curvature_xx * across * across + 2 * curvature_xy * across * up
        curvature = curvature + curvature_yy * up * up
        found = torch.zeros_like(low, dtype=torch.bool)
        depth = low.clone()
        on = torch.arange(len(low), device=low.device)
        for _ in range(_WALK_STEPS):
            here = depth[on]
            f, slope = self._f(table, _take(bundle, on), here)
            parabola = 2 * f / ((slope.square() + 2 * curvature[on] * f).sqrt() - slope)
            step = torch.maximum(f / steepest[on], parabola)
            arrived = (f <= 0) | (step <= tolerance)
            found[on] = arrived
            depth[on] = torch.where(f > 0, torch.minimum(here + step, high[on]), here)
            on = on[~arrived & (here < high[on])]
            if not len(on):
                break
        return depth, found


def _take(bundle: Bundle, rays: Tensor) -> Bundle:
    return Bundle(*(part[rays] for part in bundle))


def _depths_of_side(bundle: Bundle, half_width: tuple[float, float]) -> tuple[Tensor, Tensor]:
    """Depths at which each ray comes in over the aperture, and leaves it.

    Infinite for rays along the axis; those that are never over it leave before they come in.
    """
    enters, leaves = (torch.full_like(bundle.x, end) for end in (-torch.inf, torch.inf))
    for start, slope, r in zip(
        (bundle.x, bundle.y), (bundle.slope_x, bundle.slope_y), half_width, strict=True
    ):
        along = torch.where(slope < 0, -start, start)
        steep, beside = slope.abs().clamp_min(1e-300), start.abs() > r * RIM
        first = torch.where(beside, torch.inf, -torch.inf)
        enters = enters.maximum(torch.where(slope == 0, first, (-r * RIM - along) / steep))
        leaves = leaves.minimum(torch.where(slope == 0, torch.inf, (r * RIM - along) / steep))
    return enters, leaves
