"""A bundle of rays on its way through the elements of a path."""

from typing import NamedTuple

import torch
from torch import Tensor

from workbench.geometry.frames import Frame

Vector = tuple[Tensor, Tensor, Tensor]


class RayBundle(NamedTuple):
    """Rays; it never shrinks: a ray that is lost stays, with no flux.

    All tensors broadcast against each other. Light parallel to the axis keeps x as a column, y as
    a row and one direction for all, so that a tensor grid of rays stays one.

    Attributes
    ----------
    position : tuple of three tensors
        Where the rays are, scene units; z is counted from the datum of the path.
    direction : tuple of three tensors
        Unit vectors.
    flux : Tensor
        Flux of each ray; 0 for lost ones.
    alive : Tensor of bool
        False for lost rays; their position and direction are finite stand-ins.
    """

    position: Vector
    direction: Vector
    flux: Tensor
    alive: Tensor

    def to(self, device: torch.device | str, dtype: torch.dtype) -> "RayBundle":
        """The same rays on a device, in a float type."""

        def vector(parts: Vector) -> Vector:
            x, y, z = (part.to(device, dtype) for part in parts)
            return x, y, z

        flux, alive = self.flux.to(device, dtype), self.alive.to(device)
        return RayBundle(vector(self.position), vector(self.direction), flux, alive)


def seen(rays: RayBundle, change: Frame) -> RayBundle:
    """Rays in other coordinates.

    Parameters
    ----------
    rays : RayBundle
        The rays.
    change : Frame
        Where the coordinates of the rays stand in the other ones.
    """
    if change.is_identity:
        return rays
    direction = _turned(rays.direction, change)
    return rays._replace(position=place_seen(rays.position, change), direction=direction)


def place_seen(place: Vector, change: Frame) -> Vector:
    """Places in other coordinates; see `seen`."""
    shift = change.position.tolist()
    x, y, z = (part + by for part, by in zip(_turned(place, change), shift, strict=True))
    return x, y, z


def _turned(vector: Vector, change: Frame) -> Vector:
    x, y, z = (_product(row, vector) for row in change.rotation.tolist())
    return x, y, z


def _product(row: list[float], vector: Vector) -> Tensor:
    parts = [
        part if factor == 1 else factor * part
        for factor, part in zip(row, vector, strict=True)
        if factor
    ]
    return sum(parts[1:], parts[0])


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
    rim_distance : Tensor, optional
        How far within the rim of the last face the rays meet it; see `workbench.optics.images.rim`.
    """

    column: Tensor
    row: Tensor
    rays: RayBundle
    lost: dict[str, Tensor]
    rim_distance: Tensor | None = None
