"""Runs of the document's design in a thread, and previews between them."""

from dataclasses import replace
from functools import partial

from PySide6.QtCore import QObject, QTimer, Signal

from ui.background import Background, Task
from ui.document.document import Document
from ui.document.frame import Frame, iterations_before
from ui.document.shown_lens import FrameHistory
from ui.run.kept_runs import called, with_run
from ui.run.worker import Generate, RunJob, Seen, work
from ui.words import later, tr
from workbench.design.snapshot import Result
from workbench.design.task import origin
from workbench.files.session import Session

_PATIENCE_MS = 3000  # after which a run that was stopped is given up


class Runner(QObject):
    """Runs one job at a time in the background.

    A preview is no run: the state stays "idle", and a run or another preview replaces it. Calls
    that do not fit the state do nothing.
    """

    state_changed = Signal(str)
    frame_ready = Signal(object)  # Frame
    finished = Signal(object)  # Result or None
    failed = Signal(str)
    unshown = Signal(object)  # Session
    waiting = Signal(bool)

    def __init__(self, parent: QObject | None = None, generate: Generate | None = None) -> None:
        super().__init__(parent)
        self._generate = generate
        self.state = "idle"  # or "running", "paused", "stopping"
        self._waiting = False
        self._task: Task | None = None  # of a job
        self.best: Result | None = None  # of the active run so far
        self._background = Background(later("run"), self)
        self._background.progressed.connect(self._show)
        self._background.done.connect(lambda *_: self._end())
        self._background.failed.connect(self._end)
        self._patience = QTimer(self, singleShot=True, interval=_PATIENCE_MS)
        self._patience.timeout.connect(self._give_up)

    def start(self, session: Session, continue_run: bool) -> None:
        if self.state != "idle":
            raise RuntimeError(f"cannot start a run while one is {self.state}")
        self._give(RunJob(session, continue_run=continue_run, generate=self._generate))
        self._set_state("running")

    def preview(self, session: Session) -> None:
        """Show the lens with its stored figures, or those of a first trace."""
        if self.state == "idle":
            self._give(RunJob(session, preview=True, generate=self._generate))

    def show(self, frame: Frame) -> None:
        """Show a frame from elsewhere in place of a preview."""
        if self.state == "idle":
            self.drop_preview()
            self.frame_ready.emit(frame)

    def drop_preview(self) -> None:
        if self.state == "idle":
            self._drop_job()

    def pause(self) -> None:
        if self._task is not None and self.state == "running":
            self._task.hold()
            self._set_state("paused")

    def resume(self) -> None:
        if self._task is not None and self.state == "paused":
            self._task.release()
            self._set_state("running")

    def stop(self) -> None:
        """End the run before its next iteration; `finished` follows.

        Work that takes longer than a person waits, such as a first design, is given up.
        """
        if self._task is not None and self.state in ("running", "paused"):
            self._task.stop()
            self._patience.start()
            self._set_state("stopping")

    def shutdown(self) -> None:
        """Stop and wait for the thread; emits no more about the run."""
        self._drop_job()
        self._background.close()
        self._set_state("idle")

    def _give(self, job: RunJob) -> None:
        self._drop_job()
        self._task = self._background.begin(partial(work, job), job)

    def _drop_job(self) -> None:
        self._set_waiting(False)
        self._patience.stop()
        self.best = None
        if self._task is not None:
            self._task = None
            self._background.cancel()

    def _give_up(self) -> None:
        if self._task is not None:
            self._task.give_up()

    def _show(self, _: RunJob, seen: Seen | None) -> None:
        self._set_waiting(seen is None)
        if seen is not None:
            self.best = seen.best or self.best
            self.frame_ready.emit(seen.frame)

    def _end(self, failure: str = "") -> None:
        assert self._task is not None  # a dropped one ends without a signal
        job: RunJob = self._task.request
        self._drop_job()
        self._set_state("idle")
        if failure:
            self.failed.emit(failure)
        if not job.preview:
            self.finished.emit(job.history.result())
        elif failure:
            self.unshown.emit(job.session)

    def _set_waiting(self, waiting: bool) -> None:
        if waiting != self._waiting:
            self._waiting = waiting
            self.waiting.emit(waiting)

    def _set_state(self, state: str) -> None:
        if state != self.state:
            self.state = state
            self.state_changed.emit(state)


_PREVIEW_MS = 200  # a person who types is not done yet


class RunControl(QObject):
    """Runs designs of the document, and previews it between runs."""

    ended = Signal()
    displaced = Signal(str)

    def __init__(self, document: Document, parent: QObject) -> None:
        super().__init__(parent)
        self._document = document
        self.followed = False
        self.runner = Runner(self)
        self.history = FrameHistory(self)
        self.runner.frame_ready.connect(self._keep)
        self.runner.finished.connect(self._finish)
        self.runner.state_changed.connect(self._keep_task)
        self._preview = QTimer(self, singleShot=True, interval=_PREVIEW_MS)
        self._preview.timeout.connect(self._show_preview)
        document.session_changed.connect(self._preview.start)
        document.session_changed.connect(self._follow)
        self._preview.start()

    @property
    def busy(self) -> bool:
        return self.runner.state != "idle"

    def start(self) -> None:
        self._start(continue_run=False)

    def go_on(self) -> None:
        self._start(continue_run=True)

    def go_on_from(self, frame: Frame) -> None:
        self.history.branch(frame)
        self._document.set_result(
            frame.result, tr("return to iteration {number}").format(number=iterations_before(frame))
        )
        self.go_on()

    def toggle_pause(self) -> None:
        if self.runner.state == "paused":
            self.runner.resume()
        else:
            self.runner.pause()

    def show(self, frame: Frame) -> None:
        """Show a frame of a drag in place of a preview."""
        self._preview.stop()
        self.runner.show(frame)

    def preview(self) -> None:
        self._preview.start()

    def drop_preview(self) -> None:
        """Let no preview follow what is shown."""
        self._preview.stop()
        self.runner.drop_preview()

    def close(self) -> None:
        self._preview.stop()
        self.runner.shutdown()

    def _start(self, continue_run: bool) -> None:
        self._preview.stop()
        self.runner.start(self._document.session, continue_run)

    def _show_preview(self) -> None:
        if not (self.busy or self.followed):
            self.runner.preview(self._document.session)

    def _keep_task(self, state: str) -> None:
        self._document.in_run = state != "idle"

    def _keep(self, frame: Frame) -> None:
        if self.busy:  # a preview is no moment of a run
            self.history.add(frame)

    def _follow(self, session: Session) -> None:
        if not self.busy:
            self.history.show(session)

    def _finish(self, result: Result | None) -> None:
        if result is not None:
            self.history.keep(result)
            session, displaced = with_run(self._document.session, result)
            self._document.change(session, tr("design run"))
            for run in displaced:
                self.displaced.emit(called(run))
        self.ended.emit()


NO_LENS = later("There is no result yet, or it is still being computed. Try again in a moment.")


class CurrentLens(QObject):
    """The lens to export: that of the document, or the best one of a run."""

    def __init__(self, document: Document, parent: QObject) -> None:
        super().__init__(parent)
        self._document = document
        self._control: RunControl | None = None
        self._preview: Frame | None = None

    def follow(self, control: "RunControl") -> None:
        self._control = control
        control.runner.frame_ready.connect(self._keep_preview)

    @property
    def in_the_making(self) -> Result | None:
        return None if self._control is None else self._control.runner.best

    @property
    def session(self) -> Session | None:
        """The design with the shown lens as its result; None where there is no lens yet."""
        session = self._document.session
        making = self.in_the_making
        if making is not None:
            return replace(session, result=making)
        if session.result is not None:
            return session
        heights, frame = session.heights, self._preview
        if heights is None or frame is None or frame.session is not session:
            return None
        return replace(session, result=frame.result.with_state(heights=heights))

    @property
    def text(self) -> str:
        """Description with the task of the lens; empty without a lens."""
        making, session = self.in_the_making, self._document.session
        optic = session.scene.optic.called
        if making is not None:
            return tr("the best {optic} so far, after {count} iterations", optic=optic).format(
                count=making.iterations
            )
        return (
            ""
            if session.heights is None
            else tr("this {optic}, {origin}", optic=optic).format(
                origin=tr(origin(session, called))
            )
        )

    def _keep_preview(self, frame: Frame) -> None:
        self._preview = frame
