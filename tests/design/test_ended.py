"""Why a run ended, as its history keeps it."""

import re

import numpy as np
import pytest

from workbench.design import descent
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


def test_auto_ends_where_errors_fall_by_less_than_is_visible(make_scene, disc, monkeypatch):
    monkeypatch.setattr(descent, "_SHARP", (descent._SHARP[0]._replace(points=0.5),))
    why = ended(run(make_scene({"run.iterations": 1000}), disc))
    assert why == "converged: error less than 50 percentage points lower in 8 iterations"


def test_the_last_stage_says_why(make_scene, disc):
    stage = {"iterations": 2, "method": "paper"}
    settings = {"method": "auto", "iterations": 1000, "stages": [stage]}
    scene = make_scene({"lens.control_points": [5, 5], "run": settings})
    assert ended(run(scene, disc)).startswith("converged: ")


def test_locked_everywhere(make_scene, disc):
    scene = make_scene({"lens.control_points": [5, 5]})
    locked = np.ones((5, 5), bool)
    assert ended(run(scene, disc, None, {"exit": locked})) == "all control points are locked"


def test_leaving_a_run_is_recorded_as_stopped(make_scene, disc):
    assert ended(run(make_scene({}), disc), most=2) == "stopped"


def test_a_failure_is_recorded_and_raised(make_scene, disc):
    def failing():
        yield next(run(make_scene({}), disc))
        raise RunFailed("the loss is not finite")

    history = History()
    with pytest.raises(RunFailed, match="the loss is not finite"):
        list(history.follow(failing()))
    assert history.result().ended == "failed: the loss is not finite"


def test_a_run_without_improvement_is_reported(make_scene, disc):
    run_data = {"method": "paper", "iterations": 3, "learning_rate": 1e9}
    why = ended(run(make_scene({"run": run_data}), disc))
    assert why == "all iterations are done; no iteration made the lens better"
