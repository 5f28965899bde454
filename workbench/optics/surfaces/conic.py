"""A conic of revolution about the axis, with aspheric terms and an outline."""

import math
from collections.abc import Mapping, Sequence

import numpy as np
import torch
from torch import Tensor

from workbench.geometry.outlines import Outline
from workbench.optics.rays import RayBundle
from workbench.optics.surfaces.surface import Meeting

# Steps of Newton's method to an asphere, some four are usual; after these bisection goes on.
_NEWTON_STEPS, _BISECTIONS = 20, 60
# The aspheric sag is defined so much beyond the outline, where the conic itself is.
_BEYOND, _WITHIN = 1.01, 1 - 1e-6
# Places along the radius where its least and its greatest sag are looked for.
_PLACES = 1000


class Conic:
    """Surface z = c r² / (1 + √(1 − (1 + k) c² r²)) + a₄ r⁴ + a₆ r⁶ + … about its vertex.

    A `Surface`. The sag is that of ISO 10110-12.

    `name`: what it is called; `z`: where its vertex is, counted from the origin of its frame;
    `curvature`: c, one over the radius: positive where the centre of curvature lies on the +z side;
    `conic`: the conic constant k: 0 of a sphere, −1 of a paraboloid; `outline`: what of it is
    glass; `coefficients`: a₄, a₆, …; none of a conic. `reach2`: greatest r² of an asphere that rays
    meet: a little beyond the outline; `low`, `high`: its sag is between these up to there.

    Notes
    -----
    The intersection with a conic is in closed form: W. T. Welford, *Aberrations of Optical Systems*
    (1986), section 4.3. That with an asphere begins there, and takes steps of Newton's method that
    are safeguarded by a bracket. For the search the sag stays as it is beyond ``reach2``, so that
    each line has a root between ``low`` and ``high``.
    """

    freeform = False

    def __init__(
        self,
        name: str,
        z: float,
        curvature: float,
        conic: float,
        outline: Outline,
        coefficients: Sequence[float] = (),
    ) -> None:
        self.name, self.outline = name, outline
        self.z, self.curvature, self.conic = z, curvature, conic
        self.coefficients = tuple(coefficients) if any(coefficients) else ()
        self.kind = "asphere" if self.coefficients else "conic"
        r_x, r_y = outline.half_width
        farthest = math.hypot(r_x, r_y) if outline.whole else max(r_x, r_y)
        bent = (1 + conic) * curvature**2
        self.reach2 = min(_BEYOND * farthest**2, _WITHIN / bent if bent > 0 else math.inf)
        r2 = torch.as_tensor(np.linspace(0, self.reach2, _PLACES))
        sag, _ = self._sag(r2)
        margin = 0.01 * float(sag.max() - sag.min())
        self.low, self.high = float(sag.min()) - margin, float(sag.max()) + margin

    def from_behind(self) -> "Conic":
        """See `Surface.from_behind`."""
        coefficients = [-each for each in self.coefficients]
        return Conic(self.name, -self.z, -self.curvature, self.conic, self.outline, coefficients)

    def tolerance(self, dtype: torch.dtype) -> float:
        """A step of the search as small as this is rounding."""
        size = max(abs(self.low), abs(self.high), math.sqrt(self.reach2))
        return 4 * torch.finfo(dtype).eps * size

    def meet(self, rays: RayBundle, heights: Mapping[str, Tensor]) -> Meeting:
        """Where rays meet the conic; see `Surface.meet`."""
        meeting = self.meet_unbounded(rays, heights)
        x, y, _ = meeting.position
        return meeting._replace(met=meeting.met & self.outline.contains(x, y))

    def meet_unbounded(self, rays: RayBundle, heights: Mapping[str, Tensor]) -> Meeting:
        """As `meet`, also beside the outline."""
        (x, y, z), (d_x, d_y, d_z) = rays.position, rays.direction
        forward = d_z > 0
        steep = torch.where(forward, d_z, 1.0)
        a, b = d_x / steep, d_y / steep
        x, y = x + a * (self.z - z), y + b * (self.z - z)
        depth, there = self._conic_depth(x, y, a, b)
        if self.coefficients:
            depth = self._aspheric_depth((x, y, a, b), depth)
        x, y = x + a * depth, y + b * depth
        r2 = x.square() + y.square()
        k_1, c = 1 + self.conic, self.curvature
        rest = 1 - k_1 * c**2 * r2
        if self.coefficients:
            there = r2 <= self.reach2
        else:
            there = there & (rest > 0) & (1 - k_1 * c * depth > 0)
        there = there & forward
        r2, on_x, on_y = (torch.where(there, part, 0.0) for part in (r2, x, y))
        _, rise = self._sag(r2)
        length = (1 + 4 * rise.square() * r2).rsqrt()
        normal = -2 * rise * on_x * length, -2 * rise * on_y * length, length
        return Meeting((x, y, depth + self.z), normal, rays.alive & there)

    def _sag(self, r2: Tensor) -> tuple[Tensor, Tensor]:
        """Sag, and its derivative by r²."""
        c = self.curvature
        root = (1 - (1 + self.conic) * c**2 * r2).sqrt()
        sag, rise = c * r2 / (1 + root), c / (2 * root)
        q, q_1 = torch.zeros_like(r2), torch.zeros_like(r2)
        for each in reversed(self.coefficients):
            q, q_1 = q * r2 + each, q_1 * r2 + q
        return sag + r2.square() * q, rise + 2 * r2 * q + r2.square() * q_1

    def _conic_depth(self, x: Tensor, y: Tensor, a: Tensor, b: Tensor) -> tuple[Tensor, Tensor]:
        """Depth at which lines meet the conic without its aspheric terms, and which of them do."""
        c, k_1 = self.curvature, 1 + self.conic
        half = 1 - c * (a * x + b * y)
        first = c * (x.square() + y.square())
        square = half.square() - c * (a.square() + b.square() + k_1) * first
        there = square > 0
        root = half + torch.where(there, square, 1.0).sqrt()
        there = there & (root > 0)
        return torch.where(there, first / torch.where(there, root, 1.0), 0.0), there

    def _aspheric_depth(self, line: tuple[Tensor, Tensor, Tensor, Tensor], start: Tensor) -> Tensor:
        """Depth at which lines meet the asphere; the derivative is that of the root."""
        with torch.no_grad():
            depth = self._search([part.detach() for part in line], start.detach())
        f, slope = self._f(line, depth)
        return depth - f / slope.detach().clamp_max(-1e-3)

    def _search(self, line: Sequence[Tensor], start: Tensor) -> Tensor:
        tolerance = self.tolerance(start.dtype)
        depth = start.clamp(self.low, self.high)
        low, high = torch.full_like(depth, self.low), torch.full_like(depth, self.high)
        for number in range(_NEWTON_STEPS + _BISECTIONS):
            f, slope = self._f(line, depth)
            low, high = torch.where(f > 0, depth, low), torch.where(f > 0, high, depth)
            step = depth - f / slope
            good = (step - depth).abs() <= tolerance
            if number < _NEWTON_STEPS:
                good = good | ((step > low) & (step < high))
            new = torch.where(good, step, (low + high) / 2)
            moved = (new - depth).abs().max().item() if new.numel() else 0.0
            depth = new
            if moved <= tolerance:
                break
        return depth

    def _f(self, line: Sequence[Tensor], depth: Tensor) -> tuple[Tensor, Tensor]:
        """How far the face is above the line, and how this changes with the depth."""
        x, y, a, b = line
        x, y = x + a * depth, y + b * depth
        r2 = x.square() + y.square()
        within = r2 <= self.reach2
        sag, rise = self._sag(torch.where(within, r2, self.reach2))
        slope = 2 * rise * (a * x + b * y)
        return sag - depth, torch.where(within, slope, 0.0) - 1
