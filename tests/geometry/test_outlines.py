"""What of a lens's bounding rectangle is glass: areas in closed form, and the map of the square."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench.geometry.outlines import Ellipse, Rectangle

KINDS = pytest.mark.parametrize("kind", [Rectangle, Ellipse])
HALF = (1.3, 0.7)
length = st.floats(0.01, 100)


def edges(count, r):
    return np.linspace(-1.1 * r, 1.1 * r, count + 1)


@KINDS
@given(r_x=length, r_y=length, columns=st.integers(1, 60), rows=st.integers(1, 60))
def test_cells_add_up_to_the_area(kind, r_x, r_y, columns, rows):
    outline = kind((r_x, r_y))
    x, y = edges(columns, r_x)[:, None], edges(rows, r_y)
    inside = outline.area_inside((x[:-1], x[1:]), (y[:-1], y[1:]))
    assert inside.shape == (columns, rows)
    assert inside.sum() == pytest.approx(outline.area, rel=1e-12)
    assert (inside >= 0).all()


def test_a_cut_cell_has_the_area_that_quadrature_finds():
    outline = Ellipse(HALF)
    x = np.linspace(0.5, 1.35, 200_001)
    x = (x[1:] + x[:-1]) / 2
    top = HALF[1] * np.sqrt((1 - (x / HALF[0]) ** 2).clip(min=0))
    expected = (top.clip(0.2, 0.6) - 0.2).mean() * 0.85
    assert outline.area_inside((0.5, 1.35), (0.2, 0.6)) == pytest.approx(expected, rel=1e-8)


@KINDS
def test_the_map_of_the_square_fills_the_outline(kind):
    outline = kind(HALF)
    side = np.linspace(-1, 1, 801)
    middle = (side[1:] + side[:-1]) / 2
    x, y = outline.from_square(middle[:, None], middle)
    assert outline.contains(x, y).all()
    area = outline.stretch(middle[:, None], middle).mean() * 4
    assert area == pytest.approx(outline.area, rel=1e-6)


def test_the_stretch_is_the_determinant_of_the_map(rng):
    u, v = rng.uniform(-0.99, 0.99, (2, 50))
    h, outline = 1e-6, Ellipse(HALF)
    (east, north), (west, south) = (
        np.subtract(outline.from_square(*after), outline.from_square(*before)) / (2 * h)
        for before, after in (((u - h, v), (u + h, v)), ((u, v - h), (u, v + h)))
    )
    np.testing.assert_allclose(
        outline.stretch(u, v), east * south - north * west, rtol=1e-8, atol=1e-9
    )
