"""Collimated light, and `Source`, the list of all kinds of sources."""

import math
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, Self

import numpy as np
from pydantic import ConfigDict, Field

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.messages import Message
from workbench.scene import limits
from workbench.scene.element import Element
from workbench.scene.fields import ANGLE, LENGTH, PLACE, about
from workbench.scene.measured_source import PhotometricSource, RayFileSource
from workbench.scene.part import Kinds, Part, Positive
from workbench.scene.points import PointSource
from workbench.scene.receiver import AnyReceiver
from workbench.scene.source import AnySource, disc
from workbench.scene.turning import turned
from workbench.scene.wide_sources import AreaSource, GridSource

if TYPE_CHECKING:
    from workbench.scene.task import Scene

RayCount = Annotated[int, Field(ge=1, le=4096)]

# Cells of light tell the shape of a beam that is this part of the lens wide, and of wider ones.
_NARROWEST = 0.01

# Degrees that are rounding.
_STRAIGHT = 1e-11


class UniformProfile(Part):
    """As bright everywhere."""

    model_config = ConfigDict(title="Uniform")

    kind: Literal["uniform"] = "uniform"
    radius: ClassVar[float] = math.inf


class GaussianProfile(Part):
    """A laser beam about the optical axis of the lens; what passes its rim misses the lens."""

    model_config = ConfigDict(title="Gaussian beam")

    kind: Literal["gaussian"]
    radius: Annotated[
        Positive,
        LENGTH,
        about(
            "Beam radius",
            "Where the irradiance has fallen to 1/e² (13.5 %) of that in the middle, measured "
            "across the beam.",
        ),
    ]

    @classmethod
    def defaults_for(cls, scene: "Scene") -> dict[str, Any]:
        """Most of its light meets the lens."""
        return {"radius": min(scene.optic.half_width) / 2}


Profile = Annotated[UniformProfile | GaussianProfile, Kinds("kind", default="uniform")]


class CollimatedSource(AnySource):
    """Light from infinitely far that fills the entrance face: the sun, a laser beam."""

    model_config = ConfigDict(title="Collimated light")

    kind: Literal["collimated"]
    rays: Annotated[
        tuple[RayCount, RayCount],
        about(
            "Rays",
            "Rays along x and y in each iteration of the paper's method, and for derivative maps. "
            "More give a smoother image and take longer; at least two per pixel and axis are "
            "good. Automatic chooses its own.",
        ),
    ] = (512, 512)
    direction: Annotated[
        tuple[float, float],
        ANGLE,
        PLACE,
        about(
            "Direction",
            "How far the light is tilted against the optical axis: about x, which makes it go "
            "downwards, and about y, which makes it go to +x.",
        ),
    ] = (0.0, 0.0)
    angular_diameter: Annotated[
        float,
        ANGLE,
        about(
            "Angular diameter",
            "Full angle of the disc that the light comes from: 0.533 for the sun, 0 for a laser "
            "or a star. It blurs the image by as much as the disc's light spreads on the way.",
            ge=0,
            lt=180,
        ),
    ] = 0.0
    profile: Annotated[
        Profile,
        about("Profile", "How bright the light is across the beam."),
    ] = UniformProfile()

    @property
    def along_axis(self) -> bool:
        """Straight light that comes from no disc."""
        return not any(self.direction) and not self.angular_diameter

    @property
    def heading(self) -> Array:
        """That of its disc's middle; see `AnySource.heading`."""
        return turned(self.direction)[:, 2]

    def standing(self, place: Array | None, turn: Array) -> Self:
        """See `AnySource.standing`."""
        x, y, z = (turn @ self.heading).tolist()
        aside = math.hypot(x, y)
        degrees = math.degrees(math.atan2(aside, z))
        about = (0.0, 0.0)
        if degrees > _STRAIGHT:
            about = (-degrees * y / aside, degrees * x / aside) if aside else (degrees, 0.0)
        return self.model_copy(update={"direction": about})

    @property
    def continuous(self) -> bool:
        """If it comes from a disc."""
        return self.angular_diameter > 0

    @property
    def moves(self) -> bool:
        """A beam does."""
        return math.isfinite(self.profile.radius)

    @property
    def ray_count(self) -> int:
        """All its rays."""
        return math.prod(self.rays)

    @property
    def samples(self) -> tuple[int, int]:
        """Its rays."""
        return self.rays

    @property
    def mirrored(self) -> tuple[bool, bool]:
        """Where it is not tilted to the side."""
        return self.direction[1] == 0, self.direction[0] == 0

    @property
    def sharp(self) -> Self:
        """The same from the middle of its disc alone."""
        return self.model_copy(update={"angular_diameter": 0.0})

    @property
    def blur_shape(self) -> Literal["ellipse"]:
        """A disc's."""
        return "ellipse"

    def directions(self, x: Array, y: Array) -> Array:
        """Unit vectors (k, 3) in which light goes, of places (k,) of the unit disc.

        What is even on this disc is even in solid angle.
        """
        part = np.square(x) + np.square(y)
        versine = part * 2 * math.sin(math.radians(self.angular_diameter) / 4) ** 2
        aside = np.sqrt((2 - versine) * versine / np.where(part > 0, part, 1.0))
        ways = np.column_stack([x * aside, y * aside, 1 - versine])
        return np.asarray(ways @ turned(self.direction).T)

    def face(self, optic: Element, z: float) -> Array:
        """Its disc; see `AnySource.face`."""
        if not self.continuous:
            return super().face(optic, z)
        places = disc()
        ways = self.directions(*places[..., :2].reshape(-1, 2).T)
        middle = np.array([0.0, 0.0, optic.front_z])
        return np.asarray(middle + (z - optic.front_z) * ways / ways[:, 2:]).reshape(places.shape)

    def blur(self, optic: Element, receiver: AnyReceiver) -> tuple[float, float]:
        """The angle of its disc, times how far that moves light."""
        angle = math.radians(self.angular_diameter)
        x, y = receiver.per_radian(optic.leaving_z)
        return angle * x, angle * y

    def check_before(self, optic: Element) -> None:
        """Refuse light that comes from behind the entrance face, and beams too slim for it."""
        steepest = math.hypot(*self.direction) + self.angular_diameter / 2
        if steepest >= 90:
            axis = 0 if abs(self.direction[0]) >= abs(self.direction[1]) else 1
            raise Refused(
                f"source.direction[{axis}]",
                Message(
                    "{angle:g} brings light {steepest:g} degrees from the axis, which does not "
                    "come to {front}; less than 90 in all",
                    angle=self.direction[axis],
                    steepest=steepest,
                    front=optic.front_called,
                ),
            )
        radius, least = self.profile.radius, _NARROWEST * max(optic.half_width)
        if radius < least:
            raise Refused(
                "source.profile.radius",
                Message(
                    "{radius:g} is too narrow for a {optic} with a half-width of {half:g}; at "
                    "least {least:g}",
                    radius=radius,
                    optic=optic.called,
                    half=max(optic.half_width),
                    least=least,
                ),
            )
        if math.isfinite(radius):
            limits.check_lengths(
                [("source.profile.radius", radius)], optic.half_width, limits.FARTHEST
            )


Source = Annotated[
    CollimatedSource | PointSource | GridSource | PhotometricSource | RayFileSource | AreaSource,
    Kinds("kind"),
]
