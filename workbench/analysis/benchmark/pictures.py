"""Error and time of designs of real pictures, each designed by a fresh ``freeform design``."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import islice
from statistics import median
from types import SimpleNamespace

from resources.pictures import PICTURES
from workbench.analysis.benchmark.examples import BenchmarkTask, Notify, Table, TableColumn
from workbench.analysis.benchmark.frontier import TracedError, verified
from workbench.analysis.benchmark.machine import YARDSTICK, FreshRun, fresh_design
from workbench.analysis.benchmark.names import Settings
from workbench.analysis.cells.image import ACCURACY
from workbench.analysis.metrics import relative_l2
from workbench.arrays import Array
from workbench.design.run import run
from workbench.errors import Refused, RunFailed

_PIXELS = 256  # a side
_ACCURACY = 0.1  # of the verified image, in parts of the own error


@dataclass(frozen=True, eq=False)
class PictureDesign:
    """The lens of a picture, what it cost, and its verified image."""

    scene: str  # name of the picture
    target: Array  # (n_y, n_x)
    run: FreshRun | None = None
    check: TracedError | None = None
    failure: str = ""  # reason of a failure

    @property
    def error(self) -> float | None:
        """Verified error."""
        return self.check and self.check.error

    @property
    def bound(self) -> float | None:
        """Error bound of ``error``."""
        return self.check and self.check.bound

    @property
    def efficiency(self) -> float | None:
        """Efficiency of the lens."""
        return self.check and self.check.efficiency

    @property
    def own(self) -> float | None:
        """Error as the run computes it."""
        return self.run and relative_l2(self.run.irradiance, self.target)

    @property
    def own_off_by(self) -> float | None:
        """Relative difference of own and verified error."""
        return abs(self.own / self.error - 1) if self.own and self.error else None

    @property
    def seconds(self) -> float | None:
        """Time of the whole command."""
        return self.run and self.run.seconds

    @property
    def yardsticks(self) -> float | None:
        """Time of the whole command, as a multiple of the time of a fixed task."""
        return self.run and self.run.yardsticks

    @property
    def processor(self) -> float | None:
        """Processor time of the whole command."""
        return self.run and self.run.processor

    @property
    def iterations(self) -> int | None:
        """Iterations taken."""
        return self.run and self.run.iterations

    @property
    def net(self) -> str | None:
        """Control points of the finished lens."""
        return self.run and " × ".join(map(str, self.run.heights.shape))

    @property
    def megabytes(self) -> float | None:
        """Peak memory of the command in MB."""
        return self.run and self.run.megabytes


def designs(settings: Settings, notify: Notify) -> Iterator[PictureDesign]:
    """Design the pictures one after the other."""
    for name in settings.only:
        if name not in PICTURES:
            raise Refused(name, f"is no picture; there are {', '.join(PICTURES)}")
    pixels = settings.pixels or _PIXELS
    tasks = [BenchmarkTask.picture(name, pixels) for name in settings.only or PICTURES]
    notify(tasks[0].name, "compiling kernels")  # not part of the first time
    for _ in islice(run(tasks[0].scene, tasks[0].target), 2):
        pass
    for task in tasks:
        yield _designed(task, settings.iterations, notify)


def _designed(task: BenchmarkTask, iterations: int | None, notify: Notify) -> PictureDesign:
    try:
        notify(task.name, "designing")
        found = fresh_design(task, iterations, 1)
        notify(task.name, "verifying")
        accuracy = min(ACCURACY, _ACCURACY * relative_l2(found.irradiance, task.target))
        check = verified(task, found.heights, accuracy)
        return PictureDesign(task.name, task.target, found, check)
    except (Refused, RunFailed) as failure:
        return PictureDesign(task.name, task.target, failure=str(failure))


_COST = (
    TableColumn("error", "verified error", ".2%"),
    TableColumn("own", "own error", ".2%"),
    TableColumn("own_off_by", "own off by", ".1%"),
    TableColumn("seconds", "seconds", ".1f"),
    TableColumn("yardsticks", "yardsticks", ".0f"),
    TableColumn("processor", "processor s", ".1f"),
    TableColumn("iterations", "iterations", ".0f"),
    TableColumn("megabytes", "peak MB", ".0f"),
)
_NOTE = (
    "Verified error: relative L2 distance of the lens's image from the target, by cells of its "
    "face in another tracer; ± is the bound of that image's own error. Own error: the same "
    "distance as the run sees it, and its relative difference. Seconds, processor seconds and "
    "memory are those of a whole `freeform design` in a fresh process. " + YARDSTICK
)


def tables(found: Sequence[PictureDesign]) -> tuple[Table, Table]:
    """The designs as rows; the median and the worst of each figure."""
    columns = (
        TableColumn("scene", "picture"),
        _COST[0],
        TableColumn("bound", "±", ".2%"),
        *_COST[1:],
        TableColumn("net", "net"),
        TableColumn("efficiency", "light on the screen", ".1%"),
        TableColumn("failure", "failed"),
    )
    n_y, n_x = found[0].target.shape
    title = f"Real pictures of {n_x} × {n_y} pixels"
    known = [each for each in found if each.check is not None]
    summary = [_summary("median", median, known), _summary("worst", max, known)]
    note = f"{len(known)} of {len(found)} pictures were designed."
    summed = (TableColumn("scene", f"{n_x} × {n_y} pixels"), *_COST)
    return (
        Table(title, columns, found, _NOTE),
        Table(f"{title}: median and worst", summed, summary, note),
    )


def _summary(
    name: str, of: Callable[[list[float]], float], designs: Sequence[PictureDesign]
) -> SimpleNamespace:
    figures = {}
    for column in _COST:
        values = [value for each in designs if (value := getattr(each, column.name)) is not None]
        figures[column.name] = of(values) if values else None
    return SimpleNamespace(scene=name, **figures)
