"""A sweep: points in, rows out; what is finished already is not done again."""

from collections.abc import Iterator, Sequence
from typing import Protocol, TypeVar

from workbench.errors import Refused
from workbench.files.session import Session
from workbench.sweep.points import Point, key_of
from workbench.sweep.store import PointRow, Store
from workbench.sweep.work import DesignTask, Done, Failed

Key = TypeVar("Key")


class Workers(Protocol):
    """Whoever works on tasks."""

    def work(self, tasks: Iterator[tuple[Key, DesignTask]]) -> Iterator[tuple[Key, Done | Failed]]:
        """Yield what came with each task and what became of it."""


def sweep(
    points: Sequence[Point], store: Store, workers: Workers, rays: int
) -> Iterator[tuple[int, PointRow]]:
    """Design a lens at each point.

    Parameters
    ----------
    points : sequence of Point
        The points.
    store : Store
        Keeps each result as soon as it is there.
    workers : Workers
        Processes of this machine, or a cluster.
    rays : int
        Rays of the independent check of each lens, at least.

    Yields
    ------
    number : int
        Which point.
    row : PointRow
        What became of it. First come those that cannot be worked on and those that are finished
        already, then the others as they end.

    Raises
    ------
    Refused
        If a result cannot be written.
    """
    left: list[tuple[int, str]] = []
    for number, point in enumerate(points):
        try:
            key = key_of(point.session(), rays)
        except Refused as refused:
            yield number, PointRow.of(point, str(refused))
            continue
        found = store.find(point, key)
        if found is None:
            left.append((number, key))
        else:
            yield number, found

    working: dict[tuple[int, str], Session] = {}

    def tasks() -> Iterator[tuple[tuple[int, str], DesignTask]]:
        for each in left:
            session = working[each] = points[each[0]].session()
            yield each, DesignTask(session.scene, session.target, rays)

    for each, outcome in workers.work(tasks()):
        (number, key), task = each, working.pop(each)
        if isinstance(outcome, Failed):
            yield number, PointRow.of(points[number], outcome.reason)
        else:
            yield number, store.put(points[number], key, task, outcome)
