"""A sweep in a thread of the window, until all is done or somebody has seen enough."""

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from ui.threads.background import Task
from workbench.progress import Interrupted, interrupted_when

if TYPE_CHECKING:
    from workbench.sweep.points import Point
    from workbench.sweep.sweep import PointRow

RAYS = 4_000_000
"""Of the check of each lens, as on the command line."""


@dataclass(frozen=True, eq=False)
class Sweep:
    """What is to be designed.

    Attributes
    ----------
    points : list of Point
        The design tasks.
    folder : Path
        Where sessions and tables go; what is finished there is not done again.
    """

    points: "list[Point]"
    folder: Path


def work_on(sweep: Sweep, task: Task) -> None:
    """Design the lenses of a sweep, each in a process; meant for a thread.

    Reports the number of a point and its row as soon as it is finished. What is finished when the
    task is stopped is kept.

    Raises
    ------
    Refused
        If the folder cannot be written, or another sweep is at work in it.
    """
    # Late: what they stand on is slow to import.
    from workbench.sweep.processes import Processes
    from workbench.sweep.sweep import Store
    from workbench.sweep.sweep import sweep as rows_of

    store, found = Store(sweep.folder), dict[int, "PointRow"]()
    with store.locked():
        try:
            workers = Processes.of(len(sweep.points))
            with interrupted_when(lambda: task.stopped), workers:
                for number, row in rows_of(sweep.points, store, workers, RAYS):
                    found[number] = row
                    task.report((number, row))
        except Interrupted:
            pass  # the table has what is finished
        store.write_table([found[number] for number in sorted(found)])
