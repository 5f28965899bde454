"""Diffusers in Mitsuba, which has Lambertian scatter, but none about the direction of a ray."""

import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.messages import Message
from workbench.scene import Diffuser, GaussianScatter, LambertianScatter
from workbench.scene.part import row_of

# Cosines of incidence, and angles of scatter, between which sums run.
_COSINES, _ANGLES = 257, 4001


def scattering(mi: Any, diffuser: Diffuser) -> Any:
    """What a diffuser is made of in Mitsuba.

    Raises
    ------
    Refused
        If Mitsuba is given no scatter by its law.
    """
    if not isinstance(diffuser.scatter, tuple(_LAWS)):
        law = diffuser.scatter.kind
        unknown = Message("Mitsuba is given no scatter of kind {law}; compare without it", law=law)
        raise Refused(f"{diffuser.name}.scatter", unknown)
    return row_of(_LAWS, diffuser.scatter)(mi, diffuser.scatter, diffuser.transmittance)


def _lambertian(mi: Any, scatter: LambertianScatter, transmittance: float) -> Any:
    """All light goes to the other side by Lambert's law, wherever it comes from."""
    return mi.load_dict(
        {
            "type": "principledthin",
            "base_color": {"type": "rgb", "value": transmittance},
            "diff_trans": 2.0,  # all of it goes through
            "spec_trans": 0.0,
        }
    )


def _gaussian(mi: Any, scatter: GaussianScatter, transmittance: float) -> Any:
    """Light about the direction in which it would go on, as exp(−θ²/2σ²) per solid angle.

    Angles are drawn as θ exp(−θ²/2σ²). Weights make up for the difference, and for directions to
    the wrong side, so that no light is lost.
    """
    sigma, kind = math.radians(scatter.sigma), mi.BSDFFlags.GlossyTransmission
    within = -math.expm1(-((math.pi / sigma) ** 2) / 2)
    weights = (transmittance / _going_on(sigma)).tolist()

    class Scatter(mi.BSDF):  # type: ignore[misc]
        """Mitsuba samples it; the screen hides it from the camera, so it is not evaluated."""

        def __init__(self) -> None:
            super().__init__(mi.Properties())
            self.m_flags = kind | mi.BSDFFlags.FrontSide | mi.BSDFFlags.BackSide
            self.m_components = [self.m_flags]

        def sample(self, ctx: Any, si: Any, sample1: Any, sample2: Any, active: Any = True) -> Any:
            """A direction, and its light over what comes."""
            angle = sigma * math.sqrt(-2 * math.log1p(-within * sample2[0]))
            turn, sine = 2 * math.pi * sample2[1], math.sin(angle)
            local = mi.Vector3f(sine * math.cos(turn), sine * math.sin(turn), math.cos(angle))
            found = mi.BSDFSample3f()
            found.wo, found.pdf, found.eta = mi.Frame3f(-si.wi).to_world(local), 1.0, 1.0
            found.sampled_type, found.sampled_component = +kind, 0
            if found.wo[2] * si.wi[2] >= 0:
                return found, mi.Color3f(0.0)
            part = abs(si.wi[2]) * (_COSINES - 1)
            low = min(int(part), _COSINES - 2)
            weight = weights[low] + (part - low) * (weights[low + 1] - weights[low])
            return found, mi.Color3f(weight * sine / angle if angle > 0 else weight)

        def eval(self, ctx: Any, si: Any, wo: Any, active: Any = True) -> Any:
            """Nothing; see the class."""
            return mi.Color3f(0.0)

        def pdf(self, ctx: Any, si: Any, wo: Any, active: Any = True) -> Any:
            """Nothing; see the class."""
            return 0.0

    return Scatter()


def _going_on(sigma: float) -> Array:
    """Mean of sin θ / θ of the drawn angles that go on, and 0 of others, by cosine of incidence."""
    angle = (np.arange(_ANGLES) + 0.5) / _ANGLES * min(math.pi, 9 * sigma)
    cosine = np.linspace(0, 1, _COSINES)[:, None]
    across = np.sqrt(1 - cosine**2) * np.sin(angle)
    with np.errstate(divide="ignore"):
        rim = np.clip(-cosine * np.cos(angle) / across, -1, 1)
    drawn = angle * np.exp(-((angle / sigma) ** 2) / 2)
    turns = np.arccos(rim) / math.pi  # part of the turns that lead to the other side
    return np.asarray((drawn * np.sinc(angle / math.pi) * turns).sum(axis=1) / drawn.sum())


_LAWS: Mapping[type, Callable[[Any, Any, float], Any]] = {
    GaussianScatter: _gaussian,
    LambertianScatter: _lambertian,
}
