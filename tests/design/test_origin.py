"""What a lens was designed for is found among the kept runs."""

from dataclasses import replace

import numpy as np
import pytest

from tests.accounts import account_of
from workbench.design.lens_state import LensState
from workbench.design.origin import origin
from workbench.design.session import KeptRun, Session
from workbench.design.snapshot import Result
from workbench.geometry.faces import FaceArrays


@pytest.fixture
def task(make_scene):
    scene = make_scene()
    n_x, n_y = scene.receiver.pixels
    return Session(scene, np.ones((n_y, n_x)))


@pytest.fixture
def designed(task):
    """A design whose lens is that of its only kept run."""
    result = Result(
        LensState(
            heights=FaceArrays({"exit": np.full(task.scene.optic.net_shape, 0.5)}),
            irradiance=task.target,
            loss=1.0,
            account=account_of(1.0, 0.9, 0.0, 0.0, 0.0, 0.0, 0.04, 0.06),
        ),
        losses=np.array([2.0, 1.0]),
        seconds=0.5,
    )
    return replace(task, result=result, runs=(KeptRun("Run 1", task.scene, task.target, result),))


def moved(session, part="screen", **values):
    scene = session.scene
    changed = getattr(scene, part).model_copy(update=values)
    return session.with_scene(scene.model_copy(update={part: changed}), session.target)


def test_a_lens_of_a_run_is_designed_for_the_task_of_the_run(designed):
    assert origin(designed) == "designed for this task"


def test_the_other_task_is_named_with_what_differs(designed):
    other = moved(designed, z=7.0)
    assert other.result is None
    assert origin(other) == "designed for another task (Run 1): screen.z 5.0, now 7.0"
    traced = replace(other, result=replace(designed.result, losses=np.empty(0)))
    assert origin(traced) == origin(other)
