"""Refraction at a face between two media, with the light that is reflected and absorbed."""

import torch
from torch import Tensor

from workbench.optics.interfaces.interface import Passed
from workbench.optics.rays import RayBundle, Vector
from workbench.optics.refraction import refract
from workbench.optics.surfaces.surface import Meeting
from workbench.optics.transmittance import TransmittanceLaw


class Refraction:
    """Snell's law; an `Interface`.

    Parameters
    ----------
    law : TransmittanceLaw
        The refractive indices, and how much of the light is refracted.
    reflected : str
        Name in the light account of what is reflected where the rest is refracted.
    absorption : float
        Of the medium before the face, per length: flux falls as exp(−absorption · path).

    Notes
    -----
    Total reflection takes all of the flux and is called ``total_reflection`` in the account of any
    face.
    """

    def __init__(self, law: TransmittanceLaw, reflected: str, absorption: float = 0.0) -> None:
        self.law, self.reflected, self.absorption = law, reflected, absorption

    def turn(self, rays: RayBundle, meeting: Meeting) -> Passed:
        """The refracted light; see `Interface.turn`."""
        out = refract(rays.direction, meeting.normal, self.law.ratio)
        lost = {}
        flux = torch.where(meeting.met, rays.flux, 0.0)
        if self.absorption > 0:
            arriving = flux * (-self.absorption * _way(rays.position, meeting.position)).exp()
            lost["absorbed"] = flux - arriving
            flux = arriving
        passes = meeting.met & out.passes
        part = self.law.at(out.cos_in, out.cos_out)
        transmitted = torch.where(passes, flux * part, 0.0)
        lost["total_reflection"] = flux * ~out.passes
        lost[self.reflected] = (flux - transmitted) * out.passes
        return Passed(RayBundle(meeting.position, out.direction, transmitted, passes), lost)


def _way(start: Vector, end: Vector) -> Tensor:
    """Lengths of straight ways, with a finite slope where they are 0."""
    x, y, z = (after - before for before, after in zip(start, end, strict=True))
    return (x.square() + y.square() + z.square()).clamp_min(torch.finfo(z.dtype).tiny).sqrt()
