"""Commands on a designed lens (validate, tolerances, manufacture, export, pictures, report).

Arguments and examples, as in `design_arguments`.
"""

import argparse
import textwrap
from pathlib import Path
from typing import Any

from workbench.analysis.making.photograph_options import PhotographOptions
from workbench.analysis.making.plan_options import PlanOptions
from workbench.analysis.shop_limits import Limits
from workbench.cli.parser import (
    add_hidden_options,
    add_json,
    add_options,
    add_other,
    add_plot,
    add_session,
    add_tolerance_sizes,
    add_verb,
    count,
    distances,
    length,
    place,
    rays,
    stops,
    tolerances_of,
)
from workbench.errors import Refused
from workbench.files.export.formats import ENDINGS
from workbench.files.export.options import GROUPS, MESH_UNITS, MILLIMETRES

_ENTRANCE = ".entrance"
LIGHTS = ("daylight", "led", "equal")
"""Those of `workbench.analysis.photo.light`, which takes long to import."""


def add_validate(commands: Any) -> None:
    """Add ``freeform validate``."""
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
        _run_validate,
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


def _run_validate(options: argparse.Namespace) -> None:
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


def add_tolerances(commands: Any) -> None:
    """Add ``freeform tolerances``."""
    parser = add_verb(
        commands,
        "tolerances",
        "Perturb the lens of a session at random, evenly within tolerances, and trace each "
        "lens anew. Lengths are in the scene's unit. Ctrl-C keeps what is finished.",
        [
            "tolerances flame.freeform --tilt 0.2 --decentre 0.01",
            "tolerances flame.freeform --surface 1e-5 0.1 --samples 500 --plot errors.png",
        ],
        _run_tolerances,
    )
    add_session(parser)
    parser.add_argument(
        "--samples", metavar="N", type=count, default=100, help="lenses; default %(default)s"
    )
    parser.add_argument(
        "--rays", metavar="N", type=rays, default=1_000_000, help="for each; default %(default)s"
    )
    add_tolerance_sizes(parser)
    add_plot(parser, "draw how the error is distributed")
    add_json(parser)


def _run_tolerances(options: argparse.Namespace) -> None:
    from workbench.cli.tolerances import tolerances

    within = tolerances_of(options)
    tolerances(options.session, within, options.samples, options.rays, options.plot, options.json)


def add_manufacture(commands: Any) -> None:
    """Add ``freeform manufacture``."""
    parser = add_verb(
        commands,
        "manufacture",
        "Print what a shop asks of the lens of a session: thickness, slope, radii of curvature, "
        "the ball cutter that fits, sag and draft. Lengths are in the scene's unit. Ends with "
        "status 1 if a limit is not met.",
        [
            "manufacture flame.freeform",
            "manufacture flame.freeform --min-radius 0.05 --max-slope 25 --plot maps.png",
        ],
        _run_manufacture,
    )
    add_session(parser)
    add_options(parser, Limits)
    add_plot(parser, "draw maps; what is beyond limits is hatched")
    add_json(parser)


def _run_manufacture(options: argparse.Namespace) -> None:
    from workbench.cli.manufacture import manufacture

    limits = Limits.of(vars(options))
    manufacture(options.session, limits, options.plot, options.json)


def add_plan(commands: Any) -> None:
    """Add ``freeform plan``."""
    parser = add_verb(
        commands,
        "plan",
        "Find the cheapest way to mill and polish the lens of a session: step-over and width of "
        "polishing for a wanted error as made. Lengths are in the scene's unit.",
        [
            "plan plate.freeform",
            "plan plate.freeform --error 6 --ball 1.5 -o milled.freeform",
        ],
        _run_plan,
    )
    add_session(parser)
    add_options(parser, PlanOptions)
    parser.add_output(
        "-o",
        dest="output",
        metavar="OUT.freeform",
        help="session whose lens is made by the cheapest plan",
    )
    add_json(parser)


def _run_plan(options: argparse.Namespace) -> None:
    from workbench.cli.plan import plan

    plan(options.session, PlanOptions.of(vars(options)), options.output, options.json)


def add_photograph(commands: Any) -> None:
    """Add ``freeform photograph``."""
    parser = add_verb(
        commands,
        "photograph",
        "Compare a photograph of the projected light with the prediction, and find likely causes "
        "of differences: distance and tilt of the screen, size of the source.",
        ["photograph plate.freeform wall.jpg --corners 210,95 1630,120 1605,1180 232,1204"],
        _run_photograph,
    )
    add_session(parser)
    parser.add_input("photo", role="the photograph", metavar="PHOTO", help="image file")
    parser.add_argument(
        "--corners",
        metavar="X,Y",
        nargs=4,
        type=place,
        required=True,
        help="pixels of the screen's corners in the photograph, around it from the top left one of "
        "the target",
    )
    add_options(parser, PhotographOptions)
    add_plot(parser, "draw the photograph beside the prediction")
    add_json(parser)


def _run_photograph(options: argparse.Namespace) -> None:
    from workbench.cli.photograph import photograph

    photograph(
        options.session,
        options.photo,
        tuple(options.corners),
        PhotographOptions.of(vars(options)),
        options.plot,
        options.json,
    )


def add_export(commands: Any) -> None:
    """Add ``freeform export``."""
    shared = [ending for ending in ENDINGS if not ending.startswith(_ENTRANCE)]
    endings = textwrap.fill(
        f"Endings: {', '.join(shared)}. {_ENTRANCE} before that of a face, of height or of G-code "
        "(a.entrance.xyz): the freeform entrance face.",
        79,
    )
    parser = add_verb(
        commands,
        "export",
        f"Write the lens of a session and its light; the endings select the formats.\n\n{endings}",
        [
            "export flame.freeform flame.step flame.irradiance.tiff",
            "export flame.freeform flame.stl flame.3mf --chord-error 1e-5",
            'export flame.freeform flame.nc --dialect fanuc --cutter "1 mm" --roughing flat',
        ],
        _run_export,
    )
    add_session(parser)
    parser.add_output("files", metavar="FILE", nargs="+", help="file to write, such as lens.step")
    parser.add_argument(
        "--chord-error",
        metavar="LENGTH",
        type=length,
        help="how far meshes may be from the exit face, in the scene's unit; "
        "default 1e-4 of the larger half-width",
    )
    parser.add_argument(
        "--mesh-unit",
        metavar="UNIT",
        choices=MESH_UNITS,
        default=MILLIMETRES,
        help="of .stl, .obj, .ply, .3mf: mm, cm, m, inch, scene [mm]",
    )
    add_hidden_options(parser, GROUPS, "--options")
    parser.add_argument(
        "--element",
        metavar="NAME",
        help="element of files that hold one element [the last one]",
    )


def _run_export(options: argparse.Namespace) -> None:
    from workbench.cli.output import export

    unit, element = options.mesh_unit, options.element
    export(options.session, options.files, options.chord_error, vars(options), unit, element)


def add_pictures(commands: Any) -> None:
    """Add ``freeform pictures``."""
    parser = add_verb(
        commands,
        "pictures",
        "Draw the lens of a session with its rays, its light and its loss as PNG.",
        [
            "pictures flame.freeform pictures/",
            "pictures flame.freeform pictures/ --photo --exposure -0.5",
        ],
        _run_pictures,
    )
    add_session(parser)
    parser.add_output(
        "folder", files=_picture_files, metavar="FOLDER", help="where the pictures go"
    )
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


def _picture_files(folder: Path) -> list[Path]:
    from workbench.pictures import PICTURES

    return [folder / name for name in (*PICTURES, "photo.png")]


def _run_pictures(options: argparse.Namespace) -> None:
    from workbench.cli.output import pictures

    asked = [name for name in ("exposure", "light") if getattr(options, name) is not None]
    if asked and not options.photo:
        raise Refused("usage", f"--{asked[0]} is of the photo; give --photo as well")
    exposure = (options.exposure or 0.0) if options.photo else None
    pictures(options.session, options.folder, exposure, options.light or "")


def add_report(commands: Any) -> None:
    """Add ``freeform report``."""
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
        _run_report,
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
    add_tolerance_sizes(parser)


def _run_report(options: argparse.Namespace) -> None:
    from workbench.cli.output import report

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
