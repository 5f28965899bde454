"""``freeform export``: its arguments."""

import argparse
import textwrap
from typing import Any

from workbench.cli.verbs.kinds import length, ranged
from workbench.cli.verbs.parser import add_verb
from workbench.cli.verbs.shared import add_session
from workbench.files.export.cutting import PLAIN, RANGES, Cutting
from workbench.files.export.formats import ENDINGS
from workbench.files.export.mesh_unit import MESH_UNITS, MILLIMETRES

_ENTRANCE = ".entrance"

DOES = "write a lens for manufacture and for other programs"


def add(commands: Any) -> None:
    """Add the verb."""
    shared = [ending for ending in ENDINGS if not ending.startswith(_ENTRANCE)]
    endings = textwrap.fill(
        f"Endings: {', '.join(shared)}. {_ENTRANCE} before that of a face, of height or of G-code "
        "(a.entrance.xyz): the freeform entrance face.",
        79,
    )
    parser = add_verb(
        commands,
        "export",
        f"Write the lens of a session and its light; endings tell the formats.\n\n{endings}",
        [
            "export flame.freeform flame.step flame.irradiance.tiff",
            "export flame.freeform flame.stl flame.3mf --chord-error 1e-5",
            "export flame.freeform flame.nc --tool-radius 0.05 --scallop 1e-4",
        ],
        _run,
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
        help="lengths in .stl, .obj, .ply, .3mf: mm, cm, m, inch, scene [mm]",
    )
    for name, metavar, does in (
        ("tool-radius", "LENGTH", "ball cutter of G-code [the scene's, or one that fits]"),
        ("scallop", "LENGTH", "ridges between its cuts [1e-4 of the larger half-width]"),
        ("safe-height", "LENGTH", "how far above the cuts the cutter travels [its diameter]"),
    ):
        parser.add_argument(f"--{name}", metavar=metavar, type=length, help=does)
    parser.add_argument(
        "--rim", metavar="LENGTH", type=length, default=0.0, help="stock around it, to clamp it by"
    )
    for name, metavar, does in (
        ("feed", "MM/MIN", "speed of cuts"),
        ("plunge-feed", "MM/MIN", "speed into the stock"),
        ("spindle-speed", "RPM", "speed of the spindle"),
        ("dwell", "SECONDS", "wait for the spindle"),
    ):
        field = name.replace("-", "_")
        least, most, unit = allowed = RANGES[field]
        parser.add_argument(
            f"--{name}",
            metavar=metavar,
            type=ranged(*allowed),
            default=getattr(PLAIN, field),
            help=f"{does}, {least:g} to {most:g} {unit} [%(default)g]",
        )
    parser.add_argument("--negative", action="store_true", help="cut a mould of the face instead")


def _run(options: argparse.Namespace) -> None:
    from workbench.cli.export import export

    cutting = Cutting(
        options.tool_radius,
        options.scallop,
        options.rim,
        options.safe_height,
        options.feed,
        options.plunge_feed,
        options.spindle_speed,
        options.dwell,
        options.negative,
    )
    export(options.session, options.files, options.chord_error, cutting, options.mesh_unit)
