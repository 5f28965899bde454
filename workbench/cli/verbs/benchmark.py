"""``freeform benchmark``: its arguments."""

import argparse
from pathlib import Path
from typing import Any

from workbench.analysis.benchmark.names import BENCHMARKS, DEFAULT, WITH_CURVES
from workbench.cli.verbs.kinds import count
from workbench.cli.verbs.parser import add_verb
from workbench.cli.verbs.shared import add_json

DOES = "measure run time against error"


def add(commands: Any) -> None:
    """Add the verb."""
    names = "\n".join(f"  {name:<11}{does}" for name, does in BENCHMARKS.items())
    parser = add_verb(
        commands,
        "benchmark",
        f"Measure run time against error. Ctrl-C keeps what is finished.\n\nbenchmarks:\n{names}",
        [
            "benchmark",
            "benchmark frontier --output new/ --against old/frontier.json",
            "benchmark frontier --output both/ --result new.json --against old.json",
        ],
        _run,
    )
    parser.add_argument(
        "names", metavar="NAME", nargs="*", help=f"what to measure; default {DEFAULT}"
    )
    parser.add_output(
        "--output",
        metavar="FOLDER",
        default=Path("benchmark"),
        files=lambda folder: [folder / f"{name}.json" for name in WITH_CURVES],
        help="where tables and pictures go; default %(default)s",
    )
    parser.add_argument(
        "--iterations", metavar="N", type=count, help="of every design, in place of its own"
    )
    parser.add_input(
        "--against",
        role="the earlier result",
        metavar="FILE.json",
        help=f"earlier result, drawn beside the new one; for {', '.join(WITH_CURVES)}",
    )
    parser.add_input(
        "--result",
        role="the result",
        metavar="FILE.json",
        help="finished result, whose picture is drawn again; nothing is measured",
    )
    add_json(parser)


def _run(options: argparse.Namespace) -> None:
    from workbench.cli.benchmark import benchmark, draw_result

    names = options.names or [DEFAULT]
    if options.result is not None:
        for name in names:
            draw_result(name, options.result, options.output, options.against)
        return
    benchmark(names, options.output, options.iterations, options.against, options.json)
