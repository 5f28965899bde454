"""What every surface does."""

from collections.abc import Mapping
from typing import NamedTuple, Protocol

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
    outline : Outline
        What of it is glass; centred on the axis of its frame.
    """

    name: str
    kind: str
    freeform: bool
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
