"""A screen across the axis."""

import torch
from torch import Tensor

from workbench.optics.rays import RayBundle
from workbench.scene import Screen

# A face that sends light sideways for ever sends it past any screen.
_ACROSS = 1e-6


class PlaneReceiver:
    """Plane at one z on which light makes an image.

    Parameters
    ----------
    screen : Screen
        The part of the plane on which light is wanted.
    datum : float
        z of the scene from which the path counts z.

    Attributes
    ----------
    screen : Screen
        As given.
    z : float
        Where the plane is, counted from the datum.
    """

    def __init__(self, screen: Screen, datum: float) -> None:
        self.screen, self.z = screen, screen.z - datum

    def places(self, rays: RayBundle) -> tuple[Tensor, Tensor]:
        """Where (x, y) rays hit the plane, scene units; infinite for those that never do."""
        (x, y, z), (d_x, d_y, d_z) = rays.position, rays.direction
        across = d_z.abs() > _ACROSS
        way = (self.z - z) / torch.where(across, d_z, 1.0)
        # Light to +z begins before the screen, even where rounding says otherwise.
        hits = rays.alive & across & ((d_z > 0) | (way > 0))
        return (
            torch.where(hits, x + d_x * way, torch.inf),
            torch.where(hits, y + d_y * way, torch.inf),
        )
