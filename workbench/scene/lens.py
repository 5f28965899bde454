"""The lens: two faces with a material between."""

import math
from collections.abc import Mapping
from typing import Annotated, Any, Literal, Self

from pydantic import (
    ConfigDict,
    Field,
    PrivateAttr,
    ValidationError,
    ValidatorFunctionWrapHandler,
    WrapValidator,
)
from pydantic_core import PydanticCustomError

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.levels import EXPERT, LIMITS
from workbench.materials import refractive_index
from workbench.messages import Message
from workbench.scene import limits
from workbench.scene.element import DEFAULT_WAVELENGTH, Element
from workbench.scene.fields import LENGTH, PLACE, Choices, Measure, Members, about
from workbench.scene.losses import LENS_LOSSES, Loss, TakesLight
from workbench.scene.part import NonNegative, Part, Positive
from workbench.scene.spline_face import Face, PlacedFace


class CustomIndex(Part):
    """A refractive index that is the same at all wavelengths."""

    model_config = ConfigDict(title="Custom index")

    index: Annotated[
        float, about("Index", "Refractive index at the wavelength of the light.", gt=1)
    ]
    _off: tuple[str, float] | None = PrivateAttr(default=None)

    def at(self, wavelength_um: float) -> float:
        """Refractive index at a wavelength."""
        if self._off is None:
            return self.index
        name, off = self._off
        return refractive_index(name, wavelength_um) + off


def _name_or_index(value: Any, read: ValidatorFunctionWrapHandler) -> Any:
    # One error, not one for each member of the union.
    try:
        return read(value)
    except ValidationError:
        raise PydanticCustomError("material", "neither a name nor an index above 1") from None


Material = Annotated[str | CustomIndex, WrapValidator(_name_or_index)]
Reflectance = Annotated[float, Field(ge=0, lt=1)]

# An automatic entrance face may rise by this part of the lens's half-width, and for several images
# by half of the glass too: light of an image at two distances is moved between the faces alone. In
# 100 mm of glass 100 mm wide they rise by 36 mm. The example *Photograph at two distances* with an
# automatic range is 0.8 % off, and 5.8 and 5.3 % with a quarter of the half-width. For one image a
# wide range gains nothing, and light of near sources leaves by the side before a face far in it.
_RISE = 0.25
# And by this part of the way from a source to it: what it may rise is glass that the exit face
# stands on, in which light of near sources spreads. With an LED 10 mm before a lens 120 mm wide and
# a rise of 0, 3, 6 and 15 mm the error is 24.5, 9.6, 8.8 and 13.7 %; 70, 69, 68 and 49 % of the
# light come to the screen.
_NEAR_RISE = 0.5
# A designed exit face seldom rises farther above its base than so many half-widths of the lens.
# Stock that reaches far to the screen does not state where the exit face will be: a first design in
# stock of 500 mm was 34 % off, and is 17 % off.
_RISES = 1.0
# A receiver that is infinitely far counts as so many half-widths of the lens away.
_FAR = 8.0
# An automatic thickness takes at most so many half-widths: where it goes up to a screen that is 1e9
# away, the undesigned lens was 250,000 thick, and its heights had too few digits for its shape.
_THICKEST = 1000.0


def _thinnest(data: dict[str, Any]) -> float:
    """Default minimal thickness: small beside the lens and its stock."""
    thickest, usual = data.get("max_thickness"), limits.relative(0.05)(data)
    return usual if thickest is None else min(usual, thickest / 2)


class Lens(Element):
    """Two faces with a material between; light goes through along its +z.

    ``max_thickness`` and ``min_thickness`` are counted between both faces and hold everywhere: each
    face stays on its side of a plane, or of two. Defaults scale with the lens.
    """

    called = "lens"
    most_faces = 2
    face_called = "exit face"
    body_called = "body of glass"
    front_called = Message("the entrance face")
    onwards = 1
    losses = LENS_LOSSES

    kind: Literal["lens"]
    material: Annotated[
        Material,
        about("Material", "What the lens is made of: a catalogue material, or a custom index."),
    ]
    thickness: Annotated[
        float,
        LENGTH,
        about("Thickness", "From the vertex of the front face to the vertex of the back face."),
    ]
    faces: Annotated[
        tuple[Face, Face],
        Members(("Front face", "Back face")),
        about("Faces", "Front face and back face, in the order in which light meets them."),
    ]
    _wavelength: float = PrivateAttr(default=DEFAULT_WAVELENGTH)
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
        EXPERT,
        about(
            "Absorption",
            "How much the glass absorbs per length: light falls as exp(−absorption · path). Clear "
            "glass and acrylic absorb some 0.0002 per mm.",
        ),
    ] = 0.0
    reflection: Annotated[
        Literal["fresnel", "schlick", "none"],
        Choices((("fresnel", "Fresnel, exact"), ("schlick", "Schlick, approximate"))),
        EXPERT,
        about(
            "Reflection",
            "What bare faces reflect: by Fresnel's equations for unpolarised light, by Schlick's "
            "approximation to them, as in the paper, or nothing. Under total reflection all of it.",
        ),
    ] = "fresnel"
    coating: Annotated[
        tuple[Reflectance, Reflectance] | None,
        PLACE,
        EXPERT,
        about(
            "Coating",
            "Part of the light that an antireflection coating reflects, at the entrance face and "
            "at the exit face, at all angles: 0.005 is a good one. Left empty, faces are bare.",
        ),
    ] = None
    max_thickness: Annotated[
        Positive | None,
        LENGTH,
        LIMITS,
        about(
            "Max. thickness",
            "The back face is at most this far from the front face: the thickness of the stock "
            "that the part is made of. Left empty, any will do.",
        ),
    ] = None
    min_thickness: Annotated[
        NonNegative,
        LENGTH,
        LIMITS,
        about(
            "Min. thickness",
            "The back face stays at least this far from the front face, so that the part can be "
            "made.",
        ),
    ] = Field(default_factory=_thinnest)

    @property
    def placed_faces(self) -> tuple[PlacedFace, ...]:
        """Front face and back face."""
        front, back = self.faces
        return (
            PlacedFace(f"{self.name}.front", "faces[0]", front, self.entrance_z),
            PlacedFace(f"{self.name}.back", "faces[1]", back, self.entrance_z + self.thickness),
        )

    def with_face(self, name: str, face: Face) -> Self:
        """See `Element.with_face`."""
        faces = (face, self.faces[1]) if name == f"{self.name}.front" else (self.faces[0], face)
        return self.model_copy(update={"faces": faces})

    def lit(self, wavelength_um: float) -> Self:
        """See `Element.lit`."""
        if wavelength_um == self._wavelength:
            return self
        copy = self.model_copy()
        copy._wavelength = wavelength_um
        return copy

    def denser(self, off: float) -> Self:
        """See `Element.denser`; its dispersion stays, and files have its index alone."""
        made = CustomIndex(index=self.index + off)
        if isinstance(self.material, str):
            made._off = self.material, off
        return self.model_copy(update={"material": made})

    @property
    def entrance_z(self) -> float:
        """Z of the vertex of the front face, scene units."""
        return self.position[2]

    def _own_heights(self) -> list[tuple[str, float]]:
        names = ("thickness", "max_thickness", "min_thickness")
        return [(name, getattr(self, name) or 0.0) for name in names]

    def check_element(self) -> None:
        """Refuse what cannot be computed with, and what cannot be made."""
        front, back = self.faces
        if front.designed and not back.designed:
            raise Refused(
                "faces[1].shape",
                Message("a B-spline front face needs a B-spline back face; 'bspline'"),
            )
        super().check_element()
        if not self.index > 1:
            raise Refused(
                "material", Message("{index:g}; greater than 1 is needed", index=self.index)
            )
        limits.check_index(self.index)
        if not self.designed:
            limits.check_absorption(self.absorption, self.thickness)
            return
        if self.z_min >= self.z_max:
            raise Refused(
                "max_thickness",
                Message(
                    "{height:g} is below the minimal thickness; use more than {least:g}",
                    height=self.max_thickness,
                    least=self.min_thickness,
                ),
            )
        if self.height_range is not None:
            self._check_range(*self.height_range)
        undesigned = max(self.base.extent(self.half_width)[0], self.z_min) - self.entrance_z
        limits.check_absorption(self.absorption, undesigned)

    def remarks(self) -> Mapping[str, str]:
        """The index of a named material."""
        return {"material": f"n = {self.index:.5f}"} if isinstance(self.material, str) else {}

    def _check_range(self, low: float, high: float) -> None:
        """Refuse a height range that leaves a control point nowhere to be."""
        lowest, highest = self.base.extent(self.half_width)
        if lowest + high <= self.z_min:
            raise Refused(
                "faces[1].height_range[1]",
                Message(
                    "{height:g} is below the minimal thickness; use more than {least:g}",
                    height=high,
                    least=self.z_min - lowest,
                ),
            )
        if highest + low >= self.z_max:
            raise Refused(
                "faces[1].height_range[0]",
                Message(
                    "{height:g} is above the maximal thickness; use less than {most:g}",
                    height=low,
                    most=self.z_max - highest,
                ),
            )

    @property
    def front_z(self) -> float:
        """The plane that sources stand before: no point of the entrance face is before it."""
        return self.entrance_range[0]

    @property
    def entrance_offsets(self) -> tuple[float, float]:
        """How far the entrance face can come from its place, down and up."""
        return self.entrance.offsets(self._entrance_rise, self.half_width)

    @property
    def datum(self) -> float:
        """See `Element.datum`."""
        return self.entrance_z

    @property
    def _entrance_rise(self) -> float:
        """How far a freeform entrance face may rise where nobody says so.

        Half of what both faces share at most, so that the exit face has as much: the glass between
        their places, and where that is thin, half of the lens's half-width.
        """
        glass = self.base.extent(self.half_width)[0] - self.entrance_z - self.min_thickness
        shared = [max(2 * _RISE * max(self.half_width), glass)]
        if self.max_thickness is not None:
            shared.append(self.max_thickness - self.min_thickness)
        if self.height_range is not None:
            shared.append(glass + self.height_range[1])
        return max(min(shared) / 2, 0.0)

    @property
    def leaving_z(self) -> float:
        """The highest that the exit face can become, as far as a design may come to it."""
        top = self.base.extent(self.half_width)[1]
        rises = max(top, self.z_min) + _RISES * max(self.half_width)
        return min(self.highest, rises) if self.designed else top

    @property
    def lowest(self) -> float:
        """That of the entrance face."""
        return self.front_z

    @property
    def z_min(self) -> float:
        """The z that the minimal thickness keeps the exit face above."""
        return self.entrance_range[1] + self.min_thickness

    @property
    def z_max(self) -> float:
        """The z that the maximal thickness keeps the exit face below; infinite without one."""
        return math.inf if self.max_thickness is None else self.front_z + self.max_thickness

    @property
    def highest(self) -> float:
        """The z that no point of the exit face can be above.

        Without any limit it is the top of the base: each run keeps the face clear of its screen.
        """
        top = self.base.extent(self.half_width)[1]
        if not self.designed:
            return top
        if self.height_range is not None:
            return min(top + self.height_range[1], self.z_max)
        return max(top, self.z_min) if self.max_thickness is None else self.z_max

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
        """Return the lens with all limits of its heights; see `Element.bounded`.

        An automatic entrance face rises by no more than a part of the way from the source, and for
        one image by no more than a part of the lens's half-width.
        """
        rise = min(self._entrance_rise, _NEAR_RISE * (self.entrance_z - source_z))
        if not several:
            rise = min(rise, _RISE * max(self.half_width))
        entrance = self.entrance.within(self.entrance.offsets(rise, self.half_width))
        lens = self.with_front(entrance)
        if self.height_range is not None or self.max_thickness is not None:
            return lens
        if math.isinf(receiver_z):
            receiver_z = lens.highest + _FAR * max(self.half_width)
        receiver_z = min(receiver_z, lens.highest + _THICKEST * max(self.half_width))
        thickness = (1 - part) * lens.highest + part * receiver_z - self.front_z
        return lens.model_copy(update={"max_thickness": thickness})

    def ranged(self, low: float, high: float) -> Self:
        """See `Element.ranged`: the entrance face keeps its present range."""
        return super().ranged(low, high).with_front(self.entrance.within(self.entrance_offsets))

    def flat_z(self, heights: Array) -> float:
        """The entrance face."""
        return self.entrance_z

    @property
    def steepest(self) -> float:
        """By Snell's law at the entrance face."""
        return float((self.index**2 - 1) ** -0.5)

    @property
    def least_loss(self) -> float:
        """What the coating, or the bare face at normal incidence, reflects."""
        if self.coating is not None:
            return self.coating[1]
        return 0.0 if self.reflection == "none" else ((self.index - 1) / (self.index + 1)) ** 2

    @property
    def least_thickness(self) -> float:
        """That of the glass."""
        return self.min_thickness

    @property
    def index(self) -> float:
        """Refractive index as a number."""
        if isinstance(self.material, CustomIndex):
            return self.material.at(self._wavelength)
        return refractive_index(self.material, self._wavelength)
