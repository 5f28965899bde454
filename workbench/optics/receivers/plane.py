"""A screen, anywhere in the light and tilted."""

from collections.abc import Iterable

import torch
from torch import Tensor

from workbench.optics.rays import RayBundle, Vector
from workbench.optics.receivers.receiver import ACROSS, ReceiverNumbers, Triple
from workbench.scene import Screen


class PlaneReceiver:
    """Plane on which light makes an image; a `Receiver`.

    `screen`: the part of the plane on which light is wanted; `datum`: z of the scene from which the
    path counts z; `onwards`: 1 for light that comes along the screen's own +z, -1 for light that
    comes against it.
    """

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
