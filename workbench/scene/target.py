"""The wanted image."""

from typing import Annotated, Literal

from pydantic import ConfigDict

from workbench.scene.fields import FILE, Measure, about
from workbench.scene.kinds import Kinds
from workbench.scene.part import Part


class Finish(Part):
    """What is done to every target: black border, blur, inversion."""

    padding: Annotated[
        float,
        Measure("of width", "of the screen"),
        about(
            "Padding",
            "Black border on each side as a fraction of the screen; it keeps light away from the "
            "edge.",
            ge=0,
            lt=0.5,
        ),
    ] = 0.0
    blur: Annotated[
        float,
        Measure("px", "pixels"),
        about(
            "Blur",
            "Standard deviation of a Gaussian over the target. Soft edges are easier for a smooth "
            "lens.",
            ge=0,
            le=1000,
        ),
    ] = 0.0
    invert: Annotated[bool, about("Invert", "Swap bright and dark.")] = False

    @property
    def file(self) -> str | None:
        """The image file; None for a built-in shape."""
        return None


class ImageTarget(Finish):
    """Bright pixels get much light, black ones and transparent ones none."""

    model_config = ConfigDict(title="Image file")

    image: Annotated[
        str,
        FILE,
        about(
            "Image",
            "Image file; bright pixels get much light, black ones and transparent ones none. "
            "Where all that is drawn is black, as in many a logo on a transparent ground, the "
            "drawing itself gets the light. It is fitted into the screen with its aspect kept. "
            "A relative path starts at the scene file's folder.",
            min_length=1,
        ),
    ]

    @property
    def file(self) -> str | None:
        """The image file."""
        return self.image


_Radius = Annotated[
    float,
    Measure("of half width", "of the screen's smaller half-width"),
    about(
        "Radius",
        "Radius of the shape as a fraction of the screen's smaller half-width.",
        gt=0,
        le=1,
    ),
]


class TopHatTarget(Finish):
    """A uniform disc."""

    model_config = ConfigDict(title="Top hat")

    builtin: Literal["tophat"] = "tophat"
    radius: _Radius = 0.6


class FlameTarget(Finish):
    """A flame-like logo on black."""

    model_config = ConfigDict(title="Flame")

    builtin: Literal["flame"] = "flame"
    height: Annotated[
        float,
        Measure("of width", "of the screen's smaller width"),
        about(
            "Height",
            "Height of the shape as a fraction of the screen's smaller width.",
            gt=0,
            le=1,
        ),
    ] = 0.85


class BallTarget(Finish):
    """A faceted ball in several greys."""

    model_config = ConfigDict(title="Ball")

    builtin: Literal["ball"] = "ball"
    radius: _Radius = 0.8


Target = Annotated[
    ImageTarget | TopHatTarget | FlameTarget | BallTarget, Kinds("builtin", default="image")
]
