"""Arguments and examples of ``freeform inspect``."""

import argparse
from typing import Any

from workbench.analysis.inspection.options import InspectionOptions
from workbench.cli.parser import add_json, add_options, add_plot, add_session, add_verb, rays
from workbench.measured.surfaces import ENDINGS


def add_inspect(commands: Any) -> None:
    """Add ``freeform inspect``."""
    parser = add_verb(
        commands,
        "inspect",
        "Align measurements of made parts to a face of the lens of a session, print how far they "
        "are off, and check the light of each part as measured. With -o write a session whose "
        "face makes good what repeats. Files of pictures need a scale unless they have one. "
        f"Formats: {', '.join(ENDINGS)}.",
        [
            "inspect flame.freeform 1.sdf 2.sdf 3.sdf -o corrected.freeform",
            "inspect flame.freeform next.sdf --made-from corrected.freeform -o second.freeform",
        ],
        _run_inspect,
    )
    add_session(parser)
    parser.add_input(
        "files", role="a measurement", metavar="FILE", nargs="+", help="measurement of a part"
    )
    parser.add_argument("--face", metavar="ID", help="such as lens.back [the designed face]")
    add_options(parser, InspectionOptions)
    parser.add_argument(
        "--levels",
        metavar=("BLACK", "WHITE"),
        type=float,
        nargs=2,
        help=argparse.SUPPRESS,  # of older scripts: --black and --white at once
    )
    parser.add_input(
        "--made-from",
        role="the session that parts were made from",
        metavar="SESSION",
        help="corrected session that the parts were made from",
    )
    parser.add_argument(
        "--rays", metavar="N", type=rays, default=4_000_000, help="of each check [%(default)s]"
    )
    add_plot(parser, "draw the residuals and the light")
    add_json(parser)
    parser.add_output(
        "-o", "--output", metavar="CORRECTED", help="session to write, with the corrected face"
    )


def _run_inspect(options: argparse.Namespace) -> None:
    from workbench.cli.inspect import inspect

    stated = vars(options)
    if options.levels:
        stated |= dict(zip(("black", "white"), options.levels, strict=True))
    inspect(
        options.session,
        options.files,
        face=options.face,
        options=InspectionOptions.of(stated),
        made_from=options.made_from,
        rays=options.rays,
        plot=options.plot,
        as_json=options.json,
        output=options.output,
    )
