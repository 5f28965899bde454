"""Light of collimated beams, cones and near emitters in the check."""

import numpy as np
import pytest

from tests.optics.points import smooth
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.sources import light_source
from workbench.analysis.tracing.sources.cones import covering_cones
from workbench.analysis.validation import validate
from workbench.optics.plan import Plan
from workbench.optics.sources.emission import covering_caps

SUN = {"kind": "collimated", "angular_diameter": 6.0}


TILTED = {"kind": "collimated", "direction": [8.0, -5.0], "angular_diameter": 2.0}


PARALLEL = {"kind": "collimated", "direction": [8.0, -5.0]}


BEAM = {"kind": "collimated", "profile": {"kind": "gaussian", "radius": 0.7}}


OBLIQUE = BEAM | {"direction": [10.0, 4.0], "angular_diameter": 3.0}


ALL = pytest.mark.parametrize("source", [SUN, TILTED, PARALLEL, BEAM, OBLIQUE])


@pytest.mark.usefixtures("fewer_rays")
@ALL
def test_the_check_agrees_with_the_walk(make_scene, source):
    few = {"screen.pixels": [8, 8], "filter": {"kind": "box"}}
    scene = make_scene(few | {"source": source | {"rays": [250, 250]}})
    heights = smooth(scene)
    light = Plan(scene, fused=False).trace({"lens.back": heights})
    image = light.flux.double().numpy() / scene.receiver.pixel_measure
    faces = {"lens.back": heights.numpy()}
    found = validate(scene, image, faces, rays=60_000, accuracy=0.05)
    assert found.relative_l2_corrected < 2e-2
    assert found.account.on_screen + sum(found.account.lost.values()) == pytest.approx(1, abs=1e-9)
    for name, flux in found.account.lost.items():
        assert flux == pytest.approx(light.account.lost[name], abs=3e-3), name
    assert found.by_cells is not None
    assert found.by_cells.unscattered.distance < found.by_cells.bound + 5e-3


@pytest.mark.parametrize("half_width", [(1.0, 1.0), (1.0, 0.01), (1e-6, 2e-6), (0.3, 4.0)])
@pytest.mark.parametrize("distance", [1e-2, 1.0, 1e2, 1e6, 1e12])
def test_cones_equal_those_of_the_optimiser(half_width, distance, rng):
    aside = rng.uniform(-2, 2, (50, 2)) * max(1.0, distance)
    points = np.column_stack([aside, np.full(50, 0.5 - distance)])
    cones, caps = covering_cones(points, half_width, 0.5), covering_caps(points, half_width, 0.5)
    assert cones.versine == pytest.approx(caps.versine, rel=1e-9)
    assert cones.axis == pytest.approx(caps.axis, abs=1e-9)
    assert cones.centre == pytest.approx(caps.centre, abs=1e-7 * min(half_width))


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
