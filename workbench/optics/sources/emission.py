"""Light of points into the first face: its cone, its rays, and its account by quadrature."""

import math
from functools import lru_cache
from itertools import combinations
from typing import NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.geometry.outlines import Outline, outline_of
from workbench.optics.interfaces import TransmittanceLaw
from workbench.scene import Element, LightOfPoints


class Caps(NamedTuple):
    """Spherical caps of directions, one for each of k points."""

    axis: Array  # (k, 3), unit vectors through their middles
    # (k,), 1 − cos of the angle between the axis and its rim; of a far point the cosine itself has
    # no digits left.
    versine: Array
    centre: Array  # (k, 2), where the axes cross the plane of the rectangle

    @property
    def cos_max(self) -> Array:
        """Cosines of the angles between axes and rims, shape (k,)."""
        return 1 - self.versine

    @property
    def solid_angle(self) -> Array:
        """Solid angles in steradians, shape (k,)."""
        return 2 * np.pi * self.versine


def covering_caps(points: Array, half_width: tuple[float, float], z: float) -> Caps:
    """The smallest cap around each point that covers a centred rectangle in the plane z.

    `points` (k, 3): the points, before the plane; `half_width`: half-widths of the rectangle; `z`:
    where the rectangle is.

    Notes
    -----
    A cap of less than a half-sphere is convex, so one that holds the four corners holds the
    rectangle. The smallest is held by two or three of the corners; on the axis it is that of de
    Koning et al. (2023), section 2.2.

    Unit vectors to the corners are counted from the one to the middle of the rectangle, without a
    difference of long ways: so a far point loses no digits.
    """
    r_x, r_y = half_width
    corners = np.array([[i * r_x, j * r_y, 0.0] for i in (-1, 1) for j in (-1, 1)])
    middle = [0.0, 0.0, z] - points  # [points, 3]
    far = np.linalg.norm(middle, axis=1)[:, None]
    ways = corners + middle[:, None]  # [points, corners, 3]
    length = np.linalg.norm(ways, axis=2)
    shorter = (corners * (ways + middle[:, None])).sum(axis=2) / (length + far)
    ahead = middle / far
    unit = (corners - ahead[:, None] * shorter[..., None]) / length[..., None]

    # Of the smallest ball that holds the unit vectors the middle is on the axis.
    balls = _middles(unit)
    radius2 = np.stack([np.square(unit - b[:, None]).sum(axis=2).max(axis=1) for b in balls])
    radius2[np.isnan(radius2)] = np.inf  # three corners on a line have no circle
    best = radius2.argmin(axis=0), np.arange(len(points))
    aside, sine2 = np.stack(balls)[best], radius2[best]
    axis = ahead + aside
    rise = middle[:, 2:] / axis[:, 2:]
    centre = rise * (aside[:, :2] - ahead[:, :2] * (aside[:, 2:] / ahead[:, 2:]))
    versine = sine2 / (1 + np.sqrt((1 - sine2).clip(min=0)))
    # Rounding must not leave a corner dark.
    versine *= 1 + 1e-12
    return Caps(axis / np.linalg.norm(axis, axis=1, keepdims=True), versine, centre)


def _middles(unit: Array) -> list[Array]:
    """Middles of the balls, shape (k, 3) each, that may be the smallest around four points."""
    found = [(unit[:, i] + unit[:, j]) / 2 for i, j in combinations(range(4), 2)]
    for i, j, k in combinations(range(4), 3):
        b, c = unit[:, j] - unit[:, i], unit[:, k] - unit[:, i]
        across = np.cross(b, c)
        b2, c2, across2 = (np.square(v).sum(axis=1, keepdims=True) for v in (b, c, across))
        with np.errstate(invalid="ignore", divide="ignore"):
            centre = (c2 * np.cross(across, b) + b2 * np.cross(c, across)) / (2 * across2)
        found.append(unit[:, i] + centre)
    return found


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
    `emit`.
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
