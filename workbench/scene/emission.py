"""How points emit, how their rays are drawn and where these meet the lens."""

from typing import Annotated, ClassVar, Literal

from pydantic import ConfigDict, Field

from workbench.errors import Refused
from workbench.messages import Message
from workbench.scene.element import Element
from workbench.scene.fields import Choices, ForMethod, about
from workbench.scene.kinds import Kinds
from workbench.scene.part import Part

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
    about("Intersection", "How it is found where a ray of the paper's method meets the exit face."),
]
Emission = Annotated[
    Literal["uniform", "lambertian"],
    about(
        "Emission",
        "Uniform: equally bright in all directions, as a small bulb. Lambertian: dimmer away from "
        "the optical axis, as the surface of an LED.",
    ),
]
Sampling = Annotated[
    Literal["sobol", "random"],
    Choices((("sobol", "Low discrepancy"),)),
    about(
        "Sampling",
        "How directions of the paper's method are drawn. Low discrepancy (Sobol) spreads them "
        "evenly and needs far fewer rays; random is noisier, as in the paper.",
    ),
]
Fresh = Annotated[
    bool,
    ForMethod("paper"),
    about(
        "Fresh rays",
        "Draw new rays for each iteration of the paper's method, so that the lens cannot fit "
        "itself to one set of them. Automatic does not have this.",
    ),
]
