"""Commands and their arguments."""

import argparse
from collections.abc import Callable, Sequence
from typing import Any

from workbench import __version__
from workbench.cli.design_arguments import (
    add_benchmark,
    add_bound,
    add_design,
    add_robust,
    add_sweep,
)
from workbench.cli.inspect_arguments import add_inspect
from workbench.cli.lens_arguments import (
    add_export,
    add_manufacture,
    add_photograph,
    add_pictures,
    add_plan,
    add_report,
    add_tolerances,
    add_validate,
)
from workbench.cli.parser import Parser

VERBS: dict[str, tuple[str, Callable[[Any], None]]] = {
    "design": ("design a lens", add_design),
    "bound": ("compute the least error that any lens can reach", add_bound),
    "sweep": ("design many lenses: several scenes, fields that vary", add_sweep),
    "robust": ("design compromises for what is uncertain of a set-up", add_robust),
    "validate": ("check a lens by an independent trace", add_validate),
    "tolerances": ("find how small errors of a lens change its image", add_tolerances),
    "manufacture": ("compute thickness, slope and radii; compare with limits", add_manufacture),
    "plan": ("find the cheapest way to mill and polish a lens", add_plan),
    "photograph": ("compare a photograph of the light with the prediction", add_photograph),
    "inspect": ("compare measured parts with the design, and correct it", add_inspect),
    "export": ("write a lens for manufacture and for other programs", add_export),
    "pictures": ("draw a lens and its light", add_pictures),
    "report": ("write a report of a lens (HTML, PDF)", add_report),
    "benchmark": ("measure run time against error", add_benchmark),
}
_EXAMPLES = """\
examples:
  freeform design resources/examples/flame.json -o flame.freeform
  freeform validate flame.freeform
  freeform export flame.freeform flame.step

SCENE is a scene file (JSON) or a session (.freeform), SESSION a session with a designed lens.
freeform COMMAND --help describes each command.

Exit status: 0 done, 1 failed, 2 refused; 130 after Ctrl-C, 143 after SIGTERM,
129 when the terminal is closed."""


def parse(arguments: Sequence[str] | None) -> argparse.Namespace:
    """Parse a command line; raise Refused if that fails.

    ``command`` of the result is a function to be called with the result.
    """
    verbs = "\n".join(f"  {name:<13}{does}" for name, (does, _) in VERBS.items())
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
    for _, add in VERBS.values():
        add(commands)
    return parser.parse_args(arguments)
