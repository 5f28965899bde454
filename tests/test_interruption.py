"""Long work that one does not wait for to its end."""

import numpy as np
import pytest

from workbench.analysis.manufacture import manufacture
from workbench.design.limits import undesigned
from workbench.design.transport import transport_start
from workbench.extended.blur import Blur
from workbench.extended.deblur import spread_light
from workbench.interruption import Interrupted, check_interruption, interrupted_when


@pytest.mark.parametrize(
    "work",
    [
        lambda scene: manufacture(scene.optic, undesigned(scene.optic)),
        lambda scene: transport_start(scene, np.eye(16)),
        lambda scene: spread_light(np.eye(16), Blur((3.0, 3.0))),
    ],
    ids=["manufacture", "first lens", "light to be blurred"],
)
def test_long_work_ends_when_it_is_interrupted(make_scene, work):
    scene, asked = make_scene({"screen.pixels": [16, 16]}), []

    def second_time():
        asked.append(None)
        return len(asked) == 2

    with pytest.raises(Interrupted), interrupted_when(second_time):
        work(scene)
    check_interruption()  # nothing is interrupted any more
