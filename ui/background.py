"""Work in threads, and garbage collection in the window's thread.

1. A `Background` uses one thread. Of the requests during its work it executes only the latest.
2. All signals are emitted in the window's thread; cancelled work emits none.
3. An error is emitted as a translated sentence; the traceback of a defect goes to the log.
"""

import gc
import logging
import os
import threading
from collections.abc import Callable, Generator
from contextlib import closing
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

from PySide6.QtCore import QObject, QThread, QTimer, Signal, Slot

from ui.words import error_text, tr
from workbench.defects import details, unexpected
from workbench.errors import Refused, RunFailed
from workbench.process import cores
from workbench.progress import Interrupted, given_up_when


def leave_cores(count: int = 1) -> None:
    """Let torch and kernels use all cores but these: drawing slows down synchronised threads."""
    os.environ.setdefault("OMP_NUM_THREADS", str(max(1, cores() - count)))


LOG = logging.getLogger("freeform-workbench")
"""Gets the traceback of each unexpected error; see `ui.unexpected_errors`."""


Step = TypeVar("Step")
End = TypeVar("End")


class Task:
    """Requested work: its thread reports by it, and whoever began it can hold and stop it.

    What `ui.widgets.shelf` shows: ``title``, ``part`` of the work that is done (0 to 1, if known),
    and at the end ``outcome``, a sentence, with ``path``, the written file or folder.
    """

    def __init__(
        self, work: "Work", request: Any, report: Callable[["Task", object], object], title: str
    ) -> None:
        self.request, self.title = request, title
        self.part: float | None = None
        self.outcome = ""
        self.path: Path | None = None
        self.wanted = True
        self.held = self.stopped = self.given_up = False
        self.heard = True  # whether the window has taken what was reported last
        self.ended = False
        self.result: object = None
        self.error: Exception | None = None
        self._work, self._report = work, report
        self._changed = threading.Condition()

    def stop(self) -> None:
        """Ask the work to end soon, also while it is held; its result is emitted."""
        with self._changed:
            self.stopped = True
            self._changed.notify_all()

    def give_up(self) -> None:
        """End the work at once, wherever it asks; without a result."""
        self.given_up = True
        self.stop()

    def hold(self) -> None:
        """Make the next `passes` wait."""
        self.held = True

    def release(self) -> None:
        with self._changed:
            self.held = False
            self._changed.notify_all()

    def passes(self) -> bool:
        """Wait in the thread while held; whether the work may go on."""
        with self._changed:
            self._changed.wait_for(lambda: self.stopped or not self.held)
            return not self.stopped

    def report(self, value: object) -> None:
        """Report progress, as the part that is done or otherwise, from the thread of the work."""
        if isinstance(value, float):
            self.part = value
        self.heard = False
        self._report(self, value)

    def follow(
        self, steps: Generator[Step, None, End], report: Callable[[Step], object] | None = None
    ) -> End | None:
        """Run steps until their end or until `stop`; return their result, or None if stopped."""
        with closing(steps):
            while not self.stopped:
                try:
                    step = next(steps)
                except StopIteration as end:
                    found: End = end.value
                    return found
                if report is not None:
                    report(step)
        return None

    def run(self) -> None:
        try:
            with given_up_when(lambda: self.given_up or not self.wanted):
                self.result = self._work(self)
        except Interrupted:
            pass
        except Exception as error:  # of any kind: it has to reach the person
            self.error = error
        finally:
            del self._work  # which may hold this task


Work = Callable[[Task], object]


class _Thread(QThread):
    def __init__(self, call: Callable[[], object]) -> None:
        super().__init__()
        self._call = call

    def run(self) -> None:
        self._call()


class Background(QObject):
    """Executes the latest requested work and emits its result.

    ``name`` is that of the work in English, translatable. ``finish_first`` lets begun work finish
    before that of a later request begins; by default a later request cancels it. ``progressed``
    and ``done`` are emitted with the request; ``changed`` with each `Task` that has a title, when
    it begins, progresses and has ended.
    """

    progressed = Signal(object, object)
    done = Signal(object, object)
    failed = Signal(str)
    changed = Signal(object)

    # From the thread. These are queued: their receivers live in the window's thread.
    _reported = Signal(object, object)
    _ended = Signal(object)

    def __init__(self, name: str, parent: QObject | None, *, finish_first: bool = False) -> None:
        super().__init__(parent)
        self._name, self._finish_first = name, finish_first
        self._next: Task | None = None
        self._task: Task | None = None  # in the thread
        self._thread: _Thread | None = None
        self._closed = False
        self._reported.connect(self._pass_on)
        self._ended.connect(self._end)

    @property
    def busy(self) -> bool:
        return self._next is not None or (self._task is not None and self._task.wanted)

    @property
    def running(self) -> bool:
        """Whether a thread is at work, even on cancelled work."""
        return self._task is not None

    @property
    def stopping(self) -> bool:
        """Whether stopped work has not yet emitted its result."""
        return self._task is not None and self._task.wanted and self._task.stopped

    def begin(self, work: Work, request: object = None, title: str = "") -> Task:
        """Execute work with its `Task`, now or when the thread is free; never once closed."""
        task = Task(work, request, self._reported.emit, title)
        if self._closed:
            return task
        if not self._finish_first:
            self.cancel()
        self._next = task
        if self._task is None:
            self._begin_next()
        return task

    def stop(self) -> None:
        """Ask the work to end soon; its result is emitted."""
        self._next = None
        if self._task is not None:
            self._task.stop()

    def cancel(self) -> None:
        """Ask the work to end soon; nothing more is emitted."""
        self.stop()
        if self._task is not None and self._task.wanted:
            self._task.wanted = False
            self._show(self._task, ended=True)

    def finish(self) -> None:
        while self._task is not None:
            self._end(self._task)

    def close(self) -> None:
        """Cancel all work and wait for the thread; safe to call twice."""
        self._closed = True
        self.cancel()
        self._join()

    def _begin_next(self) -> None:
        self._task, self._next = self._next, None
        if self._task is not None:
            self._thread = _Thread(partial(self._run, self._task))
            self._thread.setObjectName(self._name)  # what the system calls it
            self._show(self._task)
            self._thread.start()

    def _run(self, task: Task) -> None:
        task.run()
        self._ended.emit(task)

    def _join(self) -> None:
        if self._thread is not None:
            self._thread.wait()
        self._task = self._thread = None

    @Slot(object, object)
    def _pass_on(self, task: Task, value: object) -> None:
        if task is self._task and task.wanted:
            task.heard = True
            self.progressed.emit(task.request, value)
            self._show(task)

    @Slot(object)
    def _end(self, task: Task) -> None:
        if task is not self._task:  # ended or closed before this came
            return
        self._join()
        if task.wanted and task.error is None:
            self.done.emit(task.request, task.result)
        elif task.wanted and task.error is not None:
            task.outcome = self._sentence(task.error)
            self.failed.emit(task.outcome)
        if task.wanted:
            self._show(task, ended=True)
        if self._task is None:  # else a slot has begun other work
            self._begin_next()

    def _show(self, task: Task, ended: bool = False) -> None:
        task.ended = ended
        if task.title:
            self.changed.emit(task)

    def _sentence(self, error: Exception) -> str:
        if isinstance(error, Refused | RunFailed):
            return error_text(error)
        LOG.error(details(error))
        work = tr(self._name)
        return tr("The {work} failed: {error}").format(work=work, error=unexpected(error))


def close_threads(owner: QObject) -> None:
    """Close the work of an object and of all its children."""
    for background in owner.findChildren(Background):
        background.close()


class GarbageCollector(QTimer):
    """Collects garbage in the window's thread: in others Qt forbids to delete timers and widgets.

    Left to itself, Python collects in whichever thread allocates.
    """

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent, interval=100)
        self.timeout.connect(self._collect)
        gc.disable()
        self.start()

    def close(self) -> None:
        self.stop()
        gc.enable()

    def _collect(self) -> None:
        counts = zip(gc.get_count(), gc.get_threshold(), strict=True)
        full = [generation for generation, (count, most) in enumerate(counts) if count > most]
        if full:
            gc.collect(full[-1])
