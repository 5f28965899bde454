"""Maps of a derivative and of manufacture."""

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure

from workbench.analysis.manufacture import exceeded, surface_maps
from workbench.analysis.shop_limits import Limits
from workbench.geometry.surface import ControlNet
from workbench.pictures.axes import BEYOND, WITHIN
from workbench.pictures.images import DerivativeImage
from workbench.pictures.manufacture import draw_manufacture, draw_map
from workbench.targets.colour import SRGB


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
    picture.update(derivative)
    seen = colours(axes, picture)
    red, blue, small, none = seen[0, 0], seen[1, 5], seen[2, 2], seen[3, 7]
    assert red[0] > red[2] + 50 and blue[2] > blue[0] + 50
    assert small.min() > 230
    assert np.ptp(none) == 0 and 100 < none[0] < 200
    picture.update(None)
    assert (colours(axes, picture) == none).all()


@pytest.fixture
def maps(make_scene):
    """A bowl that is deeper along x: thickest at the rim, bent most along x."""
    lens = make_scene({"lens.half_width": [1.0, 0.8]}).optic
    x, y = ControlNet.of(lens).positions
    return surface_maps(lens, {"lens.back": 0.5 + 0.2 * x[:, None] ** 2 + 0.1 * y**2}, (41, 33))


def drawn(maps, limits):
    figure = Figure()
    draw_manufacture(figure, maps, limits, "cm")
    return {axes.get_images()[0].get_label(): axes for axes in figure.axes}


def test_one_map_shows_where_any_limit_is_exceeded(maps):
    limits = Limits(max_slope=15.0, max_thickness=0.7)
    axes = Figure().subplots()
    count = draw_map(axes, "Limits", maps, limits, "cm")
    masks = exceeded(maps, limits)
    np.testing.assert_array_equal(count, sum(mask.astype(int) for mask in masks.values()))
    assert count.max() == 2
    assert hatched(axes, -0.98, 0.7) and not hatched(axes, 0.1, 0.0)
    part = (masks["slope"].mean(), masks["thickness"].mean(), (count == 0).mean())
    steep, thick, within = (f"{100 * each:.2g} %" for each in part)
    texts = [text.get_text() for text in axes.get_legend().get_texts()]
    assert texts == [f"Within limits ({within})", f"Thickness ({thick})", f"Slope ({steep})"]
    draw_map(axes := Figure().subplots(), "Limits", maps, Limits(), "cm")
    assert axes.get_legend().get_texts()[0].get_text() == "No limit is set (100 %)"


def test_areas_within_limits_are_told_from_others_by_their_brightness_alone():
    red, green = (
        sum(SRGB.light(np.array(to_rgb(colour))) * (0.2126, 0.7152, 0.0722))
        for colour in (BEYOND, WITHIN)
    )
    assert (green + 0.05) / (red + 0.05) > 3


def hatched(axes, x, y):
    """Whether a place lies in the hatched region."""
    return any(
        path.contains_point((x, y)) for shape in axes.collections for path in shape.get_paths()
    )


def test_each_map_shows_its_values(maps):
    found = drawn(maps, Limits())
    for name, values in (
        ("Thickness", maps.thickness),
        ("Slope", maps.slope),
        ("Concave curvature", maps.concave),
        ("Convex curvature", maps.convex.clip(0)),
    ):
        image = found[name].get_images()[0]
        assert np.asarray(image.get_array()) == pytest.approx(values)
        assert image.get_extent() == pytest.approx((-1.0, 1.0, -0.8, 0.8))
        assert not found[name].collections


def test_areas_beyond_limits_are_hatched(maps):
    limits = Limits(min_thickness=0.55, max_thickness=0.7, max_slope=15.0, min_radius=2.6)
    found = drawn(maps, limits)
    thick, steep = found["Thickness"], found["Slope"]
    assert hatched(thick, 0.05, 0.05)  # too thin
    assert hatched(thick, 0.98, 0.7)  # too thick
    assert not hatched(thick, 0.7, 0.0)
    assert hatched(steep, -0.9, 0.0)
    assert not hatched(steep, 0.1, 0.0)
    assert hatched(found["Concave curvature"], 0.0, 0.0)
    assert not found["Convex curvature"].collections
    assert thick.get_title() == "Thickness, at least 0.55 cm, at most 0.7 cm"
    assert steep.get_title() == "Slope, at most 15°"
    assert found["Convex curvature"].get_title().endswith("radius at least 2.6 cm")
