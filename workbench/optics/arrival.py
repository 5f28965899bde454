"""Light at the receiver, before it becomes an image."""

from typing import NamedTuple

from torch import Tensor

from workbench.optics.rays import RayBundle


class Arrival(NamedTuple):
    """Rays at the receiver.

    Attributes
    ----------
    column, row : Tensor
        Where they land, in pixels; infinite for rays that do not get there.
    rays : RayBundle
        The rays behind the last face; their flux is differentiable.
    lost : dict of str to Tensor
        Flux lost on the way, by its name in the light account: scalars in float64, no gradient.
    room : Tensor, optional
        How far within the rim of the last face the rays meet it; see `workbench.optics.rim`.
    """

    column: Tensor
    row: Tensor
    rays: RayBundle
    lost: dict[str, Tensor]
    room: Tensor | None = None
