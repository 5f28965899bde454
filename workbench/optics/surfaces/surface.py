"""What every surface does; and planes across the axis."""

from collections.abc import Mapping
from typing import NamedTuple, Protocol

import torch
from torch import Tensor

from workbench.geometry.outlines import Outline
from workbench.optics.rays import RayBundle, Vector


class Meeting(NamedTuple):
    """Where rays meet a surface; tensors that broadcast against those of the rays.

    Attributes
    ----------
    position : tuple of three tensors
        Places on the surface; of rays that do not meet it finite stand-ins.
    normal : tuple of three tensors
        Unit normals there, with a positive z.
    met : Tensor of bool
        Whether a ray meets the surface within its outline.
    """

    position: Vector
    normal: Vector
    met: Tensor


class Surface(Protocol):
    """A face that rays meet.

    Attributes
    ----------
    name : str
        What its heights are called; one name for each surface of a path.
    kind : str
        What it is, in words.
    freeform : bool
        Whether it depends on control heights; rays before the first such surface stay as they are
        during a run.
    compiled : bool
        Whether the compiled train knows it; else rays meet it by `meet` alone.
    outline : Outline
        What of it is glass; centred on the axis of its frame.
    """

    name: str
    kind: str
    freeform: bool
    compiled: bool
    outline: Outline

    def meet(self, rays: RayBundle, heights: Mapping[str, Tensor]) -> Meeting:
        """Where rays meet the surface.

        Parameters
        ----------
        rays : RayBundle
            The rays.
        heights : mapping of str to Tensor
            Control heights (n_u, n_v) of the freeform surfaces by name, z counted as in the scene.
        """
        ...

    def meet_unbounded(self, rays: RayBundle, heights: Mapping[str, Tensor]) -> Meeting:
        """As `meet`, also where the outline would cut the surface off."""
        ...

    def from_behind(self) -> "Surface":
        """The same surface in a frame that is turned by 180° about its x; names stay."""
        ...


class Plane:
    """Plane at one z; a `Surface`.

    `name`: what it is called; `z`: where it is, counted from the origin of its frame; `outline`:
    what of the plane is glass.
    """

    kind = "plane"
    freeform = False
    compiled = True

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
