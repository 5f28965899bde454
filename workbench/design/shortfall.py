"""What a task needs of its lens beyond what is allowed."""

from dataclasses import dataclass, replace
from typing import Literal

from workbench.errors import Refused
from workbench.scene import Scene

Cause = Literal["height_range", "max_thickness", "min_thickness", "screen", "entrance_range"]
Interval = tuple[float, float]

# Entrance ranges that are tried, times the one before.
_WIDER = 2.0, 1.5, 1.25, 1.1

_CURES: dict[Cause, str] = {
    "height_range": "widen the height range, or leave it out",
    "max_thickness": "thicker stock, or a smaller minimal thickness, lets the lens bend more",
    "min_thickness": "a higher base or a smaller minimal thickness gives it room",
    "screen": "move the screen away from the lens",
    "entrance_range": "widen the entrance range",
}


@dataclass(frozen=True)
class Shortfall:
    """Limits of a lens that keep it from what its task needs.

    Attributes
    ----------
    cause : str
        The limit: "height_range", "max_thickness", "min_thickness", "screen" for one so near
        that the exit face has no room before it, or "entrance_range".
    needed : tuple[float, float], optional
        Of a range, the offsets from the place of the face that the task needs; else the thinnest
        and the thickest place; scene units. None where that is not known.
    allowed : tuple[float, float]
        The same as it is allowed.
    share : float
        Part of the control heights that are at an end of their interval; of an entrance range,
        the part that the face fills.
    """

    cause: Cause
    needed: Interval | None
    allowed: Interval
    share: float

    def sentence(self, scene: Scene) -> str:
        """What is needed and what is allowed by a scene."""
        called, unit = scene.optic.called, scene.unit
        thinnest, thickest = self.allowed
        if self.cause == "height_range":
            allowed = f"{_offsets(self.allowed)} {unit} is allowed"
            if self.needed is not None:
                return f"The {called} needs {_offsets(self.needed)} {unit}; {allowed}"
            return f"{self._ends} an end of their range; {allowed}"
        if self.cause == "entrance_range":
            return (
                f"The entrance face fills {100 * self.share:.0f} % of its range of "
                f"{_offsets(self.allowed)} {unit}, and would bend more of the light in a wider one"
            )
        if self.cause == "min_thickness":
            return f"{self._ends} the minimal thickness of {thinnest:.3g} {unit}"
        limit = (
            "the stock allows" if self.cause == "max_thickness" else "the screen leaves room for"
        )
        if self.needed is not None:
            needed = f"The {called} needs to be {self.needed[1]:.3g} {unit} thick"
            return f"{needed}; {limit} {thickest:.3g} {unit}"
        return f"{self._ends} the largest thickness; {limit} {thickest:.3g} {unit}"

    def scaled(self, factor: float) -> "Shortfall":
        """The same in another unit of length, of which ``factor`` make the one before."""
        needed = None if self.needed is None else _times(self.needed, factor)
        return replace(self, needed=needed, allowed=_times(self.allowed, factor))

    @property
    def cure(self) -> str:
        """What helps."""
        return _CURES[self.cause]

    @property
    def _ends(self) -> str:
        return f"{100 * self.share:.0f} % of the control heights are at"


def wider_entrance(scene: Scene) -> Interval | None:
    """A wider range for the entrance face, to both sides of its middle, that the lens has room for.

    Returns
    -------
    tuple of float, or None
        Offsets from its place, twice as far apart or a little less; None where the range is
        automatic, or source and exit face leave no room.
    """
    given = scene.optic.entrance.height_range
    if given is None:
        return None
    middle, half = (given[1] + given[0]) / 2, (given[1] - given[0]) / 2
    for times in _WIDER:
        wider = middle - times * half, middle + times * half
        try:
            entrance = scene.optic.entrance.within(wider)
            optic = scene.optic.model_copy(update={"entrance": entrance})
            optic.check()
            scene.with_optic(optic).check()
        except Refused:
            continue
        return wider
    return None


def _times(interval: Interval, factor: float) -> Interval:
    return interval[0] * factor, interval[1] * factor


def _offsets(interval: Interval) -> str:
    low, high = interval
    if abs(low + high) <= 0.005 * (high - low):
        return f"±{high:.3g}"
    return f"{low:.3g} to {high:.3g}"
