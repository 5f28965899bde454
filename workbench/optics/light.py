"""What every way to trace a lens gives, be it reference or kernel."""

from collections.abc import Sequence
from typing import NamedTuple, Protocol

from torch import Tensor

from workbench.scene import Filter, Screen


class Light(NamedTuple):
    """The image of a lens, and the light that was lost on the way from the exit face.

    Attributes
    ----------
    flux : Tensor, shape (n_y, n_x)
        Flux in each pixel, row 0 at +y; differentiable.
    on_screen, off_screen : float
        Flux of the rays that hit the scene's screen, and of those that go beside it. A
        reconstruction filter spreads some of it over the rim; the account is of rays.
    total_reflection, fresnel_exit : float
        Flux reflected at the exit face, totally or where the rest was refracted.
    left_side : float
        Flux that left the lens through its side.
    """

    flux: Tensor
    on_screen: float
    off_screen: float
    total_reflection: float
    fresnel_exit: float
    left_side: float


def sum_of(lights: Sequence[Light]) -> Light:
    """The light of several sets of rays."""
    return Light(*(sum(each[1:], each[0]) for each in zip(*lights, strict=True)))


class Tracer(Protocol):
    """Traces one set of rays through lens after lens."""

    @property
    def emitted(self) -> float:
        """Flux of the source."""
        ...

    @property
    def missed_lens(self) -> float:
        """Flux that passes the entrance face by."""
        ...

    @property
    def fresnel_entrance(self) -> float:
        """Flux reflected at the entrance face."""
        ...

    def image(self, heights: Tensor, screen: Screen, filter: Filter) -> Light:
        """Trace a lens with control heights of shape (n_u, n_v)."""
        ...
