"""Work in threads of its own, so that the window answers meanwhile.

1. One thread at a time works for a `Background`. Of the requests that come meanwhile the latest is
   next, and the others never begin.
2. Every signal is emitted in the window's thread; for work that was cancelled, none is.
3. An error is passed as the exception itself, with its traceback; see `sentence_of`.
"""

import threading
from collections.abc import Callable, Generator
from contextlib import closing
from functools import partial
from typing import TypeVar

from PySide6.QtCore import QObject, QThread, Signal, Slot

from workbench.interruption import Interrupted, given_up_when

Step = TypeVar("Step")
End = TypeVar("End")


class Task:
    """Work that was asked for, as its thread sees it.

    Parameters
    ----------
    work : Callable
        Does it; gets the task.
    request : object
        What was asked.
    report : Callable
        Takes the task and a value to the window's thread.
    """

    def __init__(
        self, work: "Work", request: object, report: Callable[["Task", object], object]
    ) -> None:
        self.request = request
        self.wanted = True
        self.result: object = None
        self.error: Exception | None = None
        self._work, self._report = work, report
        self._stopped = threading.Event()

    @property
    def stopped(self) -> bool:
        """Whether the work shall end soon."""
        return self._stopped.is_set()

    def stop(self) -> None:
        """Ask the work to end soon."""
        self._stopped.set()

    def report(self, value: object) -> None:
        """Tell how far the work is; meant for its thread."""
        self._report(self, value)

    def follow(
        self, steps: Generator[Step, None, End], watch: Callable[[Step], object] | None = None
    ) -> End | None:
        """Take steps until their end, or until the work shall end; meant for its thread.

        Parameters
        ----------
        steps : generator
            Each of its steps takes a moment.
        watch : callable, optional
            Called with what each step yields.

        Returns
        -------
        object
            What the steps return; None if they were left before that.
        """
        with closing(steps):
            while not self.stopped:
                try:
                    step = next(steps)
                except StopIteration as end:
                    found: End = end.value
                    return found
                if watch is not None:
                    watch(step)
        return None

    def run(self) -> None:
        """Do the work, or leave it as soon as nobody wants it; meant for its thread."""
        try:
            with given_up_when(lambda: not self.wanted):
                self.result = self._work(self)
        except Interrupted:
            pass
        except Exception as error:  # of any kind: it has to reach the person
            self.error = error


Work = Callable[[Task], object]


class _Thread(QThread):
    """Makes one call. It has no event loop, and nothing is connected to it."""

    def __init__(self, call: Callable[[], object]) -> None:
        super().__init__()
        self._call = call

    def run(self) -> None:
        self._call()


class Background(QObject):
    """Does the latest work that was asked for, and tells what came of it.

    Parameters
    ----------
    name : str
        Of the thread.
    finish_first : bool
        Finish and tell work that has begun before that of a later request begins; otherwise a
        later request cancels it.

    Attributes
    ----------
    progressed : Signal(object, object)
        A request, and what the work on it reports.
    done : Signal(object, object)
        A request, and what the work on it returned.
    failed : Signal(object, Exception)
        A request, and what ended the work on it.
    """

    progressed = Signal(object, object)
    done = Signal(object, object)
    failed = Signal(object, object)

    # From the thread. These are queued: their receivers live in the window's thread.
    _reported = Signal(object, object)
    _ended = Signal(object)

    def __init__(self, name: str, parent: QObject | None, *, finish_first: bool = False) -> None:
        super().__init__(parent)
        self._name, self._finish_first = name, finish_first
        self._next: Task | None = None
        self._task: Task | None = None  # in the thread
        self._thread: _Thread | None = None
        self._reported.connect(self._pass_on)
        self._ended.connect(self._end)

    @property
    def busy(self) -> bool:
        """Whether an outcome is still to be emitted."""
        return self._next is not None or (self._task is not None and self._task.wanted)

    @property
    def running(self) -> bool:
        """Whether a thread is at work, be it on what nobody wants any more."""
        return self._task is not None

    @property
    def stopping(self) -> bool:
        """Whether the work whose outcome is still to be emitted was asked to end."""
        return self._task is not None and self._task.wanted and self._task.stopped

    def begin(self, work: Work, request: object = None) -> None:
        """Do some work, now or as soon as the thread is free.

        Parameters
        ----------
        work : Callable
            Is called in the thread with its `Task`, which says when it shall end sooner.
        request : object
            Is emitted with the outcome.
        """
        if not self._finish_first:
            self.cancel()
        self._next = Task(work, request, self._reported.emit)
        if self._task is None:
            self._begin_next()

    def stop(self) -> None:
        """Ask the work to end soon; what it returns is emitted."""
        self._next = None
        if self._task is not None:
            self._task.stop()

    def cancel(self) -> None:
        """Ask the work to end soon, and emit nothing more of it."""
        self.stop()
        if self._task is not None:
            self._task.wanted = False

    def finish(self) -> None:
        """Wait for all work and tell what came of it before returning."""
        while self._task is not None:
            self._end(self._task)

    def close(self) -> None:
        """Cancel the work and wait for the thread; safe to call twice."""
        self.cancel()
        self._join()

    def _begin_next(self) -> None:
        self._task, self._next = self._next, None
        if self._task is not None:
            self._thread = _Thread(partial(self._run, self._task))
            self._thread.setObjectName(self._name)  # what the system calls it
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
            self.progressed.emit(task.request, value)

    @Slot(object)
    def _end(self, task: Task) -> None:
        if task is not self._task:  # ended or closed before this came
            return
        self._join()
        if task.wanted and task.error is None:
            self.done.emit(task.request, task.result)
        elif task.wanted:
            self.failed.emit(task.request, task.error)
        if self._task is None:  # else a slot has begun other work
            self._begin_next()
