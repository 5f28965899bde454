"""The diffuser: a plane that scatters the light that passes it."""

from typing import TYPE_CHECKING, Annotated, Any, Literal, Self

from pydantic import ConfigDict

from workbench.arrays import Array
from workbench.messages import Message
from workbench.scene.element import (
    Element,
    ElementPosition,
    ElementTilt,
    HalfWidth,
    Name,
    Outline,
    PlacedFace,
)
from workbench.scene.faces import Face, PlaneFace
from workbench.scene.fields import ANGLE, about
from workbench.scene.kinds import Kinds
from workbench.scene.losses import Loss, TakesLight
from workbench.scene.part import Part

if TYPE_CHECKING:
    from workbench.scene.task import Scene

_USUAL_SIGMA = 5.0
_LOSSES = {
    "missed_diffuser": Loss(
        "Missed the diffuser",
        "Light that passes the diffuser by.",
        "misses the diffuser",
        "a larger diffuser catches it",
    ),
}


class GaussianScatter(Part):
    """Light is scattered about the direction in which it would go on."""

    model_config = ConfigDict(title="Gaussian")

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


class LambertianScatter(Part):
    """Light leaves with the same radiance in all directions, wherever it comes from."""

    model_config = ConfigDict(title="Lambertian")

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
    losses = _LOSSES

    kind: Literal["diffuser"]
    name: Name
    position: ElementPosition = (0.0, 0.0, 0.0)
    tilt: ElementTilt = (0.0, 0.0, 0.0)
    half_width: HalfWidth
    outline: Outline = "rectangle"
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
    def floor(self) -> float:
        """Its plane."""
        return self.position[2]

    @property
    def ceiling(self) -> float:
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
