"""Each result has a course of its own, which comes and goes with it."""

import weakref
from types import SimpleNamespace

import numpy as np
import pytest

from ui.document.frame import iterations_before
from ui.document.shown_lens import FrameHistory
from workbench.pictures.loss import Verified

EARLY, LATE = Verified(1, 0.5), Verified(3, 0.25)


class Fake(SimpleNamespace):
    """Equal to itself alone, like what it stands in for."""

    __eq__, __hash__ = object.__eq__, object.__hash__


@pytest.fixture
def task(make_scene):
    return Fake(scene=make_scene({}), target=np.ones((32, 32)), result=None)


@pytest.fixture
def run(task):
    """Adds frames and checks, and gives the session with the result that they lead to."""

    def do(history, iterations, size=1000, checks=()):
        for at in range(iterations + 1):
            history.add(frame(task, at, size))
        for check in checks:
            history.add_check(check)
        result = Fake(losses=np.zeros(iterations))
        history.keep(result)
        return Fake(scene=task.scene, target=task.target, result=result)

    return do


def frame(session, at, size):
    return Fake(
        session=session,
        result=SimpleNamespace(losses=np.zeros(at), iterations=at),
        surfaces={"lens.back": np.zeros(size // 8)},
        state=SimpleNamespace(
            heights={"lens.back": np.zeros(0)}, irradiance=np.zeros(0), further=()
        ),
        paths=SimpleNamespace(points=np.zeros(0), weight=np.zeros(0)),
    )


def shown(history):
    return [iterations_before(each) for each in history.frames]


def test_moments_and_checks_follow_the_result(task, run):
    history = FrameHistory()
    first = run(history, 3, checks=[EARLY, LATE])
    second = run(history, 2)
    assert shown(history) == [0, 1, 2] and history.checks == ()
    history.show(first)
    assert shown(history) == [0, 1, 2, 3] and history.checks == (EARLY, LATE)
    history.show(task)
    assert shown(history) == [] and history.checks == ()
    history.show(second)
    assert shown(history) == [0, 1, 2]


def test_frames_of_a_result_that_is_gone_are_freed_with_the_next_design(task, run):
    history = FrameHistory()
    session = run(history, 3)
    last = weakref.ref(history.frames[-1])
    history.show(task)
    assert last() is not None  # undo may bring it back
    del session
    history.show(task)
    assert last() is None
