"""Processes of this machine that work on points side by side.

Each has a pipe of its own. A process that is killed costs the point it worked on, no more; and
all of them end when the one that started them does, however that happens.
"""

import multiprocessing
import os
import signal
import threading
from collections.abc import Iterator
from contextlib import suppress
from multiprocessing.connection import Connection, wait
from multiprocessing.context import SpawnProcess
from typing import Any, Self, TypeVar

from workbench.interruption import check_interruption
from workbench.sweep.work import DesignTask, Done, Failed, attempt

Key = TypeVar("Key")

_OFTEN = 0.1  # seconds after which it may be interrupted


class Processes:
    """Works on tasks while entered.

    Parameters
    ----------
    count : int
        How many processes, at most.
    threads : int
        Threads of each.
    """

    def __init__(self, count: int, threads: int) -> None:
        self._count, self._threads = count, threads
        self._all: dict[Connection, SpawnProcess] = {}
        self._idle: list[Connection] = []

    @classmethod
    def of(cls, points: int, jobs: int | None = None) -> Self:
        """As many as there are cores, or points, or ``jobs``; all cores are shared among them."""
        cores = os.cpu_count() or 1
        count = min(jobs or cores, points)
        return cls(count, max(cores // count, 1))

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: Any) -> None:
        for pipe, process in self._all.items():
            process.terminate()
            process.join()
            pipe.close()
        self._all.clear()

    def work(self, tasks: Iterator[tuple[Key, DesignTask]]) -> Iterator[tuple[Key, Done | Failed]]:
        """Work on tasks, which are asked for as they are needed.

        Yields
        ------
        tuple
            What came with a task, and what became of it; in the order in which they end.

        Raises
        ------
        Interrupted
            If it is to end; see `workbench.interruption`.
        """
        busy: dict[Connection, Key] = {}
        while True:
            while len(busy) < self._count and (task := next(tasks, None)) is not None:
                pipe = self._idle.pop() if self._idle else self._start()
                busy[pipe] = task[0]
                with suppress(OSError):  # a process that is gone tells so by its answer
                    pipe.send(task[1])
            if not busy:
                return
            while not (ready := wait(list(busy), _OFTEN)):
                check_interruption()
            for pipe in [pipe for pipe in busy if pipe in ready]:
                yield busy.pop(pipe), self._answer(pipe)

    def _start(self) -> Connection:
        context = multiprocessing.get_context("spawn")  # threads do not survive a fork
        ours, theirs = context.Pipe()
        process = context.Process(target=_serve, args=(theirs, self._threads))
        process.start()
        theirs.close()  # so that its end is seen here
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
    """Work on what comes through a pipe until nobody is there."""
    for name in ("SIGINT", "SIGHUP"):  # of the terminal, for the one that started this
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
    os.kill(os.getpid(), signal.SIGTERM)  # whatever the thread of the work does
