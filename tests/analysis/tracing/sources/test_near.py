"""Random places as dense as the light of a source close by."""

import numpy as np
import pytest

from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.sources import light_source


@pytest.mark.parametrize("emission", ["lambertian", "uniform"])
def test_rays_of_an_emitter_close_by_carry_almost_the_same_flux(make_scene, emission):
    near = {"kind": "area", "center": [0.1, 0, -0.2], "half_width": [0.02, 0.02]}
    scene = make_scene({"source": near | {"emission": emission}})
    light = light_source(scene.source, scene.optic, Pose(), 50_000, 1)
    flux = np.concatenate([rays.flux for number in range(16) for rays in light.batch(number)])
    # Even places would give a spread of twice the mean and more.
    assert flux.std() < 0.5 * flux.mean()


@pytest.mark.parametrize("away", [0.1, 1e-3, 1e-9])
def test_a_wide_emitter_close_by_lights_the_face_beside_its_middle(make_scene, away):
    """Each ray carries about as much, also where a point lights a spot of a billionth."""
    near = {"kind": "area", "center": [0.1, 0, -away], "half_width": [0.3, 0.3]}
    scene = make_scene({"source": near})
    light = light_source(scene.source, scene.optic, Pose(), 50_000, 1)
    rays = [rays for number in range(16) for rays in light.batch(number)]
    flux = np.concatenate([each.flux for each in rays])
    assert flux.sum() / light.rays * (1 + light.beside) == pytest.approx(1, abs=0.01)
    assert flux.std() < flux.mean()
    x = np.concatenate([each.position[:, 0] for each in rays])
    mean = np.average(x, weights=flux)
    assert mean == pytest.approx(0.1, abs=0.01)
    assert np.sqrt(np.average((x - mean) ** 2, weights=flux)) > 0.3 / np.sqrt(3) - 0.01
