"""Where rays in the lens meet the exit face.

Along a ray of depth t below the entrance face the face is met where
f(t) = Z(x(t), y(t)) − z_in − t = 0. By the convex-hull property f is not negative where the ray
is at the height of the lowest control point, and not positive at that of the highest, so the root
is bracketed unless the ray leaves through the side before.

*Exact*: Newton's method, safeguarded by the bracket, from the root of the last lens. The gradient
comes from the implicit function theorem, not through the iterations. Where f may have more than
one root (the slopes of face and ray together exceed 1), steps that no Lipschitz function can take
too far lead to the first.
"""

from typing import NamedTuple

import torch
from torch import Tensor

from workbench.geometry.patches import Patches

_NEWTON_STEPS = 30
_MARCH_STEPS = 200


class Bundle(NamedTuple):
    """Rays behind the entrance face, all of shape (m,): start, slopes dx/dz, dy/dz, flux."""

    x: Tensor
    y: Tensor
    slope_x: Tensor
    slope_y: Tensor
    flux: Tensor


class Met(NamedTuple):
    """Where rays meet the exit face.

    Attributes
    ----------
    depth : Tensor, shape (m,)
        Height above the entrance face; differentiable with respect to the table of patches.
    found : Tensor of bool, shape (m,)
        False for rays that leave through the side; their depth is a stand-in.
    """

    depth: Tensor
    found: Tensor


class ExactIntersection:
    """Finds roots for one set of rays again and again, while the lens changes a little.

    Parameters
    ----------
    bundle : Bundle
        The rays.
    half_width : tuple[float, float]
        Half-widths of the aperture.
    patches : Patches
        Evaluates the face; heights in its tables are counted from the entrance face.
    """

    def __init__(self, bundle: Bundle, half_width: tuple[float, float], patches: Patches) -> None:
        self._bundle = bundle
        self._patches = patches
        self._side = _depth_of_side(bundle, half_width)
        self._steepest = (
            bundle.slope_x.abs().max().item() if len(bundle.x) else 0.0,
            bundle.slope_y.abs().max().item() if len(bundle.x) else 0.0,
        )
        self._last: Tensor | None = None

    def meet(self, heights: Tensor, table: Tensor) -> Met:
        """Roots for a lens.

        Parameters
        ----------
        heights : Tensor, shape (n_u, n_v)
            Control heights above the entrance face.
        table : Tensor
            Their table of patches.
        """
        with torch.no_grad():
            depth, found = self._search(heights.detach(), table.detach())
            self._last = depth
        # One step of Newton's method with a constant slope: it moves the depth by rounding at
        # most, and its derivative is that of the root.
        f, slope = self._f(table, depth)
        depth = depth - torch.where(found, f / slope.detach(), 0.0)
        return Met(depth, found)

    def _f(self, table: Tensor, depth: Tensor) -> tuple[Tensor, Tensor]:
        bundle, patches = self._bundle, self._patches
        place = patches.place(bundle.x + bundle.slope_x * depth, bundle.y + bundle.slope_y * depth)
        z, z_x, z_y = patches.evaluate(table, place)
        return z - depth, z_x * bundle.slope_x + z_y * bundle.slope_y - 1

    def _search(self, heights: Tensor, table: Tensor) -> tuple[Tensor, Tensor]:
        dtype = self._bundle.x.dtype
        lowest, highest = heights.min().to(dtype), heights.max().to(dtype)
        low = torch.full_like(self._side, lowest.item())
        high = torch.minimum(self._side, highest)
        leaves_early = self._side < lowest
        lipschitz = 1 + self._slope_bound(heights)
        if lipschitz >= 2:
            low = self._march(table, low, high, lipschitz)
        # A ray that the side cuts off meets the face before it only where f is not positive there.
        f_high, _ = self._f(table, high)
        f_low, _ = self._f(table, low)
        found = ~leaves_early & ((f_high <= 0) | (f_low <= 0))

        start = (low + high) / 2 if self._last is None else self._last
        depth = torch.minimum(torch.maximum(start, low), high)
        tolerance = 4 * torch.finfo(dtype).eps * max(abs(lowest.item()), abs(highest.item()))
        for _ in range(_NEWTON_STEPS):
            f, slope = self._f(table, depth)
            above = f > 0
            low = torch.where(above, depth, low)
            high = torch.where(above, high, depth)
            step = depth - f / slope
            inside = (step >= low) & (step <= high) & (slope < 0)
            new = torch.where(inside, step, (low + high) / 2)
            moved = torch.where(found, (new - depth).abs(), 0.0).max() if len(new) else 0.0
            depth = new
            if moved <= tolerance:
                break
        return depth, found

    def _slope_bound(self, heights: Tensor) -> float:
        """The most that the face can rise under a ray, per depth, from its control polygon."""
        steepest_x, steepest_y = self._patches.slope_bounds(heights)
        return steepest_x * self._steepest[0] + steepest_y * self._steepest[1]

    def _march(self, table: Tensor, low: Tensor, high: Tensor, lipschitz: float) -> Tensor:
        """Walk up from below without passing the first root; close to it where there is one."""
        depth = low
        for _ in range(_MARCH_STEPS):
            f, _ = self._f(table, depth)
            step = torch.minimum(depth + (f / lipschitz).clamp_min(0), high)
            if bool((step - depth <= 1e-3 * (high - low)).all()):
                return step
            depth = step
        return depth


def _depth_of_side(bundle: Bundle, half_width: tuple[float, float]) -> Tensor:
    """Depth at which each ray leaves the aperture; infinite for rays along the axis."""
    depth = torch.full_like(bundle.x, torch.inf)
    for start, slope, r in zip(
        (bundle.x, bundle.y), (bundle.slope_x, bundle.slope_y), half_width, strict=True
    ):
        room = torch.where(slope > 0, r - start, start + r)
        reach = torch.where(slope == 0, torch.inf, room / slope.abs().clamp_min(1e-300))
        depth = torch.minimum(depth, reach)
    return depth
