"""Arguments and examples of ``freeform inspect``."""

import argparse
from typing import Any

from workbench.cli.parser import add_json, add_plot, add_session, add_verb, length, rays
from workbench.measured.surfaces import ENDINGS, UNITS


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
    for name, does in (
        ("unit", "of the measurements [that of the file, or else of the scene]"),
        ("z-unit", "of their heights, if it is another one"),
    ):
        parser.add_argument(f"--{name}", choices=UNITS, help=does)
    parser.add_argument("--scale", action="store_true", help="determine a scale (shrinkage), too")
    parser.add_argument(
        "--pixel", metavar="LENGTH", type=length, help="of pictures: the side of a pixel"
    )
    parser.add_argument(
        "--levels",
        metavar=("BLACK", "WHITE"),
        type=float,
        nargs=2,
        default=(0.0, 1.0),
        help="of pictures: heights of black and of white",
    )
    parser.add_input(
        "--made-from",
        role="the session that parts were made from",
        metavar="SESSION",
        help="session that the parts were made from, if it is a corrected one",
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
    from workbench.analysis.inspection.inspection import Units
    from workbench.cli.inspect import inspect
    from workbench.measured.surfaces import PictureScale

    pictures = None if options.pixel is None else PictureScale(options.pixel, *options.levels)
    inspect(
        options.session,
        options.files,
        face=options.face,
        unit=Units(options.unit, options.z_unit),
        with_scale=options.scale,
        pictures=pictures,
        made_from=options.made_from,
        rays=options.rays,
        plot=options.plot,
        as_json=options.json,
        output=options.output,
    )
