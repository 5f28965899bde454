"""What all elements of an optical train have in common."""

import math
from abc import abstractmethod
from collections.abc import Mapping
from functools import cache
from itertools import product
from typing import Annotated, Any, ClassVar, Literal, Self

import numpy as np
import numpy.typing as npt

from workbench.arrays import Array
from workbench.errors import Refused, refused_within
from workbench.levels import EXPERT, LIMITS, full_size
from workbench.messages import Message
from workbench.scene import limits
from workbench.scene.fields import LENGTH, PLACE, AutoNet, FieldDescription, about, describe
from workbench.scene.losses import Loss, TakesLight
from workbench.scene.part import Part, Positive
from workbench.scene.spline_face import Face, PlacedBase, PlacedFace, SplineFace, check_net
from workbench.scene.turning import Place, Standing, Tilt

DEFAULT_WAVELENGTH = 0.5876
"""Vacuum wavelength in µm of light whose source does not state one: the helium d line."""


class Element(Standing, Part):
    """One entry of an optical train: a lens, a mirror or a diffuser."""

    # Names within a sentence: of it, its last freeform face, its solid part, what light meets first
    called: ClassVar[str]
    face_called: ClassVar[str]
    body_called: ClassVar[str]
    front_called: ClassVar[str]
    most_faces: ClassVar[int]  # how many of its faces can be freeform
    onwards: ClassVar[int]  # 1 if light goes on to +z behind it, -1 if it goes back to -z
    losses: ClassVar[Mapping[str, Loss]]  # at any of its kind, by the names of the light account

    kind: str
    name: Annotated[
        str,
        EXPERT,
        about(
            "Name",
            "Name of the element; letters, digits, - and _.",
            pattern=r"^[A-Za-z0-9_-]{1,40}$",
        ),
    ]
    position: Annotated[
        Place,
        LENGTH,
        PLACE,
        about("Position", "Where the vertex of its front face stands: x, y and z."),
    ] = (0.0, 0.0, 0.0)
    tilt: Annotated[
        Tilt,
        about(
            "Tilt",
            "How the element is turned about its front vertex: about its x, then about its new y, "
            "then about its new z.",
        ),
    ] = (0.0, 0.0, 0.0)
    half_width: Annotated[
        tuple[Positive, Positive],
        LENGTH,
        full_size("Full width and height of the element. All of it is lit."),
        about("Half width", "Half of its extent along x and y. All of it is lit."),
    ]
    outline: Annotated[
        Literal["rectangle", "ellipse"],
        LIMITS,
        about(
            "Outline",
            "The rectangle of its size, or the ellipse within. Light beside it misses it.",
        ),
    ] = "rectangle"

    @classmethod
    @cache
    def fields(cls) -> tuple[FieldDescription, ...]:
        """What its fields say of themselves, those of all elements first."""
        return tuple(describe(name, field) for name, field in cls.model_fields.items())

    @property
    @abstractmethod
    def placed_faces(self) -> tuple[PlacedFace, ...]:
        """Its faces in the order in which light meets them."""

    @property
    def designed_face(self) -> str:
        """Id of its last face, which is the one that is shaped if only one is."""
        return self.placed_faces[-1].name

    @property
    def designed_front(self) -> str | None:
        """Id of its front face where that is shaped together with the last one."""
        first, *others = self.placed_faces
        return first.name if others and first.face.designed else None

    @property
    def corners(self) -> Array:
        """Corners (8, 3) in the scene of the box around an element before its design."""
        bases = (PlacedBase(placed.face.base, placed.z) for placed in self.placed_faces)
        ends = [z for base in bases for z in base.extent(self.half_width)]
        sides = [(-r, r) for r in self.half_width]
        return self.in_scene(np.array(list(product(*sides, (min(ends), max(ends))))))

    def nearest_to(self, other: "Element") -> float:
        """The z in the coordinates of another element at which a fixed one comes closest to it."""
        z = other.seen(self.corners)[:, 2]
        return float(z.min() if other.onwards > 0 else z.max())

    @property
    def straightened(self) -> Self:
        """The element as it stands in its own coordinates, see `origin`."""
        place = {"position": (0.0, 0.0, self.position[2]), "tilt": (0.0, 0.0, 0.0)}
        return self if self.upright else self.model_copy(update=place)

    @property
    def designed(self) -> bool:
        """Whether one of its faces is a B-spline, which the design shapes unless it is fixed."""
        return any(placed.face.designed for placed in self.placed_faces)

    @property
    def undesigned(self) -> Self:
        """The element with all of its faces fixed as they are before the design."""
        element = self
        for placed in self.placed_faces:
            element = element.with_face(placed.name, placed.face.undesigned)
        return element

    @property
    def free(self) -> bool:
        """Whether the design changes one of its faces."""
        faces = (placed.face for placed in self.placed_faces)
        return any(isinstance(face, SplineFace) and not face.fixed for face in faces)

    @property
    def fixed_faces(self) -> tuple[tuple[PlacedFace, SplineFace], ...]:
        """Its B-spline faces that a design leaves as they are, and where they stand."""
        return tuple(
            (placed, placed.face)
            for placed in self.placed_faces
            if isinstance(placed.face, SplineFace) and placed.face.fixed
        )

    @property
    def face_files(self) -> dict[str, bytes | None]:
        """Files of the control heights of its fixed faces, by name."""
        return {f.heights: f.content for _, f in self.fixed_faces if f.heights is not None}

    def carrying(self, files: Mapping[str, bytes | None]) -> Self:
        """Return the element with the contents of the files of its fixed faces, where given."""
        element = self
        for placed, face in self.fixed_faces:
            data = files.get(face.heights or "")
            if data is not None and data is not face.content:
                with refused_within(placed.path):
                    element = element.with_face(placed.name, face.carrying(data))
        return element

    def lit(self, wavelength_um: float) -> Self:
        """Return the element as light of a wavelength meets it."""
        return self

    def denser(self, off: float) -> Self:
        """Return the element with a refractive index that is off; one without glass as it is."""
        return self

    @property
    def _shaped(self) -> PlacedFace:
        return self.placed_faces[-1]

    @property
    def spline(self) -> SplineFace:
        """The face of `designed_face`, which is a B-spline; raises `TypeError` if it is none."""
        face = self._shaped.face
        if not isinstance(face, SplineFace):
            raise TypeError(f"the {self._shaped.name} face of {self.name} is no B-spline")
        return face

    @abstractmethod
    def with_face(self, name: str, face: Face) -> Self:
        """Return the element with another face in place of the one with an id."""

    def with_front(self, face: Face) -> Self:
        """Return the element with another front face."""
        return self.with_face(self.placed_faces[0].name, face)

    def shaped(self, name: str | None = None, **changes: Any) -> Self:
        """Return the element with changes of a B-spline face, by default `designed_face`."""
        faces = {placed.name: placed.face for placed in self.placed_faces}
        name = name or self.designed_face
        return self.with_face(name, faces[name].model_copy(update=changes))

    @property
    def degree(self) -> tuple[int, int]:
        """Degrees of the face that the design shapes."""
        return self.spline.degree

    @property
    def control_points(self) -> tuple[int, int] | AutoNet:
        """Control points of that face, as the scene states them."""
        return self.spline.control_points

    @property
    def height_range(self) -> tuple[float, float] | None:
        """Height range of that face, as the scene states it."""
        return self._shaped.face.height_range

    @property
    def base(self) -> PlacedBase:
        """Base of that face at its place in the scene; of a fixed face, the face itself."""
        return PlacedBase(self._shaped.face.base, self._shaped.z)

    @property
    def entrance(self) -> Face:
        """The face before the one that the design shapes; a plane where there is none."""
        return self.placed_faces[0].face

    @property
    @abstractmethod
    def front_z(self) -> float:
        """The plane of the aperture: light that passes the outline there reaches the element."""

    @property
    def datum(self) -> float:
        """The z from which paths of slanted light count: near the faces."""
        return self.front_z

    @property
    def entrance_range(self) -> tuple[float, float]:
        """The lowest and the highest z that the entrance face can come to."""
        low, high = self.entrance_offsets
        return self.datum + low, self.datum + high

    @property
    def entrance_offsets(self) -> tuple[float, float]:
        """The same from its place on the axis."""
        return 0.0, 0.0

    @property
    def leaving_z(self) -> float:
        """About where light leaves it, as far as that is known before a design."""
        return self.front_z

    @property
    def lowest(self) -> float:
        """The z that no point of it can be below: sources stand before that."""
        return self.z_min

    @property
    def highest(self) -> float:
        """The z that no point of its face can be above, as far as it is known before a run."""
        return self.z_max

    @property
    def edge_z(self) -> float:
        """The z that its face cannot be beyond, on the side to which light goes."""
        return self.highest if self.onwards > 0 else self.lowest

    @property
    @abstractmethod
    def z_min(self) -> float:
        """The z that its face is kept above whatever the height range is."""

    @property
    @abstractmethod
    def z_max(self) -> float:
        """The z that its face is kept below whatever the height range is; infinite without one."""

    @property
    def index(self) -> float:
        """Refractive index of what is before its face."""
        return 1.0

    @property
    def steepest(self) -> float:
        """Tangent of the largest angle to the axis at which light may come to its face, about."""
        return 1.0

    @property
    @abstractmethod
    def least_loss(self) -> float:
        """The least part of the light that its last face loses."""

    @property
    def least_thickness(self) -> float:
        """The least that the solid part may be thick, by itself."""
        return 0.0

    @property
    @abstractmethod
    def deflection(self) -> float:
        """By how many radians a small slope of the face turns light, over the slope."""

    @property
    @abstractmethod
    def held_by(self) -> Literal["height_range", "max_thickness", "screen"]:
        """What keeps its face below, if no height range does."""

    def bounded(
        self, source_z: float, receiver_z: float, several: bool = False, part: float = 1.0
    ) -> Self:
        """The element with all that limits its heights.

        `source_z`, `receiver_z`: where its source and its receiver are nearest to it; `several`:
        whether it makes several images; `part`: of the distance to the receiver, that it may rise
        where neither a height range nor a maximal thickness is given.
        """
        return self

    def ranged(self, low: float, high: float) -> Self:
        """The element with another height range; nothing else of it moves."""
        return self.shaped(height_range=(low, high))

    @abstractmethod
    def flat_z(self, heights: Array) -> float:
        """Where the flat side of the solid part is, if the face has these control heights."""

    def face_in_words(self, face: str) -> str:
        """What one of its freeform faces is called within a sentence."""
        return self.face_called if face == self.designed_face else "entrance face"

    def outwards(self, face: str) -> int:
        """1 if one of its freeform faces is seen from +z, -1 if from -z."""
        return self.onwards if face == self.designed_face else -1

    def place_of(self, face: str, x: npt.ArrayLike, y: npt.ArrayLike) -> Array:
        """Where one of its freeform faces stands before the design, z at (x, y)."""
        if face == self.designed_face:
            return self.base.height_at(x, y)
        return np.full(np.broadcast(x, y).shape, self.datum)

    def range_of(self, face: str) -> tuple[float, float] | None:
        """How far one of its freeform faces may be from its place; None if nobody says so."""
        return self.height_range if face == self.designed_face else self.entrance_offsets

    @property
    def net_shape(self) -> tuple[int, int]:
        """As `known_shape`; raises `Refused` where the program has yet to choose."""
        if self.known_shape is None:
            path = f"{self._shaped.path}.control_points"
            raise Refused(path, Message("'auto' needs a target to choose for; numbers"))
        return self.known_shape

    @property
    def known_shape(self) -> tuple[int, int] | None:
        """Numbers of control points along x and y; None where they have yet to be chosen."""
        if not self.designed:
            return None
        points = self.control_points
        return points.shape if isinstance(points, AutoNet) else points

    def with_net(self, shape: tuple[int, int] | None) -> Self:
        """The same for whose ``"auto"`` the program has chosen a net; None takes a choice back."""
        auto = isinstance(self.control_points, AutoNet)
        return self.shaped(control_points=AutoNet(shape)) if auto else self

    def limits_at(self, x: npt.ArrayLike, y: npt.ArrayLike) -> tuple[Array, Array]:
        """Lowest and highest z, the latter perhaps infinite, of control points at (x, y)."""
        low, high = self.height_range or (-math.inf, math.inf)
        base = self.base.height_at(x, y)
        return np.maximum(base + low, self.z_min), np.minimum(base + high, self.z_max)

    @classmethod
    def all_losses(cls) -> dict[str, Loss]:
        """Its losses, and those that its fields bring, by name."""
        losses = dict(cls.losses)
        for field in cls.fields():
            if mark := field.mark(TakesLight):
                losses[mark.name] = mark.loss
        return losses

    @property
    def possible_losses(self) -> dict[str, Loss]:
        """Its losses, and those of its fields that take light, by name."""
        losses = self.all_losses()
        for field in self.fields():
            if (mark := field.mark(TakesLight)) and not self.differs(field.name):
                del losses[mark.name]
        return losses

    def check_element(self) -> None:
        """Refuse an element that cannot be computed with or made; paths are from the element."""
        limits.check_width(self.half_width)
        places = [(f"position[{axis}]", place) for axis, place in enumerate(self.position)]
        limits.check_lengths(places, self.half_width, limits.FARTHEST)
        heights = [("position[2]", self.position[2]), *self._own_heights()]
        limits.check_lengths(heights, self.half_width, limits.HEIGHT)
        ellipse = self.outline == "ellipse"
        rim = max(self.half_width) if ellipse else math.hypot(*self.half_width)
        for placed in self.placed_faces:
            with refused_within(placed.path):
                placed.face.check_face(self.called, self.half_width, rim)
                if isinstance(placed.face, SplineFace) and self.designed:
                    given = placed.face.net(self.known_shape) if self.known_shape else None
                    if given is not None:
                        check_net("control_points", *given)

    def _own_heights(self) -> list[tuple[str, float]]:
        """Names and values of further fields that are heights of the element."""
        return []
