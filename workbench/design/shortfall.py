"""What a task needs of its lens beyond what is allowed."""

from dataclasses import dataclass, replace
from typing import Literal

from workbench.design.limits import bounded
from workbench.errors import Refused
from workbench.said import Said
from workbench.scene import Scene

Cause = Literal["height_range", "max_thickness", "min_thickness", "screen", "entrance_range"]
Interval = tuple[float, float]

# Entrance ranges that are tried, times the one before.
_WIDER = 2.0, 1.5, 1.25, 1.1

_CURES: dict[Cause, Said] = {
    "height_range": Said("widen the height range, or leave it out"),
    "max_thickness": Said("thicker stock, or a smaller minimal thickness, lets the lens bend more"),
    "min_thickness": Said("a higher base or a smaller minimal thickness gives it room"),
    "screen": Said("move the screen away from the lens"),
    "entrance_range": Said("widen the entrance range"),
}


@dataclass(frozen=True)
class Shortfall:
    """Limits of a lens that keep it from what its task needs."""

    # The limit: "height_range", "max_thickness", "min_thickness", "screen" for one so near that the
    # exit face has no room before it, or "entrance_range".
    cause: Cause
    # Of a range, the offsets from the place of the face that the task needs; else the thinnest and
    # the thickest place; scene units. None where that is not known.
    needed: Interval | None
    allowed: Interval  # the same as it is allowed
    # Part of the control heights that are at an end of their interval; of an entrance range, the
    # part that the face fills.
    share: float

    def sentence(self, scene: Scene) -> Said:
        """What is needed and what is allowed by a scene."""
        if self.cause == "entrance_range":
            values = {
                "part": 100 * self.share,
                "range": _offsets(self.allowed),
                "unit": scene.unit,
            }
            if self.automatic_in(scene):
                return Said(
                    "The entrance face fills {part:.0f} % of its automatic range of {range} {unit}",
                    **values,
                )
            return Said(
                "The entrance face fills {part:.0f} % of its range of {range} {unit}, and would "
                "bend more of the light in a wider one",
                **values,
            )
        if self.cause == "min_thickness":
            return Said(
                "{part:.0f} % of the control heights are at the minimal thickness of "
                "{thinnest:.3g} {unit}",
                part=100 * self.share,
                thinnest=self.allowed[0],
                unit=scene.unit,
            )
        return self._in_range(scene) if self.cause == "height_range" else self._in_stock(scene)

    def _in_range(self, scene: Scene) -> Said:
        unit = scene.unit
        offsets = _offsets(self.allowed)
        allowed = (
            Said("{range} {unit} is the automatic limit", range=offsets, unit=unit)
            if self.automatic_in(scene)
            else Said("{range} {unit} is allowed", range=offsets, unit=unit)
        )
        if self.needed is None:
            return Said(
                "{part:.0f} % of the control heights are at an end of their range; {allowed}",
                part=100 * self.share,
                allowed=allowed,
            )
        return Said(
            "The {optic} needs {range} {unit}; {allowed}",
            optic=scene.optic.called,
            range=_offsets(self.needed),
            unit=unit,
            allowed=allowed,
        )

    def _in_stock(self, scene: Scene) -> Said:
        unit, thickest = scene.unit, self.allowed[1]
        if self.automatic_in(scene):
            allowed = Said(
                "{thickest:.3g} {unit} is the automatic limit", thickest=thickest, unit=unit
            )
        elif self.cause == "screen":
            allowed = Said(
                "the screen leaves room for {thickest:.3g} {unit}", thickest=thickest, unit=unit
            )
        else:
            allowed = Said("the stock allows {thickest:.3g} {unit}", thickest=thickest, unit=unit)
        if self.needed is None:
            return Said(
                "{part:.0f} % of the control heights are at the largest thickness; {allowed}",
                part=100 * self.share,
                allowed=allowed,
            )
        return Said(
            "The {optic} needs to be {needed:.3g} {unit} thick; {allowed}",
            optic=scene.optic.called,
            needed=self.needed[1],
            unit=unit,
            allowed=allowed,
        )

    def in_full(self, scene: Scene) -> Said:
        """The sentence, and what helps."""
        return Said("{sentence}: {cure}", sentence=self.sentence(scene), cure=self.cure_in(scene))

    def at_field(self, scene: Scene) -> Said:
        """The sentence and what helps, behind the path of the field that holds the limit."""
        return Said("{field}: {said}", field=self._field(scene), said=self.in_full(scene))

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

    def cure_in(self, scene: Scene) -> Said:
        """What helps in a scene."""
        if self.automatic_in(scene):
            if self.cause == "screen":
                field = f"{scene.optic_path}.max_thickness"
                return Said("set {field} to a larger thickness", field=field)
            return Said("set {field} to a wider range", field=self._field(scene))
        return _CURES[self.cause]


def wider_entrance(scene: Scene) -> Interval | None:
    """A wider range for the entrance face, to both sides of its middle, that the lens has room for.

    Returns offsets from its place, twice as far apart or a little less; None where the entrance
    face is flat, or source and exit face leave no room.
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


def _offsets(interval: Interval) -> Said:
    low, high = interval
    if abs(low + high) <= 0.005 * (high - low):
        return Said("±{high:.3g}", high=high)
    return Said("{low:.3g} to {high:.3g}", low=low, high=high)
