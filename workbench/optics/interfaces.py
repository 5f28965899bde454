"""What a face does to the light that meets it: refraction, transmittance, reflection."""

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any, NamedTuple, Protocol, TypeVar, cast

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.optics.kernels.refraction import fresnel, schlick
from workbench.optics.rays import RayBundle, Vector
from workbench.optics.surfaces.surface import Meeting
from workbench.scene import Lens

Cosine = TypeVar("Cosine", Tensor, Array, float)


class Law(Protocol):
    """What decides how much of the light a face between two media refracts."""

    @property
    def ratio(self) -> float:
        """Refractive index before the face over that behind it."""
        ...

    def at(self, cos_in: Cosine, cos_out: Cosine) -> Cosine:
        """Part of the light that is refracted.

        Parameters
        ----------
        cos_in, cos_out : Tensor, ndarray or float
            Cosines of the angles of incidence and refraction.
        """
        ...


def laws_of(lens: Lens) -> tuple[Law, Law]:
    """Those of the entrance face and of the exit face."""
    entering, leaving = 1 / lens.index, lens.index
    if lens.coating is None:
        law = _LAWS[lens.reflection]
        return law(entering), law(leaving)
    front, back = lens.coating
    return TransmittanceLaw.constant(entering, front), TransmittanceLaw.constant(leaving, back)


class TransmittanceLaw(NamedTuple):
    """A `Law` that the compiled train knows.

    Attributes
    ----------
    ratio : float
        Refractive index before the face over that behind it.
    passing : float
        Part that is refracted at normal incidence.
    grazing : float
        Part of that which is lost at grazing incidence: 1 with Schlick's approximation, 0 of a
        face that transmits the same at all angles. Not used if ``exact``.
    exact : bool
        Whether Fresnel's equations for unpolarised light decide.
    """

    ratio: float
    passing: float
    grazing: float
    exact: bool

    @classmethod
    def fresnel(cls, ratio: float) -> "TransmittanceLaw":
        """Fresnel's equations, the mean of both polarisations."""
        return cls(ratio, 1 - normal_reflectance(ratio), 1.0, True)

    @classmethod
    def schlick(cls, ratio: float) -> "TransmittanceLaw":
        """Schlick's approximation (1994, eq. 24), in the angle on the thinner side."""
        return cls(ratio, 1 - normal_reflectance(ratio), 1.0, False)

    @classmethod
    def constant(cls, ratio: float, reflectance: float) -> "TransmittanceLaw":
        """The same reflectance at all angles below that of total reflection."""
        return cls(ratio, 1 - reflectance, 0.0, False)

    def at(self, cos_in: Cosine, cos_out: Cosine) -> Cosine:
        """Part of the light that is refracted, see `Law.at`; 0 at grazing incidence if bare."""
        if self.exact:
            return cast(Cosine, fresnel(self.ratio, cos_in, cos_out))
        cos = cos_in if self.ratio < 1 else cos_out
        return cast(Cosine, schlick(1.0, self.passing, self.grazing, cos))

    def cast(self, kind: type[np.floating[Any]]) -> "TransmittanceLaw":
        """The same law for kernels of a float type."""
        return TransmittanceLaw._make([*map(kind, self[:3]), self.exact])


_LAWS: Mapping[str, Callable[[float], Law]] = {
    "fresnel": TransmittanceLaw.fresnel,
    "schlick": TransmittanceLaw.schlick,
    "none": partial(TransmittanceLaw.constant, reflectance=0.0),
}


def normal_reflectance(index: float) -> float:
    """Part of the light that is reflected at normal incidence; of an index or one over it."""
    return ((index - 1) / (index + 1)) ** 2


class Refracted(NamedTuple):
    """What happens to rays at a face."""

    # Unit directions of the refracted rays; of totally reflected ones a finite stand-in.
    direction: Vector
    # Cosines of the angles of incidence and refraction; cos_out is 1 under total reflection.
    cos_in: Tensor
    cos_out: Tensor
    passes: Tensor  # False where the ray is totally reflected


def refract(direction: Vector, normal: Vector, ratio: float) -> Refracted:
    """Vector form of Snell's law.

    `direction`: unit directions of the incoming rays; `normal`: unit normals that point the way the
    light goes (positive product with ``direction``); `ratio`: refractive index before the face over
    that behind it.

    Notes
    -----
    t = η d + (cos θ_t − η cos θ_i) N. The factor of N is taken as (1 − η²) / (cos θ_t + η cos θ_i),
    the same number without the cancellation that costs all digits as η goes to 1.
    """
    (d_x, d_y, d_z), (n_x, n_y, n_z) = direction, normal
    cos_in = d_x * n_x + d_y * n_y + d_z * n_z
    cos_out, passes = root_where_positive(1 - ratio**2 * (1 - cos_in.square()))
    along = (1 - ratio**2) / (cos_out + ratio * cos_in)
    out = (ratio * d_x + along * n_x, ratio * d_y + along * n_y, ratio * d_z + along * n_z)
    return Refracted(out, cos_in, cos_out, passes)


def root_where_positive(square: Tensor) -> tuple[Tensor, Tensor]:
    """Square root where a squared cosine is positive, and where that is.

    Within rounding of the critical angle no light passes (its weight is 0 there), which keeps
    the slope of the root finite; masked rays get the root 1 and with it no gradient.
    """
    positive = square > 16 * torch.finfo(square.dtype).eps
    return torch.where(positive, square, 1.0).sqrt(), positive


class Passed(NamedTuple):
    """Light behind an interface.

    Attributes
    ----------
    rays : RayBundle
        It starts where the light met the face.
    lost : mapping of str to Tensor
        Flux that each ray lost, by its key in the light account.
    """

    rays: RayBundle
    lost: Mapping[str, Tensor]


class Interface(Protocol):
    """Turns rays that have met a face, and takes its share of their flux.

    Attributes
    ----------
    compiled : bool
        Whether the compiled train knows it; else rays pass it by `turn` alone.
    """

    compiled: bool

    def turn(self, rays: RayBundle, meeting: Meeting) -> Passed:
        """The light that goes on.

        Parameters
        ----------
        rays : RayBundle
            Before the face.
        meeting : Meeting
            Where they meet it.
        """
        ...


class Reflection:
    """The law of reflection; an `Interface`.

    Parameters
    ----------
    reflectance : float
        Part of the light that is reflected, at all angles.
    absorbed : str
        Key of the rest in the light account.
    """

    compiled = True

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


class Refraction:
    """Snell's law; an `Interface`.

    Parameters
    ----------
    law : Law
        The refractive indices, and how much of the light is refracted.
    reflected : str
        Key in the light account of what is reflected where the rest is refracted.
    absorption : float
        Of the medium before the face, per length: flux falls as exp(−absorption · path).
    total, absorbed : str
        Keys in the light account of what is totally reflected, and of what the medium absorbs.
        Without ``total``, for a face without total reflection, all that the face takes is
        ``reflected``.
    """

    def __init__(
        self,
        law: Law,
        reflected: str,
        absorption: float = 0.0,
        total: str | None = "total_reflection",
        absorbed: str = "absorbed",
    ) -> None:
        self.law, self.reflected, self.absorption = law, reflected, absorption
        self.total, self.absorbed = total, absorbed
        self.compiled = isinstance(law, TransmittanceLaw)

    def turn(self, rays: RayBundle, meeting: Meeting) -> Passed:
        """The refracted light; see `Interface.turn`."""
        out = refract(rays.direction, meeting.normal, self.law.ratio)
        lost = {}
        flux = torch.where(meeting.met, rays.flux, 0.0)
        if self.absorption > 0:
            arriving = flux * (-self.absorption * _way(rays.position, meeting.position)).exp()
            lost[self.absorbed] = flux - arriving
            flux = arriving
        passes = meeting.met & out.passes
        part = self.law.at(out.cos_in, out.cos_out)
        transmitted = torch.where(passes, flux * part, 0.0)
        if self.total is None:
            lost[self.reflected] = flux - transmitted
        else:
            lost[self.total] = flux * ~out.passes
            lost[self.reflected] = (flux - transmitted) * out.passes
        return Passed(RayBundle(meeting.position, out.direction, transmitted, passes), lost)


def _way(start: Vector, end: Vector) -> Tensor:
    """Lengths of straight ways, with a finite slope where they are 0."""
    x, y, z = (after - before for before, after in zip(start, end, strict=True))
    return (x.square() + y.square() + z.square()).clamp_min(torch.finfo(z.dtype).tiny).sqrt()
