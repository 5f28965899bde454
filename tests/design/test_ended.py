"""Why a run ended, as its history keeps it."""

import re

import numpy as np
import pytest

from workbench.design.run import run
from workbench.design.snapshot import History
from workbench.errors import RunFailed


@pytest.fixture
def disc():
    across = np.linspace(-1, 1, 32)
    return (np.hypot(*np.meshgrid(across, across)) < 0.6).astype(float)


def ended(snapshots, most=None):
    """Follow a run to its end, or for so many snapshots."""
    history = History()
    following = history.follow(snapshots)
    for number, _ in enumerate(following, 1):
        assert not history.result().ended  # not yet
        if number == most:
            following.close()
    return history.result().ended


@pytest.mark.parametrize("method", ["auto", "paper"])
def test_all_iterations_are_done(make_scene, disc, method):
    scene = make_scene({"run": {"method": method, "iterations": 3}})
    assert ended(run(scene, disc)) == "all iterations are done"


def test_auto_says_that_it_converged(make_scene, disc):
    scene = make_scene({"lens.control_points": [5, 5], "run.iterations": 1000})
    why = ended(run(scene, disc))
    slow = re.fullmatch("converged: less than 5 % better in [0-9]+ iterations", why)
    assert slow or why in (
        "converged: no step makes the image better",
        "converged: error below 0.1 %",
    )


def test_a_failure_is_recorded_and_raised(make_scene, disc):
    def failing():
        yield next(run(make_scene({}), disc))
        raise RunFailed("the loss is not finite")

    history = History()
    with pytest.raises(RunFailed, match="the loss is not finite"):
        list(history.follow(failing()))
    assert history.result().ended == "failed: the loss is not finite"
