"""The lens: an entrance face, a B-spline exit face over a base."""

import math
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Annotated, Any, Literal

import numpy as np
import numpy.typing as npt
from pydantic import ConfigDict, Field, field_validator

from workbench import materials
from workbench.errors import Refused, shown
from workbench.scene import limits
from workbench.scene.auto_net import AutoNet, NumbersOrAuto
from workbench.scene.entrance import Entrance, FlatEntrance
from workbench.scene.fields import LENGTH, PLACE, RANGE, SINCE_2, Choices, Measure, about
from workbench.scene.kinds import Kinds
from workbench.scene.net import Degree, NetSize, check_net
from workbench.scene.part import NonNegative, Part, Positive

if TYPE_CHECKING:
    from workbench.scene.task import Scene

Reflectance = Annotated[float, Field(ge=0, lt=1)]
# An automatic entrance face may rise by this part of the lens's half-width.
_RISE = 0.25
_BaseHeight = Annotated[
    float, LENGTH, about("Base at z", "Where the base crosses the optical axis.")
]


class FlatBase(Part):
    """A plane across the axis."""

    model_config = ConfigDict(title="Flat")

    shape: Literal["flat"] = "flat"
    height: _BaseHeight

    def height_at(self, x: npt.ArrayLike, y: npt.ArrayLike) -> npt.NDArray[np.float64]:
        """Height f(x, y) of the base, scene units; x and y broadcast."""
        x, y = np.broadcast_arrays(x, y)
        return np.full(x.shape, self.height)

    def extent(self, half_width: tuple[float, float]) -> tuple[float, float]:
        """Lowest and highest value over the aperture."""
        return self.height, self.height

    def check_within(self, half_width: tuple[float, float]) -> None:
        """Refuse nothing: it suits any lens."""


class SphereBase(Part):
    """A spherical cap that rises or falls towards the rim."""

    model_config = ConfigDict(title="Sphere")

    shape: Literal["sphere"] = "sphere"
    height: _BaseHeight
    radius: Annotated[
        Positive,
        LENGTH,
        about(
            "Base radius", "Radius of curvature of the base; more than the lens's half-diagonal."
        ),
    ]
    form: Annotated[
        Literal["concave", "convex"],
        about("Base form", "Concave rises towards the rim, convex falls."),
    ] = "concave"

    @classmethod
    def begun(cls, scene: "Scene") -> dict[str, Any]:
        """Shallow enough for any lens that a flat base was good for."""
        return {"radius": float(f"{10 * math.hypot(*scene.lens.half_width):.2g}")}

    def height_at(self, x: npt.ArrayLike, y: npt.ArrayLike) -> npt.NDArray[np.float64]:
        """Height f(x, y) of the base, scene units; x and y broadcast."""
        r2 = np.square(x) + np.square(y)
        # R − √(R² − r²) without the cancellation of two large numbers.
        sag = r2 / (self.radius + np.sqrt(self.radius**2 - r2))
        return np.asarray(self.height + (sag if self.form == "concave" else -sag))

    def extent(self, half_width: tuple[float, float]) -> tuple[float, float]:
        """Lowest and highest value over the aperture."""
        rim = float(self.height_at(*half_width))
        return min(rim, self.height), max(rim, self.height)

    def check_within(self, half_width: tuple[float, float]) -> None:
        """Refuse a radius that is no number beside the lens, or does not span it."""
        limits.check_lengths([("lens.base.radius", self.radius)], half_width, limits.FAR)
        if self.radius <= math.hypot(*half_width):
            raise Refused(
                "lens.base.radius",
                f"{self.radius:g} does not span the lens; "
                f"more than its half-diagonal {math.hypot(*half_width):g}",
            )


Base = Annotated[FlatBase | SphereBase, Kinds("shape", default="flat")]


def _relative(factor: float) -> Callable[[dict[str, Any]], float]:
    """Default length: a multiple of the larger lens half-width (0 where that was refused)."""
    return lambda data: factor * max(data.get("half_width", (0.0,)))


def _thinnest(data: dict[str, Any]) -> float:
    """Default minimal thickness: small beside the lens and its stock."""
    thickest = data.get("max_thickness")
    relative = _relative(0.05)(data)
    return relative if thickest is None else min(relative, thickest / 2)


class Lens(Part):
    """Entrance face and B-spline exit face over a rectangle.

    ``max_thickness`` and ``min_thickness`` are counted from the entrance face to the exit face, and
    hold in any case: each face stays on its side of a plane, or of two. Defaults scale with the
    lens.
    """

    half_width: Annotated[
        tuple[Positive, Positive],
        LENGTH,
        about("Half width", "Half of the lens's extent along x and y. All of it is lit."),
    ]
    outline: Annotated[
        Literal["rectangle", "ellipse"],
        SINCE_2,
        about(
            "Outline",
            "The shape of the lens as seen along the axis; the half widths of an ellipse are its "
            "semi-axes. Light beside it misses the lens.",
        ),
    ] = "rectangle"
    entrance_z: Annotated[
        float,
        LENGTH,
        about("Entrance at z", "Where the entrance face stands on the optical axis."),
    ] = 0.0
    entrance: Annotated[
        Entrance,
        SINCE_2,
        about("Entrance face", "The face that light meets first."),
    ] = FlatEntrance()
    refractive_index: Annotated[
        float | str,
        about(
            "Material", "What the lens is made of: a catalogue material, or an index of your own."
        ),
    ]
    wavelength_um: Annotated[
        Positive | None,
        Measure("µm"),
        about("Wavelength", "Vacuum wavelength at which the material's index is taken."),
    ] = None
    absorption: Annotated[
        NonNegative,
        Measure(power=-1),
        SINCE_2,
        about(
            "Absorption",
            "How much the glass absorbs per length: light falls as exp(−absorption · path). Clear "
            "glass and acrylic absorb some 0.0002 per mm.",
        ),
    ] = 0.0
    reflection: Annotated[
        Literal["fresnel", "schlick", "none"],
        Choices((("fresnel", "Fresnel, exact"), ("schlick", "Schlick, approximate"))),
        SINCE_2,
        about(
            "Reflection",
            "What bare faces reflect: by Fresnel's equations for unpolarised light, by Schlick's "
            "approximation to them, as in the paper, or nothing. Under total reflection all of it.",
        ),
    ] = "schlick"
    coating: Annotated[
        tuple[Reflectance, Reflectance] | None,
        PLACE,
        SINCE_2,
        about(
            "Coating",
            "Part of the light that an antireflection coating reflects, at the entrance face and "
            "at the exit face, at all angles: 0.005 is a good one. Left empty, faces are bare.",
        ),
    ] = None
    degree: Annotated[
        tuple[Degree, Degree],
        about(
            "Degree",
            "Polynomial degree of the exit face's B-spline along x and y. 3 gives smooth "
            "curvature.",
        ),
    ] = (3, 3)
    control_points: Annotated[
        tuple[NetSize, NetSize] | AutoNet,
        NumbersOrAuto(),
        about(
            "Control points",
            "Number of control points along x and y. More of them draw finer detail and take "
            "longer. Automatic takes what the target's detail, the screen's pixels and the size of "
            "the source are worth; the paper's method then has nets like those of the paper.",
        ),
    ]
    base: Annotated[
        Base,
        about(
            "Base",
            "The shape of the exit face before the design; heights are counted from it.",
        ),
    ] = Field(
        default_factory=lambda data: FlatBase(
            height=data.get("entrance_z", 0.0) + _relative(0.5)(data)
        )
    )
    height_range: Annotated[
        tuple[float, float] | None,
        LENGTH,
        RANGE,
        about(
            "Height range",
            "How far the exit face may be from the base. Automatic takes what the task needs, "
            "between the thinnest and the thickest lens that is allowed.",
        ),
    ] = None
    max_thickness: Annotated[
        Positive | None,
        LENGTH,
        about(
            "Max. thickness",
            "The exit face is at most this far from the entrance face: the thickness of the stock "
            "that the part is made of. Left empty, any will do.",
        ),
    ] = None
    min_thickness: Annotated[
        NonNegative,
        LENGTH,
        about(
            "Min. thickness",
            "The exit face stays at least this far above the entrance face, so that the part can "
            "be made.",
        ),
    ] = Field(default_factory=_thinnest)

    @field_validator("refractive_index", mode="before")
    @classmethod
    def _number_or_name(cls, value: object) -> object:
        # Said here, not by pydantic, which would report each member of the union.
        if isinstance(value, bool) or not isinstance(value, (int, float, str)):
            raise Refused(
                "lens.refractive_index",
                f"{shown(value)} is neither a number nor a name; "
                "a number above 1 or a material name",
            )
        if isinstance(value, (int, float)) and not 1 < value < math.inf:
            raise Refused(
                "lens.refractive_index", f"{shown(value)}; a number greater than 1 is needed"
            )
        return value

    def check(self) -> None:
        """Refuse what cannot be computed with, and what cannot be made."""
        self._check_lengths()
        if self.known_shape is not None:
            check_net("lens.control_points", self.known_shape, self.degree)
        self.entrance.check_within(self.known_shape)
        if not self.index > 1:
            raise Refused("lens.refractive_index", f"{self.index:g}; greater than 1 is needed")
        limits.check_index(self.index)
        self.base.check_within(self.half_width)
        if self.floor >= self.ceiling:
            raise Refused(
                "lens.max_thickness",
                f"{self.max_thickness:g} leaves no room above the minimal thickness; "
                f"more than {self.min_thickness:g}",
            )
        if self.height_range is not None:
            self._check_range(*self.height_range)
        undesigned = max(self.base.extent(self.half_width)[0], self.floor) - self.entrance_z
        limits.check_absorption(self.absorption, undesigned)

    def _check_lengths(self) -> None:
        """Refuse lengths beside which the digits of the lens's shape are lost."""
        limits.check_width(self.half_width)
        heights = [
            ("lens.entrance_z", self.entrance_z),
            *self.entrance.lengths(),
            ("lens.base.height", self.base.height),
            *((f"lens.height_range[{end}]", z) for end, z in enumerate(self.height_range or ())),
            ("lens.max_thickness", self.max_thickness or 0.0),
            ("lens.min_thickness", self.min_thickness),
        ]
        limits.check_lengths(heights, self.half_width, limits.HEIGHT)

    def remarks(self) -> Mapping[str, str]:
        """The index of a named material, and the control points that the program has chosen."""
        remarks = {}
        if isinstance(self.refractive_index, str):
            remarks["refractive_index"] = f"n = {self.index:.5f}"
        if isinstance(self.control_points, AutoNet) and self.control_points.shape is not None:
            remarks["control_points"] = "{} × {}".format(*self.control_points.shape)
        return remarks

    @property
    def net_shape(self) -> tuple[int, int]:
        """Numbers of control points along x and y: as given, or as the program has chosen.

        Raises
        ------
        Refused
            If it has yet to choose; a `Session`, which has a target, is a task where it has.
        """
        if self.known_shape is None:
            raise Refused("lens.control_points", "'auto' needs a target to choose for; numbers")
        return self.known_shape

    @property
    def known_shape(self) -> tuple[int, int] | None:
        """As `net_shape`; None where the program has yet to choose."""
        points = self.control_points
        return points.shape if isinstance(points, AutoNet) else points

    def with_net(self, shape: tuple[int, int] | None) -> "Lens":
        """A lens for whose ``"auto"`` the program has chosen a net; None takes a choice back."""
        if not isinstance(self.control_points, AutoNet):
            return self
        return self.altered(control_points=AutoNet(shape))

    def _check_range(self, low: float, high: float) -> None:
        """Refuse a height range that leaves a control point nowhere to be."""
        if not low < high:
            raise Refused("lens.height_range", f"[{low:g}, {high:g}] is empty; low before high")
        lowest, highest = self.base.extent(self.half_width)
        if lowest + high <= self.floor:
            raise Refused(
                "lens.height_range[1]",
                f"{high:g} leaves no room above the minimal thickness; "
                f"more than {self.floor - lowest:g}",
            )
        if highest + low >= self.ceiling:
            raise Refused(
                "lens.height_range[0]",
                f"{low:g} leaves no room below the maximal thickness; "
                f"less than {self.ceiling - highest:g}",
            )

    @property
    def front_z(self) -> float:
        """Where light reaches the lens: sources stand before this plane, and are judged at it.

        The light of a source is what passes the outline in this plane; no point of the entrance
        face is before it.
        """
        return self.entrance_range[0]

    @property
    def entrance_range(self) -> tuple[float, float]:
        """The lowest and the highest z that the entrance face can come to."""
        low, high = self.entrance.offsets(self._room_at_entrance)
        return self.entrance_z + low, self.entrance_z + high

    @property
    def _room_at_entrance(self) -> float:
        """How far a freeform entrance face may rise where nobody says so.

        Half of what both faces share at most, so that the exit face has as much.
        """
        shared = [2 * _RISE * max(self.half_width)]
        if self.max_thickness is not None:
            shared.append(self.max_thickness - self.min_thickness)
        if self.height_range is not None:
            top = self.base.extent(self.half_width)[0] + self.height_range[1]
            shared.append(top - self.entrance_z - self.min_thickness)
        return max(min(shared) / 2, 0.0)

    @property
    def floor(self) -> float:
        """The z that the minimal thickness keeps the exit face above."""
        return self.entrance_range[1] + self.min_thickness

    @property
    def ceiling(self) -> float:
        """The z that the maximal thickness keeps the exit face below; infinite without one."""
        return math.inf if self.max_thickness is None else self.front_z + self.max_thickness

    def limits_at(
        self, x: npt.ArrayLike, y: npt.ArrayLike
    ) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
        """Lowest and highest z that control points at (x, y) may have; x and y broadcast.

        The highest is infinite where neither a height range nor a maximal thickness is given.
        """
        low, high = self.height_range or (-math.inf, math.inf)
        base = self.base.height_at(x, y)
        return np.maximum(base + low, self.floor), np.minimum(base + high, self.ceiling)

    @property
    def highest(self) -> float:
        """The z that no point of the exit face can be above.

        Without a height range and a maximal thickness it is the top of the base: each run keeps
        the face clear of its screen.
        """
        top = self.base.extent(self.half_width)[1]
        if self.height_range is not None:
            return min(top + self.height_range[1], self.ceiling)
        return max(top, self.floor) if self.max_thickness is None else self.ceiling

    @property
    def index(self) -> float:
        """Refractive index as a number."""
        if not isinstance(self.refractive_index, str):
            return float(self.refractive_index)
        if self.wavelength_um is None:
            named = shown(self.refractive_index)
            raise Refused("lens.wavelength_um", f"missing; it goes with {named}")
        return materials.refractive_index(self.refractive_index, self.wavelength_um)
