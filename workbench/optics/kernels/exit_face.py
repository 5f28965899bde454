"""The face to which drawn rays are traced, and the account of their light there."""

from collections.abc import Mapping
from typing import NamedTuple

from torch import Tensor

from workbench.geometry.surface import ControlNet
from workbench.optics.account import Account
from workbench.optics.interfaces import Refraction
from workbench.optics.kernels.function import Sums
from workbench.optics.light import Light
from workbench.optics.path import Path
from workbench.optics.steps import FaceStep
from workbench.optics.surfaces import BSplineSurface
from workbench.optics.transmittance import TransmittanceLaw


class ExitFace(NamedTuple):
    """A B-spline that refracts light towards the receiver.

    Attributes
    ----------
    name : str
        What its heights are called.
    net : ControlNet
        Where its control heights sit.
    mesh : bool
        Whether triangles stand for it.
    law : TransmittanceLaw
        How it refracts; the refractive index before it is larger than that behind it.
    absorption : float
        Of the medium before it, per length.
    missed, reflected : str
        Names of light that does not meet it, and that it reflects where the rest is refracted.
    """

    name: str
    net: ControlNet
    mesh: bool
    law: TransmittanceLaw
    absorption: float
    missed: str
    reflected: str

    @classmethod
    def of(cls, path: Path) -> "ExitFace | None":
        """The only face that depends on heights; None unless it fills the rectangle of its net."""
        match path.shaped:
            case (
                FaceStep(
                    BSplineSurface(name=name, net=net, outline=outline) as surface,
                    Refraction(law=law, reflected=reflected, absorption=absorption),
                    missed,
                    None,
                ),
            ) if not surface.behind and outline.whole and law.ratio > 1:
                mesh = surface.subdivisions is not None
                return cls(name, net, mesh, law, absorption, missed, reflected)
        return None

    def light(self, flux: Tensor, sums: Sums, before: Mapping[str, float]) -> Light:
        """An image, and the account of its light; ``before`` is lost before this face, by name."""
        lost = dict(before)
        for name, part in (
            ("off_screen", sums.off_screen),
            ("total_reflection", sums.total_reflection),
            (self.reflected, sums.reflected),
            (self.missed, sums.missed),
            *([("absorbed", sums.absorbed)] if self.absorption > 0 else []),
        ):
            lost[name] = lost.get(name, 0.0) + part
        return Light(flux, Account(sums.on_screen, lost))
