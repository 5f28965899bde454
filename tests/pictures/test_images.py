import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure

from workbench.pictures.axes import AS_SEEN, SIGNED, paint, round_scale
from workbench.pictures.images import (
    IrradianceImage,
    PhotoImage,
    colours_for,
    full_scale,
    signed_error,
    target_irradiance,
    to_colours,
)
from workbench.targets.colour import SRGB


@pytest.fixture
def scene(make_scene):
    return make_scene({"screen.half_width": [2.0, 1.0], "screen.pixels": [8, 4]})


@pytest.fixture
def axes():
    return Figure(layout="constrained").subplots()


def test_target_irradiance_carries_unit_flux(scene, rng):
    target = rng.random((4, 8))
    flux = target_irradiance(scene, target).sum() * scene.receiver.pixel_measure
    assert flux == pytest.approx(1, abs=1e-12)


def test_error_compares_at_equal_flux(scene, rng):
    target = rng.random((4, 8))
    np.testing.assert_allclose(signed_error(scene, target, 3.7 * target), 0, atol=1e-12)


def test_error_is_positive_where_light_is_too_much(scene):
    target = np.ones((4, 8))
    light = np.zeros((4, 8))
    light[:, :4] = 1
    error = signed_error(scene, target, light)
    np.testing.assert_allclose(error[:, :4], 1 / 8)
    np.testing.assert_allclose(error[:, 4:], -1 / 8)


@pytest.mark.parametrize(
    ("largest", "scale"), [(0.11, 0.2), (0.5, 0.5), (0.51, 1.0), (7.0, 10.0), (0.0, 1.0)]
)
def test_round_scale(largest, scale):
    assert round_scale(largest) == pytest.approx(scale)


def drawn_image(figure):
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    return np.asarray(canvas.buffer_rgba())[..., :3].astype(int)


def test_row_0_is_at_the_top_and_column_0_at_the_left(scene, axes):
    target = np.ones((4, 8))
    light = np.zeros((4, 8))
    light[0, 0] = full_scale(scene, target)
    picture = IrradianceImage(axes, scene, target)
    picture.update(light)
    pixels = drawn_image(axes.figure)
    height = pixels.shape[0]
    column, row = axes.transData.transform((-1.75, 0.75))  # centre of pixel (0, 0)
    bright = pixels[height - 1 - int(row), int(column)]
    column, row = axes.transData.transform((1.75, -0.75))
    dark = pixels[height - 1 - int(row), int(column)]
    assert bright.sum() > 600 and dark.sum() < 30


@pytest.mark.parametrize("flux", [1.0, 0.9, 0.5, 0.117, 1e-4])
def test_a_right_image_has_the_colours_of_its_target_however_much_light_is_lost(
    axes, scene, rng, flux
):
    target = rng.random((4, 8))
    lit = IrradianceImage(axes, scene, target)
    lit.update(target_irradiance(scene, target, flux))
    brightest = lit.image.norm(lit.image.get_array()).max()
    assert 0.73 < brightest < 0.88
    lit.set_logarithmic(True)
    assert lit.image.norm.vmax == 8 * full_scale(scene, target, flux)  # of a screen of 8 cm²


def test_a_far_field_is_drawn_in_degrees_counted_from_the_axis(make_scene, axes):
    far = {"half_angle": [20.0, 10.0], "center": [30.0, -5.0], "pixels": [8, 4]}
    image = IrradianceImage(axes, make_scene({"screen": None, "far_field": far}), np.ones((4, 8)))
    assert axes.get_xlim() == (10, 50) and axes.get_ylim() == (-15, 5)
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("H (°)", "V (°)")
    assert axes.child_axes[0].get_ylabel() == "× mean"
    assert image.image.get_label() == "intensity"


def test_an_error_of_nothing_has_the_colour_of_the_ground_in_both_themes():
    axes = Figure().add_subplot()
    image = axes.imshow(np.zeros((2, 2)), cmap=SIGNED, vmin=-1, vmax=1)
    for ink, paper in (("white", "#323232"), ("black", "#efefef")):
        paint(axes.figure, ink, paper)
        low, zero, high = (np.array(image.to_rgba(value)[:3]) for value in (-1.0, 0.0, 1.0))
        away = [np.abs(zero - to_rgb(other)).max() for other in (paper, ink)]
        assert away[0] < 0.1 < away[1]
        assert low[2] > low[0] and high[0] > high[2]  # blue and red


@pytest.mark.parametrize(("side", "ends"), [("front", (2.0, -2.0)), ("back", (-2.0, 2.0))])
def test_a_photo_lies_as_its_viewer_sees_the_receiver(axes, make_scene, rng, side, ends):
    scene = make_scene(
        {
            "screen.half_width": [2.0, 1.0],
            "screen.pixels": [8, 4],
            "target.viewed_from": side,
        }
    )
    colours = rng.integers(0, 255, (4, 8, 3), dtype=np.uint8)
    photo = PhotoImage(axes, scene)
    photo.update(colours)
    (image,) = axes.images
    np.testing.assert_array_equal(image.get_array(), colours)
    assert tuple(image.get_extent()) == (*ends, -1.0, 1.0)


def test_pictures_are_shown_as_seen_and_light_in_lux_in_colours(make_scene):
    picture = {"target": {"image": "picture.png"}}
    assert colours_for(make_scene(picture)) == AS_SEEN
    assert colours_for(make_scene()) == "inferno"


def test_greys_as_seen_are_those_of_the_picture():
    stored = np.arange(256)
    greys = to_colours(SRGB.light(stored / 255), 1.0, AS_SEEN)
    assert np.abs(greys[:, 0].astype(int) - stored).max() <= 1
    assert (greys[:, 0] == greys[:, 2]).all()
