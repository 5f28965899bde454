"""The canvas of images: what is painted at a place is what the pointer reads there."""

import numpy as np
import pytest
from PySide6.QtCore import QPointF
from PySide6.QtGui import QImage, QPalette

from ui.views.image_canvas import ImageCanvas
from workbench.pictures.axes import Extent, colour_bar, map_image, pixel_at

BOUNDS = -3.0, 1.0, 2.0, 5.0
SHAPE = 24, 32  # rows, columns


@pytest.fixture
def values():
    """An image that is unlike itself mirrored, turned or moved by a pixel."""
    return np.random.default_rng(1).permutation(np.arange(SHAPE[0] * SHAPE[1])).reshape(SHAPE)


@pytest.fixture
def canvas(values, show):
    """A canvas with the image in grey levels, shown at a size."""
    canvas = ImageCanvas(None)

    def make(width, height, part=BOUNDS, mirrored=False):
        axes = canvas.begin()
        image = map_image(axes, "light", Extent(BOUNDS, "cm"), SHAPE[::-1], "viridis")
        colour_bar(axes, image, "lx", "max")
        if mirrored:
            left, right, bottom, top = BOUNDS
            image.set_extent((right, left, bottom, top))
        image.set_data(values[:, ::-1] if mirrored else values)
        image.set_clim(0, values.max())
        canvas.recolour()
        show(canvas, width, height)
        canvas.clearFocus()  # which is framed
        canvas.show_part(part)
        canvas.show_changes()
        return canvas

    return make


def painted(canvas, ratio=1):
    """Colours (height, width, 3) that a display of this pixel ratio shows."""
    image = QImage(canvas.size() * ratio, QImage.Format.Format_RGB32)
    image.setDevicePixelRatio(ratio)
    canvas.render(image)
    data = np.frombuffer(image.constBits(), np.uint8)
    return data.reshape(image.height(), image.width(), 4)[..., 2::-1].copy()


def read(canvas, values, ratio=1):
    """Colours of the values that are read in the middle of each pixel; the ground beyond."""
    image = canvas.figure.axes[0].images[0]
    colours = image.to_rgba(values, bytes=True)[..., :3]
    ground = canvas.palette().color(QPalette.ColorRole.Window).getRgb()[:3]
    rows = []
    for j in range(canvas.height() * ratio):
        row = []
        for i in range(canvas.width() * ratio):
            x, y = canvas.place_at(QPointF((i + 0.5) / ratio, (j + 0.5) / ratio))
            pixel = pixel_at(BOUNDS, SHAPE, x, y)
            row.append(ground if pixel is None else colours[pixel])
        rows.append(row)
    return np.array(rows)


@pytest.mark.parametrize(
    ("part", "size", "ratio", "mirrored"),
    [  # each value beside some of the others
        (BOUNDS, (192, 150), 1, True),
        (BOUNDS, (160, 131), 2, False),
        ((-2.6, -0.9, 2.3, 3.575), (141, 250), 1, False),
        ((-2.6, -0.9, 2.3, 3.575), (192, 150), 1, True),
        ((0.81, 0.97, 4.5, 4.62), (160, 131), 1, True),
        ((0.81, 0.97, 4.5, 4.62), (141, 250), 2, False),
    ],
)
def test_each_pixel_shows_the_value_that_is_read_there(canvas, values, size, part, ratio, mirrored):
    shown = canvas(*size, part, mirrored)
    seen, wanted = painted(shown, ratio), read(shown, values, ratio)
    around = np.pad(wanted, ((1, 1), (1, 1), (0, 0)), mode="edge")
    height, width = seen.shape[:2]
    near = [around[j : j + height, i : i + width] for j in range(3) for i in range(3)]
    assert np.any([(seen == each).all(axis=-1) for each in near], axis=0).all()  # ends are rounded
    assert (seen == wanted).all(axis=-1).mean() > 0.8


@pytest.mark.parametrize("size", [(200, 90), (90, 200)])
def test_the_image_ends_where_the_panel_ends(canvas, size):
    shown = canvas(*size)
    left, right, bottom, top = BOUNDS
    first, last = shown.position_of(left, top), shown.position_of(right, bottom)
    if size[0] > size[1]:
        assert (first.y(), last.y()) == pytest.approx((0, 90))
        assert first.x() == pytest.approx(200 - last.x())
    else:
        assert (first.x(), last.x()) == pytest.approx((0, 90))
        assert first.y() == pytest.approx(200 - last.y())


def test_a_part_fills_the_panel_with_what_is_beside_it(canvas):
    shown = canvas(200, 90, (-2.0, -1.0, 3.0, 4.0))
    axes = shown.figure.axes[0]
    assert axes.get_ylim() == pytest.approx((3, 4))
    assert axes.get_xlim() == pytest.approx((-1.5 - 200 / 90 / 2, -1.5 + 200 / 90 / 2))


def test_a_small_picture_of_many_pixels_has_their_mean(show):
    canvas, n = ImageCanvas(None), 600
    image = map_image(canvas.begin(), "light", Extent((-1, 1, -1, 1), "cm"), (n, n), "gray")
    image.set_data(np.indices((n, n)).sum(axis=0) % 2)  # a chessboard
    image.set_clim(0, 1)
    canvas.recolour()
    show(canvas, 100, 100)
    canvas.show_part((-1, 1, -1, 1))
    canvas.show_changes()
    middle = painted(canvas)[10:90, 10:90].astype(int)
    assert np.abs(middle - 127).max() <= 2


def test_scales_come_with_the_pointer(canvas):
    shown = canvas(400, 300)
    bare = painted(shown)
    shown.show_scales(True)
    with_scales = painted(shown)
    changed = (bare != with_scales).any(axis=-1)
    middle = changed[100:200, 150:250]
    assert changed[-20:].any() and changed[:, :40].any() and changed[:, -40:].any()
    assert not middle.any()
    shown.show_scales(False)
    np.testing.assert_array_equal(painted(shown), bare)
