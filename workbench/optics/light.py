"""What every way to trace a lens gives, be it reference or kernel."""

from collections.abc import Mapping
from typing import NamedTuple, Protocol

from torch import Tensor

from workbench.scene import Filter, Screen


class Light(NamedTuple):
    """The image of a lens, and where the rest of the light went.

    Attributes
    ----------
    flux : Tensor, shape (n_y, n_x)
        Flux in each pixel, row 0 at +y; differentiable.
    on_screen : float
        Flux of the rays that hit the scene's screen. A reconstruction filter spreads some of it
        over the rim; the account is of rays.
    lost : mapping of str to float
        Flux of all other rays, by its name in the light account.
    """

    flux: Tensor
    on_screen: float
    lost: Mapping[str, float]


class Tracer(Protocol):
    """Traces one set of rays through lens after lens."""

    @property
    def notes(self) -> list[str]:
        """What is special about it, in words."""
        ...

    def image(self, heights: Tensor, screen: Screen, filter: Filter) -> Light:
        """Trace a lens with control heights of shape (n_u, n_v)."""
        ...
