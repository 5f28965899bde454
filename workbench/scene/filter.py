"""How rays become an image on the receiver."""

from typing import Annotated, ClassVar, Literal

from pydantic import AfterValidator, ConfigDict, Field
from pydantic_core import PydanticCustomError

from workbench.scene.fields import Measure, about
from workbench.scene.kinds import Kinds
from workbench.scene.part import Part


def _odd(size: int) -> int:
    if size % 2 == 0:
        raise PydanticCustomError("even", "is even")
    return size


FilterSize = Annotated[int, Field(ge=1, le=99), AfterValidator(_odd)]


class BoxFilter(Part):
    """Every ray counts fully in the pixel that it hits."""

    model_config = ConfigDict(title="Box")

    kind: Literal["box"] = "box"
    # As a Gaussian that is no wider than a pixel.
    size: ClassVar[tuple[int, int]] = (1, 1)
    alpha: ClassVar[float] = 0.0
    smooth: ClassVar[bool] = False
    """Whether the image changes as a ray moves within a pixel, so that it has a derivative."""


class GaussianFilter(Part):
    """Light falls off over some pixels, so that a design feels where in a pixel a ray lands."""

    model_config = ConfigDict(title="Gaussian")

    smooth: ClassVar[bool] = True

    kind: Literal["gaussian"] = "gaussian"
    size: Annotated[
        tuple[FilterSize, FilterSize],
        Measure("px", "pixels"),
        about("Size", "Pixels along x and y that one ray reaches; odd numbers."),
    ] = (3, 3)
    alpha: Annotated[
        float,
        Measure("px⁻²", "per pixel²"),
        about(
            "Alpha",
            "How fast the Gaussian falls: exp(−alpha · distance²). Small is wide.",
            ge=1e-6,
            le=1e6,
        ),
    ] = 1.0


Filter = Annotated[GaussianFilter | BoxFilter, Kinds("kind", default="gaussian")]
