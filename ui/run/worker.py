"""The side of a run in its own thread, which touches no widget.

1. A job has its own session, gate and mailbox: stopping one job does not affect the next.
2. A frame is computed once the window has taken the previous one, before a pause, and at the end.
3. A paused run waits at the gate's condition, without polling.
"""

from collections.abc import Callable, Generator
from dataclasses import dataclass, field, replace
from threading import Condition, Lock
from typing import Generic, TypeVar

from ui.background import Task
from ui.document.frame import Frame, make_frame
from workbench.arrays import Array
from workbench.design.snapshot import History, Result, Snapshot
from workbench.files.session import Session
from workbench.geometry.faces import ControlHeights, Locks
from workbench.progress import given_up_when, interrupted_when
from workbench.scene import Run, Scene

Value = TypeVar("Value")


class Mailbox(Generic[Value]):
    """Passes the latest value between threads."""

    def __init__(self) -> None:
        self._lock = Lock()
        self._value: Value | None = None

    @property
    def empty(self) -> bool:
        """Whether the last value was taken: its reader wants another."""
        with self._lock:
            return self._value is None

    def put(self, value: Value) -> None:
        with self._lock:
            self._value = value

    def take(self) -> Value | None:
        """Take the latest value; None if there is none since the last time."""
        with self._lock:
            value, self._value = self._value, None
            return value


Generate = Callable[["Scene", Array, ControlHeights | None, Locks], Generator[Snapshot, None, str]]


class Gate:
    """Pauses and stops a run."""

    def __init__(self) -> None:
        self._changed = Condition()
        self.held = False
        self.stopped = self.given_up = False

    def hold(self) -> None:
        """Make the next `passes` wait."""
        with self._changed:
            self.held = True

    def release(self) -> None:
        with self._changed:
            self.held = False
            self._changed.notify_all()

    def stop(self) -> None:
        """End the run at its next `passes`, also while it waits there."""
        with self._changed:
            self.stopped = True
            self._changed.notify_all()

    def give_up(self) -> None:
        """End the run as soon as possible, for another one."""
        self.given_up = True
        self.stop()

    def passes(self) -> bool:
        """Wait while held; whether the run may go on."""
        with self._changed:
            self._changed.wait_for(lambda: self.stopped or not self.held)
            return not self.stopped


@dataclass(eq=False)
class RunJob:
    """One task for the worker."""

    session: Session
    preview: bool = False
    continue_run: bool = False
    generate: Generate | None = None
    gate: Gate = field(default_factory=Gate)
    mailbox: Mailbox[Frame] = field(default_factory=Mailbox)
    best: Mailbox[Result] = field(default_factory=Mailbox)
    history: History = field(init=False)

    def __post_init__(self) -> None:
        earlier = self.session.result if self.continue_run else None
        self.history = History(earlier)


def frame_of(session: Session, result: Result) -> Frame:
    """Return the frame of a session's result."""
    frame = make_frame(session, _as_snapshot(result, session.scene.run), History(result))
    return replace(frame, result=result)  # with why its run ended


def work(job: RunJob, task: Task) -> None:
    """Do a job in a thread; reports if it has to wait for kernels."""
    if job.preview:
        _show(job)
    else:
        _run(job, task)


def _run(job: RunJob, task: Task) -> None:
    gate, unseen = job.gate, None
    if job.generate is None and not _ready():
        task.report("waits")
    snapshots = job.history.follow(_snapshots(job))
    try:
        with (
            interrupted_when(lambda: gate.stopped),
            given_up_when(lambda: gate.given_up or not task.wanted),
        ):
            for snapshot in snapshots:
                unseen = snapshot
                if gate.held or job.mailbox.empty:
                    _post(job, snapshot)
                    unseen = None
                if not gate.passes():
                    break
    finally:
        snapshots.close()
        if unseen is not None and not gate.given_up:
            _post(job, unseen)


def _show(job: RunJob) -> None:
    result = job.session.result
    if job.gate.stopped:
        return
    if result is not None:
        job.mailbox.put(frame_of(job.session, result))
        return
    from workbench.optics.ready import without_waiting

    snapshots = _snapshots(job)
    try:
        with without_waiting():
            snapshot = next(snapshots)
    finally:
        snapshots.close()
    job.mailbox.put(make_frame(job.session, snapshot, History()))


def _snapshots(job: RunJob) -> Generator[Snapshot, None, str]:
    # A preview of a lens without figures of this task is the first one of a run from there, and
    # locked control points are those of the lens that is there, however the run begins.
    session, locked = job.session, job.session.locked
    locks = any(mask.any() for mask in locked.values())
    start = session.heights if job.continue_run or job.preview or locks else None
    generate = job.generate or _engine()
    return (yield from generate(session.scene, session.target, start, locked))


def _post(job: RunJob, snapshot: Snapshot) -> None:
    """Post the best lens, then the frame: a reader of the frame has both."""
    best = job.history.result()
    if best is not None:
        job.best.put(best)
    job.mailbox.put(make_frame(job.session, snapshot, job.history))


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
