"""How much of the light of points enters the lens, by quadrature over the entrance face."""

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.geometry.outlines import Outline, outline_of
from workbench.optics.cap import Caps, covering_caps
from workbench.optics.transmittance import TransmittanceLaw
from workbench.scene import Element, LightOfPoints

# Steps around an outline: for so many of the distance of a point, at least and at most.
_PER_LENGTH, _FEWEST, _MOST = 100, 512, 1 << 15
_NODE, _WEIGHT = np.polynomial.legendre.leggauss(20)


class Entering(NamedTuple):
    """The light of a source on the entrance face."""

    # Flux per solid angle of any point, straight ahead; all light of the source together is 1.
    intensity: float
    missed: float  # flux that passed the face by
    reflected: float  # flux reflected at the face


@lru_cache(maxsize=8)
def entering(source: LightOfPoints, optic: Element, law: TransmittanceLaw) -> Entering:
    """Account of a source's light before and at the entrance face.

    The law is that of the face; the points are a grid, and emit as in
    `workbench.optics.emission.emit`.
    """
    if source.axes is None:
        raise TypeError("the account of points that are no grid is not known")
    lambertian, intensity = source.emission == "lambertian", intensity_of(source, optic)
    distance = optic.front_z - source.nearest_z
    outline = outline_of(optic)
    if not outline.whole:
        feet = source.positions[:, :2]
        met, refracted = intensity * _through(outline, feet, distance, law, lambertian)
        return Entering(intensity, missed=1 - met, reflected=met - refracted)
    (x, weight_x), (y, weight_y) = (
        _nodes(centre, r, distance) for centre, r in zip(source.axes, optic.half_width, strict=True)
    )
    met = refracted = 0.0
    for row, weight in zip(x, weight_x, strict=True):
        cos = distance / np.sqrt(distance**2 + row[:, None] ** 2 + y[:, None, :] ** 2)
        flux = cos**3 * (cos if lambertian else 1.0) / distance**2
        passing = flux * law.at(cos, np.sqrt(1 - law.ratio**2 * (1 - cos) * (1 + cos)))
        met += np.einsum("jab,a,jb", flux, weight, weight_y)
        refracted += np.einsum("jab,a,jb", passing, weight, weight_y)
    met, refracted = intensity * float(met), intensity * float(refracted)
    return Entering(intensity, missed=1 - met, reflected=met - refracted)


def _through(
    outline: Outline, feet: Array, distance: float, law: TransmittanceLaw, lambertian: bool
) -> Array:
    """Light of points of intensity 1 on a face with a smooth outline, and what enters it.

    By Green's theorem it is the integral of the light within r of the foot of the point, over the
    angle of the way around: the rule of equal steps is exact beyond all powers there.
    """
    steps = math.ceil(_PER_LENGTH * max(outline.half_width) / distance)
    rim = outline.boundary(min(max(steps, _FEWEST), _MOST))[:-1]
    step = 2 * np.pi / len(rim)  # of sines; between neighbours these differ by less than step says
    forward = (np.roll(rim, -1, axis=0) - np.roll(rim, 1, axis=0)) * (step / np.sin(step) / 2)
    found = np.zeros(2)
    part, weight = (_NODE + 1) / 2, _WEIGHT / 2
    for foot in feet:
        x, y = (rim - foot).T
        r2 = x**2 + y**2
        slant = np.sqrt(r2 + distance**2)
        versine = r2 / (slant * (slant + distance))  # 1 − cos, with all digits of a far point
        t = versine[:, None] * part
        flux = versine[:, None] * weight * (1 - t if lambertian else 1.0)
        passing = flux * law.at(1 - t, np.sqrt(1 - law.ratio**2 * t * (2 - t)))
        across = x * forward[:, 1] - y * forward[:, 0]
        turn = np.divide(across, r2, where=r2 > 0, out=np.zeros_like(r2))
        found += turn @ flux.sum(axis=1), turn @ passing.sum(axis=1)
    return found


def intensity_of(source: LightOfPoints, optic: Element) -> float:
    """Flux per solid angle of any point, straight ahead; all light of the source together is 1."""
    caps = covering_caps(source.positions, optic.half_width, optic.front_z)
    lambertian = source.emission == "lambertian"
    mean = _mean_cosine(caps, source.facing) if lambertian else np.ones(len(caps.versine))
    return 1 / float(caps.solid_angle @ mean)


def _nodes(centre: Array, half_width: float, distance: float) -> tuple[Array, Array]:
    """Gauss-Legendre nodes on the face as seen from each centre, and their weights.

    In a = arsinh(x / distance) the light is smooth at a scale of 1, however near its source is.
    """
    low = np.arcsinh((-half_width - centre) / distance)
    high = np.arcsinh((half_width - centre) / distance)
    panels = int(np.ceil((high - low).max()))
    start, node, weight = np.arange(panels), (_NODE + 1) / 2, _WEIGHT / 2
    part = ((start[:, None] + node) / panels).ravel()  # of the way from low to high
    width = (high - low)[:, None]
    a = low[:, None] + width * part
    return distance * np.sinh(a), distance * width / panels * np.tile(weight, panels) * np.cosh(a)


def _mean_cosine(caps: Caps, facing: Array) -> Array:
    """Means over caps of the cosine to a unit vector, where that is positive; shape (k,)."""
    ahead = caps.axis @ facing
    aside = np.linalg.norm(np.cross(caps.axis, facing), axis=1)
    rim, level = 2 * np.arcsin(np.sqrt(caps.versine / 2)), np.arctan2(ahead, aside)
    mean = ahead * (1 - caps.versine / 2)
    some = (rim > level) & (aside > 0)  # straight ahead, rounding alone makes the rim larger
    if some.any():
        mean[some] = _cosine_ahead(ahead[some], aside[some], rim[some], level[some])
        mean[some] /= caps.versine[some]
    return np.asarray(mean)


def _cosine_ahead(ahead: Array, aside: Array, rim: Array, level: Array) -> Array:
    """Means of caps that are partly behind their points, times their versines; shape (k,)."""
    # Rings around the axis that lie half behind: cos = A + B cos ψ, over the ψ of light ahead.
    # The square takes the root out of the end of ψ where the first ring dips below.
    root = (_NODE + 1) / 2
    angle = level[:, None] + (rim - level)[:, None] * root**2  # [points, nodes]
    part_a, part_b = ahead[:, None] * np.cos(angle), aside[:, None] * np.sin(angle)
    end = np.arccos((-part_a / part_b).clip(-1, 1))
    ring = (part_a * end + part_b * np.sin(end)) / np.pi
    partly = (rim - level) * ((ring * np.sin(angle) * root) @ _WEIGHT)
    return np.asarray(ahead * np.sin(level) ** 2 / 2 + partly)
