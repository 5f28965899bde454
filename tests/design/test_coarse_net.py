"""A net too coarse for its target is named as the reason of a high error, and nothing else is."""

import numpy as np
import pytest

from workbench.design.coarse_net import coarse_net
from workbench.design.run import run
from workbench.design.snapshot import History


@pytest.fixture
def stripes():
    """Detail that a few control points do not show."""
    across = np.arange(32) // 2 % 2
    return 0.2 + np.outer(np.ones(32), across)


def designed(scene, target):
    history = History()
    for _ in history.follow(run(scene, target)):
        pass
    return history.result()


@pytest.fixture
def scene(make_scene):
    return make_scene({"lens.control_points": [6, 6], "run.iterations": 300})


def test_a_coarse_net_is_named_with_what_can_show_the_target(scene, stripes):
    result = designed(scene, stripes)
    found = coarse_net(scene, stripes, result)
    assert found.shape == (6, 6) and min(found.finer) > 12 and found.error > 0.05
    assert "6 × 6 control points are too few" in found.sentence
