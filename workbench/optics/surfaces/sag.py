"""Fixed faces: rotational conics and aspheres, and faces whose sag is a function in torch.

A new shape of a fixed face is a row in ``_SHAPES``: `Sag` traces any smooth function. The compiled
train knows planes and conics; rays pass other shapes in torch.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
import torch
from torch import Tensor

from workbench.geometry.outlines import Outline
from workbench.optics.rays import RayBundle
from workbench.optics.surfaces.surface import Meeting, Plane, Surface
from workbench.scene.faces import ConicFace, FixedFace, PlaneFace

SagFunction = Callable[[Tensor, Tensor], Tensor]

# Steps of Newton's method, some five are usual; a step that leads away from the face is halved.
_STEPS = 50
_ROUNDING = 64


class Sag:
    """Surface z = sag(x, y); a `Surface`.

    Parameters
    ----------
    sag : callable
        z at tensors x and y of any shape, smooth and finite also somewhat beyond the outline. It
        may depend on other tensors: gradients reach them.
    outline : Outline
        What of it is glass.
    name : str
        What it is called.
    freeform : bool
        Whether what the sag depends on may change between two walks.

    Notes
    -----
    Newton's method finds the depth t at which a ray meets the face. One more step from there has
    the derivatives of the root, by rays and by all that the sag depends on (implicit function).
    """

    kind, compiled = "sag", False

    def __init__(
        self, sag: SagFunction, outline: Outline, name: str = "sag", freeform: bool = True
    ) -> None:
        self.sag, self.outline, self.name, self.freeform = sag, outline, name, freeform

    def from_behind(self) -> "Sag":
        """See `Surface.from_behind`."""
        return Sag(lambda x, y: -self.sag(x, -y), self.outline, self.name, self.freeform)

    def meet(self, rays: RayBundle, heights: Mapping[str, Tensor]) -> Meeting:
        """Where rays meet the face; see `Surface.meet`."""
        meeting = self.meet_unbounded(rays, heights)
        x, y, _ = meeting.position
        return meeting._replace(met=meeting.met & self.outline.contains(x.detach(), y.detach()))

    def meet_unbounded(self, rays: RayBundle, heights: Mapping[str, Tensor]) -> Meeting:
        """As `meet`, also beside the outline."""
        # The search itself has gradients, also where nothing depends on parameters.
        changing = self.freeform or any(
            part.requires_grad for part in rays.position + rays.direction
        )
        with torch.set_grad_enabled(torch.is_grad_enabled() and changing):
            return self._meet(rays)

    def _meet(self, rays: RayBundle) -> Meeting:
        (x, y, z), (d_x, d_y, d_z) = rays.position, rays.direction
        forward = rays.alive & (d_z > 0)
        steep = torch.where(forward, d_z, 1.0)
        a, b = d_x / steep, d_y / steep
        # Where the ray is at z = 0, and its slopes.
        line = x - a * z, y - b * z, a, b
        shape = (line[0] + line[1] + a + b).shape
        depth, found = self._search([part.detach().expand(shape) for part in line])
        found = found & forward
        # Lost rays go along the axis: also a sag that has no value where they are has gradients.
        x, y, a, b = (torch.where(found, part, 0.0) for part in line)
        depth = torch.where(found, depth, 0.0)
        off, along_x, along_y = self._off((x, y, a, b), depth)
        with torch.no_grad():
            slope = along_x * a + along_y * b - 1
            slope = torch.where(found & (slope != 0), slope, -1.0)
        depth = torch.where(found, depth - off / slope, 0.0)
        x, y = x + a * depth, y + b * depth
        _, along_x, along_y = self._off((x, y, a, b), depth, fixed=True)
        length = (along_x.square() + along_y.square() + 1).rsqrt()
        normal = -along_x * length, -along_y * length, length
        return Meeting((x, y, depth), normal, found)

    def _search(self, line: list[Tensor]) -> tuple[Tensor, Tensor]:
        """Depths at which lines meet the face, and which of them do."""
        with torch.no_grad():
            x, y, a, b = line
            depth = self.sag(x, y) + torch.zeros_like(x)
            depth = torch.where(depth.isfinite(), depth, self.sag(0 * x, 0 * y))
            off, along_x, along_y = self._off((x, y, a, b), depth)
            whole = torch.ones_like(depth)
            for _ in range(_STEPS):
                if not bool((off.abs() > self._rounding(depth)).any()):
                    break
                step = -off / (along_x * a + along_y * b - 1)
                step = torch.where(step.isfinite(), step, 0.0)
                there, *slopes = self._off((x, y, a, b), depth + whole * step)
                good = there.abs() < off.abs()
                depth = torch.where(good, depth + whole * step, depth)
                off, along_x, along_y = (
                    torch.where(good, new, old)
                    for new, old in zip((there, *slopes), (off, along_x, along_y), strict=True)
                )
                whole = torch.where(good, (2 * whole).clamp_max(1.0), whole / 2)
            return depth, off.abs() <= self._rounding(depth)

    def _rounding(self, depth: Tensor) -> Tensor:
        size = depth.abs() + max(self.outline.half_width)
        return _ROUNDING * torch.finfo(depth.dtype).eps * size

    def _off(
        self, line: tuple[Tensor, ...], depth: Tensor, fixed: bool = False
    ) -> tuple[Tensor, Tensor, Tensor]:
        """How far the face is above a line at a depth, and the slopes of the face along x and y."""
        graph = torch.is_grad_enabled()
        x, y, a, b = line
        with torch.enable_grad():
            if not fixed:
                x, y = x + a * depth, y + b * depth
            if not x.requires_grad:
                x = x.detach().requires_grad_()
            if not y.requires_grad:
                y = y.detach().requires_grad_()
            z = self.sag(x, y) + 0 * (x + y)
            along_x, along_y = torch.autograd.grad(z.sum(), (x, y), create_graph=graph)
            off = z - depth
        if not graph:
            off = off.detach()
        return off, along_x, along_y


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

    freeform, compiled = False, True

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


_SHAPES: Mapping[type, Callable[[Any, str, float, Outline], Surface]] = {
    PlaneFace: lambda _, *placed: Plane(*placed),
    ConicFace: lambda face, name, z, outline: Conic(
        name, z, 1 / face.radius, face.conic, outline, face.coefficients
    ),
}


def fixed_surface(face: FixedFace, name: str, z: float, outline: Outline) -> Surface:
    """Return the surface of a fixed face with its vertex at a z; see `Surface` for the rest."""
    return _SHAPES[type(face)](face, name, z, outline)
