import numpy as np
import pytest
from matplotlib.figure import Figure

from workbench.geometry.surface import ControlNet
from workbench.pictures.surface import ASPECTS, SurfaceImage

NAMED = {aspect.name: aspect for aspect in ASPECTS}


@pytest.fixture
def scene(make_scene):
    base = {"shape": "sphere", "height": 0.5, "radius": 4.0, "form": "concave"}
    return make_scene({"lens.half_width": [1.0, 0.5], "lens.base": base})


@pytest.fixture
def axes():
    return Figure().subplots()


def tilted(scene, a, b):
    """Control heights of the plane z = 0.5 + a x + b y."""
    x, y = ControlNet.of(scene.optic).positions
    return 0.5 + a * x[:, None] + b * y


def test_height_is_that_over_the_base_with_row_0_at_the_top(scene, axes):
    image = SurfaceImage(axes, scene, NAMED["height"])
    image.update(tilted(scene, 0.1, 0.4))
    assert image.values.shape == (96, 192)
    x, y = 1 - 1 / 192, 0.5 - 1 / 192  # the last column of the first row
    wanted = 0.5 + 0.1 * x + 0.4 * y - scene.optic.base.height_at(x, y)
    assert image.values[0, -1] == pytest.approx(wanted, rel=1e-12)
    assert image.values[0, -1] > image.values[-1, -1] > image.values[-1, 0]
    low, high = image.image.get_clim()
    assert low == -high
    assert axes.child_axes[0].get_ylabel() == "height (cm)"


def test_slope_is_an_angle_on_a_scale_from_zero(scene, axes):
    image = SurfaceImage(axes, scene, NAMED["slope"])
    image.update(tilted(scene, 1.0, 0.0))
    np.testing.assert_allclose(image.values, 45)
    assert image.image.get_clim() == (0, 50)
    assert axes.child_axes[0].get_ylabel() == "slope (°)"


def test_the_entrance_face_is_shown_from_its_own_place(make_scene, axes):
    entrance = {"shape": "freeform", "control_points": [6, 7], "height_range": [-0.1, 0.1]}
    scene = make_scene({"lens.entrance": entrance, "lens.entrance_z": -0.2})
    image = SurfaceImage(axes, scene, NAMED["height"], "lens.front")
    image.update(np.full((6, 7), -0.15))
    np.testing.assert_allclose(image.values, 0.05, rtol=1e-12)
