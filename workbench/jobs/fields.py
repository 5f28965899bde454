"""Fields and scene parts that several jobs share."""

from typing import Annotated, Any, Literal

import resources
from workbench.powers import rounded
from workbench.scene import ImageTarget, Measure, Part, Positive, Target
from workbench.scene.fields import LENGTH, Choices, about

Picture = Annotated[
    Target, about("Picture", "What the light shall draw: a picture file, a shape or a word.")
]
Pair = tuple[Positive, Positive]
Size = Annotated[
    Pair, LENGTH, about("Lens size", "Full width and height of the lens; all of it is lit.")
]
ImageSize = Annotated[
    Pair,
    LENGTH,
    about("Image size", "Full width and height of the image; the picture is fitted into it."),
]
Distance = Annotated[
    Positive,
    LENGTH,
    about("Distance to the image", "From the entrance face of the lens to the image."),
]
LampDistance = Annotated[
    Positive, LENGTH, about("Lamp to lens", "From the lamp to the entrance face of the lens.")
]
LampSize = Annotated[
    Pair, LENGTH, about("LED size", "Full width and height of the LED's bright face.")
]
LampFlux = Annotated[
    Positive | None,
    Measure("lm", "lumen"),
    about(
        "Luminous flux",
        "All light of the lamp, as its data sheet says. With it, light is given in lux and lumen; "
        "left empty, in parts of all light.",
        le=1e9,
    ),
]
MATERIALS = (
    ("PMMA", "Acrylic (PMMA)"),
    ("PC", "Polycarbonate"),
    ("PS", "Polystyrene"),
    ("N-BK7", "Glass (N-BK7)"),
    ("fused silica", "Fused silica"),
)
"""Materials of the catalogue, and what a person reads for each."""
Material = Annotated[
    Literal["PMMA", "PC", "PS", "N-BK7", "fused silica"],
    Choices(MATERIALS),
    about("Material", "What the lens is made of. Any index can be given later."),
]
Thickness = Annotated[
    Positive | None,
    LENGTH,
    about(
        "Stock thickness",
        "Thickness of the plate that the lens is cut from. Left empty, any will do, and one is "
        "proposed.",
    ),
]
WAVELENGTH_NM = Measure("nm")
GREEN_UM = 0.55
SUN = 0.533
"""Angular diameter of the sun, degrees."""


def shipped(name: str) -> ImageTarget:
    """A picture that ships with the program, whose numbers are light, for viewers of a wall."""
    image = str(resources.path("targets", f"{name}-256.png"))
    return ImageTarget(image=image, viewed_from="front")


def lens(size: tuple[float, float], material: str) -> dict[str, Any]:
    """A lens of a full width and height, whose back face is designed."""
    return {
        "kind": "lens",
        "name": "lens",
        "half_width": halves(size),
        "material": material,
        "faces": [{"shape": "plane"}, {"shape": "bspline", "control_points": "auto"}],
    }


def mirror(size: tuple[float, float]) -> dict[str, Any]:
    """A mirror of a full width and height."""
    return {
        "kind": "mirror",
        "name": "mirror",
        "half_width": halves(size),
        "face": {"shape": "bspline", "control_points": "auto"},
    }


def screen(distance: float, size: tuple[float, float]) -> dict[str, Any]:
    """A screen of a full width and height across the axis."""
    return {"kind": "plane", "position": [0.0, 0.0, distance], "half_width": halves(size)}


def emitter(
    distance: float, size: tuple[float, float], lumens: float | None = None
) -> dict[str, Any]:
    """The bright face of an LED of a full width and height, so far before the lens."""
    return {
        "kind": "area",
        "position": [0.0, 0.0, -distance],
        "half_width": halves(size),
        "flux": lumens,
    }


def halves(size: tuple[float, float]) -> list[float]:
    """Half of each."""
    return [each / 2 for each in size]


def legible(*numbers: float) -> list[float]:
    """Numbers of a calculation with five digits, which a person can read and fields can show."""
    return [rounded(number, 5) for number in numbers]


def written(part: Part) -> dict[str, Any]:
    """A part as plain data."""
    data: dict[str, Any] = part.model_dump(mode="json", exclude_none=True)
    return data
