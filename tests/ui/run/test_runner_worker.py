"""The worker without its thread: jobs done on the spot."""

import dataclasses
from functools import partial

import numpy as np
import pytest

from ui.run import worker as worker_module
from ui.run.worker import RunJob
from ui.threads.background import Task
from workbench.errors import Refused, RunFailed
from workbench.geometry.faces import FaceArrays


@pytest.fixture
def work():
    """Does a job and returns its result and its failure."""

    def do(job, generate):
        job = dataclasses.replace(job, generate=generate)
        task = Task(partial(worker_module.work, job), job, print)
        task.run()
        return job.history.result(), task.error

    return do


def test_frame_holds_what_is_drawn(session, as_run, work):
    job = RunJob(session)
    work(job, as_run(3))
    frame = job.mailbox.take()
    assert frame.session is session
    surface = frame.surfaces["exit"]
    assert surface.ndim == 3 and surface.shape[2] == 3
    np.testing.assert_allclose(surface[..., 2], 0.5 - 0.003)
    assert frame.paths.points.shape[1:] == (4, 3)
    np.testing.assert_allclose(frame.result.losses, [1 / 2, 1 / 3, 1 / 4])


@pytest.mark.parametrize(
    "error",
    [RunFailed("the loss is not finite"), Refused("run.device", "no GPU"), ZeroDivisionError()],
)
def test_failure_keeps_the_last_good_lens(session, snapshots, work, error):
    def run(scene, target, start=None, locked=None):
        yield snapshots(0)
        yield snapshots(1)
        raise error

    job = RunJob(session)
    result, found = work(job, run)
    assert found is error
    np.testing.assert_array_equal(result.state.heights["exit"], snapshots(1).state.heights["exit"])
    assert job.mailbox.take().snapshot.iteration == 1


def test_continues_from_the_result(designed, snapshots, work):
    starts = []

    def run(scene, target, start=None, locked=None):
        starts.append(start)
        yield snapshots(0)
        yield snapshots(1)

    result, _ = work(RunJob(designed, continue_run=True), run)
    assert starts[0] == designed.result.state.heights
    np.testing.assert_allclose(result.losses, [1 / 2, 1 / 3, 1 / 4, 1 / 2])
    result, _ = work(RunJob(designed), run)
    assert starts[1] is None and result.iterations == 1


def test_locked_control_points_are_those_of_the_lens_that_is_there(designed, snapshots, work):
    seen = []

    def run(scene, target, start=None, locked=None):
        seen.append((start, locked))
        yield snapshots(0)

    heights = designed.result.state.heights
    mask = np.zeros((12, 10), bool)
    work(RunJob(dataclasses.replace(designed, locked=FaceArrays({"exit": mask}))), run)
    assert seen[-1][0] is None
    mask[1, 2] = True
    locked = FaceArrays({"exit": mask})
    result, _ = work(RunJob(dataclasses.replace(designed, locked=locked)), run)
    assert seen[-1][0] is heights and seen[-1][1] is locked
    assert result.iterations == 0
