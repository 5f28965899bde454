"""How far a lens may be off: the tolerances, and what each says of itself.

The command line, the form and the report follow from them. The command line reads this file before
it knows what is asked of it, so nothing here takes long to import.
"""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, fields
from typing import TYPE_CHECKING, Any, Literal

from workbench.errors import Refused
from workbench.said import Said

if TYPE_CHECKING:
    from workbench.scene import Scene

FINEST = 1 / 250
"""Least length of a face's errors, in widths of the lens, that 1000 control points follow."""


@dataclass(frozen=True)
class ToleranceField:
    """What a tolerance says of itself."""

    title: str  # what a person reads before its field
    tip: str  # what it is; "{optic}" stands for the lens or the mirror
    row: str  # what a report calls it
    # Of its number; of the first, if there are two, for both.
    unit: Literal["", "degrees", "length"]
    there: "Callable[[Scene], bool]" = lambda scene: True  # whether a scene has what could be off
    absent: str = ""  # why it changes nothing otherwise

    def tip_of(self, optic: str) -> str:
        """The tip for what is called so."""
        return self.tip.format(optic=optic)

    def shown(self, size: float, unit: str) -> str:
        """An error with its unit, in scenes of a unit of length."""
        return {
            "": f"{size:g}",
            "degrees": f"{math.degrees(size):g}°",
            "length": f"{size:g} {unit}",
        }[self.unit]

    def check(self, name: str, size: float, scene: "Scene") -> None:
        """Refuse an error of what a scene does not have, and what is no size of an error."""
        angle = math.degrees(size)
        if size and not self.there(scene):
            raise Refused(
                name,
                Said(
                    "{angle:g} degrees change nothing: {absent}; 0", angle=angle, absent=self.absent
                )
                if self.unit == "degrees"
                else Said("{size:g} changes nothing: {absent}; 0", size=size, absent=self.absent),
            )
        if self.unit == "degrees" and not 0 <= size < math.pi / 4:
            raise Refused(name, Said("{angle:g} degrees; at least 0, less than 45", angle=angle))
        if not 0 <= size < math.inf:
            raise Refused(name, Said("{size:g}; a finite number from 0 is needed", size=size))


def _tolerance(*about: Any, default: Any = 0.0, **more: Any) -> Any:
    return field(default=default, metadata={"about": ToleranceField(*about, **more)})


def _between_faces(scene: "Scene") -> bool:
    return scene.optic.most_faces > 1


_ONE_FACE = Said("a mirror has no other face")


@dataclass(frozen=True)
class Tolerances:
    """How far a lens may be off; angles in radians, lengths in scene units, 0 where it is not."""

    # Largest angle between lens and optical axis, turned about the middle of the entrance face;
    # anywhere in the disc of all such tilts, evenly.
    tilt: float = _tolerance(
        "Tilt", "Largest angle between {optic} and optical axis", "tilt up to", "degrees"
    )
    # Largest distance of the lens from the axis; evenly in the disc.
    decentre: float = _tolerance(
        "Decentre", "Largest distance of the {optic} from the axis", "decentre up to", "length"
    )
    # The same of the exit face alone, against the entrance face: turned about its own middle.
    exit_tilt: float = _tolerance(
        "Exit tilt",
        "Largest tilt of the exit face against the entrance",
        "exit face tilted by up to",
        "degrees",
        there=_between_faces,
        absent=_ONE_FACE,
    )
    exit_decentre: float = _tolerance(
        "Exit decentre",
        "Largest shift of the exit face over the entrance",
        "exit face decentred by up to",
        "length",
        there=_between_faces,
        absent=_ONE_FACE,
    )
    # Largest error of the refractive index; evenly to both sides.
    index: float = _tolerance(
        "Index ±",
        "Largest error of the refractive index",
        "index off by up to",
        "",
        there=lambda scene: scene.optic.index > 1,
        absent=Said("there is no glass"),
    )
    # Largest error of the screen's distance; evenly to both sides.
    distance: float = _tolerance(
        "Screen ±",
        "Largest error of the screen's distance",
        "distance off by up to",
        "length",
        there=lambda scene: scene.receiver.at_distance,
        absent=Said("a far field is at no distance"),
    )
    # As ``tilt``, of the source about its middle.
    source_tilt: float = _tolerance(
        "Source tilt",
        "Largest tilt of the source about its middle",
        "source tilt up to",
        "degrees",
        there=lambda scene: scene.source.turns,
        absent=Said("this source lights the lens alike however it is turned"),
    )
    # Largest distance of the source from its place; evenly in the ball.
    source_shift: float = _tolerance(
        "Source shift",
        "Largest shift of the source, in any direction",
        "source shift up to",
        "length",
        there=lambda scene: scene.source.moves,
        absent=Said("even light from infinitely far is the same everywhere"),
    )
    # Root mean square of the error of the exit face, or of a mirror, and of the entrance face; and
    # the length over which it is alike.
    surface: tuple[float, float] = _tolerance(
        "Surface",
        "Root mean square of the error of the exit face, or of the mirror, and the length over "
        "which it is alike: some micrometres over some millimetres when milled",
        "surface error, RMS",
        "length",
        default=(0.0, 1.0),
    )
    entrance_surface: tuple[float, float] = _tolerance(
        "Entrance surface",
        "The same two of the entrance face",
        "surface error of the entrance face, RMS",
        "length",
        default=(0.0, 1.0),
        there=_between_faces,
        absent=_ONE_FACE,
    )

    @classmethod
    def of(cls, values: Mapping[str, Any]) -> "Tolerances":
        """From values by name, angles in degrees; other names do not count."""
        own: dict[str, Any] = {name: values[name] for name in ABOUT}
        for name, about in ABOUT.items():
            if about.unit == "degrees":
                own[name] = math.radians(own[name])
            elif name in PAIRS:
                own[name] = tuple(own[name])
        return cls(**own)

    @property
    def any(self) -> bool:
        """Whether anything is off."""
        return any(self.sizes.values())

    @property
    def sizes(self) -> dict[str, float]:
        """How large each error may be, by name."""
        values = {name: getattr(self, name) for name in ABOUT}
        return {name: v[0] if name in PAIRS else v for name, v in values.items()}

    def check(self, scene: "Scene") -> None:
        """Refuse what is not possible for a scene, in the words of the command line.

        Raises `Refused` with the tolerance and what is allowed.
        """
        scene.check_one_image("tolerances")
        scene.check_one_element("tolerances")
        for name, size in self.sizes.items():
            ABOUT[name].check(f"{name}[0]" if name in PAIRS else name, size, scene)
        optic = scene.optic
        if self.index:
            _check_room("index", self.index, optic.index - 1, Said("else there may be no glass"))
        if self.distance:
            room = optic.onwards * (scene.receiver.plane_z - optic.edge_z)
            touch = Said("else the screen may touch the {optic}", optic=optic.called)
            _check_room("distance", self.distance, room, touch)
        if self.source_shift:
            room = optic.front_z - scene.source.nearest_z
            touch = Said("else the source may touch the {optic}", optic=optic.called)
            _check_room("source_shift", self.source_shift, room, touch)
        width = 2 * max(optic.half_width)
        for name in PAIRS:
            amplitude, scale = getattr(self, name)
            if amplitude > 0 and not FINEST * width <= scale <= width:
                raise Refused(
                    f"{name}[1]",
                    Said(
                        "{scale:g}; from {least:g} to {width:g}",
                        scale=scale,
                        least=FINEST * width,
                        width=width,
                    ),
                )


ABOUT: Mapping[str, ToleranceField] = {
    each.name: each.metadata["about"] for each in fields(Tolerances)
}
"""What each tolerance says of itself, by name."""

PAIRS = frozenset(each.name for each in fields(Tolerances) if isinstance(each.default, tuple))
"""Names of those that are an error and the length over which it is alike."""


def _check_room(name: str, size: float, room: float, otherwise: str) -> None:
    if not size < room:
        raise Refused(
            name,
            Said(
                "{size:g}; at least 0, less than {room:g}, {otherwise}",
                size=size,
                room=room,
                otherwise=otherwise,
            ),
        )
