"""How much of the light a face refracts: Fresnel's equations, Schlick's approximation, coatings.

A law is a few numbers, so that the reference, quadratures and compiled kernels
(`workbench.optics.kernels.transmittance`) take the same one.
"""

from typing import Any, NamedTuple, TypeVar

import numpy as np
from torch import Tensor

from workbench.arrays import Array
from workbench.scene import Lens

Cosine = TypeVar("Cosine", Tensor, Array, float)


class TransmittanceLaw(NamedTuple):
    """What decides how much of the light a face between two media refracts.

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

    @classmethod
    def of(cls, lens: Lens) -> tuple["TransmittanceLaw", "TransmittanceLaw"]:
        """Those of the entrance face and of the exit face."""
        ratios = 1 / lens.index, lens.index
        if lens.coating is not None:
            entrance, leaving = map(cls.constant, ratios, lens.coating)
        elif lens.reflection == "none":
            entrance, leaving = (cls.constant(ratio, 0.0) for ratio in ratios)
        else:
            bare = cls.fresnel if lens.reflection == "fresnel" else cls.schlick
            entrance, leaving = map(bare, ratios)
        return entrance, leaving

    def at(self, cos_in: Cosine, cos_out: Cosine) -> Cosine:
        """Part of the light that is refracted; 0 at grazing incidence of bare faces.

        Parameters
        ----------
        cos_in, cos_out : Tensor, ndarray or float
            Cosines of the angles of incidence and refraction.

        Notes
        -----
        With η the ratio, 1 − r² of both polarisations is 4 η cos θ_i cos θ_t over a squared sum of
        positive numbers: nothing cancels, and its slope is finite up to grazing incidence.
        """
        if self.exact:
            across = self.ratio * cos_in + cos_out
            within = cos_in + self.ratio * cos_out
            both = across * within
            squares = across * across + within * within
            return 2 * self.ratio * cos_in * cos_out * squares / (both * both)
        off = 1 - (cos_in if self.ratio < 1 else cos_out)
        fourth = off * off * (off * off)
        return self.passing * (1 - self.grazing * fourth * off)

    def cast(self, kind: type[np.floating[Any]]) -> "TransmittanceLaw":
        """The same law for kernels of a float type."""
        return TransmittanceLaw._make([*map(kind, self[:3]), self.exact])


def normal_reflectance(index: float) -> float:
    """Part of the light that is reflected at normal incidence; of an index or one over it."""
    return ((index - 1) / (index + 1)) ** 2
