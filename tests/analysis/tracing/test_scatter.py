"""Random directions of scattered light in the check."""

import numpy as np
import pytest

from tests.diffusers import with_diffuser
from workbench.analysis.tracing.elements import Crossings, TracedRays
from workbench.analysis.tracing.interfaces import ScatterBoundary
from workbench.scene import Scene


@pytest.mark.parametrize("alike", [False, True])
@pytest.mark.parametrize("kind", [{"kind": "gaussian", "sigma": 10}, {"kind": "lambertian"}])
def test_they_do_not_depend_on_where_lost_rays_are(kind, alike, rng):
    boundary = ScatterBoundary(Scene.from_data(with_diffuser(kind)).elements[1])
    position = rng.random((50, 3))
    direction = np.tile([0.0, 0.0, 1.0], (1 if alike else 50, 1))
    flux = np.ones(50)
    flux[:3] = 0.0
    found = []
    for lost in (0.0, np.nan):
        position[:3] = lost
        crossings = Crossings(position, np.array([[0.0, 0.0, 1.0]]), flux)
        found.append(boundary.turn(TracedRays(position, direction, flux), crossings)[0])
    assert np.array_equal(found[0].direction[3:], found[1].direction[3:])
    assert np.ptp(found[0].direction[3:], axis=0).min() > 0
