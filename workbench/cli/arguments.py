"""What can be typed."""

import argparse
from collections.abc import Sequence

from workbench import __version__
from workbench.cli.verbs import (
    benchmark,
    bound,
    design,
    export,
    manufacture,
    pictures,
    report,
    sweep,
    tolerances,
    validate,
)
from workbench.cli.verbs.parser import Parser

VERBS = {
    "design": design,
    "bound": bound,
    "sweep": sweep,
    "validate": validate,
    "tolerances": tolerances,
    "manufacture": manufacture,
    "export": export,
    "pictures": pictures,
    "report": report,
    "benchmark": benchmark,
}
_EXAMPLES = """\
examples:
  freeform design resources/examples/flame.json -o flame.freeform
  freeform validate flame.freeform
  freeform export flame.freeform flame.step

SCENE is a scene file (JSON) or a session (.freeform), SESSION a session with a designed lens.
freeform COMMAND --help tells more of each.

Exit status: 0 done, 1 failed, 2 refused; 130 after Ctrl-C, 143 after SIGTERM,
129 when the terminal is closed."""


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
    verbs = "\n".join(f"  {name:<13}{verb.DOES}" for name, verb in VERBS.items())
    parser = Parser(
        prog="freeform",
        usage="freeform COMMAND ...",
        description=f"Design lenses that throw an image of light.\n\ncommands:\n{verbs}",
        epilog=_EXAMPLES,
    )
    parser.add_argument("--version", action="version", version=f"freeform {__version__}")
    commands = parser.add_subparsers(
        prog=parser.prog, metavar="COMMAND", required=True, help=argparse.SUPPRESS
    )
    for verb in VERBS.values():
        verb.add(commands)
    return parser.parse_args(arguments)
