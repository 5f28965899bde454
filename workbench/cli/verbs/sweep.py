"""``freeform sweep``: its arguments."""

import argparse
from pathlib import Path
from typing import Any

from workbench.cli.verbs.kinds import count, rays
from workbench.cli.verbs.parser import add_verb
from workbench.cli.verbs.shared import add_json

DOES = "design many lenses: several scenes, fields that vary"


def add(commands: Any) -> None:
    """Add the verb."""
    parser = add_verb(
        commands,
        "sweep",
        "Design a lens for each scene and each combination of values, check each, and write all "
        "sessions and a table (CSV and JSON). What is finished is not done again when the same "
        "command is typed once more. Ctrl-C keeps what is finished.\n\n"
        "values:\n"
        "  1,2.5,3      numbers\n"
        "  0..4         whole numbers, both ends included\n"
        "  64x48,128    pairs; 128 alone is 128x128\n"
        "  auto,paper   text",
        [
            "sweep flame.json --vary lens.back.control_points=64,128 --vary run.seed=0..4",
            "sweep flame.json ball.json -o both/ --jobs 2",
            "sweep flame.json --vary source.position[2]=-5,-8 --dask tcp://host:8786",
        ],
        _run,
    )
    parser.add_input(
        "scenes",
        role="a scene of the sweep",
        metavar="SCENE",
        nargs="+",
        help="scene file, or session; designed anew",
    )
    parser.add_argument(
        "--vary",
        metavar="FIELD=VALUES",
        action="append",
        default=[],
        help="values of a field of the scene, by its path: run.seed, or of an element by its name, "
        "lens.thickness, and of its front or back face, lens.back.degree; may be given several "
        "times",
    )
    parser.add_output(
        "-o",
        dest="output",
        files=_files,
        metavar="FOLDER",
        default=Path("sweep"),
        help="where sessions and table go; default %(default)s",
    )
    parser.add_argument(
        "--jobs", metavar="N", type=count, help="lenses at the same time; default one for each core"
    )
    parser.add_argument(
        "--dask", metavar="ADDRESS", help="work on a dask.distributed cluster instead"
    )
    parser.add_argument(
        "--validate-rays",
        metavar="N",
        type=rays,
        default=4_000_000,
        help="of the check of each lens, at least; default %(default)s",
    )
    add_json(parser)


def _files(folder: Path) -> list[Path]:
    from workbench.sweep.sweep import TABLES

    return [folder / name for name in TABLES]


def _run(options: argparse.Namespace) -> None:
    from workbench.cli.sweep import sweep

    sweep(
        options.scenes,
        options.vary,
        options.output,
        options.jobs,
        options.dask,
        options.validate_rays,
        options.json,
    )
