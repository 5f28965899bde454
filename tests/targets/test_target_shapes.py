import numpy as np
import pytest

from workbench.errors import Refused
from workbench.scene import RectangleTarget, RingTarget, Screen, TextTarget
from workbench.targets.raster import coverage
from workbench.targets.shapes import draw, flame


def screen(pixels=(64, 64), half_width=(1.0, 1.0)):
    return Screen(position=(0.0, 0.0, 5.0), half_width=half_width, pixels=pixels)


@pytest.mark.parametrize("pixels", [(1, 1), (7, 5), (40, 64), (256, 256)])
@pytest.mark.parametrize("half_width", [(1.0, 1.0), (3.0, 1.5), (2e-6, 5e-6)])
def test_coverage_of_a_polygon_adds_up_to_its_area(pixels, half_width):
    star = np.array([(0.9, 0.1), (0.1, 0.2), (-0.3, 0.95), (-0.2, 0.1), (-0.9, -0.7), (0.2, -0.2)])
    x, y = (star * half_width).T
    area = abs(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))) / 2
    raster = screen(pixels, half_width)
    covered = coverage(np.stack([x, y], axis=1), raster)
    assert covered.shape == pixels[::-1]
    assert covered.sum() * raster.pixel_measure == pytest.approx(area, rel=1e-10)


def test_flame_fills_its_height_upright_and_centred():
    light = flame(screen((200, 200)), 2.0)
    rows, columns = np.nonzero(light)
    assert rows.min() <= 1
    assert rows.max() >= 198
    assert abs(columns.min() + columns.max() - 199) < 12
    # Tongues end in points: little light in the top quarter, most of it below the middle.
    assert light[:50].sum() < 0.15 * light.sum()
    assert light[100:].sum() > 0.5 * light.sum()


def test_a_rectangle_and_a_ring_have_their_areas():
    raster = screen((50, 30), (2.0, 1.0))
    lit = draw(RectangleTarget(width=0.3, height=0.55), raster, 0.9)
    assert lit.mean() == pytest.approx(0.9**2 * 0.3 * 0.55, rel=1e-12)
    np.testing.assert_allclose(draw(RectangleTarget(), raster, 1.0), 1, atol=1e-12)
    ring = draw(RingTarget(radius=0.8, inner=0.5), raster, 1.0)
    area = np.pi * 0.8**2 * (1 - 0.5**2)
    assert ring.sum() * raster.pixel_measure == pytest.approx(area, rel=1e-4)
    assert ring[13:17, 23:27].max() == 0


def test_text_stands_upright_and_fills_the_width():
    light = draw(TextTarget(text="L"), screen((60, 60)), 1.0)
    rows = np.flatnonzero(light.sum(axis=1))
    assert (rows[0], rows[-1]) == (0, 59)  # L is higher than wide
    assert light[:30].sum() < light[30:].sum()  # its foot is below
    columns = np.flatnonzero(light.sum(axis=0))
    assert (
        light[:, : columns.mean().astype(int)].sum() > 0.6 * light.sum()
    )  # its stem is on the left
    wide = draw(TextTarget(text="Light for all"), screen((90, 60)), 1.0)
    lit = np.flatnonzero(wide.sum(axis=0))
    assert (lit[0], lit[-1]) == (0, 89)


@pytest.mark.parametrize("letter", ["\u0378", "\x07"])
def test_a_letter_that_no_font_has_is_named(letter):
    with pytest.raises(Refused, match=rf"^target\.text: .*U\+{ord(letter):04X}"):
        draw(TextTarget(text=f"A{letter}"), screen(), 1.0)


@pytest.mark.parametrize(("text", "same"), [("A\tB", "A B"), ("A\r\nB", "A\nB"), ("e\u0301", "é")])
def test_a_tab_is_a_space_and_letters_may_be_composed(text, same):
    drawn = [draw(TextTarget(text=each), screen((60, 60)), 1.0) for each in (text, same)]
    np.testing.assert_array_equal(*drawn)
