"""Reflection at a mirror, which absorbs the rest."""

import torch

from workbench.optics.interfaces.interface import Passed
from workbench.optics.rays import RayBundle
from workbench.optics.surfaces.surface import Meeting


class Reflection:
    """The law of reflection; an `Interface`.

    Parameters
    ----------
    reflectance : float
        Part of the light that is reflected, at all angles.
    absorbed : str
        Name of the rest in the light account.
    """

    def __init__(self, reflectance: float, absorbed: str) -> None:
        self.reflectance, self.absorbed = reflectance, absorbed

    def turn(self, rays: RayBundle, meeting: Meeting) -> Passed:
        """The reflected light; see `Interface.turn`."""
        (d_x, d_y, d_z), (n_x, n_y, n_z) = rays.direction, meeting.normal
        twice = 2 * (d_x * n_x + d_y * n_y + d_z * n_z)
        direction = d_x - twice * n_x, d_y - twice * n_y, d_z - twice * n_z
        arriving = torch.where(meeting.met, rays.flux, 0.0)
        reflected = self.reflectance * arriving
        lost = {self.absorbed: arriving - reflected} if self.reflectance < 1 else {}
        return Passed(RayBundle(meeting.position, direction, reflected, meeting.met), lost)
