"""Plan of the cuts of a face, simulated as written: numbers are rounded before.

The face looks up. A face that looks to -z is turned over about the y axis, and so is a mould.
"""

import math
from collections.abc import Iterator
from functools import partial
from typing import NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.cutters import cutter_radii, cutter_radius
from workbench.errors import Refused
from workbench.files.export.design import Design
from workbench.files.export.dialects import DIALECTS
from workbench.files.export.options import Cutting
from workbench.geometry.ball_cutter import CutErrors, CutFace, Raster
from workbench.geometry.face_grids import element_sides
from workbench.geometry.roughing import Cutter, Roughing, plan_roughing
from workbench.messages import Message
from workbench.powers import written
from workbench.progress import Steps, within

# Allowed excess and gouge over the scallop height: a cutter that fits has less.
_EXCESS, _GOUGE = 2.0, 0.25
_DEEPEST = 1e-3  # mm, allowed gouge whatever the scallop height
_FINE = 1e-4  # scallop height over the larger half-width
_USUAL, _MOST = 1_000_000, 4_000_000  # moves of a pass: unless more are asked for, and at most
_LEAST_SCALLOP = 1e-4  # mm, unless requested
_TRIES, _SMALLER = 8, 0.6  # radii tried where no standard cutter fits, and their ratio
_WIDE = 0.25  # default roughing cutter over the width of the part
_ALLOWANCE, _STEP_DOWN = 0.1, 0.5  # by default, over the radius of the roughing cutter
_SAMPLES = 20_000  # points where roughing and face are compared
_SIDES = 65  # points along each axis of the part, for its thickness


class Stock(NamedTuple):
    """The stock as it lies below the cutter, scene units."""

    half_width: tuple[float, float]
    top: float
    bottom: float

    def zero(self, origin: str, step: float) -> tuple[float, float, float]:
        """Return x, y, z of the program's zero; x and y are multiples of ``step``."""
        x, y = self.half_width if origin == "corner" else (0.0, 0.0)
        z = self.bottom if origin == "bottom" else self.top
        return -step * round(x / step), -step * round(y / step), z


class RoughPlan(NamedTuple):
    """Roughing as written, and the least and the most material that it leaves along z."""

    roughing: Roughing
    step_down: float
    allowance: float
    left: tuple[float, float]


class CutPlan(NamedTuple):
    """Cuts of a face as written, and the errors that they leave."""

    cutting: Cutting  # requested options
    raster: Raster  # the cuts, scene units
    scallop: float  # planned scallop height
    errors: CutErrors  # errors of the simulated cut, at a place in the scene's x and y
    stock: Stock
    zero: tuple[float, float, float]  # of the program, scene units
    rough: RoughPlan | None
    # Radius of a ball that fits everywhere, scene units; infinite if unknown, as for a face with
    # edges.
    default_radius: float
    deepest: float  # allowed gouge

    def refusal(self, unit: str) -> Refused | None:
        """Return why the plan is not written: the cutter leaves more than scallops; else None."""
        cut_off, left, (x, y) = self.errors
        allowed = min(_GOUGE * self.scallop, self.deepest)
        if cut_off <= allowed and left <= _EXCESS * self.scallop:
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


def check_cutting(design: Design) -> None:
    """Refuse cutters that are larger than the part, and a stock that does not hold it."""
    cutting, unit = design.cutting, design.unit
    half = min(design.net.half_width)
    for name, radius in (
        ("tool_radius", _asked_radius(design)),
        ("roughing_cutter", _roughing_radius(design)),
    ):
        if radius is not None and radius > half:
            raise Refused(
                name,
                Message(
                    "a cutter of {radius} is wider than the part; at most {half}",
                    radius=written(radius, unit),
                    half=written(half, unit),
                ),
            )
    needed = _needed(design)
    if cutting.stock is not None and cutting.stock < needed * (1 - 1e-9):
        raise Refused(
            "stock",
            Message(
                "{stock} is too thin for the part; at least {needed}",
                stock=written(cutting.stock, unit),
                needed=written(needed, unit),
            ),
        )


def _needed(design: Design) -> float:
    """Least thickness of the stock: of a mould the depth of its cavity, else that of the part."""
    if design.cutting.negative:
        return design.cutting.stock_above + float(np.ptp(design.heights))
    line = np.linspace(-1, 1, _SIDES)
    sides = element_sides(design.optic, line, line, design.result.state.heights)
    depth = np.concatenate([design.optic.seen(side)[..., 2].ravel() for side in sides])
    return design.cutting.stock_above + float(np.ptp(depth))


def _asked_radius(design: Design) -> float | None:
    cutting = design.cutting
    if cutting.cutter is not None:
        return cutter_radius(cutting.cutter, design.unit)
    if cutting.tool_radius is not None:
        return cutting.tool_radius
    planned = next(iter(design.scene.ball_cuts), None)
    return design.scene.run.min_tool_radius if planned is None else planned.radius


def _roughing_radius(design: Design) -> float | None:
    cutting = design.cutting
    if cutting.roughing == "none":
        return None
    if cutting.roughing_cutter is not None:
        return cutter_radius(cutting.roughing_cutter, design.unit)
    widest = _WIDE * min(design.net.half_width)
    return next(iter(cutter_radii(design.unit, widest)), widest)


def planning(design: Design) -> Steps[CutPlan]:
    """Plan and simulate the cuts of a design's face, in short steps.

    A default cutter that does not fit is replaced by smaller ones. Raise Refused if there are too
    many cuts, or the stock or a cutter is impossible.
    """
    check_cutting(design)
    face = CutFace.lying(design.net, design.heights, design.outline, looks_up(design))
    asked = _asked_radius(design)
    radii = [asked] if asked else list(_defaults(design, face.default_radius))
    begin, plan = 0.0, None
    for radius in radii:
        plan = yield from within(_planning(design, face, radius), partial(_from, begin))
        if plan.refusal(design.unit) is None:
            break
        begin = _from(begin, 0.5)
    assert plan is not None
    return plan


def _defaults(design: Design, fitting: float) -> Iterator[float]:
    """Radii of standard cutters that fit, the largest first, or of special ones."""
    yield from cutter_radii(design.unit, fitting)
    yield from (fitting * _SMALLER**number for number in range(_TRIES))


def _planning(design: Design, face: CutFace, radius: float) -> Steps[CutPlan]:
    cutting, step = design.cutting, step_of(design)
    mm, top = 1e3 * design.metres, float(face.heights.max()) + design.cutting.stock_above
    fine = max(_FINE * max(design.net.half_width), _LEAST_SCALLOP / mm, 2 * step)
    cut = next(iter(design.scene.ball_cuts), None)
    if cutting.scallop is not None:
        scallop = cutting.scallop
    elif cut is not None and cut.radius == radius:
        scallop = face.scallop_of(radius, cut.step_over)
    else:
        scallop = face.finest_scallop(radius, min(fine, radius / 2), _USUAL)
    planned = face.plan_raster(radius, scallop, _MOST, step)
    raster = yield from within(planned, lambda done: 0.75 * done)
    deepest = float(raster.tip.min())
    stock = _stock(design, top, deepest)
    zero = stock.zero(cutting.origin, step)
    raster = Raster(raster.x, raster.y, _rounded_up(raster.tip, zero[2], step), radius)
    errors = yield from within(face.cut_errors(raster), lambda done: 0.75 + 0.2 * done)
    if looks_up(design) < 0:  # the face lies turned over about y
        errors = errors._replace(place=(-errors.place[0], errors.place[1]))
    rough = _rough(design, face, raster, stock, zero[2])
    yield 1.0
    fitting = face.default_radius if min(design.net.degree) > 1 else math.inf
    return CutPlan(cutting, raster, scallop, errors, stock, zero, rough, fitting, _DEEPEST / mm)


def _stock(design: Design, top: float, deepest: float) -> Stock:
    cutting = design.cutting
    thickness = cutting.stock or max(_needed(design), top - deepest)
    bottom = top - thickness
    if deepest < bottom - 1e-9 * thickness:
        raise Refused(
            "stock",
            Message(
                "{stock} is too thin: cuts at the rim go {deep} deep; at least that",
                stock=written(thickness, design.unit),
                deep=written(top - deepest, design.unit),
            ),
        )
    width, height = (r + cutting.rim for r in design.net.half_width)
    return Stock((width, height), top, bottom)


def _rough(
    design: Design, face: CutFace, raster: Raster, stock: Stock, datum: float
) -> RoughPlan | None:
    radius = _roughing_radius(design)
    if radius is None:
        return None
    cutting, step = design.cutting, step_of(design)
    cutter = Cutter(radius, cutting.roughing == "ball")
    allowance = cutting.allowance or _ALLOWANCE * radius
    step_down = cutting.step_down or _STEP_DOWN * radius
    more = max(raster.radius - radius, 0)  # the finishing cutter has to be clear of the stock
    reach = float(raster.x[-1]) + more, float(raster.y[-1]) + more
    found = plan_roughing(face, cutter, allowance, reach, step)
    found = found._replace(tip=_rounded_up(found.tip, datum, step))
    levels = (stock.top - float(found.tip.min())) / step_down
    if levels * found.tip.size > _MOST:
        raise Refused(
            "step_down",
            Message(
                "{step} makes {levels:,.0f} levels, more than a program holds; a larger one",
                step=written(step_down, design.unit),
                levels=levels,
            ),
        )
    x, y = design.outline.evenly(*np.random.default_rng(1).random((2, _SAMPLES)))
    left = found.left(x, y, face.net.at(x, y, face.heights)[0])
    return RoughPlan(found, step_down, allowance, left)


def step_of(design: Design) -> float:
    """Least increment of the program's numbers, scene units."""
    return 10.0 ** -DIALECTS[design.cutting.dialect].decimals / (1e3 * design.metres)


def looks_up(design: Design) -> int:
    """1 if the face to be cut looks to +z, else -1."""
    return -design.outward if design.cutting.negative else design.outward


def _rounded_up(z: Array, datum: float, step: float) -> Array:
    return np.asarray(datum + np.ceil((z - datum) / step - 1e-6) * step)


def _from(begin: float, done: float) -> float:
    return begin + (1 - begin) * done
