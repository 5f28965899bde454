"""The face to which all kernels follow light, and what they say of the light there."""

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
    level : float
        z of the scene near its mean height.
    mesh : bool
        Whether triangles stand for it.
    whole : bool
        Whether it fills the rectangle of its net.
    law : TransmittanceLaw
        How it refracts; the refractive index before it is larger than that behind it.
    absorption : float
        Of the medium before it, per length.
    missed, reflected : str
        Names of light that does not meet it, and that it reflects where the rest is refracted.
    """

    name: str
    net: ControlNet
    level: float
    mesh: bool
    whole: bool
    law: TransmittanceLaw
    absorption: float
    missed: str
    reflected: str

    @classmethod
    def of(cls, path: Path) -> "ExitFace | None":
        """The only face of a path that depends on heights; None where that is no such face."""
        face = cls.at(path.shaped[0]) if len(path.shaped) == 1 else None
        return face if face is not None and face.law.ratio > 1 else None

    @classmethod
    def at(cls, step: FaceStep) -> "ExitFace | None":
        """The face of a step; None where that is no B-spline that refracts."""
        match step:
            case FaceStep(
                BSplineSurface(name=name, net=net, outline=outline) as surface,
                Refraction(law=law, reflected=reflected, absorption=absorption),
                missed,
            ):
                shape = net, surface.level, surface.subdivisions is not None, outline.whole
                return cls(name, *shape, law, absorption, missed, reflected)
        return None

    @classmethod
    def rectangular(cls, path: Path) -> "ExitFace | None":
        """As `of`; None for a face that fills not all of its rectangle, too."""
        face = cls.of(path)
        return face if face is not None and face.whole else None

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
