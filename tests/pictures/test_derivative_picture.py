import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from workbench.pictures.images import DerivativeImage


@pytest.fixture
def axes():
    return Figure(layout="constrained").subplots()


@pytest.fixture
def scene(make_scene):
    return make_scene({"screen.half_width": [2.0, 1.0], "screen.pixels": [8, 4]})


def colours(axes, picture):
    """Colour of each pixel, as drawn."""
    canvas = FigureCanvasAgg(axes.figure)
    canvas.draw()
    pixels = np.asarray(canvas.buffer_rgba())[::-1, :, :3].astype(int)
    x, y = np.meshgrid(np.arange(8) / 2 - 1.75, 0.75 - np.arange(4) / 2)
    at = axes.transData.transform(np.stack([x.ravel(), y.ravel()], axis=1)).astype(int)
    return pixels[at[:, 1], at[:, 0]].reshape(4, 8, 3)


def test_gain_is_red_loss_is_blue_and_the_rest_grey(scene, axes):
    derivative = np.zeros((4, 8))
    derivative[0, 0], derivative[1, 5], derivative[2, 2] = 3.0, -3.0, 1e-9
    picture = DerivativeImage(axes, scene)
    assert picture.update(derivative) is True
    seen = colours(axes, picture)
    red, blue, small, none = seen[0, 0], seen[1, 5], seen[2, 2], seen[3, 7]
    assert red[0] > red[2] + 50 and blue[2] > blue[0] + 50
    assert small.min() > 230
    assert np.ptp(none) == 0 and 100 < none[0] < 200
    picture.update(None)
    assert (colours(axes, picture) == none).all()


def test_scale_is_symmetric_and_no_wider_than_the_map(scene, axes):
    picture = DerivativeImage(axes, scene)
    derivative = np.zeros((4, 8))
    derivative[1, 1], derivative[2, 2] = 3.7, -1.2
    assert [picture.update(derivative) for _ in range(2)] == [True, False]
    assert picture.artists[0].get_clim() == (-3.7, 3.7)
