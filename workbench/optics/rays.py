"""A bundle of rays on its way through the elements of a path."""

from typing import NamedTuple

from torch import Tensor

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
