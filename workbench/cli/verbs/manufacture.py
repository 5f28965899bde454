"""``freeform manufacture``: its arguments."""

import argparse
from typing import Any

from workbench.cli.verbs.kinds import length
from workbench.cli.verbs.parser import add_verb
from workbench.cli.verbs.shared import add_json, add_plot, add_session

DOES = "tell thickness, slope and radii, and judge them by limits"


def add(commands: Any) -> None:
    """Add the verb."""
    parser = add_verb(
        commands,
        "manufacture",
        "Tell what a shop asks of the lens of a session: thickness, slope, radii of curvature, the "
        "ball cutter that fits, sag and draft. Lengths are in the scene's unit. Ends with status 1 "
        "if a limit is not met.",
        [
            "manufacture flame.freeform",
            "manufacture flame.freeform --min-radius 0.05 --max-slope 25 --plot maps.png",
        ],
        _run,
    )
    add_session(parser)
    for name, metavar, does in (
        ("min-thickness", "LENGTH", "the lens has to be as thick everywhere [the scene's]"),
        ("max-thickness", "LENGTH", "and not thicker than this"),
        ("max-slope", "DEGREES", "largest angle between exit face and entrance face"),
        ("min-radius", "LENGTH", "smallest radius of curvature, concave and convex"),
        ("min-tool-radius", "LENGTH", "radius of the ball cutter that has to fit [the scene's]"),
    ):
        parser.add_argument(f"--{name}", metavar=metavar, type=length, help=does)
    add_plot(parser, "draw maps; what is beyond limits is hatched")
    add_json(parser)


def _run(options: argparse.Namespace) -> None:
    from workbench.analysis.manufacture_limits import Limits
    from workbench.cli.manufacture import manufacture

    limits = Limits(
        options.min_thickness,
        options.max_thickness,
        options.max_slope,
        options.min_radius,
        options.min_tool_radius,
    )
    manufacture(options.session, limits, options.plot, options.json)
