"""G-code of a finishing pass over a face, in millimetres: what GRBL and LinuxCNC both take.

Zero is the middle of the lens at the highest point of the face, which looks up. A face that looks
to -z is turned over about the y axis, and so is a mould. Programs are simulated as they are
written: the ball is swept over the rounded numbers, and what is left is compared with the face.
"""

from collections.abc import Iterator
from functools import partial
from typing import BinaryIO, NamedTuple

import numpy as np

from workbench.errors import Refused
from workbench.files.export.design import Design, Deviation
from workbench.geometry.tool_path import CutFace, Raster, Remains
from workbench.powers import written
from workbench.said import Said
from workbench.watch import Steps, finished, within

_FINE = 1e-4  # height of ridges over the larger half-width
_DIGITS = 5  # behind the point; GRBL reads seven in all
_MOST = 1_000_000  # moves of a program
_LEAST_RIDGES = 1e-4  # mm, unless they are asked for: programs round to 1e-5 mm
_TRIES, _SMALLER = 5, 0.7  # radii of a cutter that nobody has asked for
# Times the height of ridges that may be left, and be cut off: a cutter that fits does better.
_LEFT, _OFF = 2.0, 0.25


class CutPlan(NamedTuple):
    """Cuts of a face, as a program has them, and what they leave.

    Attributes
    ----------
    raster : Raster
        The cuts, scene units.
    scallop : float
        Height of ridges that was planned.
    remains : Remains
        What the simulated cut leaves; the place is that of the face as it lies below the cutter.
    top : float
        Highest control height of the face as it lies below the cutter.
    """

    raster: Raster
    scallop: float
    remains: Remains
    top: float

    @property
    def fits(self) -> bool:
        """Whether the cutter leaves ridges alone."""
        cut_off, left, _ = self.remains
        return cut_off <= _OFF * self.scallop and left <= _LEFT * self.scallop


def write_gcode(design: Design, file: BinaryIO) -> Deviation:
    """Write the cuts, and what they leave.

    Raises
    ------
    Refused
        If the cutter does not fit, or there are too many cuts.
    """
    plan = finished(planning(design))
    raster, radius, scallop = plan.raster, plan.raster.radius, plan.scallop
    cut_off, left, (x, y) = plan.remains
    if not plan.fits:
        raise Refused(
            "tool_radius",
            Said(
                "a ball cutter of {radius} does not fit: it leaves {left} at x = {x}, y = {y} and "
                "cuts off {cut}; a smaller one, or run.min_tool_radius",
                radius=written(radius, design.unit),
                left=written(left, design.unit, 2),
                x=written(x, design.unit),
                y=written(y, design.unit),
                cut=written(max(cut_off, 0), design.unit, 2),
            ),
        )
    for line in _program(design, raster, scallop, plan.top):
        file.write(f"{line}\n".encode())
    return Deviation(
        "simulated cut off by",
        max(left, cut_off),
        design.unit,
        f"cutter radius {written(radius, design.unit)}, ridges up to "
        f"{written(left, design.unit, 2)}, cut into the face up to "
        f"{written(max(cut_off, 0), design.unit, 2)}; a finishing pass in mm, zero at the top of "
        "the face",
    )


def planning(design: Design) -> Steps[CutPlan]:
    """Find the cuts of a design's face and simulate them, in steps of a moment.

    A cutter that nobody has asked for is smaller the next time if it does not fit.

    Raises
    ------
    Refused
        If there are too many cuts.
    """
    up = -design.outward if design.cutting.negative else design.outward
    heights = design.heights if up > 0 else -design.heights[::-1]
    face = CutFace(design.net, heights, design.outline)
    asked = design.cutting.tool_radius or design.scene.run.min_tool_radius
    radius, begin, plan = asked or face.fitting_radius, 0.0, None
    for _ in range(1 if asked else _TRIES):
        plan = yield from within(_planning(design, face, radius), partial(_from, begin))
        if plan.fits:
            break
        radius, begin = _SMALLER * radius, _from(begin, 0.5)
    assert plan is not None
    return plan


def _planning(design: Design, face: CutFace, radius: float) -> Steps[CutPlan]:
    """Find the cuts by one cutter."""
    mm = 1e3 * design.metres
    fine = max(_FINE * max(design.net.half_width), _LEAST_RIDGES / mm)
    scallop = design.cutting.scallop or face.finest(radius, min(fine, radius / 2), _MOST)
    raster = yield from within(face.rastering(radius, scallop, _MOST), lambda done: 0.8 * done)
    raster = _rounded(raster, mm)
    remains = yield from within(face.left(raster), lambda done: 0.8 + 0.2 * done)
    return CutPlan(raster, scallop, remains, top=float(face.heights.max()))


def _from(begin: float, done: float) -> float:
    """The part of the whole that is done, of what is done of the rest."""
    return begin + (1 - begin) * done


def _rounded(raster: Raster, millimetres: float) -> Raster:
    """The numbers that a program has, in scene units."""
    x, y, tip = (
        np.round(each * millimetres, _DIGITS) / millimetres
        for each in (raster.x, raster.y, raster.tip)
    )
    return Raster(x, y, tip, raster.radius)


def _program(design: Design, raster: Raster, scallop: float, top: float) -> Iterator[str]:
    cutting, mm = design.cutting, 1e3 * design.metres
    width, height = (2 * mm * (r + cutting.rim) for r in design.net.half_width)
    deep = mm * (top - float(raster.tip.min()))
    clear = 2 * raster.radius if cutting.safe_height is None else cutting.safe_height
    safe = mm * (float(raster.tip.max()) - top + clear)
    yield f"(freeform {'mould' if cutting.negative else 'face'}: finishing pass, mm)"
    yield f"(ball cutter of radius {mm * raster.radius:.4f}, ridges {mm * scallop:.5f})"
    yield f"(stock {width:.3f} x {height:.3f}, cut {deep:.3f} deep)"
    yield f"(clamping rim {mm * cutting.rim:.3f} wide; let holders keep off the cuts)"
    yield "(zero: middle of the lens, highest control point of the face)"
    yield "G21 G90 G17 G94"
    yield f"G0 Z{safe:.4f}"
    yield "M3"
    x, y, z = (mm * each for each in (raster.x, raster.y, raster.tip - top))
    yield f"G0 X{x[0]:.5f} Y{y[0]:.5f}"
    yield f"G1 Z{z[0, 0]:.5f} F{cutting.feed:g}"
    for row in range(len(y)):
        ends = range(len(x)) if row % 2 == 0 else range(len(x) - 1, -1, -1)
        yield from (f"G1 X{x[i]:.5f} Y{y[row]:.5f} Z{z[i, row]:.5f}" for i in ends)
    yield f"G0 Z{safe:.4f}"
    yield "M5"
    yield "M2"
