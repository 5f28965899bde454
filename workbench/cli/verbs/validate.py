"""``freeform validate``: its arguments."""

import argparse
from typing import Any

from workbench.cli.verbs.kinds import distances, rays
from workbench.cli.verbs.parser import add_verb
from workbench.cli.verbs.shared import add_json, add_other, add_plot, add_session
from workbench.errors import Refused

DOES = "check a lens by an independent trace"


def add(commands: Any) -> None:
    """Add the verb."""
    parser = add_verb(
        commands,
        "validate",
        "Trace the lens of a session anew, with other rays and by other means.",
        [
            "validate flame.freeform --rays 16000000",
            "validate flame.freeform --screen-z 5.2 --json",
            "validate flame.freeform --through-focus 4:6:9 --plot focus.png",
            "validate flame.freeform --with mitsuba",
        ],
        _run,
    )
    add_session(parser)
    parser.add_argument(
        "--rays", metavar="N", type=rays, default=4_000_000, help="at least; default %(default)s"
    )
    parser.add_argument(
        "--screen-z", metavar="Z", type=float, help="where the screen is, in place of the scene's"
    )
    parser.add_argument(
        "--through-focus",
        metavar="Z:Z:N",
        type=distances,
        default=(),
        help="also the images on N screens from one distance to another",
    )
    add_plot(parser, "draw these images")
    add_other(parser)
    add_json(parser)


def _run(options: argparse.Namespace) -> None:
    from workbench.cli.validate import validate

    if options.plot is not None and not options.through_focus:
        raise Refused("usage", "--plot draws images through focus; give --through-focus as well")
    validate(
        options.session,
        options.rays,
        screen_z=options.screen_z,
        with_mitsuba=options.other == "mitsuba",
        distances=options.through_focus,
        plot=options.plot,
        as_json=options.json,
    )
