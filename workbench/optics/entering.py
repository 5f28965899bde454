"""How much of the light of points enters the lens, by quadrature over the entrance face."""

from functools import lru_cache
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from workbench.optics.cap import Cap, covering_cap
from workbench.optics.emission import positions
from workbench.optics.refraction import normal_reflectance
from workbench.scene import GridSource, Lens, PointSource

Array = npt.NDArray[np.float64]

_NODE, _WEIGHT = np.polynomial.legendre.leggauss(20)


class Entering(NamedTuple):
    """The light of a source on the entrance face.

    Attributes
    ----------
    intensity : ndarray, shape (m_x, m_y)
        Flux per solid angle of each point, straight ahead; all light of the source together is 1.
    missed : float
        Flux that passed the face by.
    reflected : float
        Flux reflected at the face.
    """

    intensity: Array
    missed: float
    reflected: float


@lru_cache(maxsize=8)
def entering(source: PointSource | GridSource, lens: Lens) -> Entering:
    """Account of a source's light before and at the entrance face.

    The emission is that of `workbench.optics.emission.emit`: of a Lambertian grid, points that see
    the lens head-on emit more into their cones than others.
    """
    lambertian = source.emission == "lambertian"
    points = positions(source)
    caps = [covering_cap(point, lens.half_width, lens.entrance_z) for point in points]
    mean = np.array([_mean_cosine(cap) if lambertian else 1.0 for cap in caps])
    solid_angle = np.array([cap.solid_angle for cap in caps])
    count = source.points if isinstance(source, GridSource) else (1, 1)
    intensity = (1 / (solid_angle * mean.sum())).reshape(count)

    distance = lens.entrance_z - points[0, 2]
    x, weight_x = _nodes(points.reshape(*count, 3)[:, 0, 0], lens.half_width[0], distance)
    y, weight_y = _nodes(points.reshape(*count, 3)[0, :, 1], lens.half_width[1], distance)
    met = refracted = 0.0
    for k in range(count[0]):
        cos = distance / np.sqrt(distance**2 + x[k, None, :, None] ** 2 + y[:, None, :] ** 2)
        flux = cos**3 * (cos if lambertian else 1.0) / distance**2
        passing = flux * (1 - normal_reflectance(lens.index)) * (1 - (1 - cos) ** 5)
        met += intensity[k] @ np.einsum("jab,a,jb->j", flux, weight_x[k], weight_y)
        refracted += intensity[k] @ np.einsum("jab,a,jb->j", passing, weight_x[k], weight_y)
    return Entering(intensity, missed=1 - float(met), reflected=float(met - refracted))


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


def _mean_cosine(cap: Cap) -> float:
    """Mean over a cap of the cosine to the z axis, where that is positive."""
    ahead, aside = cap.axis[2], float(np.hypot(cap.axis[0], cap.axis[1]))
    rim, level = 2 * np.arcsin(np.sqrt(cap.versine / 2)), np.arctan2(ahead, aside)
    if rim <= level:
        return float(ahead * (1 - cap.versine / 2))
    # Rings around the axis that lie half behind: cos = A + B cos ψ, over the ψ of light ahead.
    # The square takes the root out of the end of ψ where the first ring dips below.
    root = (_NODE + 1) / 2
    angle = level + (rim - level) * root**2
    part_a, part_b = ahead * np.cos(angle), aside * np.sin(angle)
    end = np.arccos((-part_a / part_b).clip(-1, 1))
    ring = (part_a * end + part_b * np.sin(end)) / np.pi
    partly = (rim - level) * (_WEIGHT @ (ring * np.sin(angle) * root))
    return float((ahead * np.sin(level) ** 2 / 2 + partly) / cap.versine)
