"""Refraction at a face between two media, with Fresnel's losses."""

import torch

from workbench.optics.interfaces.interface import Passed
from workbench.optics.rays import RayBundle
from workbench.optics.refraction import refract, schlick_transmittance
from workbench.optics.surfaces.surface import Meeting


class Refraction:
    """Snell's law; an `Interface`.

    Parameters
    ----------
    before, behind : float
        Refractive indices on the sides from which and to which the light goes.
    reflected : str
        Name in the light account of what is reflected where the rest is refracted.

    Attributes
    ----------
    ratio : float
        Index before the face over that behind it.
    reflected : str
        As given.

    Notes
    -----
    Flux by Schlick's approximation, in the angle on the thinner side; total reflection takes all
    of it and is called ``total_reflection`` in the account of any face.
    """

    def __init__(self, before: float, behind: float, reflected: str) -> None:
        self.ratio, self.reflected = before / behind, reflected

    def turn(self, rays: RayBundle, meeting: Meeting) -> Passed:
        """The refracted light; see `Interface.turn`."""
        out = refract(rays.direction, meeting.normal, self.ratio)
        leaves_denser = self.ratio > 1
        cos_thin = out.cos_out if leaves_denser else out.cos_in
        index = self.ratio if leaves_denser else 1 / self.ratio
        flux = torch.where(meeting.met, rays.flux, 0.0)
        passes = meeting.met & out.passes
        transmitted = torch.where(passes, flux * schlick_transmittance(cos_thin, index), 0.0)
        lost = {"total_reflection": flux * ~out.passes}
        lost[self.reflected] = (flux - transmitted) * out.passes
        return Passed(RayBundle(meeting.position, out.direction, transmitted, passes), lost)
