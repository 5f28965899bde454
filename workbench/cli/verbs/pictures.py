"""``freeform pictures``: its arguments."""

import argparse
from pathlib import Path
from typing import Any

from workbench.cli.verbs.kinds import stops
from workbench.cli.verbs.parser import add_verb
from workbench.cli.verbs.shared import add_session
from workbench.errors import Refused

DOES = "draw a lens and its light"

LIGHTS = ("daylight", "led", "equal")
"""Those of `workbench.analysis.photo.light`, which takes long to import."""


def add(commands: Any) -> None:
    """Add the verb."""
    parser = add_verb(
        commands,
        "pictures",
        "Draw the lens of a session with its rays, its light and its loss as PNG.",
        [
            "pictures flame.freeform pictures/",
            "pictures flame.freeform pictures/ --photo --exposure -0.5",
        ],
        _run,
    )
    add_session(parser)
    parser.add_output("folder", files=_files, metavar="FOLDER", help="where the pictures go")
    parser.add_argument(
        "--photo",
        action="store_true",
        help="also predict what a camera would see on the screen, in colour",
    )
    parser.add_argument(
        "--exposure",
        metavar="STOPS",
        type=stops,
        help="of the photo; one more is twice as bright; default 0",
    )
    parser.add_argument(
        "--light",
        choices=LIGHTS,
        help="what lights the lens in the photo; default as its source suggests: daylight from "
        "infinitely far, a laser as a Gaussian beam, else an LED",
    )


def _files(folder: Path) -> list[Path]:
    from workbench.pictures import PICTURES

    return [folder / name for name in (*PICTURES, "photo.png")]


def _run(options: argparse.Namespace) -> None:
    from workbench.cli.pictures import pictures

    asked = [name for name in ("exposure", "light") if getattr(options, name) is not None]
    if asked and not options.photo:
        raise Refused("usage", f"--{asked[0]} is of the photo; give --photo as well")
    exposure = (options.exposure or 0.0) if options.photo else None
    pictures(options.session, options.folder, exposure, options.light or "")
