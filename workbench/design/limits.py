"""Where the control heights of a lens may be, and what a task needs beyond that."""

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from workbench.arrays import Array, Mask
from workbench.errors import Refused
from workbench.geometry.faces import ControlHeights, FaceArrays
from workbench.geometry.outlines import outline_of
from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.messages import Message
from workbench.scene import Element, PlacedFace, Scene, SplineFace

# A surface stays this part of its extent along z away from an end where the interval allows it:
# heights that begin at an end can hardly be moved.
_APART = 0.25
# Places along z that are tried where a surface does not fit anywhere.
_SHIFTS = 65
# The undesigned lens keeps this part of each interval away from its ends.
_INSIDE = 0.0005
# Part of the distance to the receiver that an automatic thickness takes where that is enough.
_USUAL = 0.5
# Rounding, as a part of the largest height.
_ROUNDING = 1e-12


@dataclass(frozen=True, eq=False)
class HeightLimits:
    """The interval of each control height, and the lens before any design."""

    # (n_u, n_v), ends of the intervals, scene units; the upper one may be infinite.
    lower: Array
    upper: Array
    undesigned: Array  # (n_u, n_v), base plus the middle of the height range, within the limits
    shaping: Mask  # (n_u, n_v), which of them bear on the lens: only these have to fit

    @classmethod
    def of_scene(cls, scene: Scene, part: float = _USUAL) -> dict[str, "HeightLimits"]:
        """The limits of all freeform faces of a scene, by id; ``part`` as for `bounded`."""
        return {
            face: limits
            for focused in scene.focused
            for face, limits in cls.of_faces(bounded(focused, part)).items()
        }

    @classmethod
    def of_faces(cls, optic: Element) -> dict[str, "HeightLimits"]:
        """The limits of each freeform face of an element, by its name, on its own net.

        By the convex-hull property each face stays between its limits everywhere, and all of the
        entrance face's are below those of the exit face by the minimal thickness.
        """
        laws = {optic.designed_front: cls.at_entrance, optic.designed_face: cls.of}
        fixed = {placed.name: (placed, face) for placed, face in optic.fixed_faces}
        return {
            face: cls.at(optic, *fixed[face], net) if face in fixed else laws[face](optic, net)
            for face, net in freeform_nets(optic).items()
        }

    @classmethod
    def at(
        cls, optic: Element, placed: PlacedFace, face: SplineFace, net: ControlNet
    ) -> "HeightLimits":
        """The limits of a fixed face: about its own heights, or its base, where a run keeps it."""
        x, y = net.positions
        own = face.carried_heights
        heights = (
            face.base.sag(x[:, None], y) + placed.z if own is None else own + optic.position[2]
        )
        reach = max(optic.half_width)
        return cls(heights - reach, heights + reach, heights, net.shaping(outline_of(optic)))

    @classmethod
    def at_entrance(cls, optic: Element, net: ControlNet) -> "HeightLimits":
        """The limits of the entrance face; undesigned it is where the lens says, or close to it."""
        low, high = optic.entrance_range
        middle = (
            optic.entrance_range[0]
            - optic.entrance_offsets[0]
            + sum(optic.entrance.height_range or (0.0, 0.0)) / 2
        )
        inside = _INSIDE * (high - low)
        lower, upper, undesigned = (
            np.full(net.shape, z)
            for z in (low, high, min(max(middle, low + inside), high - inside))
        )
        return cls(lower, upper, undesigned, net.shaping(outline_of(optic)))

    @classmethod
    def of(cls, optic: Element, net: ControlNet) -> "HeightLimits":
        """The limits that an element sets on a control net of the face that the task shapes."""
        x, y = net.positions
        lower, upper = optic.limits_at(x[:, None], y[None, :])
        middle = optic.base.height_at(x[:, None], y[None, :])
        if optic.height_range is not None:
            middle = middle + sum(optic.height_range) / 2
        inside = np.where(np.isfinite(upper), _INSIDE * (upper - lower), 0.0)
        shaping = net.shaping(outline_of(optic))
        return cls(lower, upper, middle.clip(lower + inside, upper - inside), shaping)

    def lacks(self, heights: Array) -> float:
        """How far along z a surface exceeds its limits, scene units; at most 0 where it fits.

        It may be moved along z.
        """
        least, most = self._shift_range(heights)
        return least - most

    def ends(self, heights: Array, fraction: float) -> tuple[Mask, Mask]:
        """Which heights are at their lower and at their upper end, within a part of the interval.

        All ends have to be finite.
        """
        near = fraction * (self.upper - self.lower)
        low, high = heights <= self.lower + near, heights >= self.upper - near
        return low & self.shaping, high & self.shaping

    def hold(self, heights: Array) -> bool:
        """Whether heights are within the limits as they are."""
        slack = _ROUNDING * np.abs(heights).max()
        fits = (heights >= self.lower - slack) & (heights <= self.upper + slack)
        return bool((fits | ~self.shaping).all())

    def kept(self, heights: Array, locked: Mask | None) -> Array:
        """Heights cut off at the limits, but for locked ones, which stay as they are."""
        inside = heights.clip(self.lower, self.upper)
        return inside if locked is None else np.where(locked, heights, inside)

    def placed(self, heights: Array, rise: float = 0.0) -> Array:
        """A surface moved along z to a rise above the undesigned lens, as far as the limits allow.

        One that does not fit anywhere is beyond the limits by as much above as below.
        """
        least, most = self._shift_range(heights)
        if least > most:
            return np.asarray(heights + (least + most) / 2)
        off = (heights - self.undesigned)[self.shaping]
        apart = min(_APART * (off.max() - off.min()), (most - least) / 2)
        shift = np.clip(rise - (off.max() + off.min()) / 2, least + apart, most - apart)
        return np.asarray(heights + shift)

    def nearest(self, heights: Array) -> Array:
        """A surface within the limits.

        It is moved along z where that is enough; else as little as possible of it is cut off.
        """
        if self.hold(heights):
            return heights
        least, most = self._shift_range(heights)
        if least <= most:
            return self.placed(heights)
        shifts = np.linspace(most, least, _SHIFTS)
        outside = ((heights + c < self.lower) | (heights + c > self.upper) for c in shifts)
        beyond = [(each & self.shaping).sum() for each in outside]
        moved: Array = heights + shifts[np.argmin(beyond)]
        return moved.clip(self.lower, self.upper)

    def _shift_range(self, heights: Array) -> tuple[float, float]:
        """How far a surface may move along z at least and at most; the former is larger if none."""
        low, high = (self.lower - heights)[self.shaping], (self.upper - heights)[self.shaping]
        return float(low.max()), float(high.min())


def undesigned(optic: Element) -> ControlHeights:
    """Control heights of an element before any design, scene units."""
    limits = HeightLimits.of_faces(optic)
    return FaceArrays({face: each.undesigned for face, each in limits.items()})


CLOSEST = 0.95
"""Part of the distance to the receiver that an automatic thickness takes at most."""


def bounded(scene: Scene, part: float = _USUAL) -> Element:
    """Return the element of a scene with all that limits its heights; see `Element.bounded`."""
    alone = scene.alone
    optic = alone.optic
    ends = [receiver.nearest_to(optic) for receiver in alone.receivers]
    ends += (behind.nearest_to(scene.optic) for behind in scene.behind[:1])
    nearest = min(ends, key=lambda z: optic.onwards * z)
    return optic.bounded(alone.source.nearest_z, nearest, len(scene.images) > 1, part)


Cause = Literal["height_range", "max_thickness", "min_thickness", "screen", "entrance_range"]
Interval = tuple[float, float]

# Part of a needed height range that a wider one has more, at each end.
_MORE = 0.05
# Entrance ranges that are tried, times the one before.
_WIDER = 2.0, 1.5, 1.25, 1.1

_CURES: dict[Cause, Message] = {
    "height_range": Message("widen the height range, or leave it out"),
    "max_thickness": Message(
        "thicker stock, or a smaller minimal thickness, lets the lens bend more"
    ),
    "min_thickness": Message("raise the base, or lower the minimal thickness"),
    "screen": Message("move the screen away from the lens"),
    "entrance_range": Message("widen the entrance range"),
}


@dataclass(frozen=True)
class Shortfall:
    """Limits of a lens that keep it from what its task needs."""

    # The limit: "height_range", "max_thickness", "min_thickness", "screen" for one so near that the
    # exit face cannot be thicker, or "entrance_range".
    cause: Cause
    # Of a range, the offsets from the place of the face that the task needs; else the thinnest and
    # the thickest place; scene units. None where that is not known.
    needed: Interval | None
    allowed: Interval  # the same as it is allowed
    # Part of the control heights that are at an end of their interval; of an entrance range, the
    # part that the face fills.
    share: float

    def sentence(self, scene: Scene) -> Message:
        """What is needed and what is allowed by a scene."""
        if self.cause == "entrance_range":
            values = {
                "part": 100 * self.share,
                "range": _offsets(self.allowed),
                "unit": scene.unit,
            }
            if self.automatic_in(scene):
                return Message(
                    "The entrance face fills {part:.0f} % of its automatic range of {range} {unit}",
                    **values,
                )
            return Message(
                "The entrance face fills {part:.0f} % of its range of {range} {unit}, and would "
                "bend more of the light in a wider one",
                **values,
            )
        if self.cause == "min_thickness":
            return Message(
                "{part:.0f} % of the control heights are at the minimal thickness of "
                "{thinnest:.3g} {unit}",
                part=100 * self.share,
                thinnest=self.allowed[0],
                unit=scene.unit,
            )
        return self._in_range(scene) if self.cause == "height_range" else self._in_stock(scene)

    def _in_range(self, scene: Scene) -> Message:
        unit = scene.unit
        offsets = _offsets(self.allowed)
        allowed = (
            Message("{range} {unit} is the automatic limit", range=offsets, unit=unit)
            if self.automatic_in(scene)
            else Message("{range} {unit} is allowed", range=offsets, unit=unit)
        )
        if self.needed is None:
            return Message(
                "{part:.0f} % of the control heights are at an end of their range; {allowed}",
                part=100 * self.share,
                allowed=allowed,
            )
        return Message(
            "The {optic} needs {range} {unit}; {allowed}",
            optic=scene.optic.called,
            range=_offsets(self.needed),
            unit=unit,
            allowed=allowed,
        )

    def _in_stock(self, scene: Scene) -> Message:
        unit, thickest = scene.unit, self.allowed[1]
        if self.automatic_in(scene):
            allowed = Message(
                "{thickest:.3g} {unit} is the automatic limit", thickest=thickest, unit=unit
            )
        elif self.cause == "screen":
            allowed = Message(
                "the screen allows {thickest:.3g} {unit}", thickest=thickest, unit=unit
            )
        else:
            allowed = Message(
                "the stock allows {thickest:.3g} {unit}", thickest=thickest, unit=unit
            )
        if self.needed is None:
            return Message(
                "{part:.0f} % of the control heights are at the largest thickness; {allowed}",
                part=100 * self.share,
                allowed=allowed,
            )
        return Message(
            "The {optic} needs to be {needed:.3g} {unit} thick; {allowed}",
            optic=scene.optic.called,
            needed=self.needed[1],
            unit=unit,
            allowed=allowed,
        )

    def in_full(self, scene: Scene) -> Message:
        """The sentence, and what helps."""
        return Message(
            "{sentence}: {cure}", sentence=self.sentence(scene), cure=self.cure_in(scene)
        )

    def at_field(self, scene: Scene) -> Message:
        """The sentence and what helps, behind the path of the field that holds the limit."""
        return Message("{field}: {reason}", field=self._field(scene), reason=self.in_full(scene))

    def _field(self, scene: Scene) -> str:
        thickness = f"{scene.optic_path}.max_thickness"
        match self.cause:
            case "height_range":
                return f"{scene.face_path()}.height_range"
            case "entrance_range":
                return f"{scene.optic_path}.faces[0].height_range"
            case "min_thickness":
                return f"{scene.optic_path}.min_thickness"
            case "screen" if scene.receiver.at_distance:
                return "images[0].receiver.position[2]"
        return thickness

    def scaled(self, factor: float) -> "Shortfall":
        """The same in another unit of length, of which ``factor`` make the one before."""
        needed = None if self.needed is None else _times(self.needed, factor)
        return replace(self, needed=needed, allowed=_times(self.allowed, factor))

    def automatic_in(self, scene: Scene) -> bool:
        """Whether the program has chosen the limit, and a field of the scene can replace it."""
        if self.cause == "height_range":
            return scene.optic.height_range is None
        if self.cause == "entrance_range":
            return scene.optic.entrance.height_range is None
        return self.cause == "screen" and (self.needed is None or not scene.receiver.at_distance)

    def wider_in(self, scene: Scene) -> tuple[str, list[float] | None] | None:
        """Path and value of a field that lifts the limit; None where no edit is known to.

        A height range that is given becomes automatic.
        """
        if self.cause == "height_range" and scene.optic.height_range is not None:
            return self._field(scene), None
        if self.cause == "height_range" and self.needed is not None:
            low, high = self.needed
            more = _MORE * (high - low)
            return self._field(scene), [low - more, high + more]
        if self.cause == "entrance_range" and (wider := wider_entrance(scene)) is not None:
            return self._field(scene), list(wider)
        return None

    def cure_in(self, scene: Scene) -> Message:
        """What helps in a scene."""
        if self.automatic_in(scene):
            if self.cause == "screen":
                field = f"{scene.optic_path}.max_thickness"
                return Message("set {field} to a larger thickness", field=field)
            return Message("set {field} to a wider range", field=self._field(scene))
        return _CURES[self.cause]


def wider_entrance(scene: Scene) -> Interval | None:
    """A wider range for the entrance face, to both sides of its middle, that the lens can hold.

    Returns offsets from its place, twice as far apart or a little less; None where the entrance
    face is flat, or source and exit face allow none.
    """
    given = bounded(scene).entrance_offsets
    if scene.optic.designed_front is None:
        return None
    middle, half = (given[1] + given[0]) / 2, (given[1] - given[0]) / 2
    for times in _WIDER:
        wider = middle - times * half, middle + times * half
        try:
            entrance = scene.optic.entrance.within(wider)
            optic = scene.optic.with_front(entrance)
            scene.with_optic(optic).check()
        except Refused:
            continue
        return wider
    return None


def _times(interval: Interval, factor: float) -> Interval:
    return interval[0] * factor, interval[1] * factor


def _offsets(interval: Interval) -> Message:
    low, high = interval
    if abs(low + high) <= 0.005 * (high - low):
        return Message("±{high:.3g}", high=high)
    return Message("{low:.3g} to {high:.3g}", low=low, high=high)
