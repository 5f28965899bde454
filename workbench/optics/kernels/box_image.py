"""The image of boxes of light, by threads, for torch; see `workbench.optics.boxes`."""

from functools import partial

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import AnyArray, Array
from workbench.optics.kernels import threads
from workbench.optics.kernels.beam_raster import ROUNDING
from workbench.optics.kernels.box_grids import Grids, add_grids, see_grids
from workbench.optics.kernels.cell_image import Back, Splits, cell_image
from workbench.optics.kernels.tensors import kind_of

# Parts where none needs an image of its own: no thread then waits long for another.
_PARTS = 32


def compiled_box_image(
    nodes: Tensor, pixels: tuple[int, int], splits: Splits
) -> tuple[Tensor, float]:
    """As `workbench.optics.boxes.box_image`, on the CPU."""
    return cell_image(_draw, nodes, pixels, splits)


def compile_for(dtype: torch.dtype) -> None:
    """Compile the kernels for a float type by an image of one cell."""
    nodes = np.zeros((3, 2, 2), kind_of(dtype))
    splits = np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0]])
    grids = Grids.of(nodes, (splits, splits))
    _forward(nodes, (2, 2), grids)
    _back(nodes, np.zeros((2, 2)), grids)


def _draw(nodes: AnyArray, pixels: tuple[int, int], splits: Splits) -> tuple[Array, float, Back]:
    """See `workbench.optics.kernels.cell_image.Draw`."""
    grids = Grids.of(nodes, splits)
    return *_forward(nodes, pixels, grids), partial(_back, grids=grids)


def _forward(nodes: AnyArray, pixels: tuple[int, int], grids: Grids) -> tuple[Array, float]:
    """The image, and the flux that lands on its plane."""
    n_x, n_y = pixels
    at = _bounds(grids, threads.images(4 * n_x * n_y))
    corners, landed = np.zeros((len(at) - 1, n_y + 1, n_x + 1, 4)), [0.0] * (len(at) - 1)

    def work(part: int) -> None:
        landed[part] = add_grids(nodes, grids, at[part], at[part + 1], corners[part])

    threads.run(work, len(at) - 1)
    image = _summed(corners)
    image[image < ROUNDING * sum(landed)] = 0.0
    return image, sum(landed)


def _summed(corners: Array) -> Array:
    """The image of what all parts have at corners of boxes; see `add_boxes`."""
    whole, by_x, by_y, by_both = np.moveaxis(corners.sum(axis=0), -1, 0)
    steps = whole - by_x - by_y + by_both
    steps[:, 1:] += (by_x - by_both)[:, :-1]
    steps[1:] += (by_y - by_both)[:-1]
    steps[1:, 1:] += by_both[:-1, :-1]
    return np.asarray(steps.cumsum(axis=0).cumsum(axis=1)[:-1, :-1])


def _back(nodes: AnyArray, cotangent: Array, grids: Grids) -> AnyArray:
    """Cotangent of the nodes from that of the image."""
    sums, result = _sums(cotangent), np.empty_like(nodes)
    at = _bounds(grids, _PARTS)

    def work(part: int) -> None:
        see_grids(nodes, grids, at[part], at[part + 1], sums, result)

    threads.run(work, len(at) - 1)
    return result


def _bounds(grids: Grids, parts: int) -> list[int]:
    """Where so many parts of some grids begin, and where the last ends."""
    count = len(grids.behind)
    return threads.bounds(count, min(parts, count))


def _sums(cotangent: Array) -> Array:
    """Sums of a cotangent of the image, as `see_boxes` takes them."""
    n_y, n_x = cotangent.shape
    whole = np.zeros((n_y + 2, n_x + 2))
    whole[-3::-1, -3::-1] = cotangent[::-1, ::-1].cumsum(axis=0).cumsum(axis=1)
    here, right, below, beyond = whole[:-1, :-1], whole[:-1, 1:], whole[1:, :-1], whole[1:, 1:]
    return np.stack([here, right - here, below - here, beyond - right - below + here], axis=-1)
