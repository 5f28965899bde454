"""The aperture of an optic: what of the light of a sample of the first face comes through it.

The light of a source is what passes the outline of the optic in the plane of its front vertex,
`Element.front_z`. A face that is not in that plane is lit by these rays alone,
before and behind the plane: other rays miss the optic. The compiled twin is
`workbench.optics.kernels.aperture`.
"""

import torch
from torch import Tensor

# In the middle of the aperture no distance to the outline has a direction.
_CENTRE = 1e-12


def seen(low: Tensor, high: Tensor, begin: Tensor | float, end: Tensor | float) -> Tensor:
    """Length of what of intervals lies between two ends."""
    return (high.clamp(max=end) - low.clamp(min=begin)).clamp(min=0)


def part_within(
    here: tuple[Tensor, Tensor],
    crossing: tuple[Tensor, Tensor],
    size: tuple[Tensor, Tensor],
    half_width: tuple[float, float],
) -> Tensor:
    """Part of what an elliptic outline holds of each sample whose light it lets through.

    Exactly 1 of light that goes straight on.

    `here`, `crossing`: x and y of samples, and of where their light crosses the aperture, scene
    units; `size`: widths along x and y of what the samples stand for; `half_width`: semi-axes of
    the outline.
    """
    holds = _held(*here, size, half_width)
    part = _held(*crossing, size, half_width) / torch.where(holds > 0, holds, 1.0)
    return torch.where(holds > 0, part.clamp_max(1), 1.0)


def _held(
    x: Tensor, y: Tensor, size: tuple[Tensor, Tensor], half_width: tuple[float, float]
) -> Tensor:
    """About how much of what a sample stands for is inside the outline around (x, y)."""
    (wide, high), (r_x, r_y) = size, half_width
    level = ((x / r_x).square() + (y / r_y).square()).clamp_min(_CENTRE).sqrt()
    across = (x.abs() * wide / r_x**2 + y.abs() * high / r_y**2).clamp_min(_CENTRE)
    return (0.5 + level * (1 - level) / across).clamp(0, 1)
