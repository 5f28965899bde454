"""Curves, maps and tables as pictures."""

import numpy as np
import pytest
from matplotlib.colors import LogNorm, PowerNorm
from matplotlib.figure import Figure

from workbench.design.session import VerifiedError
from workbench.measured.lamps import light_unit
from workbench.pictures.axes import (
    Extent,
    colour_bar,
    map_image,
    show_constant,
    shown_data,
    ticks_along,
)
from workbench.pictures.error_curves import Curve, draw_sweep
from workbench.pictures.images import IrradianceImage
from workbench.pictures.loss import LossCourse, Verified, draw_loss
from workbench.pictures.section import SectionCurves, cut_through


@pytest.fixture
def axes():
    return Figure().subplots()


def test_the_loss_of_the_shown_lens_is_stated_and_marked(axes):
    losses = np.array([4e-6, 2.51e-6])
    draw_loss(axes, losses, loss=3.28e-6)  # in light that the lens was not fitted to
    assert [text.get_text() for text in axes.texts] == ["3.28 · 10⁻⁶"]
    np.testing.assert_array_equal(axes.lines[-1].get_xydata(), [(2, 3.28e-6)])
    assert axes.get_legend() is None
    assert axes.get_ylim() == pytest.approx((2e-6, 5e-6))


def test_stages_checks_and_other_runs_stand_beside_the_loss(axes):
    other = LossCourse("Run 1", np.array([9e-6, 8e-6, 7e-6]))
    draw_loss(axes, np.array([4e-6, 3e-6]), (1,), verified=[Verified(2, 1e-8)], others=[other])
    names = [text.get_text() for text in axes.get_legend().get_texts()]
    assert names == ["this run", "Run 1", "verified"]
    assert [line.get_xdata()[0] for line in axes.lines if line.get_linestyle() == ":"] == [1.5]
    low, high = axes.get_ylim()
    assert low < 1e-8 and high > 9e-6


def test_a_lens_without_iterations_has_no_loss(axes):
    draw_loss(axes, np.zeros(0), loss=3.28e-6)
    assert not axes.texts and not any(line.get_xdata().size for line in axes.lines)


def found(percent, beside=0.1):
    low, high = percent - beside, percent + beside
    return VerifiedError(percent / 100, (max(low, 0) / 100, high / 100))


def drawn(*curves):
    axes = Figure().subplots()
    draw_sweep(axes, "Lens · Index", curves)
    return axes


def test_lenses_stand_at_their_numbers_in_order():
    axes = drawn(Curve("", ("1.6", "1.4", "1.5"), (found(3), found(1), found(2))))
    (container,) = axes.containers
    line, _, (bars,) = container
    assert np.allclose(line.get_xydata(), [(1.4, 1), (1.5, 2), (1.6, 3)])
    assert np.allclose(bars.get_segments()[0][:, 1], [0.9, 1.1])
    assert axes.get_ylim()[0] == 0
    assert axes.get_legend() is None
    assert axes.get_xlabel() == "Lens · Index"


@pytest.fixture
def scene(make_scene):
    return make_scene({"screen.half_width": [2.0, 1.0], "screen.pixels": [8, 4]})


@pytest.mark.parametrize(
    ("along", "positions", "line"),
    [
        ("x", [-1.75, -1.25, -0.75, -0.25, 0.25, 0.75, 1.25, 1.75], np.s_[1]),
        ("y", [-0.75, -0.25, 0.25, 0.75], np.s_[::-1, 6]),
    ],
)
def test_curves_are_the_pixels_along_the_axis(scene, rng, along, positions, line):
    target, image = rng.random((4, 8)), rng.random((4, 8))
    axes = Figure().subplots()
    curves = SectionCurves(axes, scene, target)
    curves.update(image, cut_through(scene, along, (1.1, 0.4)))  # row 1, column 6
    wanted, light = curves.wanted.get_data(), curves.light.get_data()
    np.testing.assert_allclose(light, [positions, 8 * image[line]])  # of 8 cm²
    # As much light in all as the image has.
    np.testing.assert_allclose(wanted, [positions, (8 * target * image.sum() / target.sum())[line]])
    across = "y = 0.4" if along == "x" else "x = 1.1"
    assert axes.get_xlabel() == f"{along} (cm) at {across} cm"


@pytest.mark.parametrize(("along", "line"), [("x", np.s_[1]), ("y", np.s_[::-1, 6])])
def test_a_cut_across_a_far_field_is_where_its_angles_are(make_scene, rng, along, line):
    far = {"half_angle": [20.0, 10.0], "center": [30.0, -5.0], "pixels": [8, 4]}
    scene, image = make_scene({"screen": None, "far_field": far}), rng.random((4, 8))
    axes = Figure().subplots()
    curves = SectionCurves(axes, scene, np.ones((4, 8)))
    curves.update(image, cut_through(scene, along, (43.0, -1.0)))  # row 1, column 6
    degrees = {"x": 12.5 + 5 * np.arange(8), "y": -12.5 + 5 * np.arange(4)}[along]
    np.testing.assert_allclose(
        curves.light.get_data(), [degrees, image[line] * light_unit(scene).density]
    )
    stated = {"x": "H (°) at V = -1°", "y": "V (°) at H = 43°"}[along]
    assert (axes.get_xlabel(), axes.get_ylabel()) == (stated, "× mean")
    assert axes.get_legend().get_texts()[1].get_text() == "intensity"


@pytest.fixture
def figure():
    return Figure()


def test_an_image_is_places_and_values_along_the_rows(scene, figure, rng):
    image = rng.random((4, 8))
    IrradianceImage(figure.subplots(), scene, np.ones((4, 8))).update(image)
    x, y, values = shown_data(figure)
    assert [x.name, y.name] == ["x [cm]", "y [cm]"]
    assert values.name == "irradiance [x mean]"
    np.testing.assert_allclose(x.values[:8], np.arange(-1.75, 2, 0.5))
    np.testing.assert_allclose(y.values[::8], [0.75, 0.25, -0.25, -0.75])
    np.testing.assert_allclose(values.values, 8 * image.ravel(), rtol=1e-12)  # cm² of the screen


def test_curves_of_the_same_places_share_them(scene, figure, rng):
    image = rng.random((4, 8))
    SectionCurves(figure.subplots(), scene, np.ones((4, 8))).update(
        image, cut_through(scene, "x", (0.0, 0.1))
    )
    columns = shown_data(figure)
    assert [column.name for column in columns] == [
        "x [cm] at y = 0.1 cm",
        "target: x mean",
        "irradiance: x mean",
    ]
    np.testing.assert_allclose(columns[2].values, 8 * image[1], rtol=1e-12)


@pytest.fixture
def image():
    """A map with a colour bar."""
    axes = Figure().subplots()
    image = map_image(axes, "height", Extent.around((1.0, 1.0), "mm"), (2, 2), "gray")
    colour_bar(axes, image, "height (mm)", "both")
    return image


def test_axes_have_a_power_too_and_files_of_numbers_have_none():
    axes = Figure().subplots()
    image = map_image(axes, "height", Extent.around((0.004, 0.004), "m"), (2, 2), "gray")
    colour_bar(axes, image, "height (m)", "both")
    image.set_data(np.full((2, 2), 3e-5))
    image.set_clim(0, 4e-5)
    axes.figure.draw_without_rendering()
    assert axes.get_xlabel() == "x (10⁻³ m)"
    assert "−2" in {text.get_text() for text in axes.get_xticklabels()}
    x, y, height = shown_data(axes.figure)
    assert [each.name for each in (x, y, height)] == ["x [m]", "y [m]", "height [m]"]
    assert height.values == pytest.approx(3e-5)
    assert np.abs(x.values).max() == pytest.approx(0.002)


@pytest.fixture
def map_of(figure):
    """An image with axes, and its colour bar."""
    axes = figure.add_subplot()
    image = map_image(axes, "light", Extent((-1, 1, 3, 5), "cm"), (4, 4), "viridis")
    image.set_clim(0.01, 100)
    return image, colour_bar(axes, image, "lx", "max")


def test_ticks_for_other_painters_are_round_and_in_place(map_of):
    image, _ = map_of
    axes = image.axes
    assert ticks_along(axes.xaxis, 4) == [
        (0.0, "−1.0"),
        (0.25, "−0.5"),
        (0.5, "0.0"),
        (0.75, "0.5"),
        (1.0, "1.0"),
    ]
    axes.set_xlim(1, -1)  # an axis to the left
    assert ticks_along(axes.xaxis, 2) == [(1.0, "−1"), (0.5, "0"), (0.0, "1")]
    assert ticks_along(axes.yaxis, 0)[0] == (0.0, "3")
    axes.set_xlim(0, 5e-5)  # whose label has the power
    numbers = [number for _, number in ticks_along(axes.xaxis, 5)]
    assert numbers == ["0", "10", "20", "30", "40", "50"]


def test_ticks_of_a_colour_bar_follow_its_scale(map_of):
    image, bar = map_of
    image.set_norm(LogNorm(0.01, 100))
    wanted = [(0.0, "0.01"), (0.25, "0.1"), (0.5, "1"), (0.75, "10"), (1.0, "100")]
    found = ticks_along(bar.ax.yaxis, 9)
    assert [number for _, number in found] == [number for _, number in wanted]
    np.testing.assert_allclose([part for part, _ in found], [part for part, _ in wanted])
    image.set_norm(PowerNorm(0.5, 0, 100))
    parts = {number: part for part, number in ticks_along(bar.ax.yaxis, 4)}
    assert parts["50"] == pytest.approx(0.5**0.5)


def test_a_constant_has_one_tick(figure):
    image = map_image(figure.add_subplot(), "z", Extent((-1, 1, -1, 1), "cm"), (4, 4), "viridis")
    show_constant(image, 0.25, "cm")
    (bar,) = image.axes.child_axes
    assert ticks_along(bar.yaxis, 9) == [(0.5, "0.25")]
