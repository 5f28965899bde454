"""``freeform design``: its arguments."""

import argparse
import math
import time
from pathlib import Path
from typing import Any

from workbench.cli.verbs.kinds import positive
from workbench.cli.verbs.parser import add_verb
from workbench.cli.verbs.shared import add_json

DOES = "design a lens"


def add(commands: Any) -> None:
    """Add the verb."""
    parser = add_verb(
        commands,
        "design",
        "Design a lens. Ctrl-C keeps the best lens so far.",
        [
            "design flame.json -o flame.freeform",
            "design flame.freeform -o finer.freeform --seconds 60",
        ],
        _run,
    )
    parser.add_input(
        "scene",
        role="the scene",
        metavar="SCENE",
        help="scene file, or session; one with a lens goes on from it",
    )
    parser.add_output(
        "-o",
        dest="output",
        may_replace=_goes_on,
        metavar="OUT.freeform",
        required=True,
        help="session to write",
    )
    parser.add_argument(
        "--iterations", metavar="N", type=int, help="upper limit, in place of the scene's"
    )
    parser.add_argument(
        "--seconds", metavar="S", type=positive, default=math.inf, help="stop after this time"
    )
    add_json(parser)


def _goes_on(path: Path) -> bool:
    """A session may take its place again, with a lens that went on from its own."""
    from workbench.files.session import is_session

    return is_session(path)


def _run(options: argparse.Namespace) -> None:
    begun = time.perf_counter()  # what is imported from here on takes seconds
    from workbench.cli.design import design

    deadline = begun + options.seconds
    design(options.scene, options.output, options.iterations, deadline, options.json)
