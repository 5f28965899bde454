"""Elements of one face: the mirror and the diffuser."""

from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, Self

from pydantic import ConfigDict, Field

from workbench.arrays import Array
from workbench.levels import EXPERT, LIMITS
from workbench.messages import Message
from workbench.scene import limits
from workbench.scene.element import Element
from workbench.scene.faces import PlaneFace
from workbench.scene.fields import ANGLE, LENGTH, about
from workbench.scene.losses import Loss, TakesLight
from workbench.scene.part import Kinds, Part, Positive
from workbench.scene.spline_face import Face, PlacedFace

if TYPE_CHECKING:
    from workbench.scene.task import Scene

_MIRROR_LOSSES = {
    "missed_mirror": Loss(
        "Missed the mirror",
        "Light that passes the mirror by: between it and the rim of the light's cone, and through "
        "the corners of the rectangle around an elliptic mirror.",
        "misses the mirror",
        "a larger mirror catches it",
    ),
}


class Mirror(Element):
    """One face that reflects, lit from below.

    It is the lower face of a plate; no light comes to the plate's flat back.
    """

    called = "mirror"
    most_faces = 1
    face_called = "mirror"
    body_called = "mirror"
    front_called = Message("the mirror")
    onwards = -1
    losses = _MIRROR_LOSSES

    kind: Literal["mirror"]
    face: Annotated[Face, about("Face", "The face that reflects.")]
    reflectance: Annotated[
        float,
        TakesLight(
            "absorbed_mirror",
            Loss(
                "Absorbed by the mirror",
                "The part of the light on the mirror that it does not reflect.",
                "is absorbed by the mirror",
                "a coating with a higher reflectance reflects it",
            ),
        ),
        EXPERT,
        about(
            "Reflectance",
            "Part of the light that the mirror reflects, at all angles: about 0.9 for aluminium, "
            "0.97 for silver. It absorbs the rest.",
            gt=0,
            le=1,
        ),
    ] = 1.0
    thickness: Annotated[
        Positive,
        LENGTH,
        LIMITS,
        about(
            "Thickness",
            "How far the flat back of the plate is behind the highest point of the mirror, in "
            "exports of the plate.",
        ),
    ] = Field(default_factory=limits.relative(0.1))

    @property
    def placed_faces(self) -> tuple[PlacedFace, ...]:
        """The one face."""
        return (PlacedFace(f"{self.name}.face", "face", self.face, self.position[2]),)

    def with_face(self, name: str, face: Face) -> Self:
        """See `Element.with_face`."""
        return self.model_copy(update={"face": face})

    def _own_heights(self) -> list[tuple[str, float]]:
        return [("thickness", self.thickness)]

    @property
    def front_z(self) -> float:
        """The middle of the base: the light that passes the outline there lights the mirror.

        Of a mirror that is not designed, the lowest that its face is.
        """
        return self.base.height if self.designed else self.base.extent(self.half_width)[0]

    @property
    def entrance(self) -> PlaneFace:
        """None that could be shaped."""
        return PlaneFace()

    @property
    def z_min(self) -> float:
        """The lowest place of the base and of the height range."""
        low, _ = self._range
        return self.base.extent(self.half_width)[0] + low

    @property
    def z_max(self) -> float:
        """The highest place of the base and of the height range."""
        _, high = self._range
        return self.base.extent(self.half_width)[1] + high

    @property
    def _range(self) -> tuple[float, float]:
        """The height range, or the most that it may automatically be."""
        most = max(self.half_width) if self.designed else 0.0
        return self.height_range or (-most, most)

    @property
    def least_loss(self) -> float:
        """What it absorbs."""
        return 1 - self.reflectance

    @property
    def deflection(self) -> float:
        """A mirror turns light by twice the angle that it is turned by itself."""
        return 2.0

    @property
    def held_by(self) -> Literal["height_range"]:
        """The most that the range may automatically be."""
        return "height_range"

    def flat_z(self, heights: Array) -> float:
        """The back of the plate."""
        return float(heights.max()) + self.thickness


_USUAL_SIGMA = 5.0

_DIFFUSER_LOSSES = {
    "missed_diffuser": Loss(
        "Missed the diffuser",
        "Light that passes the diffuser by.",
        "misses the diffuser",
        "a larger diffuser catches it",
    ),
}


class AnyScatter(Part):
    """A law of scatter.

    A new law is a class here, a member of `Scatter`, and a row in the tables of
    `workbench.extended.scatter_kernels` and `workbench.analysis.tracing.interfaces`.
    """

    about_ray: ClassVar[bool]
    """Whether light is scattered about the direction in which it would go on; else about the
    normal, wherever it comes from."""


class GaussianScatter(AnyScatter):
    """Light is scattered about the direction in which it would go on."""

    model_config = ConfigDict(title="Gaussian")
    about_ray = True

    kind: Literal["gaussian"]
    sigma: Annotated[
        float,
        ANGLE,
        about(
            "Sigma",
            "How far light is scattered: the radiant intensity of a narrow beam behind the "
            "diffuser falls as exp(−θ²/2σ²) with the angle θ to the beam. For small σ it is the "
            "standard deviation of the angle along each axis. The full width at half maximum, "
            "which data sheets state, is 2.355 σ.",
            gt=0,
            le=60,
        ),
    ]

    @classmethod
    def defaults_for(cls, scene: "Scene") -> dict[str, Any]:
        """A usual diffuser film."""
        return {"sigma": _USUAL_SIGMA}


class LambertianScatter(AnyScatter):
    """Light leaves with the same radiance in all directions, wherever it comes from."""

    model_config = ConfigDict(title="Lambertian")
    about_ray = False

    kind: Literal["lambertian"]


Scatter = Annotated[GaussianScatter | LambertianScatter, Kinds("kind")]


class Diffuser(Element):
    """One plane that scatters light onwards: the last element of a train."""

    called = "diffuser"
    most_faces = 0
    face_called = "diffuser"
    body_called = "diffuser"
    front_called = Message("the diffuser")
    onwards = 1
    losses = _DIFFUSER_LOSSES

    kind: Literal["diffuser"]
    scatter: Annotated[
        Scatter, about("Scatter", "In which directions the light goes on behind the plane.")
    ]
    transmittance: Annotated[
        float,
        TakesLight(
            "absorbed_diffuser",
            Loss(
                "Absorbed by the diffuser",
                "The part of the light on the diffuser that does not go on behind it.",
                "is absorbed by the diffuser",
                "a diffuser with a higher transmittance lets it through",
            ),
        ),
        EXPERT,
        about(
            "Transmittance",
            "Part of the light that goes on behind the diffuser, at all angles of incidence. It "
            "absorbs the rest, or reflects it.",
            gt=0,
            le=1,
        ),
    ] = 1.0

    @property
    def placed_faces(self) -> tuple[PlacedFace, ...]:
        """Its plane."""
        z = self.position[2]
        return (PlacedFace(f"{self.name}.face", "face", PlaneFace(), z),)

    def with_face(self, name: str, face: Face) -> Self:
        """Refuse: it has no face that could be another one."""
        raise TypeError("a diffuser is a plane")

    @property
    def front_z(self) -> float:
        """Its plane."""
        return self.position[2]

    @property
    def z_min(self) -> float:
        """Its plane."""
        return self.position[2]

    @property
    def z_max(self) -> float:
        """Its plane."""
        return self.position[2]

    @property
    def least_loss(self) -> float:
        """What it absorbs."""
        return 1 - self.transmittance

    @property
    def deflection(self) -> float:
        """A plane turns no light."""
        return 0.0

    @property
    def held_by(self) -> Literal["height_range"]:
        """Nothing could move it."""
        return "height_range"

    def flat_z(self, heights: Array) -> float:
        """Its plane."""
        return self.position[2]
