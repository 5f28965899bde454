"""The image of boxes of light, by threads, for torch; see `workbench.optics.boxes`."""

from functools import partial

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import AnyArray, Array
from workbench.optics.kernels import threads
from workbench.optics.kernels.beam_image import grids_of, splits_of_grids
from workbench.optics.kernels.beam_nodes import shift, shift_back
from workbench.optics.kernels.beam_raster import ROUNDING
from workbench.optics.kernels.box_raster import add_boxes, see_boxes
from workbench.optics.kernels.cell_image import Back, Splits, cell_image
from workbench.optics.kernels.function import kind_of

_Parts = tuple[Array, Array]


def compiled_box_image(
    nodes: Tensor, pixels: tuple[int, int], splits: Splits
) -> tuple[Tensor, float]:
    """As `workbench.optics.boxes.box_image`, on the CPU."""
    return cell_image(_draw, nodes, pixels, splits)


def compile_for(dtype: torch.dtype) -> None:
    """Compile the kernels for a float type by an image of one cell."""
    nodes = np.zeros((3, 2, 2), kind_of(dtype))
    splits = np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0]])
    _forward(nodes, (2, 2), (splits, splits))
    _back(nodes, np.zeros((2, 2)), (splits, splits))


def _draw(nodes: AnyArray, pixels: tuple[int, int], splits: Splits) -> tuple[Array, float, Back]:
    """See `workbench.optics.kernels.cell_image.Draw`."""
    return *_forward(nodes, pixels, splits), partial(_back, splits=splits)


def _forward(nodes: AnyArray, pixels: tuple[int, int], splits: Splits) -> tuple[Array, float]:
    """The image, and the flux that lands on its plane."""
    n_x, n_y = pixels
    grids = _grids(nodes, splits)
    at = threads.bounds(len(grids), min(torch.get_num_threads(), len(grids)))
    corners, landed = np.zeros((len(at) - 1, n_y + 1, n_x + 1, 4)), [0.0] * (len(at) - 1)

    def work(part: int) -> None:
        for rows in grids[at[part] : at[part + 1]]:
            hits, parts = _moved(nodes[:, rows], splits_of_grids(splits, rows))
            landed[part] += add_boxes(hits, nodes[2, rows], parts, corners[part])

    threads.run(work, len(at) - 1)
    image = _summed(corners)
    image[image < ROUNDING * sum(landed)] = 0.0
    return image, sum(landed)


def _summed(corners: Array) -> Array:
    """The image of what all threads have at corners of boxes; see `add_boxes`."""
    whole, by_x, by_y, by_both = np.moveaxis(corners.sum(axis=0), -1, 0)
    steps = whole - by_x - by_y + by_both
    steps[:, 1:] += (by_x - by_both)[:, :-1]
    steps[1:] += (by_y - by_both)[:-1]
    steps[1:, 1:] += by_both[:-1, :-1]
    return np.asarray(steps.cumsum(axis=0).cumsum(axis=1)[:-1, :-1])


def _back(nodes: AnyArray, cotangent: Array, splits: Splits) -> AnyArray:
    """Cotangent of the nodes from that of the image."""
    sums, result = _sums(cotangent), np.empty_like(nodes)
    grids = _grids(nodes, splits)

    def work(part: int) -> None:
        rows = grids[part]
        split, flux = splits_of_grids(splits, rows), nodes[2, rows]
        hits, parts = _moved(nodes[:, rows], split)
        d_hits, result[2, rows] = np.zeros_like(hits), 0.0
        see_boxes(hits, flux, parts, sums, d_hits, result[2, rows])
        for k in range(2):
            shift_back(nodes[k, rows], split, d_hits[k], 0, len(flux), result[k, rows])

    threads.run(work, len(grids))
    return result


def _sums(cotangent: Array) -> Array:
    """Sums of a cotangent of the image, as `see_boxes` takes them."""
    n_y, n_x = cotangent.shape
    whole = np.zeros((n_y + 2, n_x + 2))
    whole[-3::-1, -3::-1] = cotangent[::-1, ::-1].cumsum(axis=0).cumsum(axis=1)
    here, right, below, beyond = whole[:-1, :-1], whole[:-1, 1:], whole[1:, :-1], whole[1:, 1:]
    return np.stack([here, right - here, below - here, beyond - right - below + here], axis=-1)


def _grids(nodes: AnyArray, splits: Splits) -> list[slice]:
    """Rows of grids that are drawn one by one: what a grid needs stays within a cache."""
    return grids_of(splits, nodes.shape[1:]) or [slice(0, nodes.shape[1])]


def _moved(nodes: AnyArray, split: tuple[Array, Array]) -> tuple[AnyArray, _Parts]:
    """Hits of a grid, shifted; and parts of flux as `add_boxes` takes them."""
    hits = np.empty_like(nodes[:2])
    for k in range(2):
        shift(nodes[k], split, 0, len(hits[k]), hits[k])
    along_u, along_v = (np.ascontiguousarray(each[:, :2].T) for each in split)
    return hits, (along_u, along_v)
