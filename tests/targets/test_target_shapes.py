import numpy as np
import pytest

from workbench.errors import Refused
from workbench.scene import (
    BeamTarget,
    FarField,
    RectangleTarget,
    RingTarget,
    Screen,
    TextTarget,
)
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


def test_a_beam_goes_through_the_points_of_its_profile():
    profile = ((0.0, 1.0), (0.2, 0.5), (0.6, 0.1), (0.9, 0.02))
    raster = screen((401, 201), (4.01, 2.01))
    light = draw(BeamTarget(profile=profile), raster, 1.0)
    row = light[100, 200:]  # from the middle to the right, 1/100 of the half-width a pixel
    for radius, level in profile[1:-1]:
        assert row[round(100 * radius)] == pytest.approx(level, abs=0.01)
    assert (np.diff(row) <= 1e-12).all() and row[0] == pytest.approx(1.0, abs=2e-3)
    assert row[88] > 0.019 and not row[92:].any()
    np.testing.assert_allclose(light[:, 200], light[100, 100:301], atol=1e-12)  # round


def test_a_hot_spot_is_even_and_the_light_is_that_of_its_disc():
    raster = screen((200, 200))
    light = draw(BeamTarget(profile=((0.5, 1.0), (0.5001, 0.2), (1.0, 0.2))), raster, 0.8)
    area = np.pi * (0.8**2) * (0.25 + 0.75 * 0.2)
    assert light.sum() * raster.pixel_measure == pytest.approx(area, rel=2e-3)
    assert np.unique(light[90:110, 90:110]).tolist() == [1.0]


def test_a_beam_in_a_far_field_has_angles_from_its_direction():
    field = FarField(half_angle=(50.0, 50.0), center=(20.0, -30.0), pixels=(101, 101))
    light = draw(BeamTarget(profile=((0.0, 1.0), (0.8, 0.0))), field, 1.0)
    middles = np.arange(101) + 0.5
    h, v = map(np.radians, field.from_pixels(middles, middles[:, None]))
    way = np.stack(np.broadcast_arrays(np.cos(v) * np.sin(h), np.sin(v), np.cos(v) * np.cos(h)))
    angle = np.degrees(np.arccos(np.clip(np.tensordot(way[:, 50, 50], way, 1), -1, 1)))
    inside = (angle > 4) & (angle < 36)
    order = np.argsort(angle[inside])
    assert (np.diff(light[inside][order]) < 2e-3).all()  # it falls with the angle alone
    assert not light[angle > 41].any()


@pytest.mark.parametrize(
    ("profile", "path"),
    [
        (((0.0, 1.0), (0.5, 0.5), (0.5, 0.1)), r"target\.profile\[2\]\[0\]"),
        (((0.0, 0.0), (0.5, 0.0)), r"target\.profile"),
    ],
)
def test_profiles_that_are_no_beam_are_refused(profile, path):
    with pytest.raises(Refused, match=f"^{path}: "):
        BeamTarget(profile=profile).check()


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
