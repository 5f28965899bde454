"""The screen, and how rays become an image on it."""

import math
from typing import Annotated, Any, ClassVar, Literal

from pydantic import AfterValidator, ConfigDict, Field
from pydantic_core import PydanticCustomError

from workbench.scene.fields import LENGTH, Measure, about
from workbench.scene.kinds import Kinds
from workbench.scene.part import Part, Positive

PixelCount = Annotated[int, Field(ge=1, le=4096)]


class Screen(Part):
    """Plane across the axis, centred on it."""

    z: Annotated[
        float,
        LENGTH,
        about("At z", "Where the screen stands on the optical axis; beyond the lens."),
    ]
    half_width: Annotated[
        tuple[Positive, Positive],
        LENGTH,
        about("Half width", "Half of the screen's extent along x and y. The target fills it."),
    ]
    pixels: Annotated[
        tuple[PixelCount, PixelCount],
        about(
            "Pixels",
            "Pixels along x and y in which the light is counted and compared with the target.",
        ),
    ]

    def to_pixels(self, x: Any, y: Any) -> tuple[Any, Any]:
        """Continuous image coordinates (column, row) of points on the screen.

        Pixel (row i, column j) covers [j, j+1) × [i, i+1). Row 0 is at +y and column 0 at −x.
        This is the one place where y turns into rows.

        Parameters
        ----------
        x, y : float, numpy array or torch tensor
            Position on the screen, scene units.
        """
        (r_x, r_y), (n_x, n_y) = self.half_width, self.pixels
        return (x + r_x) * (n_x / (2 * r_x)), (r_y - y) * (n_y / (2 * r_y))

    def contains(self, x: Any, y: Any) -> Any:
        """Whether points of its plane are on the screen; numpy arrays or torch tensors."""
        column, row = self.to_pixels(x, y)
        n_x, n_y = self.pixels
        return (column >= 0) & (column < n_x) & (row >= 0) & (row < n_y)

    @property
    def pixel_area(self) -> float:
        """Area of one pixel, scene units squared."""
        return 4 * math.prod(self.half_width) / math.prod(self.pixels)


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


class GaussianFilter(Part):
    """Light falls off over some pixels, so that a design feels where in a pixel a ray lands."""

    model_config = ConfigDict(title="Gaussian")

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
