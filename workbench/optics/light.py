"""What every way to trace a lens gives, be it reference or kernel."""

from collections.abc import Iterable, Mapping
from typing import NamedTuple, Protocol

import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.optics.account import Account
from workbench.scene import Filter


class Light(NamedTuple):
    """The image of a lens, and where its light went."""

    flux: Tensor  # (n_y, n_x), flux in each pixel, row 0 at +y; differentiable
    account: Account  # the account of all light, with the scene's own screen


def sum_of_lines(lights: Iterable[tuple[float, Light]]) -> Light:
    """Sum of the light of all lines of a scene: of each its part of the flux, and its light."""
    lines = list(lights)
    if len(lines) == 1:
        return lines[0][1]
    flux = torch.stack([part * light.flux for part, light in lines]).sum(0)
    on_screen = sum(part * light.account.on_screen for part, light in lines)
    names = dict.fromkeys(name for _, light in lines for name in light.account.lost)
    lost = {
        name: sum(part * light.account.lost.get(name, 0.0) for part, light in lines)
        for name in names
    }
    return Light(flux, Account(on_screen, lost))


class Nodes(NamedTuple):
    """Where the corners of cells of light land, before they become an image."""

    # (3, n, m), what `workbench.optics.images.beams.beam_image` takes, with columns and rows of the
    # scene's screen; differentiable.
    hits: Tensor
    # The account of all light; what lands is light on the screen there, even if it lands beside it.
    account: Account
    # (n, m), distance within the rim of the last face, see `workbench.optics.images.rim`; where it
    # may cut cells.
    rim_distance: Tensor | None = None


class BeamTracer(Protocol):
    """Traces corners of cells of light; see `workbench.optics.images.beams`."""

    @property
    def notes(self) -> list[str]:
        """What is special about it, in words."""
        ...

    @property
    def mirrored(self) -> tuple[bool, bool]:
        """Whether the nodes are one half of all in x, in y, and the others their mirror images."""
        ...

    @property
    def splits(self) -> tuple[Array, Array]:
        """What `workbench.optics.images.beams.beam_image` takes."""
        ...

    def nodes(self, heights: Mapping[str, Tensor]) -> Nodes:
        """Trace a lens with control heights of shape (n_u, n_v)."""
        ...


class Tracer(Protocol):
    """Traces one set of rays through lens after lens."""

    @property
    def notes(self) -> list[str]:
        """What is special about it, in words."""
        ...

    def image(self, heights: Mapping[str, Tensor], filter: Filter) -> Light:
        """Trace a lens with control heights (n_u, n_v) of each freeform face, by its name."""
        ...
