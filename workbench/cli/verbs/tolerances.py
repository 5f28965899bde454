"""``freeform tolerances``: its arguments."""

import argparse
from typing import Any

from workbench.cli.verbs.kinds import count, rays
from workbench.cli.verbs.parser import add_verb
from workbench.cli.verbs.shared import (
    add_json,
    add_plot,
    add_session,
    add_tolerances,
    tolerances_of,
)

DOES = "see what small errors of a lens do to its image"


def add(commands: Any) -> None:
    """Add the verb."""
    parser = add_verb(
        commands,
        "tolerances",
        "Perturb the lens of a session at random, evenly within tolerances, and trace each "
        "lens anew. Lengths are in the scene's unit. Ctrl-C keeps what is finished.",
        [
            "tolerances flame.freeform --tilt 0.2 --decentre 0.01",
            "tolerances flame.freeform --surface 1e-5 0.1 --samples 500 --plot errors.png",
        ],
        _run,
    )
    add_session(parser)
    parser.add_argument(
        "--samples", metavar="N", type=count, default=100, help="lenses; default %(default)s"
    )
    parser.add_argument(
        "--rays", metavar="N", type=rays, default=1_000_000, help="for each; default %(default)s"
    )
    add_tolerances(parser)
    add_plot(parser, "draw how the error is distributed")
    add_json(parser)


def _run(options: argparse.Namespace) -> None:
    from workbench.cli.tolerances import tolerances

    within = tolerances_of(options)
    tolerances(options.session, within, options.samples, options.rays, options.plot, options.json)
