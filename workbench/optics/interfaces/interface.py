"""What every interface does."""

from collections.abc import Mapping
from typing import NamedTuple, Protocol

from torch import Tensor

from workbench.optics.rays import RayBundle
from workbench.optics.surfaces.surface import Meeting


class Passed(NamedTuple):
    """Light behind an interface.

    Attributes
    ----------
    rays : RayBundle
        It starts where the light met the face.
    lost : mapping of str to Tensor
        Flux that each ray lost, by its name in the light account.
    """

    rays: RayBundle
    lost: Mapping[str, Tensor]


class Interface(Protocol):
    """Turns rays that have met a face, and takes its share of their flux."""

    def turn(self, rays: RayBundle, meeting: Meeting) -> Passed:
        """The light that goes on.

        Parameters
        ----------
        rays : RayBundle
            Before the face.
        meeting : Meeting
            Where they meet it.
        """
        ...
