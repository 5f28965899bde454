"""B-spline faces, their bases, and `Face`, the list of all shapes."""

import io
import math
from abc import abstractmethod
from fractions import Fraction
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, NamedTuple, Self

import numpy as np
import numpy.typing as npt
from pydantic import ConfigDict, PrivateAttr

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.levels import EXPERT, LIMITS
from workbench.messages import Message
from workbench.powers import rounded
from workbench.scene import limits
from workbench.scene.faces import LARGEST_NET, ConicFace, Degree, FixedFace, NetShape, PlaneFace
from workbench.scene.fields import FILE, LENGTH, RANGE, AutoNet, NumbersOrAuto, about
from workbench.scene.part import Content, Kinds, Part, Positive

if TYPE_CHECKING:
    from workbench.scene.task import Scene


def check_net(path: str, shape: tuple[int, int], degree: tuple[int, int]) -> None:
    """Refuse a net with fewer control points than its degrees need.

    Raises
    ------
    Refused
        With the number, and the least.
    """
    for axis, count in enumerate(shape):
        if count < degree[axis] + 1:
            raise Refused(
                f"{path}[{axis}]",
                Message(
                    "{count} is too few for degree {degree}; at least {least}",
                    count=count,
                    degree=degree[axis],
                    least=degree[axis] + 1,
                ),
            )


class _AnyBase(Part):
    """A base has the shape of a fixed face."""

    if TYPE_CHECKING:  # each kind has this field
        shape: str

    @property
    @abstractmethod
    def face(self) -> FixedFace:
        """The fixed face of the same shape."""

    def sag(self, x: npt.ArrayLike, y: npt.ArrayLike) -> Array:
        """Height above the vertex, scene units; x and y broadcast."""
        return self.face.sag(x, y)

    def extent(self, half_width: tuple[float, float]) -> tuple[float, float]:
        """Lowest and highest sag over the aperture."""
        return self.face.extent(half_width)

    def check_within(self, path: str, called: str, half_width: tuple[float, float]) -> None:
        """Refuse a base that ends within the rim; the path is that of the base."""


class FlatBase(_AnyBase):
    """A plane across the axis."""

    model_config = ConfigDict(title="Flat")

    shape: Literal["flat"] = "flat"

    @property
    def face(self) -> PlaneFace:
        """A plane."""
        return PlaneFace()


class SphereBase(_AnyBase):
    """A spherical cap that rises or falls towards the rim."""

    model_config = ConfigDict(title="Sphere")

    shape: Literal["sphere"] = "sphere"
    radius: Annotated[
        Positive,
        LENGTH,
        about(
            "Base radius",
            "Radius of curvature of the base; more than the half-diagonal of the lens or mirror.",
        ),
    ]
    form: Annotated[
        Literal["concave", "convex"],
        about("Base form", "Concave rises towards the rim, convex falls."),
    ] = "concave"

    @property
    def face(self) -> ConicFace:
        """A sphere."""
        return ConicFace(radius=self.radius if self.form == "concave" else -self.radius)

    @classmethod
    def defaults_for(cls, scene: "Scene") -> dict[str, Any]:
        """Shallow enough for any lens or mirror that a flat base was good for."""
        return {"radius": rounded(10 * math.hypot(*scene.optic.half_width), 2)}

    def check_within(self, path: str, called: str, half_width: tuple[float, float]) -> None:
        """Refuse a radius beyond what can be computed with, or a cap that ends within the rim."""
        path = f"{path}.radius"
        limits.check_lengths([(path, self.radius)], half_width, limits.FAR)
        if self.radius <= math.hypot(*half_width):
            raise Refused(
                path,
                Message(
                    "{radius:g} does not span the {optic}; more than its half-diagonal {least:g}",
                    radius=self.radius,
                    optic=called,
                    least=math.hypot(*half_width),
                ),
            )


Base = Annotated[FlatBase | SphereBase, Kinds("shape", default="flat")]


class PlacedBase(NamedTuple):
    """A base at its place in the scene.

    Attributes
    ----------
    base : FlatBase, SphereBase or a fixed face
        Its shape.
    height : float
        z of its vertex, scene units.
    """

    base: FlatBase | SphereBase | FixedFace
    height: float

    @property
    def shape(self) -> str:
        """Name of its kind."""
        return self.base.shape

    def height_at(self, x: npt.ArrayLike, y: npt.ArrayLike) -> Array:
        """Return z at (x, y), scene units; x and y broadcast."""
        return self.height + self.base.sag(x, y)

    def extent(self, half_width: tuple[float, float]) -> tuple[float, float]:
        """Lowest and highest z over the aperture."""
        low, high = self.base.extent(half_width)
        return self.height + low, self.height + high


class SplineFace(Part):
    """A B-spline over a base; designed unless it is fixed."""

    model_config = ConfigDict(title="B-spline")

    shape: Literal["bspline"] = "bspline"
    degree: Annotated[
        tuple[Degree, Degree],
        EXPERT,
        about(
            "Degree",
            "Polynomial degree of the B-spline along x and y. 3 gives smooth curvature.",
        ),
    ] = (3, 3)
    control_points: Annotated[
        NetShape | AutoNet,
        NumbersOrAuto(),
        EXPERT,
        about(
            "Control points",
            "Number of control points along x and y. More of them draw finer detail and take "
            "longer. Automatic takes what the target's detail, the screen's pixels and the size of "
            "the source are worth, and as many for the front face as for the back face; the "
            "paper's method then has nets like those of the paper.",
        ),
    ] = AutoNet()
    base: Annotated[
        Base,
        EXPERT,
        about("Base", "The shape of the face before the design; heights are counted from it."),
    ] = FlatBase()
    height_range: Annotated[
        tuple[float, float] | None,
        LENGTH,
        RANGE,
        LIMITS,
        about(
            "Height range",
            "How far the face may be from the base. Automatic takes what the task needs.",
        ),
    ] = None
    fixed: Annotated[
        bool,
        EXPERT,
        about("Fixed", "The design leaves the face as it is, with the control heights given."),
    ] = False
    heights: Annotated[
        str | None,
        FILE,
        EXPERT,
        about(
            "Control heights",
            "File (.npy) of the control heights of a fixed face, in the element's coordinates.",
            min_length=1,
        ),
    ] = None
    designed: ClassVar[bool] = True
    flat: ClassVar[bool] = False
    _content: Content = PrivateAttr(default_factory=Content)

    @property
    def content(self) -> bytes | None:
        """The file of its control heights, if the scene carries it."""
        return self._content.data

    @property
    def carried_heights(self) -> Array | None:
        """Control heights (n_u, n_v) of its file, in the element's coordinates; None without it."""
        return None if self.content is None else _read_heights(self.content)

    def carrying(self, data: bytes) -> "SplineFace":
        """Return the face with the content of the file of its control heights.

        Raises
        ------
        Refused
            If it is no .npy file of an array of finite numbers, or not one of this face.
        """
        n_u, n_v = _read_heights(data).shape
        check_net("heights", (n_u, n_v), self.degree)
        points = self.control_points
        if not isinstance(points, AutoNet) and points != (n_u, n_v):
            raise Refused(
                "heights",
                Message(
                    "the file has {count} control points; {given}",
                    count=f"{n_u} × {n_v}",
                    given="{} × {}".format(*points),
                ),
            )
        face = self.model_copy(update={"control_points": (n_u, n_v)})
        face._content = Content(data)
        return face

    def scaled(self, factor: Fraction) -> Self:
        """See `Part.scaled`; refuse a file of heights, whose unit is that of the scene."""
        if self.fixed and self.heights is not None:
            raise Refused(
                "unit",
                Message(
                    "the control heights in {file} are in the unit of the scene; the same unit",
                    file=self.heights,
                ),
            )
        face = super().scaled(factor)
        if self.content is not None:
            face._content = Content(heights_file(float(factor) * _read_heights(self.content)))
        return face

    @property
    def undesigned(self) -> FixedFace:
        """The fixed face that it is before the design: its base."""
        return self.base.face

    @property
    def vertex_curvature(self) -> float:
        """Curvature at the vertex of its base."""
        return self.base.face.vertex_curvature

    def net(self, other: NetShape) -> tuple[NetShape, tuple[int, int]]:
        """Numbers of control points and degrees beside another face with so many points."""
        points = self.control_points
        return other if isinstance(points, AutoNet) else points, self.degree

    def offsets(self, most: float, half_width: tuple[float, float]) -> tuple[float, float]:
        """Lowest and highest offset from the base; automatic bounds reach up to ``most``."""
        return (0.0, most) if self.height_range is None else self.height_range

    def within(self, offsets: tuple[float, float]) -> "SplineFace":
        """Return the face with these bounds."""
        return self.model_copy(update={"height_range": offsets})

    def check_face(self, called: str, half_width: tuple[float, float], rim: float) -> None:
        """Refuse a net that cannot be, an empty height range and a base that does not fit."""
        if not isinstance(self.control_points, AutoNet):
            check_net("control_points", self.control_points, self.degree)
        self.base.check_within("base", called, half_width)
        own = [(f"height_range[{end}]", z) for end, z in enumerate(self.height_range or ())]
        limits.check_lengths(own, half_width, limits.HEIGHT)
        if self.height_range is not None:
            low, high = self.height_range
            if not low < high:
                raise Refused(
                    "height_range",
                    Message("[{low:g}, {high:g}] is empty; low before high", low=low, high=high),
                )

    def remarks(self) -> dict[str, str]:
        """The control points that the program has chosen; see `Part.remarks`."""
        if isinstance(self.control_points, AutoNet) and self.control_points.shape is not None:
            return {"control_points": "{} × {}".format(*self.control_points.shape)}
        return {}


def heights_file(heights: Array) -> bytes:
    """Return the content of a file of control heights; see `SplineFace.carrying`."""
    file = io.BytesIO()
    np.save(file, heights)
    return file.getvalue()


def _read_heights(data: bytes) -> Array:
    try:
        heights = np.load(io.BytesIO(data), allow_pickle=False)
    except (ValueError, EOFError, OSError):
        heights = None
    if not (
        isinstance(heights, np.ndarray)
        and heights.ndim == 2
        and max(heights.shape) <= LARGEST_NET
        and heights.dtype.kind in "fiu"
        and np.isfinite(heights).all()
    ):
        raise Refused(
            "heights",
            Message(
                "no array of control heights; a .npy file of at most {most} × {most} finite "
                "numbers",
                most=LARGEST_NET,
            ),
        )
    return heights.astype(np.float64)


Face = Annotated[FixedFace | SplineFace, Kinds("shape", title="Shape", level=EXPERT)]


class PlacedFace(NamedTuple):
    """A face of an element."""

    name: str  # its id: name of the element, "front", "back" or "face", as in ``lens.back``
    path: str  # from the element, as in ``faces[1]``
    face: Face
    z: float  # of its vertex, scene units
