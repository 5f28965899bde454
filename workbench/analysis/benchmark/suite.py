"""The benchmarks: what measures them, and the tables that they make."""

from collections.abc import Callable, Iterator, Sequence
from typing import Any, NamedTuple

from workbench.analysis.benchmark import bounds, experiments, frontier, leds, second_tracer
from workbench.analysis.benchmark.examples import Notify, Table


class Benchmark(NamedTuple):
    """A benchmark."""

    # Given a limit of iterations (None leaves it to each scene) and what to call with the progress,
    # it yields one row after the other.
    measure: Callable[[int | None, Notify], Iterator[Any]]
    tables: Callable[[Sequence[Any]], tuple[Table, ...]]  # puts rows into tables


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
    "paper": Benchmark(experiments.experiments, experiments.tables),
}
"""What `names.BENCHMARKS` lists."""
