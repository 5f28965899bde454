import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from workbench.pictures.axes import paint, pixel_at, round_scale, stable_scale
from workbench.pictures.images import (
    ErrorImage,
    IrradianceImage,
    full_scale,
    shown_error,
    signed_error,
    target_irradiance,
    to_colours,
)


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


@pytest.mark.parametrize("scale", [1.7e308, 1e-310])
def test_target_irradiance_of_huge_and_tiny_values_is_that_of_their_ratios(scene, scale):
    target = np.linspace(0, 1, 32).reshape(4, 8)
    np.testing.assert_allclose(
        target_irradiance(scene, scale * target), target_irradiance(scene, target), rtol=1e-9
    )


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


def test_no_light_at_all_lacks_the_whole_target(scene):
    target = np.ones((4, 8))
    np.testing.assert_allclose(signed_error(scene, target, np.zeros((4, 8))), -1 / 8)
    np.testing.assert_allclose(shown_error(scene, target, np.zeros((4, 8))), -1 / 8)


def test_error_that_is_shown_is_the_difference_of_what_is_shown_beside_it(scene, rng):
    target, light = rng.random((4, 8)), 0.01 * rng.random((4, 8))
    wanted = target_irradiance(scene, target, scene.receiver.total(light))
    np.testing.assert_allclose(shown_error(scene, target, light), light - wanted, atol=1e-15)


@pytest.mark.parametrize(
    ("largest", "scale"), [(0.11, 0.2), (0.5, 0.5), (0.51, 1.0), (7.0, 10.0), (0.0, 1.0)]
)
def test_round_scale(largest, scale):
    assert round_scale(largest) == pytest.approx(scale)


def test_a_scale_settles():
    values = np.array([0.0, -0.3, 0.4])
    assert stable_scale(values, 1.0) == 1.0
    assert stable_scale(2 * values, 0.5) == 1.0
    assert stable_scale(values / 10, 1.0) == pytest.approx(0.05)


def test_other_colours_keep_the_scale(axes, scene):
    image = IrradianceImage(axes, scene, np.ones((4, 8)))
    shown = image.artists[0]
    before = shown.get_clim()
    image.set_colours("viridis")
    assert shown.get_cmap().name == "viridis" and shown.get_clim() == before
    np.testing.assert_allclose(shown.get_cmap()(np.nan), shown.get_cmap()(0.0))
    assert (to_colours(np.ones((1, 1)), 1.0, "gray") == 255).all()


def test_colours_saturate_above_the_scale():
    colours = to_colours(np.array([[0.0, 1.0, 99.0]]), 1.0)
    assert colours.dtype == np.uint8 and colours.shape == (1, 3, 3)
    np.testing.assert_array_equal(colours[0, 1], colours[0, 2])
    assert (colours[0, 0] < colours[0, 1]).any()


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


def test_axes_and_bar_are_in_scene_units(scene, axes):
    IrradianceImage(axes, scene, np.ones((4, 8)))
    assert axes.get_xlim() == (-2, 2) and axes.get_ylim() == (-1, 1)
    assert axes.get_xlabel() == "x (cm)"
    (bar,) = axes.child_axes
    assert bar.get_ylabel() == "flux / cm²"


def test_error_scale_follows_the_errors_in_steps(scene, axes):
    target = np.ones((4, 8))
    picture = ErrorImage(axes, scene, target)
    light = np.ones((4, 8))
    light[::2] += 0.5
    changes = [picture.update(light) for _ in range(3)]
    assert changes == [True, False, False]
    low, high = picture.artists[0].get_clim()
    assert low == -high
    largest = np.abs(shown_error(scene, target, light)).max()
    assert high == round_scale(largest)


def test_paint_recolours_the_bar_too(scene, axes):
    IrradianceImage(axes, scene, np.ones((4, 8)))
    paint(axes.figure, "#ff0000", "#00ff00")
    (bar,) = axes.child_axes
    for part in (axes, bar):
        assert part.yaxis.label.get_color() == "#ff0000"
        assert part.spines["left"].get_edgecolor() == (1.0, 0.0, 0.0, 1.0)
    assert axes.figure.get_facecolor() == (0.0, 1.0, 0.0, 1.0)


@pytest.mark.parametrize(
    ("place", "pixel"),
    [
        ((-2, 1), (0, 0)),
        ((1.99, -0.99), (3, 7)),
        ((0.1, 0.1), (1, 4)),
        ((2, 0), None),
        ((0, 1.01), None),
        ((0, -1), None),
    ],
)
def test_a_place_is_in_one_pixel(place, pixel):
    assert pixel_at((-2.0, 2.0, -1.0, 1.0), (4, 8), *place) == pixel


def test_a_logarithmic_scale_spans_three_decades_and_darkness(axes, scene):
    target = np.ones((4, 8))
    image = IrradianceImage(axes, scene, target)
    image.set_logarithmic(True)
    top = full_scale(scene, target)
    levels = np.zeros((4, 8))
    levels[0, :4] = top, top / 10, top / 1000, top / 1e6
    image.artists[0].set_data(levels)
    shown = image.artists[0]
    colours = shown.to_rgba(shown.get_array())[0, :5]
    wanted = shown.get_cmap()([1.0, 2 / 3, 0.0, 0.0, 0.0])
    np.testing.assert_allclose(colours[:, :3], wanted[:, :3], atol=0.01)
    image.set_logarithmic(False)
    np.testing.assert_allclose(shown.norm(levels)[0, :2], [1.0, 0.1])


@pytest.mark.parametrize("flux", [1.0, 0.9, 0.5, 0.117, 1e-4])
def test_a_right_image_has_the_colours_of_its_target_however_much_light_is_lost(
    axes, scene, rng, flux
):
    target = rng.random((4, 8))
    lit = IrradianceImage(axes, scene, target)
    lit.update(target_irradiance(scene, target, flux))
    brightest = lit.artists[0].norm(lit.artists[0].get_array()).max()
    assert 0.73 < brightest < 0.88
    lit.set_logarithmic(True)
    assert lit.artists[0].norm.vmax == full_scale(scene, target, flux)


def test_a_scale_stays_while_light_changes_little(axes, scene):
    target = np.ones((4, 8))
    image = IrradianceImage(axes, scene, target)
    changes = [
        image.update(target_irradiance(scene, target, flux)) for flux in (0.9, 0.88, 0.86, 0.5)
    ]
    assert changes == [False, False, False, True]
    assert full_scale(scene, target, 0.0) == full_scale(scene, target)


def test_a_far_field_is_drawn_in_degrees_counted_from_the_axis(make_scene, axes):
    far = {"half_angle": [20.0, 10.0], "center": [30.0, -5.0], "pixels": [8, 4]}
    image = IrradianceImage(axes, make_scene({"screen": None, "far_field": far}), np.ones((4, 8)))
    assert axes.get_xlim() == (10, 50) and axes.get_ylim() == (-15, 5)
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("H (°)", "V (°)")
    assert axes.child_axes[0].get_ylabel() == "flux / sr"
    assert image.artists[0].get_label() == "intensity"


def test_numbers_beside_the_bar_stay_written_out_when_the_scale_changes(make_scene):
    scene = make_scene({"screen.half_width": [1000.0, 1000.0]})
    axes = Figure().subplots()
    image = IrradianceImage(axes, scene, np.ones((32, 32)))
    bar = axes.child_axes[0].yaxis
    for logarithmic in (False, True, False):
        image.set_logarithmic(logarithmic)
        axes.figure.draw_without_rendering()
        assert bar.get_offset_text().get_text() == ""
    assert not [text.get_text() for text in bar.get_ticklabels() if "e" in text.get_text()]
