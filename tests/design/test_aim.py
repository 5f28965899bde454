"""What the first lens aims at where its source has a size."""

import numpy as np
import pytest

from workbench.analysis.validation import validate
from workbench.design.aim import first_lens
from workbench.design.transport import transport_start
from workbench.extended.bound import Bound
from workbench.geometry.faces import FaceArrays

GRID = {"kind": "grid", "center": [0, 0, -8], "half_width": [0.25, 0.25], "points": [6, 6]}


@pytest.fixture
def scene(make_scene):
    return make_scene({"source": GRID, "lens.control_points": [48, 48], "filter": {"kind": "box"}})


@pytest.fixture
def target(scene):
    (n_x, n_y), image = scene.receiver.pixels, np.zeros(scene.receiver.pixels[::-1])
    image[n_y // 4 : -n_y // 4, n_x // 4 : -n_x // 4] = 1
    image[n_y // 4 : -n_y // 4, n_x // 2 :] *= 0.4
    return image


def test_first_lens_with_an_extended_source_is_nearer_than_that_for_the_target_itself(
    scene, target
):
    bound = Bound(scene, target).relative_l2
    sharp, aimed = (
        validate(scene, target, FaceArrays(heights), 400_000).relative_l2_corrected
        for heights in (
            {"exit": transport_start(scene, target)},
            first_lens(scene, target).heights,
        )
    )
    assert bound < aimed < 0.8 * sharp
