"""Rays of point sources and grids of them."""

from typing import NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.optics.cap import covering_caps
from workbench.scene import Element, LightOfPoints


class Rays(NamedTuple):
    """Rays that leave a source."""

    # (m, 2), where they cross the plane of the entrance face, scene units; of rays that go away
    # from it not a number or infinite.
    crossing: Array
    direction: Array  # (m, 3), unit vectors
    flux: Array  # (m,), flux of each; all together 1


def emit(source: LightOfPoints, optic: Element, seed: int, draw: int = 0) -> Rays:
    """Rays of a source into the cap that just covers the entrance face.

    `source`: the source; each point of a grid has a cap and rays of its own; `optic`: gives the
    entrance face; `draw`: number of the ray set; each is another sample.

    Notes
    -----
    Directions are uniform in solid angle: cos φ is uniform between cos φ_max and 1 (de Koning et
    al. 2023, eq. 19). A Lambertian source weighs them with the cosine to the z axis. All points
    of a grid have the same intensity, so rays in a wider cap carry more.

    Rays are followed from where the axis of the cap crosses the entrance face: a far point would
    leave no digits to a way from there.
    """
    points, count = source.positions, source.rays
    generator = np.random.default_rng([seed, draw])
    if source.sampling == "sobol":
        from scipy.stats import qmc  # late: it takes most of a second to import

        sobol = qmc.Sobol(2, seed=generator)
        square = sobol.random_base2(max(count - 1, 1).bit_length())[:count]
        # One sequence for all points; a shift of its own decorrelates each.
        shifts = generator.random((len(points), 1, 2)) if len(points) > 1 else np.zeros((1, 1, 2))
        a = (square[None] + shifts) % 1.0  # [points, rays, 2]
    else:
        a = generator.random((len(points), count, 2))

    caps = covering_caps(points, optic.half_width, optic.front_z)
    versine = caps.versine[:, None] * a[..., 0]
    cos, sin = 1 - versine, np.sqrt(versine * (2 - versine))
    across, up = (basis[:, None] for basis in _perpendicular(caps.axis))
    angle = 2 * np.pi * a[..., 1:]
    aside = np.cos(angle) * across + np.sin(angle) * up  # [points, rays, 3]
    axis = caps.axis[:, None]
    direction = cos[..., None] * axis + sin[..., None] * aside
    with np.errstate(invalid="ignore", divide="ignore"):
        way = (optic.front_z - points[:, 2:]) / caps.axis[:, 2:] * sin / direction[..., 2]
    turned = axis[..., 2:] * aside[..., :2] - aside[..., 2:] * axis[..., :2]
    crossing = caps.centre[:, None] + way[..., None] * turned
    flux = np.broadcast_to(caps.versine[:, None] / caps.versine.max(), cos.shape)
    if source.emission == "lambertian":
        flux = flux * (direction @ source.facing).clip(0)
    if not flux.any():  # a few rays may all go backwards: they miss the lens
        flux = np.ones_like(flux)
    return Rays(crossing.reshape(-1, 2), direction.reshape(-1, 3), flux.ravel() / flux.sum())


def _perpendicular(axis: Array) -> tuple[Array, Array]:
    """Two unit vectors that make a right-handed system with each axis, shape (k, 3)."""
    aside = np.eye(3)[np.abs(axis).argmin(axis=1)]
    across = np.cross(aside, axis)
    across /= np.linalg.norm(across, axis=1, keepdims=True)
    return across, np.cross(axis, across)
