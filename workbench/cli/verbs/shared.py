"""Arguments that several verbs have."""

import argparse
import math
from typing import TYPE_CHECKING

from workbench.cli.verbs.parser import Parser

if TYPE_CHECKING:
    from workbench.analysis.tolerances import Tolerances


def add_session(parser: Parser) -> None:
    """The session whose lens is meant."""
    parser.add_input("session", role="the session", metavar="SESSION", help="session with a lens")


def add_plot(parser: Parser, does: str) -> None:
    """A picture to draw besides."""
    parser.add_output("--plot", metavar="FILE.png", help=does)


def add_json(parser: argparse.ArgumentParser) -> None:
    """Figures for scripts."""
    parser.add_argument("--json", action="store_true", help="print the figures as one JSON object")


def add_tolerances(parser: argparse.ArgumentParser) -> None:
    """How far lenses may be off."""
    for name, metavar, does in (
        ("tilt", "DEGREES", "largest angle between lens and optical axis"),
        ("decentre", "LENGTH", "largest distance of the lens from the axis"),
        ("index", "N", "largest error of the refractive index"),
        ("distance", "LENGTH", "largest error of the screen's distance"),
        ("source-tilt", "DEGREES", "largest angle by which the source is turned"),
        ("source-shift", "LENGTH", "largest distance of the source from its place"),
    ):
        parser.add_argument(f"--{name}", metavar=metavar, type=float, default=0.0, help=does)
    parser.add_argument(
        "--surface",
        metavar=("RMS", "SCALE"),
        type=float,
        nargs=2,
        default=(0.0, 1.0),
        help="error of the exit face, and the length over which it is alike",
    )


def tolerances_of(options: argparse.Namespace) -> "Tolerances":
    """What `add_tolerances` has read."""
    from workbench.analysis.tolerances import Tolerances

    return Tolerances(
        tilt=math.radians(options.tilt),
        decentre=options.decentre,
        index=options.index,
        distance=options.distance,
        surface=tuple(options.surface),
        source_tilt=math.radians(options.source_tilt),
        source_shift=options.source_shift,
    )
