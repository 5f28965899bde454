import io

import numpy as np
import pytest
from matplotlib.figure import Figure

from workbench.analysis.manufacture import surface_maps
from workbench.analysis.manufacture_limits import Limits
from workbench.geometry.surface import ControlNet
from workbench.pictures.manufacture import draw_manufacture, write_manufacture


@pytest.fixture
def maps(make_scene):
    """A bowl that is deeper along x: thickest at the rim, bent most along x."""
    lens = make_scene({"lens.half_width": [1.0, 0.8]}).optic
    x, y = ControlNet.of(lens).positions
    return surface_maps(lens, {"exit": 0.5 + 0.2 * x[:, None] ** 2 + 0.1 * y**2}, (41, 33))


def drawn(maps, limits):
    figure = Figure()
    draw_manufacture(figure, maps, limits, "cm")
    return {axes.get_images()[0].get_label(): axes for axes in figure.axes}


def bar_texts(axes):
    """What stands beside the colours."""
    bar = next(each for each in axes.child_axes)
    return [label.get_text() for label in bar.get_yticklabels()]


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


def test_a_plane_can_be_drawn(make_scene):
    maps = surface_maps(make_scene().optic, {"exit": np.full((12, 10), 0.5)}, (9, 9))
    png = io.BytesIO()
    write_manufacture(png, {"exit face": maps}, Limits(max_slope=1.0), "mm")
    noisy = maps._replace(slope=maps.slope + 1e-12)  # rounding is no slope
    for name, axes in drawn(noisy, Limits()).items():
        if name != "Thickness":
            assert axes.get_images()[0].get_clim() == (0.0, 1.0)
            assert bar_texts(axes) == ["0"]
    assert png.getvalue().startswith(b"\x89PNG")


@pytest.mark.parametrize("unit_height", [3.0, 0.1])
def test_a_plate_has_one_thickness_in_spite_of_rounding(make_scene, rng, unit_height):
    lens = make_scene().optic
    maps = surface_maps(lens, {"exit": np.full((12, 10), 0.5)}, (9, 9))
    thickness = unit_height * (1 + 4e-16 * rng.standard_normal(maps.thickness.shape))
    axes = drawn(maps._replace(thickness=thickness), Limits())["Thickness"]
    image = axes.get_images()[0]
    assert np.unique(image.get_array()).tolist() == pytest.approx([unit_height])
    assert image.get_clim() == pytest.approx((0, 2 * unit_height))
    assert bar_texts(axes) == [f"{unit_height:g}"]
    assert axes.child_axes[0].get_ylabel() == "cm, constant"


def test_a_small_wedge_is_no_rounding(make_scene):
    lens = make_scene().optic
    x, _ = ControlNet.of(lens).positions
    heights = {"exit": np.broadcast_to(0.5 + 1e-6 * x[:, None], (12, 10))}
    maps = surface_maps(lens, heights, (9, 9))
    low, high = drawn(maps, Limits())["Thickness"].get_images()[0].get_clim()
    assert high - low == pytest.approx(2e-6)
