"""Work on a dask.distributed cluster; its workers need this program."""

from collections.abc import Iterator
from typing import Any, Self, TypeVar

import workbench
from workbench.errors import Refused
from workbench.sweep.processes import DesignTask, Done, Failed, attempt

Key = TypeVar("Key")

_SECONDS = 10  # time limit for the scheduler and for its first worker


class Cluster:
    """Runs tasks on a cluster, as a context manager.

    Raise Refused if the scheduler cannot be reached or workers have another version of the program.
    """

    def __init__(self, address: str) -> None:
        try:
            from distributed import Client
        except ImportError as error:
            raise Refused(
                "dask", "is not installed; pip install 'freeform-lens-workbench[dask]' does it"
            ) from error
        try:
            self._client = Client(address, timeout=_SECONDS, set_as_default=False)
        except (OSError, ValueError) as error:
            raise Refused("dask", f"{address!r} cannot be reached: {error}") from error
        try:
            self._check()
        except Refused:
            self._client.close()
            raise

    def _check(self) -> None:
        try:
            self._client.wait_for_workers(1, timeout=_SECONDS)
        except TimeoutError as error:
            raise Refused("dask", "the cluster has no worker; one is needed") from error
        try:
            versions = set(self._client.run(_version).values())
        except Exception as error:  # the import may fail with any exception
            raise Refused("dask", f"its workers cannot run this program: {error}") from error
        if versions != {workbench.__version__}:
            found = ", ".join(sorted(versions))
            raise Refused("dask", f"its workers have {found}; {workbench.__version__} is needed")

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: Any) -> None:
        self._client.close()  # cancels its pending tasks

    def work(self, tasks: Iterator[tuple[Key, DesignTask]]) -> Iterator[tuple[Key, Done | Failed]]:
        """Run tasks, as `workbench.sweep.processes.Processes.work` does."""
        from distributed import as_completed

        # One task in advance for each worker, so that none is idle; more would only use memory.
        most = 2 * max(sum(self._client.nthreads().values()), 1)
        waiting: dict[Any, Key] = {}
        ended = as_completed(loop=self._client.loop)
        while True:
            while len(waiting) < most and (task := next(tasks, None)) is not None:
                future = self._client.submit(attempt, task[1], pure=False)
                waiting[future] = task[0]
                ended.add(future)
            if not waiting:
                return
            future = next(ended)
            error = future.exception()  # an error of the cluster; errors of the design are results
            yield (
                waiting.pop(future),
                Failed(f"the cluster gave it up: {error}") if error else future.result(),
            )


def _version() -> str:
    return workbench.__version__
