"""G-code of roughing and finishing passes over a face, in millimetres.

Programs are simulated as written: the ball is swept over the rounded numbers, and the result is
compared with the face; see `workbench.files.export.cut_plan`.
"""

from collections.abc import Callable, Iterator
from itertools import islice
from typing import BinaryIO, NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.cutters import cutter_name
from workbench.files.export.cut_plan import CutPlan, check_cutting, looks_up, planning
from workbench.files.export.design import Design, Deviation
from workbench.files.export.dialects import DIALECTS
from workbench.files.export.options import ORIGINS
from workbench.powers import written
from workbench.progress import Steps, finished, within

__all__ = ["check_cutting", "write_gcode", "writing"]
_PLANNED = 0.8  # part of the time for planning
_AT_ONCE = 2000  # lines
_CLEAR = 2.0  # mm, least height of travel by default
_MOST_NUMBER = 99_990  # N words begin again after it


class Pass(NamedTuple):
    """Cuts by one cutter: polylines of its tip (n, 3), scene units, each begun from above."""

    name: str
    tool: int
    path_mode: str
    safe_height: float  # of travel, scene units
    cuts: Callable[[], Iterator[Array]]


def write_gcode(design: Design, file: BinaryIO) -> Deviation:
    """Write the cuts; raise Refused if the cutter does not fit or there are too many cuts."""
    return finished(writing(design, file), design.progress)


def writing(design: Design, file: BinaryIO) -> Steps[Deviation]:
    """Plan and simulate the cuts, unless the design has a plan, and write them, in short steps."""
    plan = design.plan
    if plan is None:
        plan = yield from within(planning(design), lambda done: _PLANNED * done)
    refusal = plan.refusal(design.unit)
    if refusal is not None:
        raise refusal
    begin, size = 0.0 if design.plan else _PLANNED, plan.raster.tip.size
    lines = _numbered(_program(design, plan), DIALECTS[plan.cutting.dialect].numbers)
    count = 0
    while some := list(islice(lines, _AT_ONCE)):
        file.write("".join(f"{line}\n" for line in some).encode("ascii"))
        count += len(some)
        yield begin + (1 - begin) * min(count / size, 1.0)
    radius, (cut_off, left, _) = plan.raster.radius, plan.errors
    return Deviation(
        "simulated cut off by",
        max(left, cut_off),
        design.unit,
        f"cutter radius {written(radius, design.unit)}, ridges up to "
        f"{written(left, design.unit, 2)}, cut into the face up to "
        f"{written(max(cut_off, 0), design.unit, 2)}; "
        f"{'a finishing pass' if plan.rough is None else 'roughing and finishing'} in mm for "
        f"{DIALECTS[plan.cutting.dialect].name}, zero: {ORIGINS[plan.cutting.origin]}, spindle "
        f"{plan.cutting.spindle_speed:g} rpm",
    )


def _program(design: Design, plan: CutPlan) -> Iterator[str]:
    """Lines of the program, without numbers."""
    dialect, cutting = DIALECTS[plan.cutting.dialect], plan.cutting
    yield from dialect.begin.format(program=cutting.program).splitlines()
    for comment in _comments(design, plan):
        yield f"({comment.upper() if dialect.capitals else comment})"
    yield dialect.modes
    tool = 0
    for each in passes(design, plan):
        change = dialect.next_tool if tool else dialect.first_tool
        yield f"({each.name.upper() if dialect.capitals else each.name})"
        if each.tool != tool and change:
            yield from change.format(tool=each.tool).splitlines()
        lengths = dialect.lengths.format(tool=each.tool) if each.tool != tool else ""
        tool = each.tool
        yield from _pass(design, plan, each, lengths)
    yield from dialect.end.splitlines()


def _pass(design: Design, plan: CutPlan, each: Pass, lengths: str) -> Iterator[str]:
    dialect, cutting = DIALECTS[plan.cutting.dialect], plan.cutting
    mm, places = 1e3 * design.metres, f".{dialect.decimals}f"
    safe = f"G0 Z{mm * (each.safe_height - plan.zero[2]):{places}}"
    yield each.path_mode
    yield f"{lengths} {safe}".strip()
    yield f"M3 S{cutting.spindle_speed:g}"
    yield dialect.dwell.format(seconds=cutting.dwell)
    if cutting.coolant:
        yield "M8"
    for cut in each.cuts():
        # Numbers are multiples of the least increment up to rounding.
        numbers = (mm * (cut - plan.zero)).tolist()
        (x, y, z), *rest = numbers
        yield f"G0 X{x:{places}} Y{y:{places}}"
        yield f"G1 Z{z:{places}} F{cutting.plunge_feed:g}"
        feed = f" F{cutting.feed:g}"
        for x, y, z in rest:
            yield f"G1 X{x:{places}} Y{y:{places}} Z{z:{places}}{feed}"
            feed = ""
        yield safe
    if cutting.coolant:
        yield "M9"
    yield "M5"


def passes(design: Design, plan: CutPlan) -> Iterator[Pass]:
    """Passes of a program, in their order."""
    dialect, raster, rough = DIALECTS[plan.cutting.dialect], plan.raster, plan.rough
    clear = plan.cutting.safe_height or max(2 * raster.radius, _CLEAR / (1e3 * design.metres))
    safe = max(float(raster.tip.max()), plan.stock.top) + clear
    tool = 1
    if rough is not None:
        cutter = rough.roughing.cutter
        # The control may leave the path by half of what roughing leaves.
        tolerance = f"{1e3 * design.metres * rough.allowance / 2:.4f}"
        mode = dialect.blended.format(tolerance=tolerance)
        top, down = plan.stock.top, rough.step_down
        yield Pass("roughing", tool, mode, safe, lambda: rough.roughing.lines(top, down))
        if not cutter.ball or cutter.radius != raster.radius:
            tool += 1
    yield Pass("finishing", tool, dialect.exact, safe, lambda: _finishing(plan))


def _finishing(plan: CutPlan) -> Iterator[Array]:
    """One cut to and fro."""
    raster = plan.raster
    x, y = np.meshgrid(raster.x, raster.y)
    places = np.stack([x, y, raster.tip.T], axis=-1)
    places[1::2] = places[1::2, ::-1]
    yield places.reshape(-1, 3)


def _comments(design: Design, plan: CutPlan) -> Iterator[str]:
    cutting, raster, mm = plan.cutting, plan.raster, 1e3 * design.metres
    width, height = (2 * mm * r for r in plan.stock.half_width)
    thick = mm * (plan.stock.top - plan.stock.bottom)
    deep = mm * (plan.stock.top - float(raster.tip.min()))
    safe = mm * (next(passes(design, plan)).safe_height - plan.zero[2])
    yield f"freeform {'mould' if cutting.negative else 'face'} of {_plain(design.optic.name)}"
    if looks_up(design) != 1:
        yield "the part lies turned over about the y axis"
    yield "units: mm, mm/min, rpm, s"
    if plan.rough is not None:
        rough, kind = plan.rough, plan.rough.roughing.cutter
        least, most = (mm * left for left in rough.left)
        end = "ball" if kind.ball else "flat"
        yield f"roughing by a {end} cutter: radius {mm * kind.radius:.4f}"
        yield f"levels {mm * rough.step_down:.4f} apart, allowance {mm * rough.allowance:.4f}"
        yield f"roughing leaves {least:.3f} to {most:.3f} along Z; its cutter plunges"
    name = cutter_name(mm * raster.radius, "mm")
    yield f"{f'{name} ' if name else ''}ball cutter: radius {mm * raster.radius:.4f}"
    yield f"ridges between cuts: {mm * plan.scallop:.5f} high"
    yield f"spindle speed: {cutting.spindle_speed:g} clockwise"
    yield f"dwell until the spindle is at speed: {cutting.dwell:g}"
    yield f"feed: {cutting.feed:g}, plunge feed: {cutting.plunge_feed:g}"
    yield f"safe height: Z{safe:.4f}"
    yield f"stock {width:.3f} x {height:.3f} x {thick:.3f}, cut {deep:.3f} deep"
    yield f"stock above the face: {mm * cutting.stock_above:.3f}"
    yield f"clamping rim {mm * cutting.rim:.3f} wide: keep holders off the cuts"
    ends = (mm * (float(each[0]) - zero) for each, zero in _with_zero(plan))
    others = (mm * (float(each[-1]) - zero) for each, zero in _with_zero(plan))
    (x_0, y_0), (x_1, y_1) = ends, others
    yield f"middle of the ball goes from X{x_0:.3f} Y{y_0:.3f} to X{x_1:.3f} Y{y_1:.3f}"
    yield f"zero: {ORIGINS[cutting.origin]}"


def _with_zero(plan: CutPlan) -> Iterator[tuple[Array, float]]:
    yield from zip((plan.raster.x, plan.raster.y), plan.zero[:2], strict=True)


def _plain(name: str) -> str:
    """A name in the signs that all controls read."""
    return "".join(c if c.isascii() and c.isalnum() else "-" for c in name)


def _numbered(lines: Iterator[str], step: int) -> Iterator[str]:
    """Put N words before blocks; comments, program numbers and the ends of the tape have none."""
    number = 0
    for line in lines:
        if step and line[0] not in "(%O":
            number = number % _MOST_NUMBER + step
            line = f"N{number} {line}"
        yield line
