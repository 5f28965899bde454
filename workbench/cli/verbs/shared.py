"""Arguments that several verbs have."""

import argparse

from workbench.analysis.tolerance_fields import ABOUT, PAIRS, Tolerances
from workbench.cli.verbs.parser import Parser


def add_session(parser: Parser) -> None:
    """The session whose lens is meant."""
    parser.add_input("session", role="the session", metavar="SESSION", help="session with a lens")


def add_plot(parser: Parser, does: str) -> None:
    """A picture to draw besides."""
    parser.add_output("--plot", metavar="FILE.png", help=does)


def add_json(parser: argparse.ArgumentParser) -> None:
    """Figures for scripts."""
    parser.add_argument("--json", action="store_true", help="print the figures as one JSON object")


def add_other(parser: argparse.ArgumentParser) -> None:
    """Another program that traces the lens."""
    parser.add_argument(
        "--with",
        dest="other",
        choices=["mitsuba"],
        help="have Mitsuba 3 trace the lens too (optional extra)",
    )


def add_tolerances(parser: argparse.ArgumentParser) -> None:
    """How far lenses may be off: an argument for each tolerance."""
    for name, about in ABOUT.items():
        metavar = about.unit.upper() or "N"
        pair = name in PAIRS
        parser.add_argument(
            f"--{name.replace('_', '-')}",
            metavar=("RMS", "SCALE") if pair else metavar,
            type=float,
            nargs=2 if pair else None,
            default=(0.0, 1.0) if pair else 0.0,
            help=about.tip[0].lower() + about.tip_of("lens or mirror")[1:],
        )


def tolerances_of(options: argparse.Namespace) -> Tolerances:
    """What `add_tolerances` has read."""
    return Tolerances.of(vars(options))
