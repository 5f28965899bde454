"""Rays on the screen plane, and what became of the others."""

from typing import NamedTuple

from torch import Tensor


class Hits(NamedTuple):
    """Rays on the screen plane; tensors of any one shape.

    Attributes
    ----------
    x, y : Tensor
        Where they hit, scene units; infinite for rays that do not get there.
    weight : Tensor
        Flux that left the exit face; 0 under total reflection.
    arriving : Tensor
        Flux before the exit face; 0 for rays that never met it.
    passes : Tensor of bool
        False under total reflection.
    left_side : Tensor, scalar
        Flux of rays that left the lens through its side.
    """

    x: Tensor
    y: Tensor
    weight: Tensor
    arriving: Tensor
    passes: Tensor
    left_side: Tensor
