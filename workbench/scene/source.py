"""What all light sources have in common."""

import math
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Annotated, Any, Literal, NamedTuple, Self

import numpy as np
from pydantic import Field, PrivateAttr

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.levels import EXPERT
from workbench.messages import Message
from workbench.scene import limits
from workbench.scene.element import DEFAULT_WAVELENGTH, Element
from workbench.scene.fields import Fallback, Measure, about
from workbench.scene.part import Part, Positive
from workbench.scene.receiver import AnyReceiver
from workbench.scene.turning import Place, proper

if TYPE_CHECKING:
    from workbench.scene.task import Scene

# A new source stands this many lens half-widths before the entrance face.
_DISTANCE = 5.0
MOST_RAYS = 1 << 24  # that a source may ask for
Rays = Annotated[
    int,
    EXPERT,
    about(
        "Rays",
        "Rays in each iteration of the paper's method, and for derivative maps. Automatic "
        "chooses its own.",
        ge=1,
        le=MOST_RAYS,
    ),
]
MOST_LINES = 16
"""Of a spectrum: each takes a trace of its own."""

Lines = tuple[tuple[Annotated[float, Field(gt=0)], Annotated[float, Field(ge=0)]], ...]


class AnySource(Part):
    """What each kind of source says of itself, so that nobody has to ask for its kind.

    By default that of light from infinity, which has no position to draw.
    """

    wavelength_um: Annotated[
        Positive | None,
        Measure("µm"),
        Fallback("source.wavelength"),
        EXPERT,
        about(
            "Wavelength",
            "Vacuum wavelength at which the indices of materials are taken. Left empty, it is "
            "0.5876 µm (helium d), or the mean of the spectrum.",
        ),
    ] = None
    spectrum: Annotated[
        Lines | None,
        EXPERT,
        about(
            "Spectrum",
            "Up to 16 lines of light in place of one wavelength: wavelength in µm and part of the "
            "flux, as in 0.45, 0.3; 0.55, 0.5; 0.63, 0.2. Each line is traced with its own "
            "refractive indices, and an image is the sum of all lines. The parts may have any sum.",
        ),
    ] = None

    _turn: tuple[tuple[float, ...], ...] | None = PrivateAttr(default=None)

    @property
    def turn(self) -> Array | None:
        """Its unit vectors as the columns of a matrix (3, 3); None where it faces +z.

        In files all sources do, or say how they are turned. In the coordinates of a tilted element
        they do not.
        """
        return None if self._turn is None else np.array(self._turn)

    @property
    def facing(self) -> Array:
        """The unit vector (3,) along which it shines where intensity falls with the cosine."""
        return np.array([0.0, 0.0, 1.0] if self._turn is None else [row[2] for row in self._turn])

    def standing(self, place: Array | None, turn: Array) -> Self:
        """Return the same source in other coordinates.

        `place` (3,): where its middle is there; None of light from infinitely far; `turn` (3, 3):
        takes its directions there: a rotation, or one of a mirror image, as behind a mirror.
        """
        own = proper(turn if self._turn is None else turn @ np.array(self._turn))
        copy = self.model_copy() if place is None else self.placed(tuple(place.tolist()))
        straight = own[2, 2] == 1 and np.array_equal(np.abs(own), np.eye(3))  # each is symmetric
        copy._turn = None if straight else tuple(map(tuple, own.tolist()))
        return copy

    @property
    def wavelength(self) -> float:
        """Vacuum wavelength in µm: as stated, or the mean of its flux, or the helium d line."""
        return self.stated_wavelength or DEFAULT_WAVELENGTH

    @property
    def stated_wavelength(self) -> float | None:
        """Vacuum wavelength in µm, of a spectrum the mean; None if nothing is stated."""
        return mean_wavelength(self.spectrum) if self.spectrum else self.wavelength_um

    @property
    def colour(self) -> dict[str, Any]:
        """The fields of its wavelengths, for a source that stands for it."""
        return {"wavelength_um": self.wavelength_um, "spectrum": self.spectrum}

    @property
    def along_axis(self) -> bool:
        """Whether all its rays go along +z."""
        return False

    @property
    def continuous(self) -> bool:
        """Whether its light comes from everywhere in a disc or an area.

        Then it says nothing of a number of points, and as many origins stand for it as its blur
        needs.
        """
        return False

    @property
    def place(self) -> Place | None:
        """Its middle, scene units."""
        return None

    @property
    def heading(self) -> Array:
        """Where the light of its middle goes if it comes from infinitely far, shape (3,)."""
        return np.array([0.0, 0.0, 1.0])

    @property
    def lumens(self) -> float | None:
        """Its flux, lm, where the scene says it."""
        return None

    @property
    def of_any_flux(self) -> "AnySource":
        """The same source without its flux, which no lens depends on."""
        return self

    @property
    def ray_count(self) -> int:
        """Rays that it asks for in all, at least."""
        return 1

    @property
    def samples(self) -> tuple[int, int]:
        """As many as a grid of its rays has along x and y."""
        return math.isqrt(self.ray_count), math.isqrt(self.ray_count)

    @property
    def mirrored(self) -> tuple[bool, bool]:
        """Whether its light is surely its own mirror image in x, in y."""
        return False, False

    @property
    def sharp(self) -> "AnySource":
        """Light of one origin that stands for it in rough plans."""
        return self

    @property
    def point_count(self) -> int:
        """How many points emit its light; infinitely far light counts as that of one."""
        return 1

    @property
    def redrawn(self) -> bool:
        """Whether each iteration of the paper's method has rays of its own."""
        return False

    @property
    def subdivisions(self) -> tuple[int, int] | None:
        """Of each knot span, where its rays meet triangles in place of the B-spline itself."""
        return None

    @property
    def nearest_z(self) -> float:
        """Where it comes closest to the lens, scene units."""
        return -math.inf if self.place is None else self.place[2]

    def blur(self, optic: Element, receiver: AnyReceiver) -> tuple[float, float]:
        """Widths along x and y of what one place of the lens makes of it on the receiver.

        In its coordinates, about: as behind a pinhole.
        """
        return 0.0, 0.0

    @property
    def blur_shape(self) -> Literal["rectangle", "ellipse"]:
        """What that is like."""
        return "rectangle"

    @property
    def blur_points(self) -> tuple[int, int] | None:
        """How many points along x and y it is made of; None where it is evenly bright."""
        return None

    @property
    def light_files(self) -> Mapping[str, bytes | None]:
        """Files that hold its light, by name: what they hold, where that is carried along."""
        return {}

    def carrying(self, files: Mapping[str, bytes | None]) -> Self:
        """The same source with what its files hold, as far as that is given."""
        return self

    def measured_in(self, unit: str) -> None:
        """Keep the unit of the scene's lengths, if it is needed: a file has one of its own."""

    def check_before(self, optic: Element) -> None:
        """Refuse a lens that it cannot light, with the path of the field and what is allowed."""

    def seen(self, most: tuple[int, int]) -> Array:
        """Points to draw it with, shape (n, 3): no more than ``most`` along x and y."""
        return np.zeros((0, 3)) if self.place is None else np.array([self.place])

    def face(self, optic: Element, z: float) -> Array:
        """What shines, to be drawn: a grid of points of shape (m, n, 3), empty for points.

        A disc infinitely far away is drawn at ``z``, as wide as the middle of the lens sees it.
        """
        return np.zeros((0, 0, 3))

    @property
    def turns(self) -> bool:
        """Whether its light is another one when it is turned about its middle."""
        return True

    @property
    def moves(self) -> bool:
        """Whether its light is another one when it stands elsewhere."""
        return self.place is not None

    @property
    def corners(self) -> Array:
        """Points by which it is widened, shape (n, 3)."""
        return np.zeros((0, 3))

    def placed(self, place: Place) -> Self:
        """The same source with its middle elsewhere."""
        return self

    def shrunk(self, factor: float) -> Self:
        """The same source of another size about its middle."""
        return self

    def resized(self, factor: float) -> Self:
        """The same source of another size, or of another angular size."""
        return self.shrunk(factor)

    def widened(self, corner: Array, digits: int) -> Self:
        """The same source with a corner at a place, shape (3,); lengths have so many decimals."""
        return self


class PlacedSource(AnySource):
    """A source that stands somewhere before the first element."""

    if TYPE_CHECKING:  # each kind has these fields, at their places in the file
        position: Place
        rays: int

    @property
    def place(self) -> Place:
        """Its position."""
        return self.position

    @property
    def ray_count(self) -> int:
        """All its rays."""
        return self.rays

    def placed(self, place: Place) -> Self:
        """See `AnySource.placed`."""
        return self.model_copy(update={"position": place})

    def check_before(self, optic: Element) -> None:
        """Refuse an element that is not behind it, or too near or too far."""
        check_place("source.position", (*self.position[:2], self.nearest_z), optic)


def check_place(path: str, place: Place, optic: Element) -> None:
    """Refuse light from a place that is not before all of an element, too near or too far.

    Raises `Refused` with its coordinate or its way, and what is possible.
    """
    x, y, z = place
    aside = [(f"{path}[0]", x), (f"{path}[1]", y)]
    limits.check_lengths(aside, optic.half_width, limits.FARTHEST)
    front, size, way = optic.front_called, max(optic.half_width), optic.front_z - z
    if z >= optic.lowest:
        behind = Message(
            "{z:g} is not before {front}; less than {most:g}", z=z, front=front, most=optic.lowest
        )
        raise Refused(f"{path}[2]", behind)
    there = {"way": way, "front": front, "optic": optic.called, "width": 2 * size}
    least, most = limits.NEAREST * size, limits.FARTHEST * size
    if way < least:
        near = Message(
            "{way:g} before {front} is too near for a {optic} that is {width:g} wide; at least "
            "{least:g}",
            least=least,
            **there,
        )
        raise Refused(f"{path}[2]", near)
    if way > most:
        far = Message(
            "{way:g} before {front} is too far for a {optic} that is {width:g} wide; at most "
            "{most:g}, or collimated light",
            most=most,
            **there,
        )
        raise Refused(f"{path}[2]", far)


def disc() -> Array:
    """Middle and rim of the unit disc at z = 0, a grid of points of shape (2, n, 3)."""
    angle = np.linspace(0, 2 * math.pi, 65)
    rim = np.stack([np.cos(angle), np.sin(angle), np.zeros(65)], axis=-1)
    return np.stack([0 * rim, rim])


def in_front(optic: Element) -> Place:
    """On the axis, far enough away for the lens to bend all its light."""
    return (0.0, 0.0, optic.front_z - _DISTANCE * max(optic.half_width))


def mean_wavelength(spectrum: Iterable[tuple[float, float]]) -> float:
    """Return the mean wavelength of some lines, weighted by their flux."""
    lines = list(spectrum)
    if len(lines) == 1:
        return lines[0][0]
    return sum(each * part for each, part in lines) / sum(part for _, part in lines)


class Line(NamedTuple):
    """One line of the light of a scene."""

    scene: "Scene"  # the scene in light of one wavelength
    part: float  # the part of the flux that has it; the parts of all lines add up to 1


def lines_of(scene: "Scene") -> tuple[Line, ...]:
    """Return the lines of a scene; those of equal indices in all elements count as one."""
    spectrum = scene.source.spectrum
    if spectrum is None:
        return (Line(scene, 1.0),)
    alike: dict[tuple[float, ...], list[tuple[float, float]]] = {}
    for wavelength, part in spectrum:
        if part:
            indices = tuple(element.lit(wavelength).index for element in scene.elements)
            alike.setdefault(indices, []).append((wavelength, part))
    total = sum(part for _, part in spectrum)
    lines = []
    for found in alike.values():
        source = scene.source.model_copy(
            update={"wavelength_um": mean_wavelength(found), "spectrum": None}
        )
        part = sum(part for _, part in found) / total if len(alike) > 1 else 1.0
        lines.append(Line(scene.model_copy(update={"source": source}), part))
    return tuple(lines)


def check_spectrum(scene: "Scene") -> None:
    """Refuse a spectrum that makes no light, or for which a material has no data.

    Raises `Refused` with the path of the field in the scene, the value and what is allowed.
    """
    source, spectrum = scene.source, scene.source.spectrum
    if spectrum is None:
        return
    path = "source.spectrum"
    if source.wavelength_um is not None:
        both = Message(
            "given together with a wavelength of {wavelength:g} µm; one of both",
            wavelength=source.wavelength_um,
        )
        raise Refused(path, both)
    if not 1 <= len(spectrum) <= MOST_LINES:
        count = Message(
            "{count} lines are given; 1 to {most}", count=len(spectrum), most=MOST_LINES
        )
        raise Refused(path, count)
    if not any(part for _, part in spectrum):
        raise Refused(path, Message("all parts of the flux are 0; one above 0"))
    for number, (wavelength, _) in enumerate(spectrum):
        for element in scene.elements:
            try:
                _ = element.lit(wavelength).index
            except Refused as refused:
                if refused.path == "source.wavelength_um":  # else the material is refused later
                    raise Refused(f"{path}[{number}][0]", refused.reason) from None
