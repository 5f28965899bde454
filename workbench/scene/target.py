"""The wanted image."""

from itertools import pairwise
from pathlib import PurePath
from typing import Annotated, Literal

from pydantic import ConfigDict, Field

from workbench.errors import Refused
from workbench.levels import EXPERT
from workbench.messages import Message
from workbench.scene.fields import FILE, PLACE, Choices, LeftOut, Measure, about
from workbench.scene.part import Kinds, Part, title_of

Side = Literal["front", "back"]
"""Of a receiver: the one from which the light comes, or the one behind it."""


class Finish(Part):
    """What is done to every target: black border, blur, inversion, and who sees it."""

    padding: Annotated[
        float,
        Measure("of width", "of the whole image"),
        EXPERT,
        about(
            "Padding",
            "Black border on each side as a fraction of the whole image; it keeps light away from "
            "the edge.",
            ge=0,
            lt=0.5,
        ),
    ] = 0.0
    blur: Annotated[
        float,
        Measure("px", "pixels"),
        EXPERT,
        about(
            "Blur",
            "Standard deviation of a Gaussian over the target. Soft edges are easier for a smooth "
            "lens.",
            ge=0,
            le=1000,
        ),
    ] = 0.0
    invert: Annotated[bool, EXPERT, about("Invert", "Swap bright and dark.")] = False
    viewed_from: Annotated[
        Side | None,
        Choices((("front", "The side of the light"), ("back", "Behind the receiver"))),
        LeftOut("As stored"),
        about(
            "Viewed from",
            "The side of the receiver from which the picture reads the right way round. An opaque "
            "wall, a table, or a far field on a distant wall is viewed from the side of the "
            "light, a rear projection from behind the receiver. If it is left out, column 0 of "
            "the picture lies at −x: it then reads right from behind with a lens, from the side "
            "of the light with a mirror.",
        ),
    ] = None

    @property
    def file(self) -> str | None:
        """The image file; None for a built-in shape."""
        return None

    @property
    def called(self) -> str:
        """What people know the target by."""
        return title_of(type(self))


_Cut = Annotated[float, Field(ge=0, lt=1)]
_MOST_CUT = 0.99
_OF_BRIGHTEST = Measure("of the brightest")
_LEAST_SPAN = 0.01  # from the black level to the white level
LEVELS = "black", "white", "gamma"
"""Fields of an image target that change the tone of its picture."""


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
            "drawing itself gets the light. It is fitted into the screen, or into the far field's "
            "angles, with its aspect kept. "
            "A relative path starts at the scene file's folder.",
            min_length=1,
        ),
    ]
    tone: Annotated[
        Literal["linear", "srgb"],
        Choices((("linear", "As stored"), ("srgb", "As shown by a monitor"))),
        EXPERT,
        about(
            "Brightness",
            "What a pixel value means. A monitor shows half of the largest value as a fifth of "
            "the light: a photograph looks as it does there only where that is undone (sRGB). "
            "As stored, the value itself is the light: half of it is half the light. "
            "A colour profile in the file counts in place of this.",
        ),
    ] = "linear"
    fit: Annotated[
        Literal["whole", "fill"],
        Choices((("whole", "All of the picture"), ("fill", "Without a border"))),
        EXPERT,
        about(
            "Fit",
            "Whether all of the picture is seen, with a black border where the screen or the far "
            "field has another aspect, or that is filled, and what is beyond it is cut away.",
        ),
    ] = "whole"
    turn: Annotated[
        Literal["none", "left", "right", "around"],
        Choices(
            (
                ("none", "As it is"),
                ("left", "A quarter to the left"),
                ("right", "A quarter to the right"),
                ("around", "Upside down"),
            )
        ),
        EXPERT,
        about("Turn", "Turns the picture."),
    ] = "none"
    crop: Annotated[
        tuple[_Cut, _Cut, _Cut, _Cut],
        PLACE,
        Measure("of the picture"),
        EXPERT,
        about(
            "Cut away",
            "What is cut away at the left, top, right and bottom of the picture, as fractions of "
            "its width and height, before it is turned.",
        ),
    ] = (0.0, 0.0, 0.0, 0.0)
    black: Annotated[
        float,
        _OF_BRIGHTEST,
        EXPERT,
        about(
            "Black level",
            "Pixel values up to this level get no light, as in the levels of a photo program. "
            "Raise it where a dark background takes light from the subject. Levels are fractions "
            "of the brightest pixel value, after the crop and the inversion.",
            ge=0,
            lt=1,
            exclude_if=lambda level: level == 0.0,
        ),
    ] = 0.0
    white: Annotated[
        float,
        _OF_BRIGHTEST,
        EXPERT,
        about(
            "White level",
            "Pixel values from this level on are white. Lower it to cut highlights off, so that "
            "the rest of the picture gets more of the light.",
            gt=0,
            le=1,
            exclude_if=lambda level: level == 1.0,
        ),
    ] = 1.0
    gamma: Annotated[
        float,
        EXPERT,
        about(
            "Gamma",
            "Above 1 the mid-tones between the black level and the white level are brighter, "
            "below 1 darker: the pixel value to the power of 1/gamma.",
            ge=0.1,
            le=10,
            exclude_if=lambda gamma: gamma == 1.0,
        ),
    ] = 1.0

    @property
    def has_levels(self) -> bool:
        """Whether levels or gamma change the tone of the picture."""
        return any(map(self.differs, LEVELS))

    @property
    def file(self) -> str | None:
        """The image file."""
        return self.image

    @property
    def called(self) -> str:
        """The name of the file."""
        return PurePath(self.image).name

    def check(self) -> None:
        """Refuse to cut all of the picture away, and a white level below the black level."""
        left, top, right, bottom = self.crop
        across, up, most = left + right, top + bottom, _MOST_CUT
        if across > most:
            wide = Message(
                "takes {across:g} of the width away; at most {most:g}", across=across, most=most
            )
            raise Refused("target.crop", wide)
        if up > most:
            high = Message("takes {up:g} of the height away; at most {most:g}", up=up, most=most)
            raise Refused("target.crop", high)
        if self.white < self.black + _LEAST_SPAN:
            least = self.black + _LEAST_SPAN
            raise Refused("target.white", Message("at least {least:g}, above black", least=least))


_Radius = Annotated[
    float,
    Measure("of half width", "of the whole image's smaller half-width"),
    about(
        "Radius",
        "Radius of the shape as a fraction of the smaller half-width of the whole image.",
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
        Measure("of width", "of the whole image's smaller width"),
        about(
            "Height",
            "Height of the shape as a fraction of the smaller width of the whole image.",
            gt=0,
            le=1,
        ),
    ] = 0.85


class BallTarget(Finish):
    """A faceted ball in several greys."""

    model_config = ConfigDict(title="Ball")

    builtin: Literal["ball"] = "ball"
    radius: _Radius = 0.8


_OF_IMAGE = Measure("of the whole image")


class RectangleTarget(Finish):
    """A uniform rectangle; as large as the whole image, all of it evenly lit."""

    model_config = ConfigDict(title="Rectangle")

    builtin: Literal["rectangle"] = "rectangle"
    width: Annotated[
        float,
        _OF_IMAGE,
        about(
            "Width", "Width of the rectangle as a fraction of that of the whole image.", gt=0, le=1
        ),
    ] = 1.0
    height: Annotated[
        float,
        _OF_IMAGE,
        about(
            "Height",
            "Height of the rectangle as a fraction of that of the whole image; a small one makes "
            "a line.",
            gt=0,
            le=1,
        ),
    ] = 1.0


class RingTarget(Finish):
    """A uniform ring."""

    model_config = ConfigDict(title="Ring")

    builtin: Literal["ring"] = "ring"
    radius: _Radius = 0.8
    inner: Annotated[
        float,
        Measure("of radius", "of the radius"),
        about("Inner radius", "As a fraction of the radius.", gt=0, lt=1),
    ] = 0.7


_Part = Annotated[float, Field(ge=0, le=1)]


class BeamTarget(Finish):
    """A rotationally symmetric beam with a hot spot, and spill around it."""

    model_config = ConfigDict(title="Beam")

    builtin: Literal["beam"] = "beam"
    profile: Annotated[
        tuple[tuple[_Part, _Part], ...],
        Measure("radius, level"),
        about(
            "Profile",
            "Points of radius and level, from the middle outwards; a smooth curve joins them. A "
            "radius is a fraction of the smaller half-width of the whole image, a level one of the "
            "peak: the radius at level 0.5 is half of the full width at half maximum, that at 0.1 "
            "half of the field width. The first level holds within its radius; beyond the last "
            "radius there is no light.",
            min_length=2,
            max_length=50,
        ),
    ] = ((0.0, 1.0), (0.25, 0.5), (0.5, 0.1), (0.9, 0.02))

    def check(self) -> None:
        """Refuse radii that do not grow, and a profile without light."""
        for number, ((before, _), (radius, _)) in enumerate(pairwise(self.profile), start=1):
            if radius <= before:
                grows = Message("{radius:g} is not above {before:g}", radius=radius, before=before)
                raise Refused(f"target.profile[{number}][0]", grows)
        if not any(level for _, level in self.profile):
            raise Refused("target.profile", Message("has no light; some level above 0 is needed"))


class TextTarget(Finish):
    """Words, as large as the whole image lets them be."""

    model_config = ConfigDict(title="Text")

    builtin: Literal["text"] = "text"
    text: Annotated[
        str,
        about("Text", "The words; \\n begins a new line.", min_length=1, max_length=200),
    ] = "Light"

    @property
    def called(self) -> str:
        """The words."""
        return f"“{' '.join(self.text.split())}”"


Target = Annotated[
    ImageTarget
    | TopHatTarget
    | FlameTarget
    | BallTarget
    | RectangleTarget
    | RingTarget
    | BeamTarget
    | TextTarget,
    Kinds("builtin", default="image"),
]
