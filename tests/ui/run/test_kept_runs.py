"""Kept runs as values: names, memory, restoring."""

from dataclasses import replace

import numpy as np
import pytest

from ui.run.kept_runs import is_named, renamed, restored, with_run
from workbench.geometry.faces import NO_LOCKS, FaceArrays

KILOBYTE = 1 << 10


@pytest.fixture
def result(history):
    return history(5).result()


@pytest.fixture
def large(result):
    """Results of about as many kilobytes, with arrays of their own."""

    def make(kilobytes):
        return result.with_state(irradiance=np.zeros(kilobytes * KILOBYTE // 8))

    return make


def names(session):
    return [run.name for run in session.runs]


def test_a_run_is_kept_with_its_task_and_a_descriptive_name(session, result):
    after, displaced = with_run(session, result)
    assert after.result is result and displaced == []
    (run,) = after.runs
    assert run.name == "Run 1: auto, 12 × 10"
    assert (run.scene, run.target, run.result) == (session.scene, session.target, result)
    assert not is_named(run)


def test_the_oldest_unnamed_run_is_dropped_first(session, large):
    for _ in range(3):
        session, _ = with_run(session, large(100))
    session = renamed(session, session.runs[0], "first")
    kept, displaced = with_run(session, large(100), budget=350 * KILOBYTE)
    assert [run.name for run in displaced] == ["Run 2: auto, 12 × 10"]
    assert names(kept) == ["first", "Run 3: auto, 12 × 10", "Run 4: auto, 12 × 10"]
    kept, displaced = with_run(kept, large(300), budget=350 * KILOBYTE)
    assert [run.name for run in displaced] == [
        "Run 3: auto, 12 × 10",
        "Run 4: auto, 12 × 10",
        "first",
    ]
    assert names(kept) == ["Run 5: auto, 12 × 10"]


def test_restoring_brings_task_and_lens_back(session, result, make_scene):
    session, _ = with_run(session, result)
    (run,) = session.runs
    locked = FaceArrays({"lens.back": np.zeros(session.scene.optic.net_shape, dtype=bool)})
    other = replace(
        session.with_scene(make_scene({"screen.z": 9.0}), session.target),
        locked=locked,
    )
    again = restored(other, run)
    assert (again.scene, again.target, again.result) == (run.scene, run.target, run.result)
    assert again.locked is locked and again.runs == session.runs and again.start is None
    coarse = make_scene({"lens.control_points": [9, 9]})
    other = replace(
        session.with_scene(coarse, session.target),
        locked=FaceArrays({"lens.back": locked["lens.back"][:9, :9]}),
    )
    assert restored(other, run).locked == NO_LOCKS
