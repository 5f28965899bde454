"""A face whose sag is any function in torch."""

from collections.abc import Callable, Mapping

import torch
from torch import Tensor

from workbench.geometry.outlines import Outline
from workbench.optics.rays import RayBundle
from workbench.optics.surfaces.surface import Meeting

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

    Notes
    -----
    Newton's method finds the depth t at which a ray meets the face. One more step from there has
    the derivatives of the root, by rays and by all that the sag depends on (implicit function).
    """

    kind = "sag"
    freeform = True  # what the sag depends on may change between two walks

    def __init__(self, sag: SagFunction, outline: Outline, name: str = "sag") -> None:
        self.sag, self.outline, self.name = sag, outline, name

    def from_behind(self) -> "Sag":
        """See `Surface.from_behind`."""
        return Sag(lambda x, y: -self.sag(x, -y), self.outline, self.name)

    def meet(self, rays: RayBundle, heights: Mapping[str, Tensor]) -> Meeting:
        """Where rays meet the face; see `Surface.meet`."""
        meeting = self.meet_unbounded(rays, heights)
        x, y, _ = meeting.position
        return meeting._replace(met=meeting.met & self.outline.contains(x.detach(), y.detach()))

    def meet_unbounded(self, rays: RayBundle, heights: Mapping[str, Tensor]) -> Meeting:
        """As `meet`, also beside the outline."""
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
