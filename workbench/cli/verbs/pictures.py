"""``freeform pictures``: its arguments."""

import argparse
from pathlib import Path
from typing import Any

from workbench.cli.verbs.parser import add_verb
from workbench.cli.verbs.shared import add_session

DOES = "draw a lens and its light"


def add(commands: Any) -> None:
    """Add the verb."""
    parser = add_verb(
        commands,
        "pictures",
        "Draw the lens of a session with its rays, its light and its loss as PNG.",
        ["pictures flame.freeform pictures/"],
        _run,
    )
    add_session(parser)
    parser.add_output("folder", files=_files, metavar="FOLDER", help="where the pictures go")


def _files(folder: Path) -> list[Path]:
    from workbench.pictures import PICTURES

    return [folder / name for name in PICTURES]


def _run(options: argparse.Namespace) -> None:
    from workbench.cli.pictures import pictures

    pictures(options.session, options.folder)
