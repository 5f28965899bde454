"""G-code of a finishing pass over a face, in millimetres, for GRBL and LinuxCNC.

Zero is the middle of the lens at the highest point of the face, which looks up. A face that looks
to -z is turned over about the y axis, and so is a mould. Programs are simulated as written: the
ball is swept over the rounded numbers, and the result is compared with the face.
"""

import math
from collections.abc import Iterator
from functools import partial
from typing import BinaryIO, NamedTuple

import numpy as np

from workbench.errors import Refused
from workbench.files.export.design import Design, Deviation
from workbench.files.export.options import Cutting
from workbench.geometry.ball_cutter import CutErrors, CutFace, Raster
from workbench.messages import Message
from workbench.powers import written
from workbench.progress import Steps, finished, within

# Allowed excess and gouge over the scallop height: a cutter that fits has less.
_EXCESS, _GOUGE = 2.0, 0.25
_FINE = 1e-4  # scallop height over the larger half-width
_DIGITS = 5  # decimals; GRBL reads seven digits
_MOST = 1_000_000  # moves of a program
_LEAST_SCALLOP = 1e-4  # mm, unless requested: programs round to 1e-5 mm
_TRIES, _SMALLER = 8, 0.6  # radii tried for a default cutter, and their ratio
_PLANNED = 0.8  # part of the time for planning


class CutPlan(NamedTuple):
    """Cuts of a face as written, and the errors that they leave."""

    cutting: Cutting  # requested options
    raster: Raster  # the cuts, scene units
    scallop: float  # planned scallop height
    errors: CutErrors  # errors of the simulated cut, at a place in the scene's x and y
    top: float  # highest control height of the face as it lies below the cutter
    # Radius of a ball that fits everywhere, scene units; infinite if unknown, as for a face with
    # edges.
    default_radius: float

    def refusal(self, unit: str) -> Refused | None:
        """Return why the plan is not written: the cutter leaves more than scallops; else None."""
        cut_off, left, (x, y) = self.errors
        if cut_off <= _GOUGE * self.scallop and left <= _EXCESS * self.scallop:
            return None
        return Refused(
            "tool_radius",
            Message(
                "a ball cutter of {radius} does not fit: it leaves {left} at x = {x}, y = {y} and "
                "cuts off {cut}; {cure}",
                radius=written(self.raster.radius, unit),
                left=written(left, unit, 2),
                x=written(x, unit),
                y=written(y, unit),
                cut=written(max(cut_off, 0), unit, 2),
                cure=self._cure(unit),
            ),
        )

    def _cure(self, unit: str) -> Message:
        if self.default_radius < self.raster.radius:
            return Message("one of {fitting} fits", fitting=written(self.default_radius, unit, 2))
        return Message("a smaller one or higher ridges are needed")


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
    begin = 0.0 if design.plan else _PLANNED
    lines = "".join(f"{line}\n" for line in _header(design, plan))
    file.write(lines.encode("ascii"))
    rows = len(plan.raster.y)
    for row in range(rows):
        lines = "".join(f"{line}\n" for line in _cuts(design, plan, row))
        file.write(lines.encode("ascii"))
        yield begin + (1 - begin) * (row + 1) / rows
    file.write("".join(f"{line}\n" for line in _footer(design, plan)).encode("ascii"))
    radius, (cut_off, left, _) = plan.raster.radius, plan.errors
    return Deviation(
        "simulated cut off by",
        max(left, cut_off),
        design.unit,
        f"cutter radius {written(radius, design.unit)}, ridges up to "
        f"{written(left, design.unit, 2)}, cut into the face up to "
        f"{written(max(cut_off, 0), design.unit, 2)}; a finishing pass in mm, zero at the top of "
        f"the face, spindle {plan.cutting.spindle_speed:g} rpm",
    )


def planning(design: Design) -> Steps[CutPlan]:
    """Plan and simulate the cuts of a design's face, in short steps.

    A default cutter that does not fit is replaced by smaller ones. Raise Refused if there are too
    many cuts.
    """
    heights = design.heights if _looks_up(design) > 0 else -design.heights[::-1]
    face = CutFace(design.net, heights, design.outline)
    asked = design.cutting.tool_radius or design.scene.run.min_tool_radius
    radius, begin, plan = asked or face.default_radius, 0.0, None
    for _ in range(1 if asked else _TRIES):
        plan = yield from within(_planning(design, face, radius), partial(_from, begin))
        if plan.refusal(design.unit) is None:
            break
        radius, begin = _SMALLER * radius, _from(begin, 0.5)
    assert plan is not None
    return plan


def _planning(design: Design, face: CutFace, radius: float) -> Steps[CutPlan]:
    mm, top = 1e3 * design.metres, float(face.heights.max())
    fine = max(_FINE * max(design.net.half_width), _LEAST_SCALLOP / mm)
    scallop = design.cutting.scallop or face.finest_scallop(radius, min(fine, radius / 2), _MOST)
    raster = yield from within(face.plan_raster(radius, scallop, _MOST), lambda done: 0.8 * done)
    raster = _rounded(raster, mm, top)
    errors = yield from within(face.cut_errors(raster), lambda done: 0.8 + 0.2 * done)
    if _looks_up(design) < 0:  # the face lies turned over about y
        errors = errors._replace(place=(-errors.place[0], errors.place[1]))
    fitting = face.default_radius if min(design.net.degree) > 1 else math.inf
    return CutPlan(design.cutting, raster, scallop, errors, top, fitting)


def _looks_up(design: Design) -> int:
    return -design.outward if design.cutting.negative else design.outward


def _from(begin: float, done: float) -> float:
    return begin + (1 - begin) * done


def _rounded(raster: Raster, millimetres: float, top: float) -> Raster:
    step = 10.0**-_DIGITS / millimetres
    x, y = np.round(raster.x / step) * step, np.round(raster.y / step) * step
    return Raster(x, y, top + np.ceil((raster.tip - top) / step) * step, raster.radius)


def _heights(design: Design, plan: CutPlan) -> tuple[float, float]:
    raster, mm = plan.raster, 1e3 * design.metres
    clear = plan.cutting.safe_height or 2 * raster.radius
    highest = float(raster.tip.max()) - plan.top
    return mm * (highest + clear), mm * highest


def _header(design: Design, plan: CutPlan) -> Iterator[str]:
    cutting, raster, mm = plan.cutting, plan.raster, 1e3 * design.metres
    width, height = (2 * mm * (r + cutting.rim) for r in design.net.half_width)
    deep = mm * (plan.top - float(raster.tip.min()))
    safe, highest = _heights(design, plan)
    yield f"(freeform {'mould' if cutting.negative else 'face'}: finishing pass)"
    yield "(units: mm, mm/min, rpm, s)"
    yield f"(ball cutter: radius {mm * raster.radius:.4f})"
    yield f"(ridges between cuts: {mm * plan.scallop:.5f} high)"
    yield f"(spindle speed: {cutting.spindle_speed:g} clockwise)"
    yield f"(dwell until the spindle is at speed: {cutting.dwell:g})"
    yield f"(feed: {cutting.feed:g}, plunge feed: {cutting.plunge_feed:g})"
    yield f"(safe height: Z{safe:.4f}, {safe - highest:.4f} over the highest cut)"
    yield f"(stock {width:.3f} x {height:.3f}, cut {deep:.3f} deep)"
    yield f"(clamping rim {mm * cutting.rim:.3f} wide: keep holders off the cuts)"
    x_end, y_end = (mm * float(each[-1]) for each in (raster.x, raster.y))
    yield f"(middle of the ball goes to X +-{x_end:.3f}, Y +-{y_end:.3f})"
    yield "(zero: middle of the lens, highest control point of the face)"
    yield "G21 G90 G17 G94"
    yield f"G0 Z{safe:.4f}"
    yield f"M3 S{cutting.spindle_speed:g}"
    yield f"G4 P{cutting.dwell:g}"
    x, y, z = (mm * float(each) for each in (raster.x[0], raster.y[0], raster.tip[0, 0] - plan.top))
    yield f"G0 X{x:.5f} Y{y:.5f}"
    yield f"G1 Z{z:.5f} F{cutting.plunge_feed:g}"


def _cuts(design: Design, plan: CutPlan, row: int) -> Iterator[str]:
    mm, turn = 1e3 * design.metres, 1 if row % 2 == 0 else -1
    x = (mm * plan.raster.x)[::turn].tolist()
    z = (mm * (plan.raster.tip[:, row] - plan.top))[::turn].tolist()
    y = mm * float(plan.raster.y[row])
    feed = f" F{plan.cutting.feed:g}" if row == 0 else ""
    for at, deep in zip(x, z, strict=True):
        yield f"G1 X{at:.5f} Y{y:.5f} Z{deep:.5f}{feed}"
        feed = ""


def _footer(design: Design, plan: CutPlan) -> Iterator[str]:
    yield f"G0 Z{_heights(design, plan)[0]:.4f}"
    yield "M5"
    yield "M30"
