"""Rays of point sources and grids of them, and what the entrance face makes of these rays.

None of it depends on the control heights: it is computed once for a set of rays, in float64.
"""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt
from scipy.stats import qmc

from workbench.optics.cap import covering_cap
from workbench.scene import GridSource, Lens, PointSource

Array = npt.NDArray[np.float64]


class Rays(NamedTuple):
    """Rays that leave a source.

    Attributes
    ----------
    origin, direction : ndarray, shape (m, 3)
        Where they start, scene units, and unit vectors.
    flux : ndarray, shape (m,)
        Flux of each; all together 1.
    """

    origin: Array
    direction: Array
    flux: Array


class InLens(NamedTuple):
    """Rays just behind the entrance face, those that met it alone.

    Attributes
    ----------
    x, y : ndarray, shape (m,)
        Where they crossed the face, scene units.
    slope_x, slope_y : ndarray, shape (m,)
        dx/dz and dy/dz in the lens.
    flux : ndarray, shape (m,)
        Flux of each that was refracted.
    missed : float
        Flux of the source that passed the face by.
    reflected : float
        Flux reflected at the face.
    """

    x: Array
    y: Array
    slope_x: Array
    slope_y: Array
    flux: Array
    missed: float
    reflected: float


def emit(source: PointSource | GridSource, lens: Lens, seed: int, draw: int = 0) -> Rays:
    """Rays of a source into the cap that just covers the entrance face.

    Parameters
    ----------
    source : PointSource or GridSource
        The source; each point of a grid has a cap and rays of its own.
    lens : Lens
        Gives the entrance face.
    seed : int
        The same seed gives the same rays.
    draw : int
        Number of the ray set; each is another sample.

    Notes
    -----
    Directions are uniform in solid angle: cos φ is uniform between cos φ_max and 1 (de Koning et
    al. 2023, eq. 19). A Lambertian source weighs them with the cosine to the z axis.
    """
    points = positions(source)
    count = source.rays
    generator = np.random.default_rng([seed, draw])
    if source.sampling == "sobol":
        sobol = qmc.Sobol(2, seed=generator)
        square = sobol.random_base2(max(count - 1, 1).bit_length())[:count]
        # One sequence for all points; a shift of its own decorrelates each.
        shifts = generator.random((len(points), 1, 2)) if len(points) > 1 else np.zeros((1, 1, 2))
        a = (square[None] + shifts) % 1.0  # [points, rays, 2]
    else:
        a = generator.random((len(points), count, 2))

    direction = np.empty((len(points), count, 3))
    for k, point in enumerate(points):
        cap = covering_cap(point, lens.half_width, lens.entrance_z)
        across, up = _perpendicular(cap.axis)
        versine = cap.versine * a[k, :, 0]
        cos, sin = 1 - versine, np.sqrt(versine * (2 - versine))
        angle = 2 * np.pi * a[k, :, 1]
        direction[k] = (
            cos[:, None] * cap.axis
            + (sin * np.cos(angle))[:, None] * across
            + (sin * np.sin(angle))[:, None] * up
        )
    rays = direction.reshape(-1, 3)
    flux = rays[:, 2].clip(0) if source.emission == "lambertian" else np.ones(len(rays))
    if not flux.any():  # a few rays may all go backwards: they miss the lens
        flux[:] = 1
    return Rays(np.repeat(points, count, axis=0), rays, flux / flux.sum())


def enter(rays: Rays, lens: Lens) -> InLens:
    """Refract rays at the flat entrance face."""
    cos = rays.direction[:, 2]
    forward = cos > 0
    path = np.divide(
        lens.entrance_z - rays.origin[:, 2], cos, out=np.zeros_like(cos), where=forward
    )
    x, y = (rays.origin[:, :2] + path[:, None] * rays.direction[:, :2]).T
    r_x, r_y = lens.half_width
    meets = forward & (np.abs(x) <= r_x) & (np.abs(y) <= r_y)

    x, y, cos, flux = x[meets], y[meets], cos[meets], rays.flux[meets]
    n = lens.index
    # The tangential part of the direction shrinks by n; what is left makes the new cosine.
    tangential = rays.direction[meets, :2] / n
    cos_inside = np.sqrt(1 - np.square(tangential).sum(axis=1))
    head_on = ((n - 1) / (n + 1)) ** 2
    transmittance = (1 - head_on) * (1 - (1 - cos) ** 5)  # Schlick; air is the thinner medium
    refracted = flux * transmittance
    return InLens(
        x,
        y,
        tangential[:, 0] / cos_inside,
        tangential[:, 1] / cos_inside,
        refracted,
        missed=float(rays.flux.sum() - flux.sum()),
        reflected=float(flux.sum() - refracted.sum()),
    )


def positions(source: PointSource | GridSource) -> Array:
    """Where the points of a source are, shape (points, 3); those of a grid in rows along y."""
    if isinstance(source, PointSource):
        return np.array([source.position])
    (x, y, z), (r_x, r_y), (m_x, m_y) = source.center, source.half_width, source.points
    along_x = x + (np.linspace(-r_x, r_x, m_x) if m_x > 1 else np.zeros(1))
    along_y = y + (np.linspace(-r_y, r_y, m_y) if m_y > 1 else np.zeros(1))
    grid_x, grid_y = np.meshgrid(along_x, along_y, indexing="ij")
    return np.stack([grid_x.ravel(), grid_y.ravel(), np.full(m_x * m_y, z)], axis=-1)


def _perpendicular(axis: Array) -> tuple[Array, Array]:
    """Two unit vectors that make a right-handed system with the axis."""
    aside = np.eye(3)[np.argmin(np.abs(axis))]
    across = np.cross(aside, axis)
    across /= np.linalg.norm(across)
    return across, np.cross(axis, across)
