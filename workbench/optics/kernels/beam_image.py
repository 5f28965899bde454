"""The image of beams as a step that torch differentiates; compiled, by threads.

Between nodes hits are interpolated linearly, and where the map from lens to receiver bends that is
off by h²/12 times the second derivative along each axis, on average over a cell. The nodes are
shifted by as much the other way, but for those at the rim. This halves the error of three images
by 384² cells, and divides it by 3 by 1024² cells (0.58 to 0.17 %).
"""

from functools import partial

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import AnyArray, Array
from workbench.optics.kernels import kind_of, threads
from workbench.optics.kernels.beam_cells import Mesh
from workbench.optics.kernels.beam_raster import ROUNDING, draw, draw_back
from workbench.optics.kernels.cell_image import Back, Splits, cell_image
from workbench.optics.kernels.polygons import compile_drawing

# Times as many parts where a part needs no image of its own: rows take more time where light is.
_SHARES = 4


def compiled_beam_image(
    nodes: Tensor, pixels: tuple[int, int], splits: Splits
) -> tuple[Tensor, float]:
    """As `workbench.optics.images.beams.beam_image`, on the CPU."""
    return cell_image(_draw, nodes, pixels, splits)


def compile_for(dtype: torch.dtype) -> None:
    """Compile the kernels for a float type by an image of one cell."""
    nodes = np.zeros((3, 2, 2), kind_of(dtype))
    splits = np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0]])
    _draw(nodes, (2, 2), (splits, splits))[2](nodes, np.zeros((2, 2)))
    compile_drawing()


def _draw(nodes: AnyArray, pixels: tuple[int, int], splits: Splits) -> tuple[Array, float, Back]:
    """See `workbench.optics.kernels.cell_image.Draw`."""
    mesh = _mesh(nodes, splits)
    n_x, n_y = pixels
    rows = nodes.shape[1] - 1
    count = min(threads.parts(nodes[0].size), threads.images(2 * n_x * n_y), rows)
    at, landed = threads.bounds(rows, count), [0.0] * count
    direct, steps = np.zeros((2, count, n_y, n_x + 1))

    def work(part: int) -> None:
        flat = direct[part].reshape(-1)
        landed[part] = draw(mesh, at[part], at[part + 1], flat, steps[part])

    threads.run(work, count)
    image = direct.sum(axis=0) - np.cumsum(steps.sum(axis=0), axis=1)
    image[image < ROUNDING * sum(landed)] = 0.0
    return image[:, :n_x], sum(landed), partial(_back, splits=splits)


def _mesh(nodes: AnyArray, splits: Splits) -> Mesh:
    along_u, along_v = splits
    lines = np.arange(len(along_v))
    turn = (lines - np.maximum.accumulate(np.where(along_v[:, 0] == 0, lines, 0))) % 2
    return Mesh(nodes[0], nodes[1], nodes[2], along_v, along_u, turn)


def _back(nodes: AnyArray, cotangent: Array, splits: Splits) -> AnyArray:
    """Cotangent of the nodes from that of the image."""
    mesh, result = _mesh(nodes, splits), np.empty_like(nodes)
    at = threads.split(nodes.shape[1], nodes[0].size, _SHARES)
    seen, right = np.zeros((2, cotangent.shape[0], cotangent.shape[1] + 1))
    seen[:, :-1] = cotangent
    right[:, :-1] = np.cumsum(cotangent[:, ::-1], axis=1)[:, ::-1]

    def work(part: int) -> None:
        draw_back(mesh, at[part], at[part + 1], cotangent, seen.reshape(-1), right, result)

    threads.run(work, len(at) - 1)
    return result
