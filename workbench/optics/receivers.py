"""Receivers: planes and far fields.

A new kind of receiver is a class here, its fields in `workbench.scene`, and a row in `_RECEIVERS`.
"""

import math
from collections.abc import Callable, Iterable, Mapping
from typing import Any, NamedTuple, Protocol

import torch
from torch import Tensor

from workbench.optics.rays import RayBundle, Vector
from workbench.scene import AnyReceiver, Element, FarField, Screen

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
    """Says in which pixels rays land.

    Attributes
    ----------
    compiled : bool
        Whether compiled kernels know it, by its `numbers`; else light lands by `places` alone.
    """

    compiled: bool

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


class PlaneReceiver:
    """Plane on which light makes an image; a `Receiver`.

    `screen`: the part of the plane on which light is wanted; `datum`: z of the scene from which the
    path counts z; `onwards`: 1 for light that comes along the screen's own +z, -1 for light that
    comes against it.
    """

    compiled = True

    def __init__(self, screen: Screen, datum: float, onwards: int = 1) -> None:
        self.part = screen
        right, up, across = screen.sides
        self._right, self._up, self._away = map(_triple, (right, up, onwards * across))
        x, y, z = _triple(screen.position)
        self._middle = x, y, z - datum

    @property
    def upright(self) -> bool:
        """As its screen is."""
        return self.part.upright

    def places(self, rays: RayBundle) -> tuple[Tensor, Tensor]:
        """See `Receiver`."""
        way, hits = self._way(rays)
        from_middle = _from(_moved(rays, way), self._middle)
        x, y = (_along(from_middle, side) for side in (self._right, self._up))
        column, row = self.part.to_pixels(x, y)
        return torch.where(hits, column, torch.inf), torch.where(hits, row, torch.inf)

    def ends(self, rays: RayBundle) -> Vector:
        """Where rays meet the plane."""
        return _moved(rays, self._way(rays)[0])

    def numbers(self) -> ReceiverNumbers:
        """See `Receiver`."""
        (r_x, r_y), (n_x, n_y) = self.part.half_width, self.part.pixels
        right, up = self.part.sides[0], self.part.sides[1]
        column, row = _triple(right * (n_x / (2 * r_x))), _triple(up * (-n_y / (2 * r_y)))
        return ReceiverNumbers(
            False, self._middle, self._away, column, row, *self.part.to_pixels(0.0, 0.0)
        )

    def _way(self, rays: RayBundle) -> tuple[Tensor, Tensor]:
        """How far rays are from the plane along them, and whether they meet it."""
        along = _along(rays.direction, self._away)
        across = along.abs() > ACROSS
        way = -_along(_from(rays.position, self._middle), self._away)
        way = way / torch.where(across, along, 1.0)
        # Light towards the screen begins before it, even where rounding says otherwise.
        return way, rays.alive & across & ((along > 0) | (way > 0))


def _moved(rays: RayBundle, way: Tensor) -> Vector:
    (x, y, z), (d_x, d_y, d_z) = rays.position, rays.direction
    return x + d_x * way, y + d_y * way, z + d_z * way


def _from(place: Vector, middle: Triple) -> Vector:
    x, y, z = place
    return x - middle[0], y - middle[1], z - middle[2]


def _along(vector: Vector, side: Triple) -> Tensor:
    """Scalar product with a unit vector, most parts of which are mostly 0."""
    parts = [part * c for part, c in zip(vector, side, strict=True) if c]
    return sum(parts[1:], parts[0])


def _triple(vector: Iterable[float]) -> Triple:
    x, y, z = map(float, vector)
    return x, y, z


_NOWHERE = 0.0, 0.0, 0.0


class FarFieldReceiver:
    """Directions in which light makes an image; a `Receiver`.

    `far_field`: the directions in which light is wanted; `distance`: how far away rays end in a
    drawing, scene units; `onwards`: 1 for light to +z, -1 for light to -z. `upright`: it is no
    plane.
    """

    upright = False
    compiled = True

    def __init__(self, far_field: FarField, distance: float, onwards: int = 1) -> None:
        self.part, self._distance, self._onwards = far_field, distance, onwards

    def places(self, rays: RayBundle) -> tuple[Tensor, Tensor]:
        """See `Receiver`."""
        d_x, d_y, d_z = rays.direction
        d_z = self._onwards * d_z
        onwards = rays.alive & (d_z > ACROSS)
        d_z = torch.where(onwards, d_z, 1.0)
        h = torch.atan2(d_x, d_z)
        v = torch.atan2(d_y, (d_x.square() + d_z.square()).sqrt())
        column, row = self.part.to_pixels(torch.rad2deg(h), torch.rad2deg(v))
        return torch.where(onwards, column, torch.inf), torch.where(onwards, row, torch.inf)

    def ends(self, rays: RayBundle) -> Vector:
        """Where rays are after some way."""
        x, y, z = (p + d * self._distance for p, d in zip(*rays[:2], strict=True))
        return x, y, z

    def numbers(self) -> ReceiverNumbers:
        """See `Receiver`."""
        (half_h, half_v), (n_x, n_y) = self.part.half_angle, self.part.pixels
        per_h, per_v = n_x / math.radians(2 * half_h), -n_y / math.radians(2 * half_v)
        column, row = (per_h, 0.0, 0.0), (per_v, 0.0, 0.0)
        return ReceiverNumbers(
            True, _NOWHERE, _NOWHERE, column, row, *self.part.to_pixels(0.0, 0.0), self._onwards
        )


_RECEIVERS: Mapping[type, Callable[[Any, Element, float, int], Receiver]] = {
    Screen: lambda screen, _, datum, onwards: PlaneReceiver(screen, datum, onwards),
    FarField: lambda far_field, optic, _, onwards: FarFieldReceiver(
        far_field, far_field.radius(optic), onwards
    ),
}


def receiver_of(part: AnyReceiver, optic: Element, datum: float, onwards: int) -> Receiver:
    """The element on which light makes an image; lit by an element; z is counted from a datum.

    ``onwards`` is 1 for light that comes along +z of the receiver's own coordinates, −1 for light
    that comes against it.
    """
    return _RECEIVERS[type(part)](part, optic, datum, onwards)
