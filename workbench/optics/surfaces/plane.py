"""A plane across the axis, with an outline."""

from collections.abc import Mapping

import torch
from torch import Tensor

from workbench.geometry.outlines import Outline
from workbench.optics.rays import RayBundle
from workbench.optics.surfaces.surface import Meeting


class Plane:
    """Plane at one z; a `Surface`.

    `name`: what it is called; `z`: where it is, counted from the origin of its frame; `outline`:
    what of the plane is glass.
    """

    kind = "plane"
    freeform = False

    def __init__(self, name: str, z: float, outline: Outline) -> None:
        self.name = name
        self.z, self.outline = z, outline

    def meet(self, rays: RayBundle, heights: Mapping[str, Tensor]) -> Meeting:
        """Where rays meet the plane; see `Surface.meet`."""
        meeting = self.meet_unbounded(rays, heights)
        x, y, _ = meeting.position
        return meeting._replace(met=meeting.met & self.outline.contains(x, y))

    def meet_unbounded(self, rays: RayBundle, heights: Mapping[str, Tensor]) -> Meeting:
        """As `meet`, also beside the outline."""
        (x, y, z), (d_x, d_y, d_z) = rays.position, rays.direction
        forward = d_z > 0
        way = torch.where(forward, (self.z - z) / torch.where(forward, d_z, 1.0), 0.0)
        x, y = x + way * d_x, y + way * d_y
        met = rays.alive & forward
        zero, one = torch.zeros_like(d_z), torch.ones_like(d_z)
        return Meeting((x, y, torch.full_like(d_z, self.z)), (zero, zero, one), met)

    def from_behind(self) -> "Plane":
        """See `Surface.from_behind`."""
        return Plane(self.name, -self.z, self.outline)
