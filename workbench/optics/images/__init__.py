"""Image reconstruction: spreads the light of each ray over the pixels around its hit.

Every ray's weight is conserved; one near the rim leaves a part of it beside the image.
De Koning et al. (2023), section 2.3; Pharr, Jakob, Humphreys (2016), section 7.8.
"""

import torch
from torch import Tensor

from workbench.scene import Filter


def reconstruct(
    column: Tensor, row: Tensor, weight: Tensor, pixels: tuple[int, int], filter: Filter
) -> Tensor:
    """Irradiance image of rays.

    Parameters
    ----------
    column, row : Tensor, shape (...)
        Where rays land, in pixels; see `workbench.scene.AnyReceiver.to_pixels`.
    weight : Tensor, shape (...)
        Flux of each ray.
    pixels : tuple[int, int]
        (n_x, n_y).
    filter : BoxFilter or GaussianFilter
        How a ray's flux is spread.

    Returns
    -------
    Tensor, shape (n_y, n_x)
        Flux in each pixel, row 0 at +y.
    """
    n_x, n_y = pixels
    margin = ((filter.size[0] - 1) // 2, (filter.size[1] - 1) // 2)
    # Ghost pixels: a hit up to `margin` pixels beside the image still lights its edge.
    columns, rows = n_x + 2 * margin[0], n_y + 2 * margin[1]

    column, row = column.flatten(), row.flatten()
    j, i = column.detach().floor(), row.detach().floor()
    near = (j >= -margin[0]) & (j < n_x + margin[0]) & (i >= -margin[1]) & (i < n_y + margin[1])
    # Hits beyond the ghost pixels stay in the ray bundle, but light nothing.
    j, i = torch.where(near, j, 0), torch.where(near, i, 0)
    weight = weight.flatten()
    weight = torch.where(near, weight, 0.0)

    # A canvas wide enough that no tap needs a check of its own: ghost pixels and their taps.
    stride = columns + 2 * margin[0]
    start = (i + margin[1]).long() * stride + (j + margin[0]).long()  # upper left tap
    offset_x = torch.where(near, column - j - 0.5, 0.0)
    offset_y = torch.where(near, row - i - 0.5, 0.0)
    taps_x = _taps(offset_x, filter, axis=0)
    taps_y = _taps(offset_y, filter, axis=1)
    # In float64 whatever the trace: many rays in one pixel add less each than float32 resolves.
    canvas = weight.new_zeros((rows + 2 * margin[1]) * stride, dtype=torch.float64)
    for b, tap_y in enumerate(taps_y):
        flux = weight if tap_y is None else weight * tap_y
        for a, tap_x in enumerate(taps_x):
            light = flux if tap_x is None else flux * tap_x
            canvas.index_add_(0, start + (b * stride + a), light.double())
    canvas = canvas.view(-1, stride)
    left, top = 2 * margin[0], 2 * margin[1]
    return canvas[top : top + n_y, left : left + n_x].to(weight.dtype)


def _taps(offset: Tensor, filter: Filter, axis: int) -> list[Tensor | None]:
    """Weights of the ν pixels around each hit; None stands for the single weight 1.

    ``offset`` is the hit's distance from the centre of its pixel, in [−½, ½). The filter
    e^(−α d²) − e^(−α (ν/2)²) is scaled by e^(α offset²), which cancels in the normalisation, so
    that neither a large α (all terms 0) nor a small one (all differences 0) leaves 0/0.
    """
    if filter.size[axis] == 1:
        return [None]
    alpha, half_size = filter.alpha, filter.size[axis] / 2
    taps = []
    for k in range(-(filter.size[axis] // 2), filter.size[axis] // 2 + 1):
        distance = offset - k
        scaled = torch.exp(2 * alpha * k * offset - alpha * k * k)
        taps.append(-scaled * torch.expm1(alpha * (distance.square() - half_size**2)))
    share = 1 / sum(taps[1:], taps[0])
    return [tap * share for tap in taps]
