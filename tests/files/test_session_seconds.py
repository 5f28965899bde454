"""Sessions keep when each iteration and why the run ended, which earlier ones did not."""

from dataclasses import replace

import numpy as np
import pytest

from tests.accounts import result_of
from workbench.design.session import KeptRun, Session
from workbench.design.snapshot import IN_VAIN, MET, SLOW, has_converged
from workbench.files.session import read_session, write_session
from workbench.messages import Message


@pytest.fixture
def session(make_scene, rng):
    scene = make_scene({"lens.control_points": [5, 4], "screen.pixels": [7, 6]})
    times = {"seconds": 2.0, "seconds_at": np.array([1.0, 1.25, 2.0]), "ended": "stopped"}
    result = result_of(rng.random((5, 4)), rng.random((6, 7)), rng.random(3), **times)
    target = rng.random((6, 7))
    earlier = replace(result, seconds_at=None, ended="")
    runs = (KeptRun("now", scene, target, result), KeptRun("earlier", scene, target, earlier))
    return Session(scene, target, result, runs=runs)


def test_seconds_come_back(session, tmp_path):
    write_session(session, tmp_path / "lens.freeform")
    found = read_session(tmp_path / "lens.freeform")
    now, earlier = (run.result for run in found.runs)
    for result in (found.result, now):
        assert result.times().tolist() == [1.0, 1.25, 2.0]
        assert result.ended == "stopped"
    assert earlier.ended == ""
    assert earlier.seconds_at is None
    assert earlier.times().tolist() == pytest.approx([2 / 3, 4 / 3, 2])


def test_why_a_run_ended_comes_back_with_its_values(session, tmp_path):
    path = tmp_path / "lens.freeform"
    ended = Message(IN_VAIN, ended=Message(SLOW, gain=0.25, patience=5))
    write_session(replace(session, result=replace(session.result, ended=ended)), path)
    found = read_session(path).result.ended
    assert (found, found.words) == (ended, IN_VAIN)
    assert found.values["ended"].words == SLOW
    assert found.values["ended"].values == {"gain": 0.25, "patience": 5}
    assert has_converged(found)


def test_a_run_that_met_its_goal_is_kept(session, tmp_path):
    path = tmp_path / "met.freeform"
    ended = Message(MET, error="1.9 %", goal="2.0 %")
    write_session(replace(session, result=replace(session.result, ended=ended)), path)
    found = read_session(path).result.ended
    assert (found, found.words) == (ended, MET)
    assert found.values == {"error": "1.9 %", "goal": "2.0 %"}
