"""The benchmarks: their measurements and tables."""

from collections.abc import Callable, Iterator, Sequence
from typing import Any, NamedTuple

from workbench.analysis.benchmark import bounds, experiments, frontier, leds, second_tracer
from workbench.analysis.benchmark.examples import Notify, Table


class Benchmark(NamedTuple):
    """A benchmark."""

    # Yields rows; takes a limit of iterations (None leaves it to each scene) and a `Notify`.
    measure: Callable[[int | None, Notify], Iterator[Any]]
    tables: Callable[[Sequence[Any]], tuple[Table, ...]]


def _courses(effort: Callable[[int | None], frontier.Effort]) -> Benchmark:
    return Benchmark(
        lambda iterations, notify: frontier.courses(effort(iterations), notify),
        lambda rows: (frontier.table(rows),),
    )


SUITE = {
    "quick": _courses(frontier.quick),
    "frontier": _courses(frontier.frontier),
    "large": _courses(frontier.large),
    "bound": Benchmark(bounds.lenses, lambda rows: (bounds.table(rows),)),
    "led": Benchmark(leds.lenses, lambda rows: (leds.table(rows),)),
    "mitsuba": Benchmark(
        lambda iterations, notify: second_tracer.comparisons(notify),
        lambda rows: (second_tracer.table(rows),),
    ),
    "trains": Benchmark(
        lambda iterations, notify: second_tracer.trains(notify, iterations),
        lambda rows: (second_tracer.table(rows),),
    ),
    "paper": Benchmark(experiments.experiments, experiments.tables),
}
"""Benchmarks by the names of `names.BENCHMARKS`."""
