"""A screen: a plane on which light is wanted."""

import math
from typing import TYPE_CHECKING, Annotated

from workbench.errors import Refused
from workbench.scene.fields import LENGTH, about
from workbench.scene.part import Positive
from workbench.scene.receiver import AnyReceiver, Array, Pixels

if TYPE_CHECKING:
    from workbench.scene.lens import Lens


class Screen(AnyReceiver):
    """Plane across the axis, centred on it."""

    measure = LENGTH
    axes = "x", "y"

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
    pixels: Pixels

    @property
    def half_extent(self) -> tuple[float, float]:
        """Its half-width."""
        return self.half_width

    @property
    def pixel_measure(self) -> float:
        """Area of one pixel, scene units squared."""
        return 4 * math.prod(self.half_width) / math.prod(self.pixels)

    def total(self, density: Array) -> float:
        """Flux of an image (n_y, n_x) of irradiance."""
        return float(density.sum()) * self.pixel_measure

    @property
    def nearest_z(self) -> float:
        """Where its lowest edge is."""
        return self.z

    def per_radian(self, z: float) -> tuple[float, float]:
        """How far from there it is."""
        return self.z - z, self.z - z

    def check_behind(self, lens: "Lens") -> None:
        """Refuse a lens that may touch it."""
        if self.z <= lens.highest:
            raise Refused(
                "screen.z",
                f"{self.z:g} may touch the lens; "
                f"more than {lens.highest:g}, the highest that the exit face can become",
            )
