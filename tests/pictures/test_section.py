import numpy as np
import pytest
from matplotlib.figure import Figure

from workbench.pictures.section import SectionCurves, cut_through


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
    assert curves.update(image, cut_through(scene, along, (1.1, 0.4))) is True  # row 1, column 6
    wanted, light = (artist.get_data() for artist in curves.artists)
    np.testing.assert_allclose(light, [positions, image[line]])
    # As much light in all as the image has.
    np.testing.assert_allclose(wanted, [positions, (target * image.sum() / target.sum())[line]])
    across = "y = 0.4" if along == "x" else "x = 1.1"
    assert axes.get_xlabel() == f"{along} (cm) at {across} cm"
    assert curves.update(image, cut_through(scene, along, (1.1, 0.4))) is False


@pytest.mark.parametrize(("along", "line"), [("x", np.s_[1]), ("y", np.s_[::-1, 6])])
def test_a_cut_across_a_far_field_is_where_its_angles_are(make_scene, rng, along, line):
    far = {"half_angle": [20.0, 10.0], "center": [30.0, -5.0], "pixels": [8, 4]}
    scene, image = make_scene({"screen": None, "far_field": far}), rng.random((4, 8))
    axes = Figure().subplots()
    curves = SectionCurves(axes, scene, np.ones((4, 8)))
    curves.update(image, cut_through(scene, along, (43.0, -1.0)))  # row 1, column 6
    degrees = {"x": 12.5 + 5 * np.arange(8), "y": -12.5 + 5 * np.arange(4)}[along]
    np.testing.assert_allclose(curves.artists[1].get_data(), [degrees, image[line]])
    said = {"x": "H (°) at V = -1°", "y": "V (°) at H = 43°"}[along]
    assert (axes.get_xlabel(), axes.get_ylabel()) == (said, "flux / sr")
    assert axes.get_legend().get_texts()[1].get_text() == "intensity"
