"""The light of a source at places of the entrance face, and all that it emits."""

import math

import numpy as np
import pytest

from tests.scenes import changed
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.sources import light_source
from workbench.analysis.tracing.sources.sampling import BATCHES
from workbench.scene import Scene

ABOVE = {"kind": "point", "position": [0.3, -0.2, -4.0]}
NEAR = {"kind": "point", "position": [1.6, 0.2, -0.2]}  # part of its cone goes down
GRID = {"kind": "grid", "center": [0.1, 0, -4], "half_width": [0.5, 1], "points": [2, 3]}
TILTED = Pose(tilt=(0.1, -0.2), decentre=(0.1, 0.0))


def light(source, pose=None, rays=1):
    scene = Scene.from_data(changed({"source": source, "lens.half_width": [1.0, 0.7]}))
    return light_source(scene.source, scene.optic, pose or Pose(), rays, 1)


def places(count):
    within = (np.arange(count) + 0.5) / count * 2 - 1
    return np.repeat(within, count), np.tile(within, count) * 0.7, 4 * 0.7 / count**2


@pytest.mark.parametrize("source", [ABOVE, NEAR, GRID])
@pytest.mark.parametrize("emission", ["uniform", "lambertian"])
@pytest.mark.parametrize("pose", [Pose(), TILTED])
def test_emitted_flux_equals_that_of_random_rays(source, emission, pose):
    random = light(source | {"emission": emission}, pose, 200_000)
    flux = sum(rays.flux.sum() for number in range(BATCHES) for rays in random.batch(number))
    assert random.emitted == pytest.approx(flux / random.rays * random.origins, rel=2e-3)


@pytest.mark.parametrize("source", [ABOVE, NEAR, GRID])
@pytest.mark.parametrize("emission", ["uniform", "lambertian"])
@pytest.mark.parametrize("pose", [Pose(), TILTED])
def test_flux_at_the_face_equals_that_of_random_rays(source, emission, pose):
    even = light(source | {"emission": emission}, pose, 400_000)
    x, y, area = places(300)
    came = sum(even.through(origin, x, y).flux.sum() * area for origin in range(even.origins))
    emitted = met = 0.0
    for number in range(BATCHES):
        for rays in even.batch(number):
            on = (np.abs(rays.position[:, :2]) <= [1.0, 0.7]).all(axis=1)
            met += rays.flux[on & (rays.direction[:, 2] > 0)].sum()
            emitted += rays.flux.sum()
    assert came / even.emitted == pytest.approx(met / emitted, rel=4e-3)


def test_the_solid_angle_of_the_face():
    x, y, area = places(400)
    axial = light({"kind": "point", "position": [0, 0, -2.0]})
    solid = 4 * math.atan(0.7 / (2 * math.sqrt(1 + 0.7**2 + 4)))
    flux = axial.through(0, x, y).flux.sum() * area
    assert flux == pytest.approx(solid / (2 * math.pi), rel=1e-5)
