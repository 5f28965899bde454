"""Runs designs in a thread of their own and shows the window what comes of them."""

from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer, Signal

from ui.run.worker import Generate, RunJob, work
from ui.threads.background import Background
from ui.threads.failure import sentence_of
from ui.words import tr
from workbench.design.snapshot import Result

if TYPE_CHECKING:
    from ui.shown.frame import Frame
    from workbench.files.session import Session

_FRAME_MS = 66  # 15 Hz


class Runner(QObject):
    """Runs one job at a time in the background.

    While a run is on, `preview` does nothing, since its frames are the lens as it stands. A
    preview does not count as a run: the state stays "idle", and a run or another preview replaces
    it. `pause`, `resume` and `stop` out of season do nothing, so that a second click is harmless.

    Parameters
    ----------
    parent : QObject, optional
        The owner.
    generate : Callable, optional
        Makes the snapshots of a run; `workbench.design.run.run` by default.

    Attributes
    ----------
    state_changed : Signal(str)
        "idle", "running", "paused" or "stopping".
    frame_ready : Signal(Frame)
        At most 15 times a second; the last frame of a run always.
    finished : Signal(Result or None)
        A run has ended, however it did, with the best lens so far; None where it had none yet.
    failed : Signal(str)
        Why a run or a preview could not go on; of a run, `finished` follows.
    unshown : Signal(Session)
        A preview failed: there is no picture of this session.
    waiting : Signal(bool)
        A run waits for its kernels, which another thread compiles; or does so no longer.
    """

    state_changed = Signal(str)
    frame_ready = Signal(object)
    finished = Signal(object)
    failed = Signal(str)
    unshown = Signal(object)
    waiting = Signal(bool)

    def __init__(self, parent: QObject | None = None, generate: Generate | None = None) -> None:
        super().__init__(parent)
        self._generate = generate
        self._state = "idle"
        self._waiting = False
        self._job: RunJob | None = None
        self._best: Result | None = None
        self._background = Background("run", self)
        self._background.progressed.connect(self._wait)
        self._background.done.connect(self._end)
        self._background.failed.connect(self._end)
        self._timer = QTimer(self, interval=_FRAME_MS)
        self._timer.timeout.connect(self._take_frame)

    @property
    def state(self) -> str:
        """One of "idle", "running", "paused" and "stopping"."""
        return self._state

    @property
    def best(self) -> Result | None:
        """The best lens so far of the run that is on; None before its first, or without a run."""
        return self._best

    def start(self, session: "Session", continue_run: bool) -> None:
        """Begin a run.

        Parameters
        ----------
        session : Session
            What to design.
        continue_run : bool
            Go on from the session's lens, if it has one.

        Raises
        ------
        RuntimeError
            If a run is on.
        """
        if self._state != "idle":
            raise RuntimeError(f"cannot start a run while one is {self._state}")
        self._give(RunJob(session, continue_run=continue_run, generate=self._generate))
        self._set_state("running")

    def preview(self, session: "Session") -> None:
        """Show the lens as it stands: with its stored figures, or those of a first trace."""
        if self._state == "idle":
            self._give(RunJob(session, preview=True, generate=self._generate))

    def show(self, frame: "Frame") -> None:
        """Show a frame that was made elsewhere, in place of a preview."""
        if self._state == "idle":
            self._drop_job()
            self.frame_ready.emit(frame)

    def pause(self) -> None:
        """Hold the run before its next iteration."""
        if self._job is not None and self._state == "running":
            self._job.gate.hold()
            self._set_state("paused")

    def resume(self) -> None:
        """Let a paused run go on."""
        if self._job is not None and self._state == "paused":
            self._job.gate.release()
            self._set_state("running")

    def stop(self) -> None:
        """End the run before its next iteration; `finished` tells when that is."""
        if self._job is not None and self._state in ("running", "paused"):
            self._job.gate.stop()
            self._set_state("stopping")

    def shutdown(self) -> None:
        """Stop and wait for the thread; nothing is emitted about the run any more."""
        self._drop_job()
        self._background.close()
        self._set_state("idle")

    def _give(self, job: RunJob) -> None:
        self._drop_job()
        self._job = job
        self._timer.start()
        self._background.begin(partial(work, job), job)

    def _drop_job(self) -> None:
        self._set_waiting(False)
        self._timer.stop()
        self._best = None
        if self._job is not None:
            self._job.gate.stop()
            self._job = None
            self._background.cancel()

    def _take_frame(self) -> None:
        if self._job is None:
            return
        frame = self._job.mailbox.take()
        self._best = self._job.best.take() or self._best
        if frame is not None:
            self._set_waiting(False)
            self.frame_ready.emit(frame)

    def _end(self, job: RunJob, error: Exception | None) -> None:
        self._take_frame()
        self._drop_job()
        self._set_state("idle")
        if error is not None:
            self.failed.emit(sentence_of(error, tr("run")))
        if not job.preview:
            self.finished.emit(job.history.result())
        elif error is not None:
            self.unshown.emit(job.session)

    def _wait(self) -> None:
        self._set_waiting(True)

    def _set_waiting(self, waiting: bool) -> None:
        if waiting != self._waiting:
            self._waiting = waiting
            self.waiting.emit(waiting)

    def _set_state(self, state: str) -> None:
        if state != self._state:
            self._state = state
            self.state_changed.emit(state)
