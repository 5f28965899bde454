import numpy as np
import pytest

from workbench.errors import Refused
from workbench.scene import (
    BallTarget,
    FlameTarget,
    RectangleTarget,
    RingTarget,
    Screen,
    TextTarget,
    TopHatTarget,
)
from workbench.targets.raster import coverage
from workbench.targets.shapes import ball, draw, flame, top_hat
from workbench.targets.text import picture_of_text

SHAPES = [
    TopHatTarget(),
    FlameTarget(),
    BallTarget(),
    RectangleTarget(),
    RingTarget(),
    TextTarget(),
]


def screen(pixels=(64, 64), half_width=(1.0, 1.0)):
    return Screen(z=5.0, half_width=half_width, pixels=pixels)


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


def test_coverage_of_a_rectangle_pixel_by_pixel():
    corners = [(-0.625, -0.5), (0.5, -0.5), (0.5, 0.75), (-0.625, 0.75)]
    for outline in (corners, corners[::-1]):
        np.testing.assert_allclose(
            coverage(outline, screen((4, 4))),
            [[0.125, 0.5, 0.5, 0]] + [[0.25, 1, 1, 0]] * 2 + [[0] * 4],
        )


def test_coverage_finds_the_part_of_a_triangle_in_each_pixel():
    covered = coverage([(-1, -1), (1, -1), (-1, 1)], screen((3, 3)))
    np.testing.assert_allclose(covered, [[0.5, 0, 0], [1, 0.5, 0], [1, 1, 0.5]], atol=1e-12)


def test_coverage_refines_consistently():
    outline = [(0.83, 0.11), (-0.2, 0.97), (-0.71, -0.64)]
    fine = coverage(outline, screen((60, 60))).reshape(20, 3, 20, 3).mean(axis=(1, 3))
    np.testing.assert_allclose(fine, coverage(outline, screen((20, 20))), atol=1e-12)


@pytest.mark.parametrize("pixels", [(5, 5), (64, 64), (63, 200), (256, 256)])
@pytest.mark.parametrize("half_width", [(1.0, 1.0), (2.0, 0.7)])
def test_disc_area(pixels, half_width):
    raster = screen(pixels, half_width)
    radius = 0.6 * min(half_width)
    area = top_hat(raster, radius).sum() * raster.pixel_measure
    assert area == pytest.approx(np.pi * radius**2, rel=1e-5)


@pytest.mark.parametrize("pixels", [(64, 64), (31, 50)])
def test_disc_is_symmetric(pixels):
    disc = top_hat(screen(pixels, (1.5, 1.0)), 0.77)
    np.testing.assert_allclose(disc, disc[::-1], atol=1e-12)
    np.testing.assert_allclose(disc, disc[:, ::-1], atol=1e-12)
    square = top_hat(screen((64, 64)), 0.77)
    np.testing.assert_allclose(square, square.T, atol=1e-12)


def test_disc_is_flat_inside_and_black_outside():
    raster = screen((200, 200))
    centres = (np.arange(200) + 0.5) / 100 - 1
    distance = np.hypot(centres[:, None], centres)
    disc = top_hat(raster, 0.6)
    assert (disc[distance < 0.59] == 1).all()
    assert (disc[distance > 0.61] == 0).all()


@pytest.mark.parametrize("target", SHAPES, ids=lambda t: t.builtin)
def test_shapes_do_not_change_with_the_raster_or_the_unit(target):
    coarse = draw(target, screen((50, 40), (1.0, 2.0)), 1.0)
    fine = draw(target, screen((100, 120), (1.0, 2.0)), 1.0)
    np.testing.assert_allclose(fine.reshape(40, 3, 50, 2).mean(axis=(1, 3)), coarse, atol=1e-12)
    tiny = draw(target, screen((50, 40), (1e-6, 2e-6)), 1.0)
    np.testing.assert_allclose(tiny, coarse, atol=1e-9)


@pytest.mark.parametrize("target", SHAPES, ids=lambda t: t.builtin)
def test_shapes_scale_with_their_size(target):
    whole = draw(target, screen((64, 64)), 1.0).sum()
    assert draw(target, screen((64, 64)), 0.5).sum() == pytest.approx(whole / 4, rel=1e-9)


@pytest.mark.parametrize("kind", [TopHatTarget, BallTarget])
def test_a_shape_of_full_size_stays_on_the_screen(kind):
    light = draw(kind(radius=1.0), screen((64, 64)), 1.0)
    assert light.min() >= 0
    assert light.max() <= 1
    assert light[0, 0] == light[-1, -1] == 0
    assert light[0].sum() < 16


def test_flame_fills_its_height_upright_and_centred():
    light = flame(screen((200, 200)), 2.0)
    rows, columns = np.nonzero(light)
    assert rows.min() <= 1
    assert rows.max() >= 198
    assert abs(columns.min() + columns.max() - 199) < 12
    # Tongues end in points: little light in the top quarter, most of it below the middle.
    assert light[:50].sum() < 0.15 * light.sum()
    assert light[100:].sum() > 0.5 * light.sum()


def test_flame_is_a_logo_of_one_brightness():
    light = flame(screen((400, 400)), 1.7)
    between = (light > 0.01) & (light < 0.99)
    assert between.sum() < 0.1 * (light > 0.99).sum()


def test_ball_has_many_different_greys_none_near_black():
    light = ball(screen((800, 800)), 0.8)
    interior = (light == np.roll(light, 1, 0)) & (light == np.roll(light, 1, 1)) & (light > 0)
    greys, counts = np.unique(light[interior].round(6), return_counts=True)
    facets = greys[counts > 20]
    assert len(facets) >= 20
    assert facets.min() >= 0.15
    assert light.max() == pytest.approx(1.0)
    assert len(np.unique((facets * 10).astype(int))) >= 8


def test_ball_facets_tile_the_disc_they_are_inscribed_in():
    light = ball(screen((400, 400)), 0.8)
    covered = np.count_nonzero(light > 0) / 400**2 * 4
    assert 0.93 < covered / (np.pi * 0.8**2) < 1
    centres = (np.arange(400) + 0.5) / 200 - 1
    distance = np.hypot(centres[:, None], centres)
    assert (light[distance < 0.7] >= 0.15 - 1e-9).all()
    assert (light[distance > 0.81] == 0).all()


def test_ball_is_lit_from_the_upper_left():
    light = ball(screen((100, 100)), 0.9)
    assert light[:50, :50].sum() > 1.5 * light[50:, 50:].sum()


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
    assert light[:, : columns.mean().astype(int)].sum() > 0.6 * light.sum()  # its stem is left
    wide = draw(TextTarget(text="Light for all"), screen((90, 60)), 1.0)
    lit = np.flatnonzero(wide.sum(axis=0))
    assert (lit[0], lit[-1]) == (0, 89)


def test_text_has_lines_and_letters_of_other_alphabets():
    one = draw(TextTarget(text="AB"), screen(), 1.0)
    for two in ("AB\nAB", r"AB\nAB"):
        light = draw(TextTarget(text=two), screen(), 1.0)
        lit = light.sum(axis=1) > 0
        assert np.abs(np.diff(lit.astype(int))).sum() >= 2  # a gap between the lines
        assert light.sum() != pytest.approx(one.sum(), rel=0.05)
    shapes = {draw(TextTarget(text=each), screen(), 1.0).tobytes() for each in "ÄΩЖ№"}
    assert len(shapes) == 4


def test_text_that_draws_nothing_is_refused():
    with pytest.raises(Refused, match="draws nothing") as caught:
        draw(TextTarget(text="  "), screen(), 1.0)
    assert caught.value.path == "target.text"


def test_a_letter_that_no_font_has_is_named():
    for letter in ("\u0378", "\x07"):
        with pytest.raises(Refused, match=rf"U\+{ord(letter):04X}") as caught:
            draw(TextTarget(text=f"A{letter}"), screen(), 1.0)
        assert caught.value.path == "target.text"


def test_a_tab_is_a_space_and_letters_may_be_composed():
    def drawn(text):
        return draw(TextTarget(text=text), screen((60, 60)), 1.0)

    np.testing.assert_array_equal(drawn("A\tB"), drawn("A B"))
    np.testing.assert_array_equal(drawn("A\r\nB"), drawn("A\nB"))
    np.testing.assert_array_equal(drawn("e\u0301"), drawn("é"))


def test_words_from_right_to_left_begin_at_the_right():
    drawn = picture_of_text("שי")  # Yod ends in the middle of its line, Shin at its foot
    foot, side = drawn[-drawn.shape[0] // 4 :], drawn.shape[1] // 8
    assert foot[:, -2 * side :].any() and not foot[:, :side].any() and drawn[:, :side].any()


def test_lines_of_words_drawn_by_the_system_stand_below_each_other():
    one, two = (picture_of_text(text) for text in ("ש", "ש\nש"))
    assert two.shape[1] == pytest.approx(one.shape[1], abs=2)
    assert two.shape[0] > 2 * one.shape[0]
    np.testing.assert_allclose(two[: one.shape[0] - 2, 2:-2].mean(), one.mean(), rtol=0.1)
