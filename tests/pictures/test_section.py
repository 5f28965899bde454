import numpy as np
import pytest
from matplotlib.figure import Figure

from workbench.pictures.section import SectionCurves


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
def test_curves_are_the_pixels_along_the_line(scene, rng, along, positions, line):
    target, image = rng.random((4, 8)), rng.random((4, 8))
    curves = SectionCurves(Figure().subplots(), scene, target, along)
    curves.update(image, 1.1, 0.4)  # row 1, column 6
    wish, light = (artist.get_data() for artist in curves.artists)
    np.testing.assert_allclose(light, [positions, image[line]])
    # As much light in all as the image has.
    np.testing.assert_allclose(wish, [positions, (target * image.sum() / target.sum())[line]])


def test_beside_the_screen_nothing_changes(scene, rng):
    curves = SectionCurves(Figure().subplots(), scene, np.ones((4, 8)), "x")
    curves.update(rng.random((4, 8)), 2.0, 0.0)
    assert curves.artists[0].get_xdata().size == 0
