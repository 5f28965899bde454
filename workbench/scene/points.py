"""Light of points: how they emit, how their rays are drawn and where these meet the lens."""

from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, Self

import numpy as np
from pydantic import ConfigDict, Field

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.levels import EXPERT
from workbench.messages import Message
from workbench.scene.element import Element
from workbench.scene.fields import LENGTH, PLACE, Choices, ForMethod, about
from workbench.scene.part import Kinds, Part
from workbench.scene.source import MOST_RAYS, PlacedSource, check_place, in_front
from workbench.scene.turning import Place

if TYPE_CHECKING:
    from workbench.scene.task import Scene

Subdivisions = Annotated[int, Field(ge=1, le=64)]
_MOST = 1 << 24  # rectangles of a mesh


class ExactMethod(Part):
    """On the B-spline itself, fast and without an error of its own."""

    model_config = ConfigDict(title="Exact")

    method: Literal["exact"] = "exact"
    subdivisions: ClassVar[None] = None

    def check_for(self, optic: Element) -> None:
        """Refuse nothing: it suits any lens."""


class MeshMethod(Part):
    """As in the paper, for comparison."""

    model_config = ConfigDict(title="Triangle mesh")

    method: Literal["mesh"] = "mesh"
    subdivisions: Annotated[
        tuple[Subdivisions, Subdivisions],
        about(
            "Subdivisions",
            "Parts along x and y that each knot span is cut into, two triangles each. Twice as "
            "many make a quarter of the error, and four times the triangles.",
        ),
    ] = (4, 4)

    def check_for(self, optic: Element) -> None:
        """Refuse more triangles than there is memory for."""
        if optic.known_shape is None:
            return  # checked with what the program chooses
        across, up = (
            (count - degree) * n
            for count, degree, n in zip(
                optic.known_shape, optic.degree, self.subdivisions, strict=True
            )
        )
        if across * up > _MOST:
            raise Refused(
                "source.intersection.subdivisions",
                Message(
                    "{parts} make {across} × {up} rectangles; at most {most} in all",
                    parts=list(self.subdivisions),
                    across=across,
                    up=up,
                    most=_MOST,
                ),
            )


Intersection = Annotated[
    ExactMethod | MeshMethod,
    Kinds("method", default="exact"),
    EXPERT,
    about("Intersection", "How it is found where a ray of the paper's method meets the exit face."),
]

Emission = Annotated[
    Literal["uniform", "lambertian"],
    EXPERT,
    about(
        "Emission",
        "Uniform: equally bright in all directions, as a small bulb. Lambertian: dimmer away from "
        "the optical axis, as the surface of an LED.",
    ),
]

Sampling = Annotated[
    Literal["sobol", "random"],
    Choices((("sobol", "Low discrepancy"),)),
    EXPERT,
    about(
        "Sampling",
        "How directions of the paper's method are drawn. Low discrepancy (Sobol) spreads them "
        "evenly and needs far fewer rays; random is noisier, as in the paper.",
    ),
]

Fresh = Annotated[
    bool,
    ForMethod("paper"),
    EXPERT,
    about(
        "Fresh rays",
        "Draw new rays for each iteration of the paper's method, so that the lens cannot fit "
        "itself to one set of them. Automatic does not have this.",
    ),
]


class LightOfPoints(PlacedSource):
    """What points have in common: each emits into a cone that just covers the entrance face."""

    kind: str
    position: Place
    rays: int
    emission: Emission = "uniform"
    sampling: Sampling = "sobol"
    fresh: Fresh = False
    intersection: Intersection = ExactMethod()

    @property
    def turns(self) -> bool:
        """Where its points are more than one, or light falls with the cosine: cones follow."""
        return self.point_count > 1 or self.emission == "lambertian"

    @property
    def positions(self) -> Array:
        """Where its points are, scene units, shape (n, 3); all have the same z."""
        return np.array([self.position])

    @property
    def point_count(self) -> int:
        """How many there are."""
        return len(self.positions)

    @property
    def axes(self) -> tuple[Array, Array] | None:
        """The x of its columns and the y of its rows of points; None where they are no grid."""
        return None

    @property
    def redrawn(self) -> bool:
        """As its field says."""
        return self.fresh

    @property
    def subdivisions(self) -> tuple[int, int] | None:
        """Those of its triangle mesh."""
        return self.intersection.subdivisions

    def check_before(self, optic: Element) -> None:
        """Refuse an element that is not behind it, or too near, too far or too fine."""
        check_place("source.position", self.position, optic)
        self.intersection.check_for(optic)


class PointSource(LightOfPoints):
    """Light from one point into the cone that just covers the entrance face."""

    model_config = ConfigDict(title="Point source")

    kind: Literal["point"]
    position: Annotated[
        Place,
        LENGTH,
        PLACE,
        about(
            "Position",
            "Where the point is: x, y and z. It has to stand before the entrance face; off the "
            "axis it lights the lens askew.",
        ),
    ]
    rays: Annotated[
        int,
        EXPERT,
        about(
            "Rays",
            "Rays in each iteration of the paper's method, and for derivative maps, those that "
            "miss the lens included. More give a smoother image and take longer; at least four "
            "per pixel are good. Automatic chooses its own.",
            ge=1,
            le=MOST_RAYS,
        ),
    ] = 500_000

    @classmethod
    def defaults_for(cls, scene: "Scene") -> dict[str, Any]:
        """Where the scene's source is."""
        return {"position": scene.source.place or in_front(scene.optic)}

    @property
    def mirrored(self) -> tuple[bool, bool]:
        """Where it is on the axis, and lights both sides alike."""
        x, y, _ = self.position
        turned = self.facing if self.emission == "lambertian" else np.zeros(3)
        return x == 0 and turned[0] == 0, y == 0 and turned[1] == 0

    @property
    def sharp(self) -> Self:
        """It is one."""
        return self

    @property
    def axes(self) -> tuple[Array, Array]:
        """The x and the y of its points, shape (1,) each."""
        x, y, _ = self.position
        return np.array([x]), np.array([y])
