"""The far field: light by its direction."""

import math

import torch
from torch import Tensor

from workbench.optics.rays import RayBundle, Vector
from workbench.optics.receivers.receiver import ACROSS, ReceiverNumbers
from workbench.scene import FarField

_NOWHERE = 0.0, 0.0, 0.0


class FarFieldReceiver:
    """Directions in which light makes an image; a `Receiver`.

    `far_field`: the directions in which light is wanted; `distance`: how far away rays end in a
    drawing, scene units; `onwards`: 1 for light to +z, -1 for light to -z. `upright`: it is no
    plane.
    """

    upright = False

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
