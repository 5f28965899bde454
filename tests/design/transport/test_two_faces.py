"""First lenses of two faces that share the bending of the light."""

import numpy as np
import pytest

from workbench.design.run import run
from workbench.design.transport.two_faces import split_start

FREEFORM = {
    "lens.entrance": {"shape": "freeform", "control_points": [16, 16]},
    "lens.control_points": [16, 16],
    "lens.height_range": None,
    "screen.pixels": [24, 24],
}


@pytest.mark.parametrize(
    "source",
    [
        {"kind": "collimated"},
        {"kind": "point", "position": [0.0, 0.0, -1.5]},
    ],
    ids=["parallel", "near point"],
)
def test_light_that_needs_no_turn_finds_two_flat_faces(make_scene, source):
    scene = make_scene({**FREEFORM, "source": source, "screen.half_width": [5.0, 5.0]})
    plate = next(run(scene, np.ones((24, 24)))).state.irradiance
    heights = split_start(scene, plate)
    turned = split_start(scene, np.eye(24))
    # The rim of the light of a plate lies within pixels, which few control points follow.
    for face, z in heights.items():
        assert np.ptp(z[2:-2, 2:-2]) < 0.15 * np.ptp(turned[face])
