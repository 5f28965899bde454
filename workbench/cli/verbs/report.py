"""``freeform report``: its arguments."""

import argparse
from typing import Any

from workbench.cli.verbs.kinds import count, rays
from workbench.cli.verbs.parser import add_verb
from workbench.cli.verbs.shared import add_other, add_session, add_tolerances, tolerances_of
from workbench.errors import Refused

DOES = "tell all of a lens on some pages (HTML, PDF)"


def add(commands: Any) -> None:
    """Add the verb."""
    parser = add_verb(
        commands,
        "report",
        "Check the lens of a session and write scene, pictures, figures, light account and what "
        "a shop asks for, as one HTML file that needs nothing else, or as PDF. With --tolerances "
        "also how the error spreads over lenses that are off; lengths are in the scene's unit.",
        [
            "report flame.freeform flame.html flame.pdf",
            "report flame.freeform flame.pdf --tolerances 100 --tilt 0.2 --decentre 0.01",
        ],
        _run,
    )
    add_session(parser)
    parser.add_output("files", metavar="FILE", nargs="+", help=".html or .pdf")
    parser.add_argument(
        "--rays",
        metavar="N",
        type=rays,
        default=4_000_000,
        help="of the check, at least; default %(default)s",
    )
    parser.add_argument(
        "--tolerances", metavar="N", type=count, help="trace so many lenses that are off"
    )
    add_other(parser)
    add_tolerances(parser)


def _run(options: argparse.Namespace) -> None:
    from workbench.cli.report import report

    within, samples = tolerances_of(options), options.tolerances
    if within.any and samples is None:
        raise Refused("usage", "tolerances without a number of lenses; give --tolerances N as well")
    if samples is not None and not within.any:
        raise Refused(
            "usage", "nothing is off; give --tilt, --decentre, --index, --distance or --surface"
        )
    report(
        options.session,
        options.files,
        options.rays,
        samples and (within, samples),
        with_mitsuba=options.other == "mitsuba",
    )
