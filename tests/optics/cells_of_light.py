"""Nodes of cells of light, as beams and boxes take them."""

import numpy as np
import torch

from workbench.optics.samples import Corners, places


def splits(shape):
    """Of one grid with rays in n rows of m."""
    n, m = shape
    return places(Corners(m - 1, n - 1), 0).split, places(Corners(m - 1, n - 1), 1).split


def nodes_of(column, row, flux=None):
    column, row = np.broadcast_arrays(column, row)
    if flux is None:
        n, m = column.shape
        flux = np.ones((n, m)) / ((n - 1) * (m - 1))
        flux[[0, -1]] /= 2
        flux[:, [0, -1]] /= 2
    return torch.tensor(np.stack([column, row, flux]))
