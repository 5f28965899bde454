"""Nodes of cells of light, as beams and boxes take them; and the exact image of beams."""

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


def unshifted(shape):
    """Splits with which nodes are drawn where they are."""
    along = [split.copy() for split in splits(shape)]
    for split in along:
        split[:, 2] = 0
    return tuple(along)


def triangles(nodes, parts):
    """Corners (3, 2) and flux of the triangles of a grid of beams."""
    column, row, flux = nodes.numpy()
    (along_u, along_v), hits = parts, np.stack([column, row], -1)
    flux = flux[:-1] * along_v[:-1, 1:2] + flux[1:] * along_v[1:, :1]
    flux = flux[:, :-1] * along_u[:-1, 1] + flux[:, 1:] * along_u[1:, 0]
    for (i, j), light in np.ndenumerate(flux):
        a, b, c, d = hits[i, j], hits[i + 1, j], hits[i + 1, j + 1], hits[i, j + 1]
        for corners in ((a, b, c), (a, c, d)) if (i + j) % 2 == 0 else ((a, b, d), (b, c, d)):
            yield np.stack(corners), light / 2


def exact_image(nodes, pixels, parts):
    """The image of beams, triangle by triangle, cut at each border of pixels."""
    n_x, n_y = pixels
    image = np.zeros((n_y, n_x))
    for corners, flux in triangles(nodes, parts):
        for (j, i), light in _cut(corners, flux, 0):
            if 0 <= j < n_x and 0 <= i < n_y:
                image[i, j] += light
    return image


def _cut(corners, light, axis):
    """Pixels of a triangle, and its light in them.

    The part of its light that a border cuts off with one corner is the product of the parts of both
    edges there. This needs no area.
    """
    low, high = corners[:, axis].min(), corners[:, axis].max()
    border = np.floor(low) + 1
    if border >= high:
        if axis == 0:
            yield from _cut(corners, light, 1)
        else:
            yield np.floor(corners.mean(0)).astype(int), light
        return
    over = corners[:, axis] >= border
    alone = np.argmax(over) if over.sum() == 1 else np.argmin(over)
    a, b, c = np.roll(corners, -alone, 0)
    p, q = ((border - a[axis]) / (end[axis] - a[axis]) for end in (b, c))
    d, e = a + p * (b - a), a + q * (c - a)
    d[axis] = e[axis] = border
    yield from _cut(np.stack([a, d, e]), light * p * q, axis)
    yield from _cut(np.stack([d, b, c]), light * (1 - p), axis)
    yield from _cut(np.stack([d, c, e]), light * p * (1 - q), axis)
