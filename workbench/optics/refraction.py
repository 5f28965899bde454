"""Refraction and reflection at one face. A vector is a tuple of three tensors."""

from typing import NamedTuple

import torch
from torch import Tensor

Vector = tuple[Tensor, Tensor, Tensor]


class Refracted(NamedTuple):
    """What happens to rays at a face."""

    # Unit directions of the refracted rays; of totally reflected ones a finite stand-in.
    direction: Vector
    # Cosines of the angles of incidence and refraction; cos_out is 1 under total reflection.
    cos_in: Tensor
    cos_out: Tensor
    passes: Tensor  # False where the ray is totally reflected


def refract(direction: Vector, normal: Vector, ratio: float) -> Refracted:
    """Vector form of Snell's law.

    `direction`: unit directions of the incoming rays; `normal`: unit normals that point the way the
    light goes (positive product with ``direction``); `ratio`: refractive index before the face over
    that behind it.

    Notes
    -----
    t = η d + (cos θ_t − η cos θ_i) N. The factor of N is taken as (1 − η²) / (cos θ_t + η cos θ_i),
    the same number without the cancellation that costs all digits as η goes to 1.
    """
    (d_x, d_y, d_z), (n_x, n_y, n_z) = direction, normal
    cos_in = d_x * n_x + d_y * n_y + d_z * n_z
    cos_out, passes = root_where_positive(1 - ratio**2 * (1 - cos_in.square()))
    along = (1 - ratio**2) / (cos_out + ratio * cos_in)
    out = (ratio * d_x + along * n_x, ratio * d_y + along * n_y, ratio * d_z + along * n_z)
    return Refracted(out, cos_in, cos_out, passes)


def root_where_positive(square: Tensor) -> tuple[Tensor, Tensor]:
    """Square root where a squared cosine is positive, and where that is.

    Within rounding of the critical angle no light passes (its weight is 0 there), which keeps
    the slope of the root finite; masked rays get the root 1 and with it no gradient.
    """
    positive = square > 16 * torch.finfo(square.dtype).eps
    return torch.where(positive, square, 1.0).sqrt(), positive
