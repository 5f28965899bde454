import numpy as np
import pytest
from matplotlib.figure import Figure

from workbench.pictures.figure_data import shown_data
from workbench.pictures.images import IrradianceImage
from workbench.pictures.section import SectionCurves, cut_through


@pytest.fixture
def scene(make_scene):
    return make_scene({"screen.half_width": [2.0, 1.0], "screen.pixels": [8, 4]})


@pytest.fixture
def figure():
    return Figure()


def test_an_image_is_places_and_values_along_the_rows(scene, figure, rng):
    image = rng.random((4, 8))
    IrradianceImage(figure.subplots(), scene, np.ones((4, 8))).update(image)
    x, y, values = shown_data(figure)
    assert [x.name, y.name] == ["x [cm]", "y [cm]"]
    assert values.name == "irradiance [flux / cm^2]"
    np.testing.assert_allclose(x.values[:8], np.arange(-1.75, 2, 0.5))
    np.testing.assert_allclose(y.values[::8], [0.75, 0.25, -0.25, -0.75])
    np.testing.assert_array_equal(values.values, image.ravel())


def test_curves_of_the_same_places_share_them(scene, figure, rng):
    image = rng.random((4, 8))
    SectionCurves(figure.subplots(), scene, np.ones((4, 8))).update(
        image, cut_through(scene, "x", (0.0, 0.1))
    )
    columns = shown_data(figure)
    assert [column.name for column in columns] == [
        "x [cm] at y = 0.1 cm",
        "target: flux / cm^2",
        "irradiance: flux / cm^2",
    ]
    np.testing.assert_array_equal(columns[2].values, image[1])
