"""Verified error against time: what a person gets who waits so long."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import islice
from typing import Any

import numpy as np
import numpy.typing as npt

from workbench.analysis.benchmark.examples import Example, Notify
from workbench.analysis.benchmark.machine import PeakMemory
from workbench.analysis.benchmark.methods import METHODS, Method
from workbench.analysis.benchmark.table import Column, Table
from workbench.analysis.validation import Validation, validate
from workbench.errors import Refused, RunFailed

Array = npt.NDArray[np.float64]

_FIRST = 0.05  # s
_WARM_UP = 3  # lenses of a run that nobody times: compilers and caches
_NOTE = (
    "Verified error: relative L2 distance from the untouched target, by an independent trace of "
    "the last lens; its standard error is beside it. Seconds are those of the method alone."
)


@dataclass(frozen=True)
class Effort:
    """How thoroughly courses are measured.

    Attributes
    ----------
    examples : tuple of Example
        The scenes.
    iterations : int or None
        Upper limit of every method; None leaves it to each.
    rays, final_rays : int
        Rays that verify a lens on the way, and the last one.
    step : float
        Factor from one time at which a lens is verified to the next.
    """

    examples: tuple[Example, ...]
    iterations: int | None
    rays: int
    final_rays: int
    step: float


@dataclass(frozen=True)
class Course:
    """Verified error of a method on a scene, against time.

    Attributes
    ----------
    scene, method : str
        Their names.
    times, errors : tuple of float
        Verified error of the best lens after some times, s. The method's own time: verifying is
        not in it.
    seconds : float
        Time of the whole run.
    error, noise, efficiency : float or None
        Of the last lens, verified with the most rays; see `Validation`.
    memory : int or None
        Peak of the process while it ran, bytes.
    sooner : float or None
        How many times sooner than the first method this one has its lowest error, or a lower one;
        None if it never does.
    failure : str
        Why there is no more; empty if all went well.
    """

    scene: str
    method: str
    times: tuple[float, ...] = ()
    errors: tuple[float, ...] = ()
    seconds: float | None = None
    error: float | None = None
    noise: float | None = None
    efficiency: float | None = None
    memory: int | None = None
    sooner: float | None = None
    failure: str = ""

    @property
    def curve(self) -> list[tuple[float, float]]:
        """Pairs of time and error."""
        return list(zip(self.times, self.errors, strict=True))

    @property
    def megabytes(self) -> float | None:
        """Peak memory in MB."""
        return None if self.memory is None else self.memory / 1e6

    def time_to(self, error: float) -> float | None:
        """The first time at which the verified error was no larger; None for never."""
        return next((t for t, e in self.curve if e <= error), None)


def quick(iterations: int | None) -> Effort:
    """The frontier in small: within two minutes on two cores."""
    small: dict[str, Any] = {
        "lens": {"control_points": [32, 32]},
        "source": {"rays": [256, 256]},
        "screen": {"pixels": [128, 128]},
        "run": {"iterations": 150},
    }
    examples = tuple(Example.of(name, **small) for name in ("tophat", "flame"))
    return Effort(examples, iterations or 200, rays=500_000, final_rays=2_000_000, step=2.0)


def frontier(iterations: int | None) -> Effort:
    """Every kind of scene at full size."""
    names = ("tophat", "ball", "flame", "flame-point", "photo", "letter")
    examples = tuple(map(Example.of, names))
    return Effort(examples, iterations, rays=4_000_000, final_rays=16_000_000, step=math.sqrt(2))


def courses(effort: Effort, notify: Notify) -> Iterator[Course]:
    """Measure all methods on all scenes, one after the other."""
    for example in effort.examples:
        yardstick: Course | None = None
        for name, method in METHODS.items():
            course = _course(example, name, method, effort, notify)
            yardstick = yardstick or course
            yield replace(course, sooner=_sooner(course, yardstick))


def table(found: Sequence[Course]) -> Table:
    """The courses as rows."""
    first = next(iter(METHODS))
    columns = (
        Column("scene", "scene"),
        Column("method", "method"),
        Column("error", "verified error", ".2%"),
        Column("noise", "±", ".2%"),
        Column("efficiency", "light on the screen", ".1%"),
        Column("seconds", "seconds", ".1f"),
        Column("sooner", f"times sooner at the best error of {first}", ".3g"),
        Column("megabytes", "peak MB", ".0f"),
        Column("failure", "failed"),
        Column("curve", ""),
    )
    return Table("Verified error against time", columns, found, _NOTE)


def _course(example: Example, name: str, method: Method, effort: Effort, notify: Notify) -> Course:
    course = Course(example.name, name)
    case = f"{example.name}, {name}"
    try:
        for _ in islice(method(example, effort.iterations), _WARM_UP):
            pass
        peak = PeakMemory()
        kept: list[tuple[float, Array]] = []
        for seconds, lens in method(example, effort.iterations):
            notify(case, f"{seconds:.1f} s")
            if not kept or seconds >= max(_FIRST, effort.step * kept[-1][0]):
                kept.append((seconds, lens))
        memory = peak.bytes()
        if seconds > kept[-1][0]:
            kept.append((seconds, lens))
        for number, (_, lens) in enumerate(kept):
            notify(case, f"verifying {number + 1} of {len(kept)}")
            course = replace(
                course,
                times=(*course.times, kept[number][0]),
                errors=(*course.errors, _verified(example, lens, effort.rays).relative_l2),
            )
        last = _verified(example, lens, effort.final_rays)
    except (Refused, RunFailed) as failure:
        return replace(course, failure=str(failure))
    return replace(
        course,
        seconds=seconds,
        error=last.relative_l2,
        noise=last.noise,
        efficiency=last.efficiency,
        memory=memory,
    )


def _verified(example: Example, lens: Array, rays: int) -> Validation:
    # A method may design on a net of its own.
    net = {"control_points": lens.shape}
    scene = example.scene.model_copy(update={"lens": example.scene.lens.model_copy(update=net)})
    return validate(scene, example.target, {"exit": lens}, rays)


def _sooner(course: Course, yardstick: Course) -> float | None:
    """Ratio of the times that both took to the lowest error that the yardstick ever has.

    Both errors are measured with the same rays. A lens is verified at some times alone: the time
    found is the first of these, and the true one may be less by the step.
    """
    if not yardstick.errors:
        return None
    goal = min(yardstick.errors)
    mine, theirs = course.time_to(goal), yardstick.time_to(goal)
    return None if mine is None or theirs is None else theirs / mine
