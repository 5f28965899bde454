"""Collimated light, light that was measured, and `Source`, the list of all kinds of sources."""

import math
from collections.abc import Mapping
from dataclasses import replace
from pathlib import PurePath
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, Self

import numpy as np
from pydantic import ConfigDict, Field, PrivateAttr

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.levels import EXPERT
from workbench.messages import Message
from workbench.scene import limits
from workbench.scene.element import Element
from workbench.scene.fields import ANGLE, FILE, LENGTH, PLACE, about
from workbench.scene.part import Content, Kinds, Part, Positive
from workbench.scene.points import PointSource
from workbench.scene.receiver import AnyReceiver
from workbench.scene.source import AnySource, PlacedSource, Rays, disc, in_front
from workbench.scene.turning import Place, proper, tilt_of, tilted, turned
from workbench.scene.wide_sources import AreaSource, GridSource

if TYPE_CHECKING:
    from workbench.scene.task import Scene

RayCount = Annotated[int, Field(ge=1, le=4096)]
# Cells of light resolve the shape of a beam that is this part of the lens wide, and of wider ones.
_NARROWEST = 0.01
_STRAIGHT = 1e-11  # degrees that are rounding


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


Profile = Annotated[
    UniformProfile | GaussianProfile, Kinds("kind", default="uniform", level=EXPERT)
]


class CollimatedSource(AnySource):
    """Light from infinitely far that fills the entrance face: the sun, a laser beam."""

    model_config = ConfigDict(title="Collimated light")

    kind: Literal["collimated"]
    rays: Annotated[
        tuple[RayCount, RayCount],
        EXPERT,
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

    def resized(self, factor: float) -> Self:
        """See `AnySource.resized`."""
        return self.model_copy(update={"angular_diameter": factor * self.angular_diameter})

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
        """Unit vectors (k, 3) of places (k,) of the unit disc, even as these in solid angle."""
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
                    "{radius:g} is too narrow for a {optic} that is {width:g} wide; at least "
                    "{least:g}",
                    radius=radius,
                    optic=optic.called,
                    width=2 * max(optic.half_width),
                    least=least,
                ),
            )
        if math.isfinite(radius):
            limits.check_lengths(
                [("source.profile.radius", radius)], optic.half_width, limits.FARTHEST
            )


Angle = Annotated[float, Field(ge=-360, le=360)]


class MeasuredSource(PlacedSource):
    """What light of files has in common: a file, where the lamp stands, and how it is turned."""

    endings: ClassVar[tuple[str, ...]]  # of the names of its files

    file: str
    position: Place
    rotation: Annotated[
        tuple[Angle, Angle, Angle],
        ANGLE,
        PLACE,
        EXPERT,
        about(
            "Rotation",
            "How the lamp is turned about its own origin: about its x, then about its new y, then "
            "about its new z.",
        ),
    ] = (0.0, 0.0, 0.0)
    rays: Rays = 500_000
    _content: Content = PrivateAttr(default_factory=Content)

    def __eq__(self, other: object) -> bool:
        """Whether all fields are equal; what the file holds is no setting."""
        if not isinstance(other, MeasuredSource):
            return NotImplemented
        ours, theirs = ((type(each), each.continuous, dict(each)) for each in (self, other))
        return ours == theirs

    @classmethod
    def defaults_for(cls, scene: "Scene") -> dict[str, Any]:
        """Where the scene's source is."""
        return {"position": scene.source.place or in_front(scene.optic)}

    @property
    def content(self) -> bytes | None:
        """What the file holds, where that is carried along."""
        return self._content.data

    @property
    def light_files(self) -> Mapping[str, bytes | None]:
        """Its file."""
        return {self.file: self.content}

    def carrying(self, files: Mapping[str, bytes | None]) -> Self:
        """The same source with what its file holds; see `AnySource.carrying`."""
        data = files.get(self.file)
        if data is None or data is self.content:
            return self
        copy = self.model_copy()
        copy._content = replace(self._content, data=data)
        return copy

    @property
    def unit(self) -> str:
        """Unit of the scene's lengths."""
        return self._content.unit

    def measured_in(self, unit: str) -> None:
        """See `AnySource.measured_in`."""
        self._content = replace(self._content, unit=unit)

    def check(self) -> None:
        """Refuse a file that is surely of another kind."""
        if PurePath(self.file).suffix.lower() not in self.endings:
            raise Refused(
                "source.file",
                Message(
                    "'{file}' is none of these: {endings}",
                    file=self.file,
                    endings=", ".join(self.endings),
                ),
            )

    @property
    def matrix(self) -> Array:
        """Turns directions of the file into those of the scene, shape (3, 3)."""
        return tilted(self.rotation)

    def standing(self, place: Array | None, turn: Array) -> Self:
        """See `AnySource.standing`; of a mirror image it is an approximation."""
        there = self.position if place is None else tuple(place.tolist())
        rotation = tilt_of(proper(turn @ self.matrix))
        return self.model_copy(update={"position": there, "rotation": rotation})


class PhotometricSource(MeasuredSource):
    """A small lamp whose intensity by direction stands in a photometric file."""

    model_config = ConfigDict(title="Photometric file")
    endings = (".ies", ".ldt")

    kind: Literal["photometric"]
    file: Annotated[
        str,
        FILE,
        about(
            "File",
            "Intensity by direction, in a file of IES LM-63 (.ies) or EULUMDAT (.ldt). Its nadir "
            "looks along +z, C0 along +x and C90 along −y; the beam axis of types A and B along "
            "+z, V upwards along +y and H to the right along −x. A relative path starts at the "
            "scene file's folder.",
            min_length=1,
        ),
    ]
    position: Annotated[
        Place,
        LENGTH,
        PLACE,
        about("Position", "Where the lamp is: x, y and z. It has to stand before the lens."),
    ]

    @property
    def sharp(self) -> PointSource:
        """As if it shone alike everywhere."""
        return PointSource(kind="point", position=self.position, **self.colour)


class RayFileSource(MeasuredSource):
    """A lamp whose rays stand in a ray file, as they were measured or simulated."""

    model_config = ConfigDict(title="Ray file")
    endings = (".tm25ray", ".dat", ".csv", ".txt")

    kind: Literal["ray_file"]
    file: Annotated[
        str,
        FILE,
        about(
            "File",
            "Rays in a file of IES TM-25 (.tm25ray), of OpticStudio (.dat), or of text (.csv, .txt)"
            " with the columns x, y, z, l, m, n and flux. A relative path starts at the scene "
            "file's folder.",
            min_length=1,
        ),
    ]
    position: Annotated[
        Place,
        LENGTH,
        PLACE,
        about("Position", "Where the origin of the file is: x, y and z."),
    ] = (0.0, 0.0, 0.0)
    file_unit: Annotated[
        Literal["mm", "cm", "m", "inch"] | None,
        EXPERT,
        about(
            "Unit of the file",
            "Unit of the lengths in the file. Left empty, it is the one that the file names.",
        ),
    ] = None
    _sharp: bool = PrivateAttr(default=False)

    @property
    def continuous(self) -> bool:
        """As its rays start anywhere; only the file states how large that place is."""
        return not self._sharp

    @property
    def sharp(self) -> Self:
        """As if all its rays came from the middle of where they start."""
        copy = self.model_copy()
        copy._sharp = True
        return copy


Source = Annotated[
    CollimatedSource | PointSource | GridSource | PhotometricSource | RayFileSource | AreaSource,
    Kinds("kind"),
]
