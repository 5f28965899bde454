"""Work in parallel processes of this machine: each designs a lens and checks it.

Each process has its own pipe. A killed process loses only its point; all processes end with their
parent.
"""

import multiprocessing
import os
import signal
import threading
from collections.abc import Iterator
from contextlib import suppress
from multiprocessing.connection import Connection, wait
from multiprocessing.context import SpawnProcess
from typing import Any, NamedTuple, Self, TypeVar

from workbench.arrays import Array
from workbench.defects import unexpected
from workbench.design.design_run import DesignRun
from workbench.design.session import Session, result_of
from workbench.design.snapshot import Result
from workbench.errors import Refused, RunFailed
from workbench.process import cores
from workbench.progress import check_interruption
from workbench.scene import Scene

Key = TypeVar("Key")
_POLL_SECONDS = 0.1  # between checks for interruption


class DesignTask(NamedTuple):
    """A scene, its target (n_y, n_x), and the least number of rays of the check."""

    scene: Scene
    target: Array
    rays: int


class Done(NamedTuple):
    """A lens and the figures of its independent check (`Validation.to_data`)."""

    result: Result
    check: dict[str, Any]


class Failed(NamedTuple):
    """Why there is no lens, in one sentence."""

    reason: str


def attempt(task: DesignTask, threads: int | None = None) -> Done | Failed:
    """Design and check a lens; a failure is part of the result."""
    try:
        return _design(task, threads)
    except (Refused, RunFailed) as failure:
        return Failed(str(failure))
    except Exception as error:  # one point must not end the sweep
        return Failed(unexpected(error))


def _design(task: DesignTask, threads: int | None) -> Done:
    import torch  # takes seconds; the parent process does not need it

    from workbench.analysis.validation import validate
    from workbench.design.transport import compile_all

    if threads is not None:
        torch.set_num_threads(threads)
    compile_all()  # not part of the run time
    run = DesignRun(Session(task.scene, task.target))
    for _ in run:
        pass
    result = result_of(run.session)
    check = validate(
        task.scene, task.target, result.state.heights, task.rays, threads=threads
    ).to_data()
    return Done(result, check)


class Processes:
    """Runs tasks in up to ``count`` processes of ``threads`` threads, as a context manager."""

    def __init__(self, count: int, threads: int) -> None:
        self._count, self._threads = count, threads
        self._all: dict[Connection, SpawnProcess] = {}
        self._idle: list[Connection] = []

    @classmethod
    def of(cls, points: int, jobs: int | None = None) -> Self:
        """Return processes that share all cores: at most one for each core, point and job."""
        available = cores()
        count = min(jobs or available, points)
        return cls(count, max(available // count, 1))

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: Any) -> None:
        for pipe, process in self._all.items():
            process.terminate()
            process.join()
            pipe.close()
        self._all.clear()

    def work(self, tasks: Iterator[tuple[Key, DesignTask]]) -> Iterator[tuple[Key, Done | Failed]]:
        """Run tasks, drawn from the iterator as processes become free.

        Yield each task's key and result, in the order of completion. Raise Interrupted if the
        program is interrupted; see `workbench.progress`.
        """
        busy: dict[Connection, Key] = {}
        while True:
            while len(busy) < self._count and (task := next(tasks, None)) is not None:
                pipe = self._idle.pop() if self._idle else self._start()
                busy[pipe] = task[0]
                with suppress(OSError):  # `_answer` reports a process that has ended
                    pipe.send(task[1])
            if not busy:
                return
            while not (ready := wait(list(busy), _POLL_SECONDS)):
                check_interruption()
            for pipe in [pipe for pipe in busy if pipe in ready]:
                yield busy.pop(pipe), self._answer(pipe)

    def _start(self) -> Connection:
        context = multiprocessing.get_context("spawn")  # threads do not survive a fork
        ours, theirs = context.Pipe()
        process = context.Process(target=_serve, args=(theirs, self._threads))
        process.start()
        theirs.close()  # so that the end of the process closes the pipe
        self._all[ours] = process
        return ours

    def _answer(self, pipe: Connection) -> Done | Failed:
        try:
            answer: Done | Failed = pipe.recv()
        except (EOFError, OSError):
            process = self._all.pop(pipe)
            process.join()
            pipe.close()
            return Failed(f"its process ended with exit status {process.exitcode}")
        self._idle.append(pipe)
        return answer


def _serve(pipe: Connection, threads: int) -> None:
    for name in ("SIGINT", "SIGHUP"):  # the parent handles signals of the terminal
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), signal.SIG_IGN)
    threading.Thread(target=_end_with_parent, daemon=True).start()
    while True:
        try:
            task = pipe.recv()
        except EOFError:
            return
        pipe.send(attempt(task, threads))


def _end_with_parent() -> None:
    parent = multiprocessing.parent_process()
    assert parent is not None
    parent.join()
    os.kill(os.getpid(), signal.SIGTERM)  # ends the process whatever its main thread does
