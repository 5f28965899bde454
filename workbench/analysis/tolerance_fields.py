"""Tolerances of a lens, with their titles, tips, units and limits.

The command line, the form and the report follow from them. The command line imports this module
for each command, so it imports nothing slow.
"""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, fields
from typing import TYPE_CHECKING, Any, Literal

from workbench.errors import Refused
from workbench.messages import Message

if TYPE_CHECKING:
    from workbench.scene import Scene

FINEST = 1 / 250
"""Least correlation length of a face's error in widths of the lens: 1000 control points."""


@dataclass(frozen=True)
class ToleranceField:
    """Description of a tolerance."""

    title: str  # of its field in the window
    tip: str  # "{optic}" stands for the lens or the mirror
    row: str  # its name in a report
    unit: Literal["", "degrees", "length"]
    absent: "Callable[[Scene], str]" = lambda scene: ""  # why it does not apply to a scene

    def tip_of(self, optic: str) -> str:
        """The tip for an element of this name."""
        return self.tip.format(optic=optic)

    def shown(self, size: float, unit: str) -> str:
        """An error with its unit; ``unit`` is the scene's unit of length."""
        return {
            "": f"{size:g}",
            "degrees": f"{math.degrees(size):g}°",
            "length": f"{size:g} {unit}",
        }[self.unit]

    def check(self, name: str, size: float, scene: "Scene") -> None:
        """Refuse an error that does not apply to a scene or is out of range."""
        angle = math.degrees(size)
        if size and (absent := self.absent(scene)):
            raise Refused(
                name,
                Message("{angle:g} degrees change nothing: {absent}; 0", angle=angle, absent=absent)
                if self.unit == "degrees"
                else Message("{size:g} changes nothing: {absent}; 0", size=size, absent=absent),
            )
        if self.unit == "degrees" and not 0 <= size < math.pi / 4:
            raise Refused(name, Message("{angle:g} degrees; at least 0, less than 45", angle=angle))
        if not 0 <= size < math.inf:
            raise Refused(name, Message("{size:g}; a finite number from 0 is needed", size=size))


def _tolerance(*about: Any, default: Any = 0.0, **more: Any) -> Any:
    return field(default=default, metadata={"about": ToleranceField(*about, **more)})


def _one_face(scene: "Scene") -> str:
    return "" if scene.optic.most_faces > 1 else Message("a mirror has no other face")


def _of_trains(scene: "Scene") -> str:
    """Why errors do not apply that are known of one upright element alone."""
    return Message("optical trains have no such error") if scene.is_train else ""


def _between_faces(scene: "Scene") -> str:
    return _of_trains(scene) or _one_face(scene)


def _no_glass(scene: "Scene") -> str:
    return "" if scene.optic.index > 1 else Message("there is no glass")


def _no_distance(scene: "Scene") -> str:
    return "" if scene.receiver.at_distance else Message("a far field is at no distance")


def _turned_alike(scene: "Scene") -> str:
    if scene.source.turns:
        return _of_trains(scene)
    return Message("this source lights the lens alike however it is turned")


def _alike_everywhere(scene: "Scene") -> str:
    if scene.source.moves:
        return ""
    return Message("even light from infinitely far is the same everywhere")


@dataclass(frozen=True)
class Tolerances:
    """Largest errors of a lens; angles in radians, lengths in scene units."""

    # About the middle of the front face; uniform in the disc of tilts.
    tilt: float = _tolerance(
        "Tilt", "Largest angle between {optic} and optical axis", "tilt up to", "degrees"
    )
    # Uniform in the disc.
    decentre: float = _tolerance(
        "Decentre", "Largest distance of the {optic} from the axis", "decentre up to", "length"
    )
    # About the middle of the back face.
    exit_tilt: float = _tolerance(
        "Exit tilt",
        "Largest tilt of the exit face against the entrance",
        "exit face tilted by up to",
        "degrees",
        absent=_between_faces,
    )
    exit_decentre: float = _tolerance(
        "Exit decentre",
        "Largest shift of the exit face over the entrance",
        "exit face decentred by up to",
        "length",
        absent=_between_faces,
    )
    # Uniform.
    index: float = _tolerance(
        "Index ±",
        "Largest error of the refractive index",
        "index off by up to",
        "",
        absent=_no_glass,
    )
    # Uniform.
    distance: float = _tolerance(
        "Screen ±",
        "Largest error of the screen's distance",
        "distance off by up to",
        "length",
        absent=_no_distance,
    )
    source_tilt: float = _tolerance(
        "Source tilt",
        "Largest tilt of the source about its middle",
        "source tilt up to",
        "degrees",
        absent=_turned_alike,
    )
    # Uniform in the ball.
    source_shift: float = _tolerance(
        "Source shift",
        "Largest shift of the source, in any direction",
        "source shift up to",
        "length",
        absent=_alike_everywhere,
    )
    # RMS and correlation length.
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
        absent=_one_face,
    )

    @classmethod
    def of(cls, values: Mapping[str, Any]) -> "Tolerances":
        """From values by name, angles in degrees; other names are ignored."""
        own: dict[str, Any] = {name: values[name] for name in ABOUT}
        for name, about in ABOUT.items():
            if about.unit == "degrees":
                own[name] = math.radians(own[name])
            elif name in PAIRS:
                own[name] = tuple(own[name])
        return cls(**own)

    @property
    def any(self) -> bool:
        """Whether any error is above 0."""
        return any(self.sizes.values())

    @property
    def sizes(self) -> dict[str, float]:
        """Largest errors by name."""
        values = {name: getattr(self, name) for name in ABOUT}
        return {name: v[0] if name in PAIRS else v for name, v in values.items()}

    def check(self, scene: "Scene") -> None:
        """Raise `Refused` with the tolerance if one is not possible for a scene."""
        scene.check_one_image("tolerances")
        if len(scene.elements) == 1:
            scene.check_one_element("tolerances")
        for name, size in self.sizes.items():
            ABOUT[name].check(f"{name}[0]" if name in PAIRS else name, size, scene)
        optic = scene.optic
        if self.index:
            _check_below(
                "index", self.index, optic.index - 1, Message("else there may be no glass")
            )
        if self.distance:
            last = scene.elements[-1]
            limit = last.onwards * (scene.receiver.plane_z - last.edge_z)
            touch = Message("else the screen may touch the {optic}", optic=optic.called)
            _check_below("distance", self.distance, limit, touch)
        if self.source_shift:
            source, first = scene.entrance
            limit = first.front_z - source.nearest_z
            touch = Message("else the source may touch the {optic}", optic=optic.called)
            _check_below("source_shift", self.source_shift, limit, touch)
        width = 2 * max(optic.half_width)
        for name in PAIRS:
            amplitude, scale = getattr(self, name)
            counts = amplitude > 0 or not 0 <= scale < math.inf
            if counts and not FINEST * width <= scale <= width:
                raise Refused(
                    f"{name}[1]",
                    Message(
                        "{scale:g}; from {least:g} to {width:g}",
                        scale=scale,
                        least=FINEST * width,
                        width=width,
                    ),
                )


ABOUT: Mapping[str, ToleranceField] = {
    each.name: each.metadata["about"] for each in fields(Tolerances)
}
"""Description of each tolerance by name."""

PAIRS = frozenset(each.name for each in fields(Tolerances) if isinstance(each.default, tuple))
"""Names of the tolerances with an RMS and a correlation length."""


def _check_below(name: str, size: float, limit: float, otherwise: str) -> None:
    if not size < limit:
        raise Refused(
            name,
            Message(
                "{size:g}; at least 0, less than {limit:g}, {otherwise}",
                size=size,
                limit=limit,
                otherwise=otherwise,
            ),
        )
