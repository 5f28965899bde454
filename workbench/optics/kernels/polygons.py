"""The image of some polygons of even light, for torch.

The twin of `workbench.optics.images.beams.drawn`. Polygons are cells that a rim cuts: so few that
one thread draws them sooner than several would begin.
"""

from typing import Any

import numpy as np
import torch
from torch import Tensor
from torch.autograd.function import once_differentiable

from workbench.arrays import Array
from workbench.compiled import jit
from workbench.optics.kernels.beam_edge import add_edge, see_edge
from workbench.optics.kernels.beam_raster import ROUNDING


def compiled_drawn(
    x: Tensor, y: Tensor, density: Tensor, pixels: tuple[int, int], landed: float
) -> Tensor:
    """As `workbench.optics.images.beams.drawn`, on the CPU."""
    drawn: Tensor = _Image.apply(x, y, density, pixels, landed)  # type: ignore[no-untyped-call]
    return drawn


def compile_drawing() -> None:
    """Compile the kernels by the image of one triangle, whether or not torch notes gradients."""
    x, y, density = np.array([[0.0, 1.0, 1.0]]), np.array([[1.0, 1.0, 0.0]]), np.ones(1)
    steps = np.zeros((2, 3))
    _add_outlines(x, y, density, steps)
    found = (np.zeros_like(each) for each in (x, y, density))
    _outlines_back(x, y, density, np.ones((2, 2)), steps, *found)


class _Image(torch.autograd.Function):
    @staticmethod
    def forward(
        ctx: Any, x: Tensor, y: Tensor, density: Tensor, pixels: tuple[int, int], landed: float
    ) -> Tensor:
        ctx.save_for_backward(x, y, density)
        n_x, n_y = pixels
        steps = np.zeros((n_y, n_x + 1))
        _add_outlines(*_arrays(x, y, density), steps)
        image = -np.cumsum(steps[:, :-1], axis=1)
        image[image < ROUNDING * landed] = 0.0
        return torch.from_numpy(image)

    @staticmethod
    @once_differentiable
    def backward(ctx: Any, cotangent: Tensor) -> tuple[Tensor, Tensor, Tensor, None, None]:
        polygons = _arrays(*ctx.saved_tensors)
        seen = cotangent.double().contiguous().numpy()
        right = np.zeros((seen.shape[0], seen.shape[1] + 1))
        right[:, :-1] = np.cumsum(seen[:, ::-1], axis=1)[:, ::-1]
        d_x, d_y, d_density = (np.zeros_like(each) for each in polygons)
        _outlines_back(*polygons, seen, right, d_x, d_y, d_density)
        return *map(torch.from_numpy, (d_x, d_y, d_density)), None, None  # type: ignore[return-value]


def _arrays(*tensors: Tensor) -> tuple[Array, ...]:
    return tuple(each.detach().contiguous().numpy() for each in tensors)


@jit(allocates=False, error_model="numpy")
def _add_outlines(x, y, density, steps):  # type: ignore[no-untyped-def]
    """Add what crosses the edges of polygons.

    `x`, `y` (polygons, corners): their corners, in pixels; `density` (polygons,): flux per area;
    `steps` (n_y, n_x + 1): changed; minus its sums along rows are the image.
    """
    corners = x.shape[1]
    for k in range(len(density)):
        for a in range(corners):
            b = a + 1 if a + 1 < corners else 0
            add_edge(x[k, a], y[k, a], x[k, b], y[k, b], density[k], steps)


@jit(allocates=False, error_model="numpy")
def _outlines_back(x, y, density, cotangent, right, d_x, d_y, d_density):  # type: ignore[no-untyped-def]
    """Adjoint of `_add_outlines`.

    `cotangent` (n_y, n_x): cotangent of the image; `right` (n_y, n_x + 1): its sums over all pixels
    from each one to the right end of the row.
    """
    corners = x.shape[1]
    for k in range(len(density)):
        for a in range(corners):
            b = a + 1 if a + 1 < corners else 0
            way_x, way_y = x[k, b] - x[k, a], y[k, b] - y[k, a]
            beside, from_start, to_end = see_edge(
                x[k, a], y[k, a], x[k, b], y[k, b], cotangent, right
            )
            d_x[k, a] += way_y * density[k] * from_start
            d_y[k, a] -= way_x * density[k] * from_start
            d_x[k, b] += way_y * density[k] * to_end
            d_y[k, b] -= way_x * density[k] * to_end
            d_density[k] -= beside
