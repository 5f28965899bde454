"""``freeform bound``: its arguments."""

import argparse
from typing import Any

from workbench.cli.verbs.parser import add_verb
from workbench.cli.verbs.shared import add_json

DOES = "tell the least error that any lens can reach"


def add(commands: Any) -> None:
    """Add the verb."""
    parser = add_verb(
        commands,
        "bound",
        "Tell the least relative L2 error that any lens of a scene can reach, as its source has a "
        "size that blurs the image, and how much of the light can be used. Nothing is designed.",
        ["bound sun.json", "bound flame.freeform --json"],
        _run,
    )
    parser.add_input("scene", role="the scene", metavar="SCENE", help="scene file, or session")
    add_json(parser)


def _run(options: argparse.Namespace) -> None:
    from workbench.cli.bound import bound

    bound(options.scene, options.json)
