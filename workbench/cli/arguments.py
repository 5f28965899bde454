"""What can be typed.

Commands are imported when they run, so that help and refusals come at once.
"""

import argparse
import math
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any, NoReturn

from workbench.analysis.benchmark.names import BENCHMARKS, DEFAULT
from workbench.errors import Refused
from workbench.files.export.formats import ENDINGS


def parse(arguments: Sequence[str] | None) -> argparse.Namespace:
    """Read a command line.

    Returns
    -------
    argparse.Namespace
        With ``command``, a function to be called with the namespace itself.

    Raises
    ------
    Refused
        If it is not understood.
    """
    parser = _Parser(prog="freeform", description="Design lenses that throw an image of light.")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)

    design = commands.add_parser(
        "design",
        help="design a lens",
        description="Design a lens. Ctrl-C keeps the best lens so far.",
    )
    design.set_defaults(command=_design)
    design.add_argument(
        "scene",
        metavar="SCENE",
        type=Path,
        help="scene file, or session; one with a lens goes on from it",
    )
    design.add_argument(
        "-o",
        dest="output",
        metavar="OUT.freeform",
        type=Path,
        required=True,
        help="session to write",
    )
    design.add_argument(
        "--iterations", metavar="N", type=int, help="upper limit, in place of the scene's"
    )
    design.add_argument(
        "--seconds", metavar="S", type=_seconds, default=math.inf, help="stop after this time"
    )

    validate = commands.add_parser(
        "validate",
        help="check a lens by an independent trace",
        description="Trace the lens of a session anew, with other rays and by other means.",
    )
    validate.set_defaults(command=_validate)
    validate.add_argument("session", metavar="SESSION", type=Path, help="session with a lens")
    validate.add_argument(
        "--rays", metavar="N", type=_count, default=4_000_000, help="at least; default %(default)s"
    )
    validate.add_argument(
        "--screen-z", metavar="Z", type=float, help="where the screen is, in place of the scene's"
    )

    tolerances = commands.add_parser(
        "tolerances",
        help="see what small errors of a lens do to its image",
        description="Perturb the lens of a session at random, evenly within tolerances, and trace "
        "each lens anew. Lengths are in the scene's unit. Ctrl-C keeps what is finished.",
    )
    tolerances.set_defaults(command=_tolerances)
    tolerances.add_argument("session", metavar="SESSION", type=Path, help="session with a lens")
    tolerances.add_argument(
        "--samples", metavar="N", type=_count, default=100, help="lenses; default %(default)s"
    )
    tolerances.add_argument(
        "--rays", metavar="N", type=_count, default=1_000_000, help="for each; default %(default)s"
    )
    for name, metavar, does in (
        ("tilt", "DEGREES", "largest angle between lens and optical axis"),
        ("decentre", "LENGTH", "largest distance of the lens from the axis"),
        ("index", "N", "largest error of the refractive index"),
        ("distance", "LENGTH", "largest error of the screen's distance"),
    ):
        tolerances.add_argument(f"--{name}", metavar=metavar, type=float, default=0.0, help=does)
    tolerances.add_argument(
        "--surface",
        metavar=("RMS", "SCALE"),
        type=float,
        nargs=2,
        default=(0.0, 1.0),
        help="error of the exit face, and the length over which it is alike",
    )
    tolerances.add_argument(
        "--plot", metavar="FILE.png", type=Path, help="draw how the error is distributed"
    )

    export = commands.add_parser(
        "export",
        help="write a lens for manufacture and for other programs",
        description="Write the lens of a session and its light; endings tell the formats.",
        epilog=f"Endings: {', '.join(ENDINGS)}.",
    )
    export.set_defaults(command=_export)
    export.add_argument("session", metavar="SESSION", type=Path, help="session with a lens")
    export.add_argument(
        "files", metavar="FILE", type=Path, nargs="+", help="file to write, such as lens.step"
    )
    export.add_argument(
        "--chord-error",
        metavar="LENGTH",
        type=_length,
        help="how far meshes may be from the exit face, in the scene's unit; "
        "default 1e-4 of the larger half-width",
    )

    pictures = commands.add_parser(
        "pictures",
        help="draw a lens and its light",
        description="Draw the lens of a session with its rays, its light and its loss as PNG.",
    )
    pictures.set_defaults(command=_pictures)
    pictures.add_argument("session", metavar="SESSION", type=Path, help="session with a lens")
    pictures.add_argument("folder", metavar="FOLDER", type=Path, help="where the pictures go")

    benchmark = commands.add_parser(
        "benchmark",
        help="measure run time against error",
        description="Measure run time against error. Ctrl-C keeps what is finished.",
        epilog="\n".join(["benchmarks:", *(f"  {n:<11}{does}" for n, does in BENCHMARKS.items())]),
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    benchmark.set_defaults(command=_benchmark)
    benchmark.add_argument(
        "names", metavar="NAME", nargs="*", help=f"what to measure; default {DEFAULT}"
    )
    benchmark.add_argument(
        "--output",
        metavar="FOLDER",
        type=Path,
        default=Path("benchmark"),
        help="where tables and pictures go; default %(default)s",
    )
    benchmark.add_argument(
        "--iterations", metavar="N", type=_count, help="of every design, in place of its own"
    )

    for command in (design, validate, tolerances, benchmark):
        command.add_argument(
            "--json", action="store_true", help="print the figures as one JSON object"
        )
    return parser.parse_args(arguments)


class _Parser(argparse.ArgumentParser):
    """Refuses in one line, without the usage, and takes no abbreviations."""

    def __init__(self, **settings: Any) -> None:
        super().__init__(**settings, allow_abbrev=False)

    def error(self, message: str) -> NoReturn:
        raise Refused("usage", f"{message}; {self.prog} --help tells more")


def _design(options: argparse.Namespace) -> None:
    from workbench.cli.design import design

    design(options.scene, options.output, options.iterations, options.seconds, options.json)


def _validate(options: argparse.Namespace) -> None:
    from workbench.cli.validate import validate

    validate(options.session, options.rays, options.screen_z, options.json)


def _tolerances(options: argparse.Namespace) -> None:
    from workbench.analysis.tolerances import Tolerances
    from workbench.cli.tolerances import tolerances

    within = Tolerances(
        tilt=math.radians(options.tilt),
        decentre=options.decentre,
        index=options.index,
        distance=options.distance,
        surface=tuple(options.surface),
    )
    tolerances(options.session, within, options.samples, options.rays, options.plot, options.json)


def _export(options: argparse.Namespace) -> None:
    from workbench.cli.export import export

    export(options.session, options.files, options.chord_error)


def _pictures(options: argparse.Namespace) -> None:
    from workbench.cli.pictures import pictures

    pictures(options.session, options.folder)


def _benchmark(options: argparse.Namespace) -> None:
    from workbench.cli.benchmark import benchmark

    names = options.names or [DEFAULT]
    benchmark(names, options.output, options.iterations, options.json)


def _seconds(text: str) -> float:
    with suppress(ValueError):
        if (seconds := float(text)) > 0:
            return seconds
    raise argparse.ArgumentTypeError(f"{text!r}; a number greater than 0 is needed")


def _length(text: str) -> float:
    length = _seconds(text)
    if math.isinf(length):
        raise argparse.ArgumentTypeError(f"{text!r}; a finite number is needed")
    return length


def _count(text: str) -> int:
    with suppress(ValueError):
        if (count := int(text)) > 0:
            return count
    raise argparse.ArgumentTypeError(f"{text!r}; a whole number greater than 0 is needed")
