"""The screen, and how rays become an image on it."""

import math
from typing import Annotated, Any, Literal, Self

from pydantic import Field, Tag, model_validator

from workbench.errors import Refused
from workbench.refusals import told_by
from workbench.scene.part import LENGTH, Part, Positive

PixelCount = Annotated[int, Field(ge=1, le=4096)]


class Screen(Part):
    """Plane at ``z`` centred on the axis; ``pixels`` are (along x, along y)."""

    z: Annotated[float, LENGTH]
    half_width: Annotated[tuple[Positive, Positive], LENGTH]
    pixels: tuple[PixelCount, PixelCount]

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


class BoxFilter(Part):
    """Every ray counts fully in the pixel that it hits."""

    kind: Literal["box"] = "box"


class GaussianFilter(Part):
    """Truncated Gaussian over ``size`` = (ν_x, ν_y) pixels; ``alpha`` per pixel²."""

    kind: Literal["gaussian"] = "gaussian"
    size: tuple[Annotated[int, Field(ge=1, le=99)], Annotated[int, Field(ge=1, le=99)]] = (3, 3)
    alpha: Annotated[float, Field(ge=1e-6, le=1e6)] = 1.0

    @model_validator(mode="after")
    def _odd(self) -> Self:
        for axis, size in enumerate(self.size):
            if size % 2 == 0:
                raise Refused(f"filter.size[{axis}]", f"{size} is even; an odd number is needed")
        return self


Filter = GaussianFilter | BoxFilter
FilterField = Annotated[
    Annotated[GaussianFilter, Tag("gaussian")] | Annotated[BoxFilter, Tag("box")],
    told_by("kind", "gaussian", "box", otherwise="gaussian"),
]
