"""The benchmarks: their measurements and tables."""

from collections.abc import Callable, Iterator, Sequence
from typing import Any, NamedTuple

from workbench.analysis.benchmark import (
    bounds,
    experiments,
    frontier,
    leds,
    pictures,
    second_tracer,
)
from workbench.analysis.benchmark.examples import Notify, Table
from workbench.analysis.benchmark.names import Settings


class Benchmark(NamedTuple):
    """A benchmark."""

    measure: Callable[[Settings, Notify], Iterator[Any]]  # yields rows
    tables: Callable[[Sequence[Any]], tuple[Table, ...]]


def _courses(effort: Callable[[int | None], frontier.Effort]) -> Benchmark:
    return Benchmark(
        lambda settings, notify: frontier.courses(effort(settings.iterations), notify),
        lambda rows: (frontier.table(rows),),
    )


SUITE = {
    "quick": _courses(frontier.quick),
    "pictures": Benchmark(pictures.designs, pictures.tables),
    "frontier": _courses(frontier.frontier),
    "bound": Benchmark(
        lambda settings, notify: bounds.lenses(settings.iterations, notify),
        lambda rows: (bounds.table(rows),),
    ),
    "led": Benchmark(
        lambda settings, notify: leds.lenses(settings.iterations, notify),
        lambda rows: (leds.table(rows),),
    ),
    "mitsuba": Benchmark(
        lambda _, notify: second_tracer.comparisons(notify),
        lambda rows: (second_tracer.table(rows),),
    ),
    "trains": Benchmark(
        lambda settings, notify: second_tracer.trains(notify, settings.iterations),
        lambda rows: (second_tracer.table(rows),),
    ),
    "paper": Benchmark(
        lambda settings, notify: experiments.experiments(settings.iterations, notify),
        experiments.tables,
    ),
}
"""Benchmarks by the names of `names.BENCHMARKS`."""
