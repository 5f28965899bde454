"""The side of a run in its own thread, which touches no widget.

1. A job has its own session and task: stopping one job does not affect the next.
2. A frame is computed once the window has taken the previous one, before a pause, and at the end.
3. A paused run waits in its task, without polling.
"""

from collections.abc import Callable, Generator
from dataclasses import dataclass, field, replace
from time import monotonic
from typing import NamedTuple

from ui.background import Task
from ui.document.frame import Frame, make_frame
from workbench.arrays import Array
from workbench.design.snapshot import History, Result, Snapshot
from workbench.files.session import Session
from workbench.geometry.faces import ControlHeights, Locks
from workbench.progress import interrupted_when
from workbench.scene import Run, Scene

_FRAME_S = 0.066  # between two frames of a run; the first lens of a design follows at once

Generate = Callable[["Scene", Array, ControlHeights | None, Locks], Generator[Snapshot, None, str]]


class Seen(NamedTuple):
    """What the window is shown of a job: the best lens so far, unless it is a preview; a frame."""

    best: Result | None
    frame: Frame


@dataclass(eq=False)
class RunJob:
    """One task for the worker."""

    session: Session
    preview: bool = False
    continue_run: bool = False
    generate: Generate | None = None
    history: History = field(init=False)

    def __post_init__(self) -> None:
        earlier = self.session.result if self.continue_run else None
        self.history = History(earlier)


def frame_of(session: Session, result: Result) -> Frame:
    """Return the frame of a session's result."""
    frame = make_frame(session, _as_snapshot(result, session.scene.run), History(result))
    return replace(frame, result=result)  # with why its run ended


def work(job: RunJob, task: Task) -> None:
    """Do a job in a thread; reports what is `Seen`, and None if it has to wait for kernels."""
    if job.preview:
        _show(job, task)
    else:
        _run(job, task)


def _run(job: RunJob, task: Task) -> None:
    unseen, shown_at = None, 0.0
    if job.generate is None and not _ready():
        task.report(None)
    snapshots = job.history.follow(_snapshots(job))
    try:
        with interrupted_when(lambda: task.stopped):
            for snapshot in snapshots:
                unseen = snapshot
                due = snapshot.iteration < 2 or monotonic() - shown_at >= _FRAME_S
                if task.held or (task.heard and due):
                    _post(job, snapshot, task)
                    unseen, shown_at = None, monotonic()
                if not task.passes():
                    break
    finally:
        snapshots.close()
        if unseen is not None and not task.given_up:
            _post(job, unseen, task)


def _show(job: RunJob, task: Task) -> None:
    result = job.session.result
    if task.stopped:
        return
    if result is not None:
        task.report(Seen(None, frame_of(job.session, result)))
        return
    from workbench.optics.ready import without_waiting

    snapshots = _snapshots(job)
    try:
        with without_waiting():
            snapshot = next(snapshots)
    finally:
        snapshots.close()
    task.report(Seen(None, make_frame(job.session, snapshot, History())))


def _snapshots(job: RunJob) -> Generator[Snapshot, None, str]:
    # A preview of a lens without figures of this task is the first one of a run from there, and
    # locked control points are those of the lens that is there, however the run begins.
    session, locked = job.session, job.session.locked
    locks = any(mask.any() for mask in locked.values())
    start = session.heights if job.continue_run or job.preview or locks else None
    generate = job.generate or _engine()
    return (yield from generate(session.scene, session.target, start, locked))


def _post(job: RunJob, snapshot: Snapshot, task: Task) -> None:
    best = job.history.result()
    task.report(Seen(best, make_frame(job.session, snapshot, job.history)))


def _ready() -> bool:
    from workbench.optics.ready import is_compiled

    return is_compiled()


def _engine() -> Generate:
    # Late: torch comes with it, and the window shows before that.
    from workbench.design.run import run

    return run


def _as_snapshot(result: Result, run: Run) -> Snapshot:
    return Snapshot(
        result.state,
        iteration=result.iterations,
        iterations=max(run.iterations, result.iterations),
        seconds=result.seconds,
        merit=result.state.loss,
        best=True,
        stage=max(0, len(run.stages) - result.stages_left),
        stages=1 + len(run.stages),
    )
