"""The side of a run that lives in a thread of its own. No widget is touched from here.

1. A job is complete in itself: session, gate, mailbox. Stopping or replacing one can neither hit
   the next nor mix their frames.
2. A frame is made only once the window has taken the last one: what nobody sees is not computed.
   Before a pause and at the end of a run it is made in any case.
3. A paused run waits at the gate's condition, which stopping wakes; it never polls.
"""

from collections.abc import Callable, Generator
from dataclasses import dataclass, field
from threading import Condition
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QThread, Signal, Slot

from ui.run.mailbox import Mailbox
from ui.shown.frame import Array, Frame, make_frame
from workbench.design.session import Mask
from workbench.design.snapshot import History, Result, Snapshot

if TYPE_CHECKING:
    from workbench.files.session import Session
    from workbench.scene import Run, Scene

Generate = Callable[["Scene", Array, Array | None, Mask | None], Generator[Snapshot, None, str]]


class Gate:
    """Lets a run through, holds it, or turns it away."""

    def __init__(self) -> None:
        self._changed = Condition()
        self._held = False
        self._stopped = False

    @property
    def held(self) -> bool:
        """Whether the next pass has to wait."""
        return self._held

    @property
    def stopped(self) -> bool:
        """Whether the run has to end."""
        return self._stopped

    def hold(self) -> None:
        """Make the next `passes` wait."""
        with self._changed:
            self._held = True

    def release(self) -> None:
        """Let a waiting run go on."""
        with self._changed:
            self._held = False
            self._changed.notify_all()

    def stop(self) -> None:
        """Turn the run away at its next `passes`, also if it waits there now."""
        with self._changed:
            self._stopped = True
            self._changed.notify_all()

    def passes(self) -> bool:
        """Wait while held; whether the run may go on."""
        with self._changed:
            self._changed.wait_for(lambda: self._stopped or not self._held)
            return not self._stopped


@dataclass(frozen=True, eq=False)
class Job:
    """One task for the worker.

    Attributes
    ----------
    session : Session
        What to design, or to show.
    preview : bool
        Show the lens as it stands and stop there.
    continue_run : bool
        Go on from the session's lens: its result, or the one that it starts from.
    generate : callable, optional
        Makes the snapshots of a run; `workbench.design.run.run` by default.
    gate : Gate
        Holds and stops it.
    mailbox, best : Mailbox
        For the latest frame, and for the best lens of the run up to it.
    """

    session: "Session"
    preview: bool = False
    continue_run: bool = False
    generate: Generate | None = None
    gate: Gate = field(default_factory=Gate)
    mailbox: Mailbox[Frame] = field(default_factory=Mailbox)
    best: Mailbox[Result] = field(default_factory=Mailbox)


class Worker(QObject):
    """Does jobs one after the other in the thread that it was moved to."""

    # The job; its result or None; what went wrong, or None.
    ended = Signal(object, object, object)
    # The job, which has to wait for what it traces with.
    waits = Signal(object)

    @Slot(object)
    def work(self, job: Job) -> None:
        """Do a job and tell how it ended."""
        history = History(job.session.result if job.continue_run else None)
        failure: Exception | None = None
        try:
            if job.preview:
                self._show(job)
            else:
                self._run(job, history)
        except Exception as error:  # of any kind: it has to reach the person
            failure = error
        self.ended.emit(job, history.result(), failure)

    def _run(self, job: Job, history: History) -> None:
        gate, unseen = job.gate, None
        if job.generate is None and not _ready():
            self.waits.emit(job)
        snapshots = history.follow(self._snapshots(job))
        try:
            for snapshot in snapshots:
                unseen = snapshot
                if gate.held or job.mailbox.empty:
                    _post(job, snapshot, history)
                    unseen = None
                if not gate.passes():
                    break
        finally:
            snapshots.close()
            if unseen is not None:
                _post(job, unseen, history)

    def _show(self, job: Job) -> None:
        result = job.session.result
        if job.gate.stopped:
            return
        if result is not None:
            snapshot = _as_snapshot(result, job.session.scene.run)
        else:
            from workbench.optics.kernels.ready import without_waiting

            snapshots = self._snapshots(job)
            try:
                with without_waiting():
                    snapshot = next(snapshots)
            finally:
                snapshots.close()
        job.mailbox.put(make_frame(job.session, snapshot, History(result)))

    def _snapshots(self, job: Job) -> Generator[Snapshot, None, str]:
        # A preview of a lens without figures of this task is the first one of a run from there, and
        # locked control points are those of the lens that is there, however the run begins.
        session, locked = job.session, job.session.locked
        locks = locked is not None and locked.any()
        start = session.control_points if job.continue_run or job.preview or locks else None
        generate = job.generate or _engine()
        return (yield from generate(session.scene, session.target, start, locked))


def _post(job: Job, snapshot: Snapshot, history: History) -> None:
    """Leave a frame of a run, after the best lens up to it: whoever sees the one has the other."""
    best = history.result()
    if best is not None:
        job.best.put(best)
    job.mailbox.put(make_frame(job.session, snapshot, history))


def _ready() -> bool:
    """Whether a run would begin at once, as far as kernels go."""
    from workbench.optics.kernels.ready import is_compiled

    return is_compiled()


def _engine() -> Generate:
    # Late: torch comes with it, and the window shows before that.
    import torch

    from workbench.design.run import run

    # For this thread alone. One core stays the window's: threads that wait for each other at
    # every step are slower, not faster, when one of them has to give way to drawing.
    torch.set_num_threads(max(1, QThread.idealThreadCount() - 1))
    return run


def _as_snapshot(result: Result, run: "Run") -> Snapshot:
    return Snapshot(
        iteration=result.iterations,
        iterations=max(run.iterations, result.iterations),
        loss=result.loss,
        control_points=result.control_points,
        irradiance=result.irradiance,
        ledger=result.ledger,
        seconds=result.seconds,
        best=True,
        stage=max(0, len(run.stages) - result.stages_left),
        stages=1 + len(run.stages),
    )
