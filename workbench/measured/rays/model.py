"""Rays as light of a few points: smooth, so that beams of it have no noise.

The points stand where each lights all of the lens alike: on a chip, if it is one. Each stands for
the rays that come from around it, and what comes from it to each place of the lens's plane is a
histogram of where these cross it. So all light keeps its place on the lens, and its direction errs
by how far a ray's start there is from its point.

A few hundred rays of a point tell no fine histogram. What all points have in common is known by all
rays, and each one's own rays only tell how it differs, as finely as they are many.
"""

from typing import NamedTuple

import numpy as np

from workbench.arrays import Array, Index
from workbench.measured.rays.placed import PlacedRays
from workbench.measured.rays.size import Size
from workbench.said import Said

# The histogram goes beyond the lens by this factor: lenses that are out of their place see it.
_WIDER = 1.2
# Rays of all points in each of its cells, about, its cells along each axis, and rays of a point at
# least.
_PER_CELL = 200
_FEWEST, _MOST = 4, 48
_PER_POINT = 24
# Standard deviation in cells of what smooths it at least; and parts of a cell of what it is
# compared with.
_SMOOTH = 0.6
_FINER = 4
# Cells of the lens along each axis in which the model is compared with its rays, and places along
# an axis of each.
_COMPARED, _WITHIN = 8, 6
# Nearest and farthest that the points are from the lens, in its half-widths.
_NEAREST, _FARTHEST = 1e-2, 1e4
# Rays for each point that place it, at most, and rounds.
_PLACING, _ROUNDS = 256, 20


class RayModel(NamedTuple):
    """Light of points that stand for rays.

    Attributes
    ----------
    places : ndarray, shape (k, 3)
        The points, scene units; all have the same z.
    radiance : ndarray, shape (k, n, n)
        Intensity over its cosine to +z of each point, towards middles of equal cells of the lens's
        plane along x and y: that of a Lambertian emitter is even.
    extent : tuple[float, float]
        The cells fill −extent to extent along x and y.
    z : float
        Where the plane is.
    size : Size
        Of where the rays start at the z of the points.
    spread : float
        How far rays start from their points, in the root mean square; over the same for a single
        point.
    off : float
        Light on the lens that is in other cells than that of the rays, of 8 × 8, over all of it.
    """

    places: Array
    radiance: Array
    extent: tuple[float, float]
    z: float
    size: Size
    spread: float = 0.0
    off: float = 0.0

    @property
    def note(self) -> Said:
        """How far it is from its rays, in words."""
        return Said(
            "{points} points stand for the rays of the file: {off:.1f} % of their light on the "
            "lens is elsewhere, and rays start {spread:.0f} % as far from their point as from the "
            "middle of all",
            points=len(self.places),
            off=100 * self.off,
            spread=100 * self.spread,
        )

    def density(self, x: Array, y: Array) -> Array:
        """Flux per area of the lens's plane, of all points together."""
        total = np.zeros(np.broadcast(x, y).shape)
        for k, place in enumerate(self.places):
            way = x - place[0], y - place[1], np.full_like(total, self.z - place[2])
            far = np.sqrt(np.square(way[0]) + np.square(way[1]) + np.square(way[2]))
            direction = way[0] / far, way[1] / far, way[2] / far
            lit = self.intensity(np.full(total.shape, k), direction)
            total += lit * direction[2] / far**2
        return total

    def intensity(self, origin: Index, direction: tuple[Array, Array, Array]) -> Array:
        """Flux per solid angle of points into directions; what the source emits in all is 1."""
        d_x, d_y, d_z = direction
        way = self.z - self.places[0, 2]
        ahead = np.where(d_z > 0, d_z, 1.0)
        x = self.places[origin, 0] + way * d_x / ahead
        y = self.places[origin, 1] + way * d_y / ahead
        return np.asarray(np.where(d_z > 0, self._at(origin, x, y) * d_z, 0.0))

    def _at(self, origin: Index, x: Array, y: Array) -> Array:
        """Radiance towards places, linear between the cells' middles."""
        n = self.radiance.shape[1]
        (e_x, e_y) = self.extent
        column, row = (x / e_x + 1) * n / 2 - 0.5, (y / e_y + 1) * n / 2 - 0.5
        i, j = (np.clip(np.floor(c), 0, n - 2).astype(np.intp) for c in (column, row))
        a, b = np.clip(column - i, 0, 1), np.clip(row - j, 0, 1)
        d = self.radiance
        low = (1 - b) * d[origin, i, j] + b * d[origin, i, j + 1]
        high = (1 - b) * d[origin, i + 1, j] + b * d[origin, i + 1, j + 1]
        inside = (np.abs(x) <= e_x) & (np.abs(y) <= e_y)
        return np.where(inside, (1 - a) * low + a * high, 0.0)


def model_of(rays: PlacedRays, half_width: tuple[float, float], z: float, points: int) -> RayModel:
    """Make a model of the rays that come to a lens.

    Parameters
    ----------
    rays : PlacedRays
        The rays.
    half_width : tuple[float, float]
        Of the lens.
    z : float
        Where its entrance face is.
    points : int
        How many points there are, at most: each has some rays.

    Raises
    ------
    ValueError
        If no ray comes to the lens.
    """
    extent = (_WIDER * half_width[0], _WIDER * half_width[1])
    x, y, come = rays.onto(z)
    come &= (np.abs(x) <= extent[0]) & (np.abs(y) <= extent[1]) & (rays.flux > 0)
    if not come.any():
        raise ValueError(Said("no ray of it comes to the lens"))
    flux, crossing = rays.flux[come], np.column_stack([x, y])[come]
    slope = rays.direction[come, :2] / rays.direction[come, 2:]
    way = _way(crossing, slope, flux, max(half_width))
    start = crossing - way * slope
    groups = _nearest(start, _places(start, flux, points))
    k = int(groups.max()) + 1
    share = np.bincount(groups, flux, k)
    middle = np.column_stack([np.bincount(groups, flux * s, k) for s in start.T]) / share[:, None]
    size = Size.of(start, flux)
    all_of_it = float(np.hypot(*size.deviation))
    near = float(np.sqrt(flux @ np.square(start - middle[groups]).sum(axis=1) / flux.sum()))
    places = np.column_stack([middle, np.full(k, z - way)])
    radiance = _radiance(groups, crossing, flux, middle, way, extent)
    spread = near / all_of_it if all_of_it > 0 else 0.0
    model = RayModel(places, radiance, extent, z, size, spread)
    return model._replace(off=_off(model, crossing, flux, half_width))


def _off(model: RayModel, crossing: Array, flux: Array, half_width: tuple[float, float]) -> float:
    """See `RayModel.off`."""
    ends = [np.linspace(-r, r, _COMPARED + 1) for r in half_width]
    of_rays, _, _ = np.histogram2d(crossing[:, 0], crossing[:, 1], bins=ends, weights=flux)
    m = _COMPARED * _WITHIN
    x, y = (r * (2 * (np.arange(m) + 0.5) / m - 1) for r in half_width)
    lit = model.density(x[:, None], y) * 4 * half_width[0] * half_width[1] / m**2
    cells = lit.reshape(_COMPARED, _WITHIN, _COMPARED, _WITHIN).sum(axis=(1, 3))
    total = float(of_rays.sum())
    return float(np.abs(cells - of_rays).sum()) / (2 * total) if total > 0 else 0.0


def _way(crossing: Array, slope: Array, flux: Array, size: float) -> float:
    """How far before the plane the points are: where directions deviate least from those of one.

    Then each lights all of the lens alike. Where the bundle is narrowest that need not be so: of a
    lamp with a collimator it is on its rim, and each point there lights a spot of the lens.
    """
    part = flux / flux.sum()
    from_middle, turned = (each - part @ each for each in (crossing, slope))
    wide = float(part @ np.square(from_middle).sum(axis=1))
    together = float(part @ (from_middle * turned).sum(axis=1))
    if together * _FARTHEST * size <= wide:  # parallel, or it converges
        return _FARTHEST * size
    return max(wide / together, _NEAREST * size)


def _places(start: Array, flux: Array, points: int) -> Array:
    """Points that stand for starts, as Lloyd's method finds them, shape (k, 2)."""
    few = _drawn(start, flux, _PLACING * points)
    count = max(min(points, len(flux) // _PER_POINT), 1)
    places = _halved(few, count)
    for _ in range(_ROUNDS):
        nearest = _nearest(few, places)
        mine = np.bincount(nearest)
        sums = [np.bincount(nearest, along) for along in few.T]
        places = np.column_stack(sums) / mine[:, None]
    return np.asarray(places)


def _drawn(start: Array, flux: Array, count: int) -> Array:
    """So many starts, as dense as the flux is."""
    sums = np.cumsum(flux)
    step = sums[-1] / count
    chosen = np.searchsorted(sums, (np.arange(count) + 0.5) * step)
    return np.asarray(start[np.minimum(chosen, len(flux) - 1)])


def _halved(few: Array, count: int) -> Array:
    """Middles of parts of starts: each is cut in two across its wider side, again and again."""
    if count == 1 or len(few) < 2:
        return np.asarray(few.mean(axis=0, keepdims=True))
    along = few[:, int(np.argmax(np.ptp(few, axis=0)))]
    order, first = np.argsort(along, kind="stable"), count // 2
    cut = max(len(few) * first // count, 1)
    parts = (few[order[:cut]], first), (few[order[cut:]], count - first)
    return np.concatenate([_halved(*part) for part in parts])


def _nearest(start: Array, places: Array) -> Index:
    """Number of the place nearest to each start; numbers of those that are nearest to none go."""
    from scipy.spatial import cKDTree  # late: it takes long to import

    nearest = cKDTree(places).query(start)[1]
    return np.unique(nearest, return_inverse=True)[1].astype(np.intp)


def _radiance(
    groups: Index,
    crossing: Array,
    flux: Array,
    middle: Array,
    way: float,
    extent: tuple[float, float],
) -> Array:
    """Radiance of each point; see `RayModel`.

    That of all points together, times how each one's rays are spread otherwise: smoothed over so
    many cells that some of its rays are there.
    """
    k = len(middle)
    n = int(np.clip(np.sqrt(len(flux) / _PER_CELL), _FEWEST, _MOST))
    counted = _histograms(groups, crossing, flux, (k, n), extent)
    share = np.bincount(groups, flux, k)[:, None, None]
    even = _even(middle, way, n, extent)
    common = _smooth(counted.sum(axis=0), _SMOOTH) / _smooth((share * even).sum(axis=0), _SMOOTH)
    expected = share * even * common
    wide = max(_SMOOTH, n * np.sqrt(_PER_CELL * k / (4 * np.pi * len(flux))))
    with np.errstate(divide="ignore", invalid="ignore"):
        other = _smooth(counted, wide) / _smooth(expected, wide)
    return np.asarray(np.where(np.isfinite(other), other, 0.0) * share * common)


def _histograms(
    groups: Index, crossing: Array, flux: Array, shape: tuple[int, int], extent: tuple[float, float]
) -> Array:
    """Flux of each group in n × n cells."""
    k, n = shape
    i, j = (
        np.clip(((c / e + 1) * n / 2).astype(np.intp), 0, n - 1)
        for c, e in zip(crossing.T, extent, strict=True)
    )
    return np.asarray(np.bincount((groups * n + i) * n + j, flux, k * n * n).reshape(k, n, n))


def _smooth(cells: Array, deviation: float) -> Array:
    """Cells along the last two axes, smoothed."""
    from scipy.ndimage import gaussian_filter1d  # late: it takes long to import

    for axis in (-2, -1):
        cells = gaussian_filter1d(cells, deviation, axis=axis, mode="reflect")
    return np.asarray(cells)


def _even(middle: Array, way: float, n: int, extent: tuple[float, float]) -> Array:
    """Flux in the same cells of points with an intensity of the cosine to +z."""
    m = n * _FINER
    x, y = (
        ((2 * (np.arange(m) + 0.5) / m - 1) * e - place[:, None]) ** 2
        for e, place in zip(extent, middle.T, strict=True)
    )
    across = (x[:, :, None] + y[:, None, :]) / way**2
    lit = 1 / (1 + across) ** 2 * 4 * extent[0] * extent[1] / (m * way) ** 2
    return np.asarray(lit.reshape(len(middle), n, _FINER, n, _FINER).sum(axis=(2, 4)))
