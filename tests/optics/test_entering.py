"""How much light enters: against closed forms, and against counting rays."""

import numpy as np
import pytest

from workbench.geometry.surface import ControlNet
from workbench.optics.entering import entering
from workbench.optics.path import Path
from workbench.optics.transmittance import TransmittanceLaw

POINT = {"kind": "point", "position": [0.3, -0.2, -5.0], "rays": 1 << 16}
GRID = {"kind": "grid", "center": [0, 0.1, -1], "half_width": [1, 1], "points": [3, 4]}


@pytest.mark.parametrize("distance", [1e-6, 1e-3, 0.5, 5.0, 1e3])
def test_a_square_seen_from_its_axis(make_scene, distance):
    scene = make_scene({"source": POINT | {"position": [0, 0, -distance]}})
    light = entering(scene.source, scene.optic, TransmittanceLaw.of(scene.optic)[0])
    square = 4 * np.arcsin(1 / (1 + distance**2))  # its solid angle
    rim = np.sqrt(distance**2 / (distance**2 + 2))
    cap = 2 * np.pi * (2 / (distance**2 + 2)) / (1 + rim)
    assert light.missed == pytest.approx(1 - square / cap, abs=1e-9)


@pytest.mark.parametrize("emission", ["uniform", "lambertian"])
@pytest.mark.parametrize(
    "source",
    [POINT, POINT | {"position": [3, 0, -1]}, POINT | {"position": [0.9, 1, -1e-3]}, GRID],
    ids=["far", "beside", "near", "grid"],
)
def test_the_account_is_that_of_many_rays(make_scene, source, emission):
    scene = make_scene({"source": source | {"rays": 1 << 15, "emission": emission}})
    light = entering(scene.source, scene.optic, TransmittanceLaw.of(scene.optic)[0])
    lost = Path.of(scene, ControlNet.of(scene.optic)).lost
    assert light.missed == pytest.approx(lost["missed_lens"].item(), abs=5e-4)
    assert light.reflected == pytest.approx(lost["fresnel_entrance"].item(), abs=5e-4)
