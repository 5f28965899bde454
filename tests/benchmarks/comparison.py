"""Variants of one computation, timed in turns."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from tests.benchmarks.timing import in_turns
from workbench.analysis.benchmark.examples import Table, TableColumn
from workbench.arrays import Array

_NOTE = (
    "Medians of turns taken in one process; ratios are medians of the ratios of each turn. Error "
    "of the image: relative L2 distance from an independent trace where rays, samples or filters "
    "differ, else from the other image."
)


class Variant(NamedTuple):
    """One way to do it.

    Attributes
    ----------
    label : str
        What is special about it.
    call : callable
        Does it once.
    rays : int
        Rays that this traces.
    error : float, optional
        What it costs in accuracy, where that is asked.
    """

    label: str
    call: Callable[[], object]
    rays: int
    error: float | None = None


@dataclass(frozen=True)
class Measured:
    """What a variant takes.

    Attributes
    ----------
    question, variant : str
        What is compared, and which of it this is.
    milliseconds : float
        Median time.
    ratio : float
        Times the first variant of the question, from the same rounds.
    rays : int
        Rays traced.
    error : float or None
        Relative L2 error of the image, where that is asked.
    """

    question: str
    variant: str
    milliseconds: float
    ratio: float
    rays: int
    error: float | None

    @property
    def nanoseconds_a_ray(self) -> float:
        """Time a ray."""
        return 1e6 * self.milliseconds / self.rays


def compare(question: str, variants: Sequence[Variant], seconds: float) -> list[Measured]:
    """Time some variants in turns, for about so many seconds."""
    calls: Mapping[str, Callable[[], object]] = {each.label: each.call for each in variants}
    times = in_turns(calls, seconds=seconds)
    first = times[variants[0].label]
    return [
        Measured(
            question=question,
            variant=each.label,
            milliseconds=1e3 * times[each.label].median,
            ratio=times[each.label].ratio(first),
            rays=each.rays,
            error=each.error,
        )
        for each in variants
    ]


def table(title: str, found: Sequence[Measured]) -> Table:
    """The variants as rows."""
    columns = (
        TableColumn("question", "compared"),
        TableColumn("variant", "variant"),
        TableColumn("milliseconds", "ms", ".2f"),
        TableColumn("ratio", "times the first", ".2f"),
        TableColumn("rays", "rays", ","),
        TableColumn("nanoseconds_a_ray", "ns a ray", ".1f"),
        TableColumn("error", "error of the image", ".1e"),
    )
    return Table(title, columns, found, _NOTE)


def image_error(image: Array, true: Array) -> float:
    """Relative L2 distance of an image from the true one, both at a total of 1."""
    true = true / true.sum()
    return float(np.linalg.norm(image / image.sum() - true) / np.linalg.norm(true))
