"""Benchmarks for developers: ``python -m tests.benchmarks kernels`` prints a table."""

import argparse
from collections.abc import Callable, Iterator
from typing import Any

from tests.benchmarks import comparison, kernels

_SUITE: dict[str, tuple[Callable[..., Iterator[Any]], Callable[..., Any]]] = {
    "kernels": (kernels.measurements, lambda rows: comparison.table("Loss and gradient", rows)),
}
"""What measures rows, and what makes a table of them."""


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser("python -m tests.benchmarks", description=__doc__)
    parser.add_argument("name", choices=_SUITE)
    measure, table = _SUITE[parser.parse_args().name]
    rows = list(measure(None, lambda case, state: print(case, state, flush=True)))
    print(table(rows).to_markdown())


if __name__ == "__main__":
    main()
