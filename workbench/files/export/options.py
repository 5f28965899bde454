"""Options of exports, and the unit of meshes.

The command line imports this module for each command, so it imports nothing slow.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple

from workbench.cutters import CUTTERS
from workbench.errors import Refused, shown
from workbench.files.export.dialects import DIALECTS
from workbench.messages import Message
from workbench.option_groups import FEED, LENGTH, OptionGroup, option
from workbench.units import METRES

if TYPE_CHECKING:
    from workbench.files.export.cut_plan import CutPlan

MILLIMETRES, SCENE_UNIT = "mm", "scene"
"""The unit that programs assume for a mesh without a unit, and the name for the scene's unit."""
MESH_UNITS = (*METRES, SCENE_UNIT)
"""Names of units of a mesh."""
SPINDLE, SECONDS = "rpm", "s"
"""Further units of options of machines."""
ORIGINS = {
    "top": "middle, top of the stock",
    "corner": "corner of least x and y, top of the stock",
    "bottom": "middle, bottom of the stock",
}
"""Places of the zero of a program, and what each is called."""
ROUGHING = {"none": "none", "flat": "flat cutter", "ball": "ball cutter"}
"""Kinds of roughing, and what each is called."""


def _length(title: str, tip: str, default: Any = None, **more: Any) -> Any:
    return option(title, tip, default, **{"unit": LENGTH, "above": default is None, **more})


def _choice(title: str, tip: str, choices: Mapping[str, str], default: Any, **more: Any) -> Any:
    return option(title, tip, default, kind=str, choices=choices, **more)


_WITH_ROUGHING = "roughing", ("flat", "ball")
_NAMES = {name: name for name in CUTTERS}


@dataclass(frozen=True)
class Cutting(OptionGroup):
    """Options of G-code; lengths in scene units.

    Raise Refused if a value is out of range, or scallops are as high as the ball's radius.
    """

    called: ClassVar[str] = "G-code"

    dialect: str = _choice(
        "Control",
        "Control that reads the program: its preamble, path modes, dwell, decimals and end.",
        {name: each.name for name, each in DIALECTS.items()},
        "grbl",
    )
    cutter: str | None = _choice(
        "Ball cutter",
        "Standard ball cutter by its diameter. Empty: the cutter of the processes or limits of the "
        "design, else the largest standard cutter that fits everywhere.",
        _NAMES,
        None,
        empty="automatic",
    )
    tool_radius: float | None = _length(
        "Tool radius",
        "Radius of another ball cutter than a standard one.",
        empty="standard",
    )
    scallop: float | None = _length(
        "Scallop height",
        "Largest height of material between neighbouring passes. Empty: that of the step-over "
        "among the processes of the design, else 1e-4 of the larger half-width, or more where that "
        "needs too many moves.",
        empty="automatic",
    )
    rim: float = _length("Fixture rim", "Width of stock around the part for clamping.", 0.0)
    stock_above: float = _length(
        "Stock above", "Height of stock above the highest point of the face.", 0.0
    )
    stock: float | None = _length(
        "Stock thickness",
        "Whole height of the stock. Empty: as much as part and cuts need.",
        empty="automatic",
    )
    origin: str = _choice(
        "Program zero",
        "Place of the stock where the program's coordinates are zero.",
        ORIGINS,
        "top",
    )
    roughing: str = _choice(
        "Roughing", "Passes at levels of z that clear the stock above the face.", ROUGHING, "none"
    )
    roughing_cutter: str | None = _choice(
        "Roughing cutter",
        "Standard cutter of the roughing passes by its diameter. Empty: the largest one that is "
        "at most a quarter as wide as the part.",
        _NAMES,
        None,
        empty="automatic",
        needs=_WITH_ROUGHING,
    )
    step_down: float | None = _length(
        "Step down",
        "Distance of two levels of roughing. Empty: half of the cutter's radius.",
        empty="automatic",
        needs=_WITH_ROUGHING,
    )
    allowance: float | None = _length(
        "Allowance",
        "Material that roughing leaves everywhere for finishing. Empty: a tenth of the cutter's "
        "radius.",
        empty="automatic",
        needs=_WITH_ROUGHING,
    )
    safe_height: float | None = _length(
        "Travel height",
        "Height of rapid moves above the stock and above the highest cut. Empty: 2 mm, or the "
        "ball's diameter if that is more.",
        empty="automatic",
    )
    feed: float = option(
        "Feed", "Feed rate while cutting.", 600.0, unit=FEED, least=1, most=100_000
    )
    plunge_feed: float = option(
        "Plunge feed",
        "Feed rate while plunging into the stock.",
        150.0,
        unit=FEED,
        least=1,
        most=100_000,
    )
    spindle_speed: float = option(
        "Spindle speed",
        "Revolutions per minute, clockwise.",
        10_000.0,
        unit=SPINDLE,
        least=1,
        most=200_000,
    )
    dwell: float = option(
        "Dwell",
        "Wait above the stock until the spindle has reached its speed.",
        3.0,
        unit=SECONDS,
        most=600,
    )
    coolant: bool = option("Coolant", "Switch flood coolant on and off.", False, kind=bool)
    program: int = option(
        "Program number",
        "Number of the program, where the control has numbers.",
        1,
        kind=int,
        least=1,
        most=9999,
        needs=("dialect", ("fanuc",)),
    )
    negative: bool = option(
        "Cut a mould of the face",
        "Cut the negative of the face, turned over about the y axis.",
        False,
        kind=bool,
    )

    def __post_init__(self) -> None:
        super().__post_init__()
        radius, ridge = self.tool_radius, self.scallop
        if radius is not None and self.cutter is not None:
            raise Refused(
                "tool_radius",
                Message("a standard cutter is chosen as well; give one of them"),
            )
        if radius is not None and ridge is not None and ridge >= radius:
            raise Refused(
                "scallop",
                Message(
                    "{ridge:g}; less than the cutter's radius {radius:g} is needed",
                    ridge=ridge,
                    radius=radius,
                ),
            )


PLAIN = Cutting()
"""Default options of G-code."""


@dataclass(frozen=True)
class Turning(OptionGroup):
    """Options of a table for diamond turning with a slow tool servo; lengths in scene units."""

    called: ClassVar[str] = "slow tool servo"

    nose_radius: float | None = _length(
        "Nose radius",
        "Radius of the diamond's round nose. Empty: 0.5 mm, or less where that does not fit.",
        empty="automatic",
    )
    feed_per_turn: float | None = _length(
        "Feed per turn",
        "How far the tool moves to the axis during a turn. Empty: for cusps of 1e-5 of the larger "
        "half-width.",
        empty="automatic",
    )
    points_per_turn: int | None = option(
        "Points per turn",
        "Points of the table for each turn. Empty: as many as keep the error between them below "
        "the chord error.",
        kind=int,
        least=16,
        most=100_000,
        empty="automatic",
    )


@dataclass(frozen=True)
class Drawing(OptionGroup):
    """Options of drawings and of the table of inspection points; lengths in scene units."""

    called: ClassVar[str] = "drawing"

    form_tolerance: float | None = _length(
        "Form tolerance",
        "Width of the zone that holds the freeform face. Empty: the drawing states none.",
        empty="none",
    )
    inspection_points: int = option(
        "Inspection points",
        "Points of the face along each axis whose coordinates are listed.",
        5,
        kind=int,
        least=2,
        most=20,
    )


@dataclass(frozen=True)
class Tile(OptionGroup):
    """A square of a face on a flat back, as a test piece; lengths in scene units."""

    called: ClassVar[str] = "test tile"

    tile_side: float | None = _length(
        "Tile side",
        "Write only a square of the face on a flat back, this wide, as a test piece. Empty: the "
        "whole part.",
        empty="whole part",
    )
    tile_x: float = _length("Tile x", "Middle of the tile along x.", 0.0, least=-math.inf)
    tile_y: float = _length("Tile y", "Middle of the tile along y.", 0.0, least=-math.inf)


GROUPS: tuple[type[OptionGroup], ...] = (Cutting, Turning, Drawing, Tile)
"""All groups of options."""


class Chosen(NamedTuple):
    """Chosen options of a format, and the plan of its cuts, which has its own."""

    options: tuple[OptionGroup, ...] = ()
    plan: "CutPlan | None" = None


def mesh_unit_of(asked: str, scene_unit: str) -> str:
    """Return the unit of length for a requested name; raise Refused if it is unknown."""
    if asked not in MESH_UNITS:
        known = ", ".join(MESH_UNITS)
        raise Refused(
            "mesh_unit", Message("{unit}; one of {known}", unit=shown(asked), known=known)
        )
    return scene_unit if asked == SCENE_UNIT else asked
