"""Table for diamond turning with a slow tool servo: angle, radius and height of the tool.

The tool follows a spiral from the rim to the axis. Its nose is a circle in the plane of the axis
and the radius; the rake angle is zero. At each angle the tip is as low as the circle may go above
the section of the face along the radius: the nose radius is compensated along z. The machine
interpolates the angle, the radius and the height linearly between points.
"""

import math
from typing import BinaryIO, NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.files.export.cut_plan import looks_up
from workbench.files.export.design import Design, Deviation
from workbench.files.export.options import Turning
from workbench.files.export.tables import write_table
from workbench.geometry.ball_cutter import CutFace
from workbench.geometry.outlines import Outline
from workbench.geometry.surface import ControlNet
from workbench.messages import Message
from workbench.powers import written

_NOSE = 0.5  # mm, by default
_CUSP = 1e-5  # height of cusps over the larger half-width
_FEWEST, _MOST_PER_TURN = 90, 46_080
_MOST = 4_000_000  # points of a table
_SAMPLES = 100_000  # points where the interpolation is measured
_TRIAL = 5_000  # of them, to choose the number of points per turn
_CHECKED, _ACROSS = 20_000, 65  # places where gouges are measured, and points along the nose
_ROUNDS, _EXACT = 60, 1e-8  # of the search for contacts; residual over the nose radius
_LEAST_RISE = 0.05  # of the residual, for a step of the secant method
_DIGITS = 7  # decimals of mm


class TurnedFace(NamedTuple):
    """A face that looks to +z above its axis, and the radius of the tool's nose; scene units."""

    net: ControlNet
    heights: Array
    outline: Outline
    nose: float

    def tip(self, angle: Array, radius: Array) -> Array:
        """Return the lowest height (m,) of the tip at places in polar coordinates.

        The nose touches the section at s: s − R p / √(1 + p²) is the radius of the tool, where p is
        the slope of the section at s. The left side rises with s if the nose fits everywhere.
        """
        nose = self.nose
        bracket = np.stack([radius - nose, radius + nose])
        at, z, slope = radius.copy(), np.empty_like(radius), np.empty_like(radius)
        before, off_before = np.full((2, len(radius)), np.nan)
        some = np.arange(len(radius))
        for _ in range(_ROUNDS):
            z[some], slope[some] = self.section(angle[some], at[some])
            place = at[some]
            off = place - nose * slope[some] / np.sqrt(1 + slope[some] ** 2) - radius[some]
            bracket[0, some] = np.where(off < 0, place, bracket[0, some])
            bracket[1, some] = np.where(off > 0, place, bracket[1, some])
            with np.errstate(invalid="ignore", divide="ignore"):
                rise = (off - off_before[some]) / (place - before[some])
            following = place - off / np.where(rise > _LEAST_RISE, rise, 1)
            low, high = bracket[:, some]
            inside = (following > low) & (following < high)
            before[some], off_before[some] = place, off
            at[some] = np.where(inside, following, (low + high) / 2)
            some = some[np.abs(off) > _EXACT * nose]
            if not len(some):
                break
        return np.asarray(z + nose / np.sqrt(1 + slope**2) - nose)

    def section(self, angle: Array, along: Array) -> tuple[Array, Array]:
        """Height and slope along the radius; beyond the edge the face continues straight."""
        cos, sin = np.cos(angle), np.sin(angle)
        x, y = along * cos, along * sin
        r_x, r_y = self.net.half_width
        inner_x, inner_y = x.clip(-r_x, r_x), y.clip(-r_y, r_y)
        z, slope_x, slope_y = self.net.at(inner_x, inner_y, self.heights)
        z = z + slope_x * (x - inner_x) + slope_y * (y - inner_y)
        return z, slope_x * cos + slope_y * sin

    def cut_off(self, angle: Array, radius: Array, tip: Array) -> float:
        """Deepest gouge of the nose into the face along z, at places in polar coordinates."""
        deepest = 0.0
        for part in np.linspace(-1, 1, _ACROSS):
            along = radius + part * self.nose
            z, _ = self.section(angle, along)
            x, y = along * np.cos(angle), along * np.sin(angle)
            side = tip + self.nose * (1 - math.sqrt(1 - part**2))
            gouge = np.where(self.outline.contains(x, y), z - side, 0)
            deepest = max(deepest, float(gouge.max(initial=0.0)))
        return deepest


class Spiral(NamedTuple):
    """A spiral from ``begin`` to the axis."""

    begin: float
    feed: float  # per turn
    per_turn: int

    @property
    def size(self) -> int:
        """Number of its points."""
        return math.ceil(self.begin / self.feed * self.per_turn) + 1

    def at(self, number: Array) -> tuple[Array, Array]:
        """Angle and radius (m,) of points by their numbers, which may be fractions."""
        radius = (self.begin - number * self.feed / self.per_turn).clip(0)
        return np.asarray(number * (2 * np.pi / self.per_turn)), radius


def write_turning(design: Design, file: BinaryIO) -> Deviation:
    """Write the table; raise Refused if the nose does not fit or there are too many points."""
    up, mm = looks_up(design), 1e3 * design.metres
    lying = CutFace.lying(design.net, design.heights, design.outline, up)
    nose = design.chosen(Turning).nose_radius or min(_NOSE / mm, lying.default_radius)
    face = TurnedFace(lying.net, lying.heights, lying.outline, nose)
    _check_nose(design, face)
    spiral = _spiral(design, face)
    numbers = np.arange(spiral.size, dtype=float)
    angle, radius = spiral.at(numbers)
    top = float(lying.heights.max())
    z = np.round(mm * (face.tip(angle, radius) - top), _DIGITS)
    bound = _bound(face, spiral, _SAMPLES, z / mm + top)
    cusp = spiral.feed**2 / (8 * nose)
    steepest = np.diff(z) / mm / (radius[1:] * np.diff(angle)).clip(spiral.feed)
    comments = (
        f"freeform face of {design.optic.name}: slow tool servo",
        "columns: angle (degrees), radius (mm), z of the lowest point of the nose (mm)",
        "x = radius cos(angle), y = radius sin(angle) on the part, which lies with this face up"
        + ("" if up > 0 else ", turned over about the y axis"),
        "zero: axis of the part, highest control point of the face",
        f"spiral from the rim to the axis: {mm * spiral.feed:.7g} mm per turn, "
        f"{spiral.per_turn} points per turn",
        f"nose radius {mm * nose:.7g} mm, rake angle 0, compensated along z",
        f"cusps between turns: {mm * cusp:.3g} mm high where the face is flat",
        f"error of linear interpolation between points: up to {mm * bound:.3g} mm",
        "steepest slope along the turn, below the clearance angle of the tool: "
        f"{math.degrees(math.atan(float(np.abs(steepest).max()))):.2f} degrees",
    )
    header = "\n".join(f"# {line}" for line in comments)
    write_table(file, (np.degrees(angle), mm * radius, z), header, " ")
    return Deviation(
        "error between points up to",
        bound,
        design.unit,
        f"{spiral.per_turn} points for each of {spiral.begin / spiral.feed:.0f} turns, nose radius "
        f"{written(nose, design.unit)}, cusps of {written(cusp, design.unit, 2)}; lengths in mm",
    )


def _spiral(design: Design, face: TurnedFace) -> Spiral:
    """Return the spiral with the fewest points that keep the chord error, or as requested."""
    turning, half = design.chosen(Turning), max(design.net.half_width)
    feed = turning.feed_per_turn or math.sqrt(8 * face.nose * _CUSP * half)
    # The tool begins clear of the part.
    begin = float(np.hypot(*face.outline.boundary(720).T).max()) + face.nose
    per_turn = turning.points_per_turn or _FEWEST
    while True:
        spiral = Spiral(begin, feed, per_turn)
        if spiral.size > _MOST:
            raise Refused(
                "feed_per_turn",
                Message(
                    "{feed} takes {points:,} points, more than {most:,}; a larger one, or fewer "
                    "points per turn",
                    feed=written(feed, design.unit),
                    points=spiral.size,
                    most=_MOST,
                ),
            )
        if turning.points_per_turn or per_turn >= _MOST_PER_TURN:
            return spiral
        if _bound(face, spiral, _TRIAL) <= design.largest_chord_error:
            return spiral
        per_turn *= 2


def _bound(face: TurnedFace, spiral: Spiral, samples: int, tip: Array | None = None) -> float:
    """Bound of the error of linear interpolation between points of the table, along z.

    The distance of a convex curve to its chord is nowhere more than twice that in the middle.
    """
    number = np.unique(np.linspace(0, spiral.size - 2, samples).astype(int))
    angle, radius = spiral.at(number + 0.5)
    x, y = radius * np.cos(angle), radius * np.sin(angle)
    number = number[face.outline.contains(x, y)]
    angle, radius = spiral.at(number + 0.5)
    if tip is None:
        ends = [face.tip(*spiral.at(number + end)) for end in (0.0, 1.0)]
    else:
        ends = [tip[number + end] for end in (0, 1)]
    return 2 * float(np.abs(sum(ends) / 2 - face.tip(angle, radius)).max(initial=0.0))


def _check_nose(design: Design, face: TurnedFace) -> None:
    x, y = face.outline.evenly(*np.random.default_rng(1).random((2, _CHECKED)))
    angle, radius = np.arctan2(y, x), np.hypot(x, y)
    deep = face.cut_off(angle, radius, face.tip(angle, radius))
    if deep > 1e-6 * face.nose:
        raise Refused(
            "nose_radius",
            Message(
                "a nose of {radius} does not fit: it cuts off {cut}; a smaller one",
                radius=written(face.nose, design.unit),
                cut=written(deep, design.unit, 2),
            ),
        )
