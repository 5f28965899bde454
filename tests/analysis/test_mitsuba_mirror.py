"""A mirror in Mitsuba, whose light goes back through the sheet that it comes from."""

import numpy as np
import pytest

from workbench.analysis.cross_check import cross_check
from workbench.geometry.surface import ControlNet
from workbench.scene import Scene

pytestmark = pytest.mark.full

pytest.importorskip("mitsuba")


@pytest.mark.parametrize(
    "source", [{"kind": "collimated"}, {"kind": "point", "position": [-2.0, 0.0, -6.0]}]
)
def test_mitsuba_finds_the_same_light_of_a_mirror(source):
    scene = Scene.from_data(
        {
            "mirror": {"half_width": [1, 1], "control_points": [6, 6], "reflectance": 0.8},
            "source": source,
            "screen": {
                "z": -6.0,
                "center": [5.0, 0.5],
                "tilt": [0.0, -40.0],
                "half_width": [2.0, 2.0],
                "pixels": [16, 16],
            },
            "target": {"builtin": "ball"},
        }
    )
    x, y = ControlNet.of(scene.optic).positions
    # It leans towards the screen, and is bent more along x than along y.
    heights = 0.28 * x[:, None] - 0.05 * np.square(x[:, None]) - 0.02 * np.square(y)
    found = cross_check(scene, np.ones((16, 16)), {"mirror": heights}, rays=200_000)
    assert found.ours.efficiency > 0.3
    assert found.mitsuba.efficiency == pytest.approx(found.ours.efficiency, rel=0.01)
    assert found.difference < 1.3 * found.noise
