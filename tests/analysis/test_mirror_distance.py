"""Screens of mirrors stand below them: farther away is a smaller z."""

import numpy as np
import pytest

from workbench.analysis.tolerance_fields import Tolerances
from workbench.analysis.tolerances import Perturbation
from workbench.errors import Refused
from workbench.scene import Scene


@pytest.fixture
def scene():
    return Scene.from_data(
        {
            "mirror": {"half_width": [1, 1], "control_points": [4, 4], "height_range": [-0.5, 0.5]},
            "source": {"kind": "collimated"},
            "screen": {"z": -5.0, "half_width": [1, 1], "pixels": [4, 4]},
            "target": {"builtin": "tophat"},
        }
    )


def test_a_screen_that_is_too_far_has_a_smaller_z(scene):
    moved, _ = Perturbation(distance=0.25).applied(scene, {"mirror.face": np.zeros((4, 4))})
    assert moved.receiver.z == pytest.approx(-5.25)


@pytest.mark.parametrize(
    "within, why",
    [
        (Tolerances(exit_tilt=0.1), "a mirror has no other face"),
        (Tolerances(entrance_surface=(0.1, 0.2)), "a mirror has no other face"),
        (Tolerances(index=0.1), "there is no glass"),
    ],
)
def test_tolerances_that_a_mirror_does_not_have_are_refused(scene, within, why):
    with pytest.raises(Refused, match=rf"changes? nothing: {why}; 0"):
        within.check(scene)
