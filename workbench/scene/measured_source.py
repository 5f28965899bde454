"""Light that was measured: a lamp's intensity by direction, or its rays, in a file."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import PurePath
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, Self

from pydantic import ConfigDict, Field, PrivateAttr

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.messages import Message
from workbench.scene.element import Element, Place
from workbench.scene.fields import FILE, LENGTH, PLACE, Measure, about
from workbench.scene.part import Content
from workbench.scene.points import PointSource
from workbench.scene.source import MOST_RAYS, AnySource, check_place, in_front
from workbench.scene.turning import proper, tilt_of, tilted

if TYPE_CHECKING:
    from workbench.scene.task import Scene

Angle = Annotated[float, Field(ge=-360, le=360)]
_FileUnit = Literal["mm", "cm", "m", "inch"]
_Rotation = Annotated[
    tuple[Angle, Angle, Angle],
    Measure("°", "degrees"),
    PLACE,
    about(
        "Rotation",
        "How the lamp is turned about its own origin: about its x, then about its new y, then "
        "about its new z.",
    ),
]
_Rays = Annotated[
    int,
    about(
        "Rays",
        "Rays in each iteration of the paper's method, and for derivative maps. Automatic chooses "
        "its own.",
        ge=1,
        le=MOST_RAYS,
    ),
]


class MeasuredSource(AnySource):
    """What light of files has in common: a file, where the lamp stands, and how it is turned."""

    endings: ClassVar[tuple[str, ...]]
    """Endings of the names of its files."""

    file: str
    position: Place
    rotation: _Rotation = (0.0, 0.0, 0.0)
    rays: _Rays = 500_000
    _content: Content = PrivateAttr(default_factory=Content)

    def __eq__(self, other: object) -> bool:
        """Whether all fields are equal; what the file holds is no setting."""
        if not isinstance(other, MeasuredSource):
            return NotImplemented
        ours, theirs = ((type(each), each.continuous, dict(each)) for each in (self, other))
        return ours == theirs

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
        """Keep the unit of the scene's lengths; see `AnySource.measured_in`."""
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
    def place(self) -> Place:
        """Where the origin of its file is."""
        return self.position

    @property
    def ray_count(self) -> int:
        """As many as it asks for."""
        return self.rays

    @property
    def matrix(self) -> Array:
        """Turns directions of the file into those of the scene, shape (3, 3)."""
        return tilted(self.rotation)

    def placed(self, place: Place) -> Self:
        """The same source elsewhere."""
        return self.model_copy(update={"position": place})

    def standing(self, place: Array | None, turn: Array) -> Self:
        """See `AnySource.standing`; of a mirror image it is an approximation."""
        there = self.position if place is None else tuple(place.tolist())
        rotation = tilt_of(proper(turn @ self.matrix))
        return self.model_copy(update={"position": there, "rotation": rotation})

    def check_before(self, optic: Element) -> None:
        """Refuse an optic that is not behind it, or too near or too far, as a point does."""
        check_place("source.position", self.position, optic)


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

    @classmethod
    def defaults_for(cls, scene: "Scene") -> dict[str, Any]:
        """Where the scene's source is."""
        return {"position": scene.source.place or in_front(scene.optic)}

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
        _FileUnit | None,
        about(
            "Unit of the file",
            "Unit of the lengths in the file. Left empty, it is the one that the file names.",
        ),
    ] = None
    _sharp: bool = PrivateAttr(default=False)

    @classmethod
    def defaults_for(cls, scene: "Scene") -> dict[str, Any]:
        """Where the scene's source is."""
        return {"position": scene.source.place or in_front(scene.optic)}

    @property
    def continuous(self) -> bool:
        """As its rays start anywhere; how large that place is, only the file tells."""
        return not self._sharp

    @property
    def sharp(self) -> Self:
        """As if all its rays came from the middle of where they start."""
        copy = self.model_copy()
        copy._sharp = True
        return copy
