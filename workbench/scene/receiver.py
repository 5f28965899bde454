"""What all receivers have in common: pixels in flat coordinates of their own."""

from typing import TYPE_CHECKING, Annotated, Any, ClassVar

import numpy as np
import numpy.typing as npt
from pydantic import Field

from workbench.scene.fields import Measure, about
from workbench.scene.part import Part

if TYPE_CHECKING:
    from workbench.scene.lens import Lens

Array = npt.NDArray[np.float64]

PixelCount = Annotated[int, Field(ge=1, le=4096)]
Pixels = Annotated[
    tuple[PixelCount, PixelCount],
    about(
        "Pixels",
        "Pixels along x and y in which the light is counted and compared with the target.",
    ),
]


class AnyReceiver(Part):
    """What each kind of receiver says of itself, so that nobody has to ask for its kind.

    Its coordinates (u, v) go to the right and up as one looks from it back at the lens.
    """

    measure: ClassVar[Measure]
    """Of its coordinates."""
    axes: ClassVar[tuple[str, str]]
    """Names of its coordinates."""

    if TYPE_CHECKING:  # each kind has this field, at its place in the file
        pixels: Pixels

    @property
    def half_extent(self) -> tuple[float, float]:
        """Half of what it covers along u and v."""
        raise NotImplementedError

    @property
    def middle(self) -> tuple[float, float]:
        """Its middle (u, v)."""
        return 0.0, 0.0

    @property
    def pixel_measure(self) -> float | Array:
        """What a pixel covers, by which its flux becomes a density: one number, or (n_y, 1)."""
        raise NotImplementedError

    @property
    def nearest_z(self) -> float:
        """Where it comes closest to the lens, scene units."""
        raise NotImplementedError

    def per_radian(self, z: float) -> tuple[float, float]:
        """How far in u and v light moves that is turned by a radian at a place z on the axis.

        For small angles about the direction of its middle.
        """
        raise NotImplementedError

    def check_behind(self, lens: "Lens") -> None:
        """Refuse a lens that cannot light it.

        Raises
        ------
        Refused
            With the path of the field, the value and what is allowed.
        """
        raise NotImplementedError

    def to_pixels(self, u: Any, v: Any) -> tuple[Any, Any]:
        """Continuous image coordinates (column, row) of places on the receiver.

        Pixel (row i, column j) covers [j, j+1) × [i, i+1). Row 0 is at +v and column 0 at −u.
        This is the one place where v turns into rows.

        Parameters
        ----------
        u, v : float, numpy array or torch tensor
            Place on the receiver, in its own coordinates.
        """
        (r_u, r_v), (n_x, n_y), (mid_u, mid_v) = self.half_extent, self.pixels, self.middle
        u, v = u - mid_u, v - mid_v
        return (u + r_u) * (n_x / (2 * r_u)), (r_v - v) * (n_y / (2 * r_v))

    def contains(self, u: Any, v: Any) -> Any:
        """Whether places in its coordinates are on it; numpy arrays or torch tensors."""
        return self.covers(*self.to_pixels(u, v))

    def covers(self, column: Any, row: Any) -> Any:
        """Whether image coordinates are on it; numpy arrays or torch tensors."""
        n_x, n_y = self.pixels
        return (column >= 0) & (column < n_x) & (row >= 0) & (row < n_y)

    def total(self, density: Array) -> float:
        """Flux of an image (n_y, n_x) of densities, one after the other where there are more."""
        return float((density * self.pixel_measure).sum())
