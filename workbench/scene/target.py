"""The wished image."""

from typing import Annotated, Literal

from pydantic import Field, Tag

from workbench.refusals import told_by
from workbench.scene.part import Part


class Finish(Part):
    """What is done to every target: black border, blur, inversion.

    ``padding`` is the black border on each side as a fraction of the screen, ``blur`` the
    standard deviation of a Gaussian in screen pixels.
    """

    padding: Annotated[float, Field(ge=0, lt=0.5)] = 0.0
    blur: Annotated[float, Field(ge=0, le=1000)] = 0.0
    invert: bool = False


class ImageTarget(Finish):
    """An image file; a relative path starts at the scene file's folder."""

    image: Annotated[str, Field(min_length=1)]


class TopHatTarget(Finish):
    """Uniform disc; ``radius`` as a fraction of the smaller screen half-width."""

    builtin: Literal["tophat"] = "tophat"
    radius: Annotated[float, Field(gt=0, le=1)] = 0.6


class FlameTarget(Finish):
    """Flame-like logo on black; ``height`` as a fraction of the smaller screen width."""

    builtin: Literal["flame"] = "flame"
    height: Annotated[float, Field(gt=0, le=1)] = 0.85


class BallTarget(Finish):
    """Faceted ball in several greys; ``radius`` as a fraction of the smaller half-width."""

    builtin: Literal["ball"] = "ball"
    radius: Annotated[float, Field(gt=0, le=1)] = 0.8


Target = ImageTarget | TopHatTarget | FlameTarget | BallTarget
TargetField = Annotated[
    Annotated[ImageTarget, Tag("image")]
    | Annotated[TopHatTarget, Tag("tophat")]
    | Annotated[FlameTarget, Tag("flame")]
    | Annotated[BallTarget, Tag("ball")],
    told_by("builtin", "tophat", "flame", "ball", otherwise="image"),
]
