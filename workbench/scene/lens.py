"""The lens: an entrance face, a B-spline exit face over a base."""

import math
from collections.abc import Mapping
from typing import Annotated, Any, Literal, Self

from pydantic import Field, field_validator

from workbench import materials
from workbench.arrays import Array
from workbench.errors import Refused, shown
from workbench.said import Said
from workbench.scene import limits
from workbench.scene.base import Base, FlatBase
from workbench.scene.entrance import Entrance, FlatEntrance
from workbench.scene.fields import LENGTH, PLACE, RANGE, SINCE_2, Choices, Measure, about
from workbench.scene.lens_losses import LENS_LOSSES
from workbench.scene.losses import Loss, TakesLight
from workbench.scene.net import ControlPoints, Degree
from workbench.scene.optic import Optic, relative
from workbench.scene.part import NonNegative, Positive

Reflectance = Annotated[float, Field(ge=0, lt=1)]
# An automatic entrance face may rise by this part of the lens's half-width, and for several images
# by half of the glass too: light of an image at two distances is moved between the faces alone. In
# 100 mm of glass 100 mm wide they rise by 36 mm. The example *Photograph at two distances* with an
# automatic range is 0.8 % off, and 5.8 and 5.3 % with a quarter of the half-width. For one image a
# wide range gains nothing, and light of near sources leaves by the side before a face far in it.
_RISE = 0.25
# And by this part of the way from a source to it: what it may rise is glass that the exit face
# stands on, in which light of near sources spreads. An LED 10 mm before a lens 120 mm wide, error
# and light on the screen:
#
# | rise | error | light |
# |---|---|---|
# | flat entrance face | 24.5 % | 70 % |
# | 3 mm | 9.6 % | 69 % |
# | 6 mm | 8.8 % | 68 % |
# | 15 mm, a quarter of the half-width | 13.7 % | 49 % |
_NEAR_RISE = 0.5
# A designed exit face seldom rises farther above its base than so many half-widths of the lens.
# Stock that reaches far to the screen does not tell where the exit face will be: a first lens in
# stock of 500 mm was 34 % off, and is 17 % off.
_RISES = 1.0
# A receiver that is infinitely far counts as so many half-widths of the lens away.
_FAR = 8.0
# An automatic thickness takes at most so many half-widths: where it goes up to a screen that is 1e9
# away, the undesigned lens was 250,000 thick, and its heights had too few digits for its shape.
_THICKEST = 1000.0


def _thinnest(data: dict[str, Any]) -> float:
    """Default minimal thickness: small beside the lens and its stock."""
    thickest = data.get("max_thickness")
    usual = relative(0.05)(data)
    return usual if thickest is None else min(usual, thickest / 2)


class Lens(Optic):
    """Entrance face and B-spline exit face over a rectangle.

    ``max_thickness`` and ``min_thickness`` are counted from the entrance face to the exit face, and
    hold in any case: each face stays on its side of a plane, or of two. Defaults scale with the
    lens.
    """

    called = "lens"
    face = "exit"
    most_faces = 2
    face_called = "exit face"
    body_called = "body of glass"
    front_called = Said("the entrance face")
    onwards = 1
    losses = LENS_LOSSES

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
        about("Material", "What the lens is made of: a catalogue material, or a custom index."),
    ]
    wavelength_um: Annotated[
        Positive | None,
        Measure("µm"),
        about("Wavelength", "Vacuum wavelength at which the material's index is taken."),
    ] = None
    absorption: Annotated[
        NonNegative,
        Measure(power=-1),
        TakesLight(
            "absorbed",
            Loss(
                "Absorbed",
                "The part that the glass absorbs of the light that comes to the exit face.",
                "is absorbed by the glass",
                "a thinner lens or a clearer glass lets more of it through",
            ),
        ),
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
    control_points: ControlPoints
    base: Annotated[
        Base,
        about(
            "Base",
            "The shape of the exit face before the design; heights are counted from it.",
        ),
    ] = Field(
        default_factory=lambda data: FlatBase(
            height=data.get("entrance_z", 0.0) + relative(0.5)(data)
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
                Said(
                    "{value} is neither a number nor a name; a number above 1 or a material name",
                    value=shown(value),
                ),
            )
        if isinstance(value, (int, float)) and not 1 < value < math.inf:
            raise Refused(
                "lens.refractive_index",
                Said("{value}; a number greater than 1 is needed", value=shown(value)),
            )
        return value

    def check(self) -> None:
        """Refuse what cannot be computed with, and what cannot be made."""
        self.check_face(
            [
                ("entrance_z", self.entrance_z),
                *self.entrance.lengths(),
                ("max_thickness", self.max_thickness or 0.0),
                ("min_thickness", self.min_thickness),
            ]
        )
        self.entrance.check_within(self.known_shape)
        if not self.index > 1:
            low = Said("{index:g}; greater than 1 is needed", index=self.index)
            raise Refused("lens.refractive_index", low)
        limits.check_index(self.index)
        if self.floor >= self.ceiling:
            raise Refused(
                "lens.max_thickness",
                Said(
                    "{height:g} leaves no room above the minimal thickness; more than {least:g}",
                    height=self.max_thickness,
                    least=self.min_thickness,
                ),
            )
        if self.height_range is not None:
            self._check_range(*self.height_range)
        undesigned = max(self.base.extent(self.half_width)[0], self.floor) - self.entrance_z
        limits.check_absorption(self.absorption, undesigned)

    def remarks(self) -> Mapping[str, str]:
        """The index of a named material, and the control points that the program has chosen."""
        remarks = self.net_remarks()
        if isinstance(self.refractive_index, str):
            remarks["refractive_index"] = f"n = {self.index:.5f}"
        return remarks

    def _check_range(self, low: float, high: float) -> None:
        """Refuse a height range that leaves a control point nowhere to be."""
        lowest, highest = self.base.extent(self.half_width)
        if lowest + high <= self.floor:
            raise Refused(
                "lens.height_range[1]",
                Said(
                    "{height:g} leaves no room above the minimal thickness; more than {least:g}",
                    height=high,
                    least=self.floor - lowest,
                ),
            )
        if highest + low >= self.ceiling:
            raise Refused(
                "lens.height_range[0]",
                Said(
                    "{height:g} leaves no room below the maximal thickness; less than {most:g}",
                    height=low,
                    most=self.ceiling - highest,
                ),
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
        low, high = self.entrance_offsets
        return self.entrance_z + low, self.entrance_z + high

    @property
    def entrance_offsets(self) -> tuple[float, float]:
        """How far the entrance face can come from its place, down and up."""
        return self.entrance.offsets(self._room_at_entrance)

    @property
    def datum(self) -> float:
        """The place of the entrance face."""
        return self.entrance_z

    @property
    def _room_at_entrance(self) -> float:
        """How far a freeform entrance face may rise where nobody says so.

        Half of what both faces share at most, so that the exit face has as much: the glass between
        their places, and where that is thin, half of the lens's half-width.
        """
        glass = self.base.extent(self.half_width)[0] - self.entrance_z - self.min_thickness
        shared = [max(2 * _RISE * max(self.half_width), glass)]
        if self.max_thickness is not None:
            shared.append(self.max_thickness - self.min_thickness)
        if self.height_range is not None:
            top = self.base.extent(self.half_width)[0] + self.height_range[1]
            shared.append(top - self.entrance_z - self.min_thickness)
        return max(min(shared) / 2, 0.0)

    @property
    def leaving_z(self) -> float:
        """The highest that the exit face can become, as far as a design may come to it."""
        top = self.base.extent(self.half_width)[1]
        return min(self.highest, max(top, self.floor) + _RISES * max(self.half_width))

    @property
    def lowest(self) -> float:
        """That of the entrance face."""
        return self.front_z

    @property
    def floor(self) -> float:
        """The z that the minimal thickness keeps the exit face above."""
        return self.entrance_range[1] + self.min_thickness

    @property
    def ceiling(self) -> float:
        """The z that the maximal thickness keeps the exit face below; infinite without one."""
        return math.inf if self.max_thickness is None else self.front_z + self.max_thickness

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
    def deflection(self) -> float:
        """As light leaves the glass."""
        return self.index - 1

    @property
    def held_by(self) -> Literal["max_thickness", "screen"]:
        """The stock, or the screen."""
        return "screen" if self.max_thickness is None else "max_thickness"

    def bounded(
        self, source_z: float, receiver_z: float, several: bool = False, part: float = 1.0
    ) -> Self:
        """Return the lens with all limits of its heights; see `Optic.bounded`.

        An automatic entrance face rises by no more than a part of the way from the source, and for
        one image by no more than a part of the lens's half-width.
        """
        rise = min(self._room_at_entrance, _NEAR_RISE * (self.entrance_z - source_z))
        if not several:
            rise = min(rise, _RISE * max(self.half_width))
        entrance = self.entrance.within(self.entrance.offsets(rise))
        lens = self.model_copy(update={"entrance": entrance})
        if self.height_range is not None or self.max_thickness is not None:
            return lens
        if math.isinf(receiver_z):
            receiver_z = lens.highest + _FAR * max(self.half_width)
        receiver_z = min(receiver_z, lens.highest + _THICKEST * max(self.half_width))
        thickness = (1 - part) * lens.highest + part * receiver_z - self.front_z
        return lens.model_copy(update={"max_thickness": thickness})

    def ranged(self, low: float, high: float) -> Self:
        """See `Optic.ranged`: the entrance face keeps the room that it has now."""
        entrance = self.entrance.within(self.entrance_offsets)
        return super().ranged(low, high).model_copy(update={"entrance": entrance})

    def flat_z(self, heights: Array) -> float:
        """The entrance face."""
        return self.entrance_z

    @property
    def steepest(self) -> float:
        """By Snell's law at the entrance face."""
        return float((self.index**2 - 1) ** -0.5)

    @property
    def least_thickness(self) -> float:
        """That of the glass."""
        return self.min_thickness

    @property
    def index(self) -> float:
        """Refractive index as a number."""
        if not isinstance(self.refractive_index, str):
            return float(self.refractive_index)
        if self.wavelength_um is None:
            named = shown(self.refractive_index)
            raise Refused(
                "lens.wavelength_um", Said("missing; it goes with {material}", material=named)
            )
        return materials.refractive_index(self.refractive_index, self.wavelength_um)
