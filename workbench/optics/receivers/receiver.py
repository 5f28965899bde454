"""What every kind of receiver does."""

from typing import NamedTuple, Protocol

from torch import Tensor

from workbench.optics.rays import RayBundle, Vector
from workbench.scene import AnyReceiver

ACROSS = 1e-6
"""Cosine below which light counts as going along a plane for ever."""

Triple = tuple[float, float, float]


class ReceiverNumbers(NamedTuple):
    """A receiver in numbers, for compiled kernels; z is counted from the path's datum."""

    # Whether it counts light by its direction alone: ``column_0 + column[0] H`` and ``row_0 +
    # row[0] V`` with H = atan2(d_x, d_z) and V = asin(d_y) in radians, for d_z > 0. Else it is a
    # plane: ``column_0 + column · (p − point)`` and ``row_0 + row · (p − point)``, where light with
    # ``normal · d`` > 0 meets it at p.
    far: bool
    point: Triple  # on the plane, scene units: its middle
    normal: Triple  # unit vector away from the light
    # Columns and rows for each scene unit along x, y and z.
    column: Triple
    row: Triple
    # Those of the point, or of the direction along the axis.
    column_0: float
    row_0: float
    # 1 for light to +z, -1 for light to -z, whose ``d_z`` a far field counts the other way.
    onwards: int = 1


class Receiver(Protocol):
    """Says in which pixels rays land."""

    @property
    def part(self) -> AnyReceiver:
        """The part of the scene."""
        ...

    @property
    def upright(self) -> bool:
        """Whether it is a plane across the axis whose columns and rows go along x and y."""
        ...

    def places(self, rays: RayBundle) -> tuple[Tensor, Tensor]:
        """Where rays land, as columns and rows; infinite for those that never do."""
        ...

    def ends(self, rays: RayBundle) -> Vector:
        """Where to end rays in a drawing, z counted from the datum.

        Any place for those that never land.
        """
        ...

    def numbers(self) -> ReceiverNumbers:
        """The same for compiled kernels."""
        ...
