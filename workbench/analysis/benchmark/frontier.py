"""Verified error against time: compared methods, their curves, and those of earlier runs."""

import math
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import islice, takewhile
from pathlib import Path
from typing import Any, NamedTuple

from pydantic import BaseModel, Field, FiniteFloat, ValidationError

from workbench.analysis.benchmark.examples import BenchmarkTask, Notify, Table, TableColumn
from workbench.analysis.benchmark.machine import YARDSTICK, FreshRun, fresh_design
from workbench.analysis.cells.image import ACCURACY, imaging
from workbench.analysis.metrics import relative_l2
from workbench.analysis.validation import validate
from workbench.arrays import Array
from workbench.design.limits import HeightLimits
from workbench.design.run import run
from workbench.design.transport import transport_start
from workbench.errors import Refused, RunFailed
from workbench.geometry.surface import ControlNet
from workbench.optics.ready import held_back
from workbench.progress import finished
from workbench.scene import Scene


class MethodLens(NamedTuple):
    """A lens found by a method."""

    seconds: float  # of the method so far
    heights: Array  # (n_u, n_v), control heights of the designed face, on the method's own net
    own: float | None = None  # relative L2 error as the method computes it


Method = Callable[[BenchmarkTask, int | None], Iterator[MethodLens]]

_PAPER_ITERATIONS = 1000  # as in the paper
# With a finer net and the paper's rays its own loss falls and the verified error rises.
_PAPER_NET = 64
_PAPER_SECONDS = 10.0  # at most, so that the benchmark ends soon


def _auto(example: BenchmarkTask, iterations: int | None) -> Iterator[MethodLens]:
    return _designed(example, "auto", iterations or example.scene.run.iterations)


def _paper(example: BenchmarkTask, iterations: int | None) -> Iterator[MethodLens]:
    n_u, n_v = example.scene.optic.net_shape
    net = min(n_u, _PAPER_NET), min(n_v, _PAPER_NET)
    lens = example.scene.optic.shaped(control_points=net)
    coarse = replace(example, scene=example.scene.with_optic(lens))
    lenses = _designed(coarse, "paper", iterations or _PAPER_ITERATIONS)
    return takewhile(lambda lens: lens.seconds <= _PAPER_SECONDS, lenses)


def _paper_on_torch(example: BenchmarkTask, iterations: int | None) -> Iterator[MethodLens]:
    """As printed: the same in plain torch, without the kernels."""
    with held_back():
        yield from _paper(example, iterations)


def _transport(example: BenchmarkTask, iterations: int | None) -> Iterator[MethodLens]:
    """The first design of ``auto`` alone."""
    start = time.perf_counter()
    first = transport_start(example.scene, example.target)
    if first is None:
        raise RunFailed("no light leaves the lens, so there is none to transport")
    limits = HeightLimits.of(example.scene.optic, ControlNet.of(example.scene.optic))
    yield MethodLens(time.perf_counter() - start, limits.nearest(first))


def _designed(example: BenchmarkTask, method: str, iterations: int) -> Iterator[MethodLens]:
    before = example.scene.run
    settings = {"iterations": iterations, "seed": before.seed, "device": before.device}
    scene = Scene.from_data(example.scene.to_data() | {"run": {"method": method} | settings})
    for snapshot in run(scene, example.target):
        if snapshot.best:
            heights = snapshot.state.heights[example.scene.optic.designed_face]
            own = relative_l2(snapshot.state.irradiance, example.target)
        yield MethodLens(snapshot.seconds, heights, own)


METHODS: dict[str, Method] = {
    "paper on torch": _paper_on_torch,
    "paper": _paper,
    "transport": _transport,
    "auto": _auto,
}
"""Compared methods by name."""


TITLE = "Verified error against time"

_FIRST = 0.05  # s
_WARM_UP = 3  # lenses of a run that nobody times: compilers and caches
_ON_THE_WAY = 1e-2  # relative error of images that verify all lenses but the last
_RAYS = 4_000_000  # where cells cannot verify a lens
_FRESH = "auto"  # what ``freeform design`` runs
_NOTE = (
    "Verified error: relative L2 distance of the last lens's image from the untouched target, by "
    "cells of its face in another tracer; ± is the bound of that image's own error. Own error: the "
    "same distance as the run itself reports it. Seconds are those of the method alone, waited is "
    "the time of a fresh `freeform design`, and peak MB is the memory of that process. " + YARDSTICK
)


@dataclass(frozen=True)
class Effort:
    """Scenes, methods and effort of a measurement."""

    examples: tuple[BenchmarkTask, ...]
    methods: tuple[str, ...]  # speed is relative to the first
    iterations: int | None  # upper limit; None leaves it to each method
    step: float  # ratio of the times of successive verified lenses
    processes: int  # fresh processes that design each scene


class TracedError(NamedTuple):
    """Relative L2 error of a lens by an independent tracer, its error bound, efficiency, image."""

    error: float
    bound: float
    efficiency: float
    irradiance: Array  # (n_y, n_x)


@dataclass(frozen=True)
class Course:
    """Verified error of a method on a scene, against time."""

    scene: str
    method: str
    # Time of the method alone, s, and verified error of its best lens.
    times: tuple[float, ...] = ()
    errors: tuple[float, ...] = ()
    own_curve: tuple[tuple[float, float], ...] = ()  # time and own error after each iteration
    last: TracedError | None = None  # of the last lens
    fresh: FreshRun | None = None
    sooner: float | None = None  # speed-up over the first method at its lowest error; None: never
    failure: str = ""  # reason of a failure

    @property
    def curve(self) -> list[tuple[float, float]]:
        """Pairs of time and verified error."""
        return list(zip(self.times, self.errors, strict=True))

    @property
    def seconds(self) -> float | None:
        """Time of the whole run."""
        return self.times[-1] if self.last else None

    @property
    def error(self) -> float | None:
        """Verified error of the last lens."""
        return self.last and self.last.error

    @property
    def bound(self) -> float | None:
        """Error bound of ``error``."""
        return self.last and self.last.bound

    @property
    def efficiency(self) -> float | None:
        """Efficiency of the last lens."""
        return self.last and self.last.efficiency

    @property
    def own(self) -> float | None:
        """Error of the last lens as the run computes it."""
        return self.own_curve[-1][1] if self.last and self.own_curve else None

    @property
    def own_over_verified(self) -> float | None:
        """Own over verified error: 1 if the run is right."""
        return self.own / self.error if self.own and self.error else None

    @property
    def waited(self) -> float | None:
        """Time of the fresh process."""
        return self.fresh and self.fresh.seconds

    @property
    def yardsticks(self) -> float | None:
        """Time of the fresh process as a multiple of the yardstick's."""
        return self.fresh and self.fresh.yardsticks

    @property
    def megabytes(self) -> float | None:
        """Peak memory of the fresh process in MB."""
        return self.fresh and self.fresh.megabytes

    def time_to(self, error: float) -> float | None:
        """Return the first time with at most this verified error; None for never."""
        return next((t for t, e in self.curve if e <= error), None)


def quick(iterations: int | None) -> Effort:
    """Two small scenes: within two minutes on two cores."""
    small: dict[str, Any] = {
        "lens.back.control_points": [32, 32],
        "source.rays": [256, 256],
        "images[0].receiver.pixels": [128, 128],
        "run.iterations": 150,
    }
    examples = tuple(BenchmarkTask.of(name, changes=small) for name in ("tophat", "flame"))
    return Effort(examples, tuple(METHODS), iterations or 200, step=2.0, processes=1)


def frontier(iterations: int | None) -> Effort:
    """Every kind of scene at full size, three real pictures among them."""
    names = ("tophat", "ball", "flame", "letter", "flame-point")
    pictures = (BenchmarkTask.picture(name, 256) for name in ("camera", "hello", "code"))
    examples = (*map(BenchmarkTask.of, names), *pictures)
    methods = ("paper", "transport", "auto")
    return Effort(examples, methods, iterations, step=math.sqrt(2), processes=3)


def courses(effort: Effort, notify: Notify) -> Iterator[Course]:
    """Measure all methods on all scenes, one after the other."""
    for example in effort.examples:
        yardstick: Course | None = None
        for name in effort.methods:
            course = _course(example, name, effort, notify)
            yardstick = yardstick or course
            yield replace(course, sooner=_sooner(course, yardstick))


def table(found: Sequence[Course]) -> Table:
    """The courses as rows."""
    columns = (
        TableColumn("scene", "scene"),
        TableColumn("method", "method"),
        TableColumn("error", "verified error", ".2%"),
        TableColumn("bound", "±", ".2%"),
        TableColumn("own", "own error", ".2%"),
        TableColumn("own_over_verified", "own / verified", ".3f"),
        TableColumn("efficiency", "light on the screen", ".1%"),
        TableColumn("seconds", "seconds", ".1f"),
        TableColumn("waited", "waited", ".1f"),
        TableColumn("yardsticks", "yardsticks", ".0f"),
        TableColumn("megabytes", "peak MB", ".0f"),
        TableColumn("sooner", f"times sooner at the best error of {found[0].method}", ".3g"),
        TableColumn("failure", "failed"),
        TableColumn("curve", ""),
        TableColumn("own_curve", ""),
    )
    return Table(TITLE, columns, found, _NOTE)


def _course(example: BenchmarkTask, name: str, effort: Effort, notify: Notify) -> Course:
    course = Course(example.name, name)
    case = f"{example.name}, {name}"
    try:
        kept: list[MethodLens] = []
        own: list[tuple[float, float]] = []
        for lens in _timed(METHODS[name], example, effort.iterations):
            notify(case, f"{lens.seconds:.1f} s")
            if lens.own is not None:
                own.append((lens.seconds, lens.own))
            if not kept or lens.seconds >= max(_FIRST, effort.step * kept[-1].seconds):
                kept.append(lens)
        if lens.seconds > kept[-1].seconds:
            kept.append(lens)
        course = replace(course, own_curve=tuple(own))
        for number, lens in enumerate(kept, 1):
            notify(case, f"verifying {number} of {len(kept)}")
            accuracy = ACCURACY if number == len(kept) else _ON_THE_WAY
            found = verified(example, lens.heights, accuracy)
            times, errors = (*course.times, lens.seconds), (*course.errors, found.error)
            course = replace(course, times=times, errors=errors)
        course = replace(course, last=found)
        if name == _FRESH:
            notify(case, "in a fresh process")
            fresh = fresh_design(example, effort.iterations, effort.processes)
            course = replace(course, fresh=fresh)
    except (Refused, RunFailed) as failure:
        return replace(course, failure=str(failure))
    return course


def _timed(method: Method, example: BenchmarkTask, iterations: int | None) -> Iterator[MethodLens]:
    for _ in islice(method(example, iterations), _WARM_UP):
        pass
    return method(example, iterations)


def verified(example: BenchmarkTask, lens: Array, accuracy: float = ACCURACY) -> TracedError:
    """Verify a lens by cells, or by random rays where the source has many points."""
    scene = example.scene.with_optic(example.scene.optic.shaped(control_points=lens.shape))
    image = finished(imaging(scene, {example.scene.optic.designed_face: lens}, accuracy))
    if image is None:
        light = validate(scene, example.target, {example.scene.optic.designed_face: lens}, _RAYS)
        low, high = light.relative_l2_corrected_interval
        bound = (high - low) / 2
        return TracedError(light.relative_l2_corrected, bound, light.efficiency, light.irradiance)
    efficiency = scene.receiver.total(image.irradiance)
    return TracedError(*image.error(example.target), efficiency, image.irradiance)


def _sooner(course: Course, yardstick: Course) -> float | None:
    """Ratio of the times of both to the lowest error of the yardstick, rounded up to a step."""
    if not yardstick.errors:
        return None
    goal = min(yardstick.errors)
    mine, theirs = course.time_to(goal), yardstick.time_to(goal)
    return None if mine is None or theirs is None else theirs / mine


METHOD = "auto"
"""Method whose curves are compared with earlier ones."""


class _Row(BaseModel):
    scene: str
    method: str
    curve: list[tuple[FiniteFloat, FiniteFloat]]
    own_curve: list[tuple[FiniteFloat, FiniteFloat]] = []


class _File(BaseModel):
    rows: list[_Row] = Field(alias=TITLE)


def kept_courses(path: Path) -> list[Course]:
    """Read the curves in a JSON file of ``freeform benchmark``; raise Refused if impossible."""
    try:
        file = _File.model_validate_json(path.read_bytes())
    except OSError as error:
        raise Refused(str(path), f"cannot be read: {error.strerror or error}") from error
    except ValidationError as error:
        raise Refused(str(path), "has no curves; frontier.json of a benchmark is needed") from error
    return [
        Course(
            row.scene,
            row.method,
            times=tuple(seconds for seconds, _ in row.curve),
            errors=tuple(found for _, found in row.curve),
            own_curve=tuple(row.own_curve),
        )
        for row in file.rows
    ]


def earlier_courses(path: Path) -> list[Course]:
    """Read the curves of ``auto`` in an earlier result; see `kept_courses`."""
    return [
        replace(course, method=f"{METHOD}, before", own_curve=())
        for course in kept_courses(path)
        if course.method == METHOD
    ]
