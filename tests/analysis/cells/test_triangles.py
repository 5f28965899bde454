"""Flux of triangles, counted in pixels."""

import numpy as np
import pytest

from workbench.analysis.cells.drawing import Canvas
from workbench.analysis.cells.kernels import fill_cells

BOTH = pytest.mark.parametrize("odd", [0, 1])  # ways to split a cell


def filled(nodes, flux, pixels, odd=0):
    """Flux in pixels, the flux that was added, and which cells are mixed."""
    nodes = np.ascontiguousarray(nodes, dtype=float)
    flux = np.broadcast_to(np.asarray(flux, dtype=float), nodes.shape[:2]).copy()
    canvas, mixed = Canvas(pixels), np.empty(np.array(flux.shape) - 1, dtype=bool)
    added = fill_cells(nodes, flux, odd, (canvas.here, canvas.behind), mixed)
    return canvas.flux(), added, mixed


def cell(*corners):
    """Nodes of one cell, from its corners in turn."""
    a, b, d, c = corners
    return [[a, c], [b, d]]


@BOTH
def test_a_rectangle_covers_parts_of_pixels(odd):
    nodes = cell((0.25, 0.5), (3.5, 0.5), (3.5, 2.75), (0.25, 2.75))
    image, added, _ = filled(nodes, 3.25 * 2.25, (5, 4), odd)
    expected = np.outer([0.5, 1, 0.75, 0], [0.75, 1, 1, 0.5, 0])
    assert image == pytest.approx(expected, abs=1e-14)
    assert added == pytest.approx(3.25 * 2.25, rel=1e-14)


def some_nodes(rng):
    """A wild map with folds, 20 pixels wide."""
    u = np.linspace(0, 1, 31)
    u, v = u[:, None], u[None, :]
    column = 10 + 6 * np.sin(4 * u + v) + 3 * np.cos(5 * v) + 0.1 * rng.random((31, 31))
    row = 10 + 6 * np.cos(3 * v * u) + 3 * np.sin(7 * u) + 0.1 * rng.random((31, 31))
    return np.stack([column, row], axis=-1), 1 + u + v * v


def test_flux_is_conserved(rng):
    nodes, flux = some_nodes(rng)
    image, added, _ = filled(nodes, flux, (24, 24))
    assert nodes.min() > 0
    assert nodes.max() < 24
    assert image.sum() == pytest.approx(added, rel=1e-13)
    corners = (flux[:-1, :-1] + flux[1:, :-1] + flux[:-1, 1:] + flux[1:, 1:]).sum() / 4
    assert added == pytest.approx(corners, rel=1e-3)
    assert image.min() > -1e-13 * image.max()


def test_pixels_agree_with_points_strewn_over_the_triangles(rng):
    nodes, flux = some_nodes(rng)
    image, _, _ = filled(nodes, flux, (24, 24))
    within = (np.arange(40) + 0.5) / 40
    a, b = (each.ravel() for each in np.meshgrid(within, within))
    expected = np.zeros_like(image)
    for (i, j), _ in np.ndenumerate(np.empty((30, 30))):
        p = {(k, n): (nodes[i + k, j + n], flux[i + k, j + n]) for k in (0, 1) for n in (0, 1)}
        even = (i + j) % 2 == 0
        for one, two, three in (
            [((0, 0), (1, 0), (0, 1)), ((1, 1), (0, 1), (1, 0))]
            if even
            else [((1, 0), (1, 1), (0, 0)), ((0, 1), (0, 0), (1, 1))]
        ):
            fold = a + b > 1  # onto the triangle
            s, t = np.where(fold, 1 - a, a), np.where(fold, 1 - b, b)
            at = p[one][0] + s[:, None] * (p[two][0] - p[one][0])
            at = at + t[:, None] * (p[three][0] - p[one][0])
            share = (p[one][1] + p[two][1] + p[three][1]) / 6 / len(s)
            np.add.at(expected, (at[:, 1].astype(int), at[:, 0].astype(int)), share)
    assert np.abs(image - expected).max() < 2e-3 * image.max()
