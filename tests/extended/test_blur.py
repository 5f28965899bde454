"""Blur of a source on pixels: exact integrals, and enough places in a pixel."""

import numpy as np
import pytest

from workbench.extended.blur import Blur
from workbench.extended.blurring import convolved, convolved_in_place

BLURS = [
    Blur((3.0, 5.0)),
    Blur((2.4, 0.0)),
    Blur((5.95, 5.95), "ellipse"),
    Blur((3.2, 12.7), "ellipse"),
    Blur((8.0, 6.0), points=(5, 3)),
    Blur((90.0, 30.0), points=(25, 1)),
]


@pytest.mark.parametrize("finer", [1, 2])
@pytest.mark.parametrize("blur", BLURS)
def test_each_kernel_holds_all_light_about_its_middle(blur, finer):
    kernels = blur.kernels(finer)
    x, y = blur.offsets(finer)
    m_x, m_y = blur.margin
    assert kernels.shape == (len(x) * len(y), 2 * m_y + 1, 2 * m_x + 1)
    assert (kernels >= 0).all()
    np.testing.assert_allclose(kernels.sum(axis=(1, 2)), 1, atol=1e-12)


def test_kernel_of_an_ellipse_is_the_part_of_its_area_in_each_pixel():
    blur = Blur((4.6, 7.2), "ellipse")
    (m_x, m_y), (x, y) = blur.margin, blur.offsets()
    fine = (np.arange(400) + 0.5) / 400 - 0.5
    for kernel, (up, across) in zip(blur.kernels(), [(v, u) for v in y for u in x], strict=True):
        for row, column in ((m_y, m_x), (m_y + 3, m_x), (m_y - 2, m_x + 1), (m_y + 1, m_x + 2)):
            inside = np.hypot(
                (column - m_x + fine - across)[None, :] / 2.3,
                (row - m_y + fine - up)[:, None] / 3.6,
            )
            share = (inside <= 1).mean() / (np.pi * 2.3 * 3.6)
            assert kernel[row, column] == pytest.approx(share, abs=2e-4)


def test_blur_of_a_scene_is_that_behind_a_pinhole(make_scene):
    source = {"kind": "grid", "center": [0, 0, -4], "half_width": [0.2, 0.1], "points": [5, 3]}
    scene = make_scene({"source": source, "screen.z": 9})
    blur = Blur.of(scene)
    (n_x, n_y), (r_x, r_y) = scene.receiver.pixels, scene.receiver.half_extent
    farther = (9 - scene.optic.highest) / 4
    assert blur.widths == pytest.approx(
        (0.4 * farther * n_x / (2 * r_x), 0.2 * farther * n_y / (2 * r_y))
    )
    assert blur.points == (5, 3)


def test_blur_is_narrower_from_an_exit_face_nearer_to_the_screen(make_scene):
    source = {"kind": "grid", "center": [0, 0, -4], "half_width": [0.2, 0.1], "points": [5, 3]}
    scene = make_scene({"source": source})
    z, lens = scene.optic.highest + 0.5, scene.optic
    # Similar triangles: the way to the screen over that from the source, shorter in the glass.
    ways = [
        (scene.receiver.z - there) / (4 + glass / lens.index)
        for there, glass in ((z, z - lens.entrance_z), (lens.highest, 0))
    ]
    narrower = [b / a for a, b in zip(Blur.of(scene).widths, Blur.of(scene, z).widths, strict=True)]
    assert narrower == pytest.approx([ways[0] / ways[1]] * 2)


def test_light_in_parts_of_a_pixel_adds_up_to_that_of_the_pixel():
    blur = Blur((3.4, 2.1), "ellipse")
    whole, parts = blur.spread(), blur.spread(4)
    assert parts.shape == (16, *whole.shape[1:])
    np.testing.assert_allclose(parts.mean(axis=0), whole[0], atol=1e-12)
    left, right = parts[4], parts[7]  # in the second row
    x = np.arange(whole.shape[2]) - blur.margin[0]
    assert (right.sum(0) - left.sum(0)) @ x == pytest.approx(0.75, abs=0.01)


@pytest.mark.parametrize("shape", [(3, 5), (1, 4), (6, 2)])
def test_convolutions_are_those_of_sums(shape, rng):
    from scipy.signal import convolve2d  # late: it takes long to import

    image, kernel = rng.random((9, 8)), rng.random(shape)
    whole = convolve2d(image, kernel)
    np.testing.assert_allclose(convolved(image, kernel), whole, atol=1e-12)
    same = convolve2d(image, kernel, mode="same")
    np.testing.assert_allclose(convolved_in_place(image, kernel), same, atol=1e-12)


@pytest.mark.parametrize("width", [0.3, 1.0, 1.2, 1.9, 2.4, 4.6, 20.0])
def test_light_moves_by_a_small_part_of_its_blur_to_the_middles_of_parts(width):
    """Or of a pixel, where the blur is narrower."""
    moved = 0.5 / Blur((width, width), "ellipse").parts
    assert moved <= 0.1 * max(width, 1.0)
