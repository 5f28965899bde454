"""The mirror: one face; light goes on from the side from which it came."""

from typing import Annotated, Literal, Self

from pydantic import Field

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
    relative,
)
from workbench.scene.faces import Face, PlaneFace
from workbench.scene.fields import LENGTH, about
from workbench.scene.losses import Loss, TakesLight
from workbench.scene.part import Positive

_LOSSES = {
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
    losses = _LOSSES

    kind: Literal["mirror"]
    name: Name
    position: ElementPosition = (0.0, 0.0, 0.0)
    tilt: ElementTilt = (0.0, 0.0, 0.0)
    half_width: HalfWidth
    outline: Outline = "rectangle"
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
        about(
            "Thickness",
            "How far the flat back of the plate is behind the highest point of the mirror, in "
            "exports of the plate.",
        ),
    ] = Field(default_factory=relative(0.1))

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
    def floor(self) -> float:
        """The lowest place of the base and of the height range."""
        low, _ = self._range
        return self.base.extent(self.half_width)[0] + low

    @property
    def ceiling(self) -> float:
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
