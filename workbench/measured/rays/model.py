"""Ray files as a sample point sources with smooth intensity, so that beams have no noise.

Each point stands for the rays that start near it. Its radiance towards the plane of the lens is a
histogram of the intersections of these rays with the plane. So the irradiance on the lens is kept,
and the direction of a ray errs by the distance from its start to its point. The points lie in the
plane in which each of them lights the whole lens.

A sample hundred rays of a point give only a coarse histogram. The common part of all points is
resolved with all rays; the rays of one point only resolve its difference from that.
"""

from typing import NamedTuple, Self

import numpy as np

from workbench.arrays import Array, Index
from workbench.measured.rays.rayset import PlacedRays
from workbench.messages import Message

# Sum of the means of u⁴ and v⁴ over that of u² v², for normalised u, v: 3.6 for a uniform
# rectangle, 6 for round distributions.
_ROUND = 4.8
# The histogram exceeds the lens by this factor, for lenses that are misaligned in tolerances.
_WIDER = 1.2
# Mean number of rays in a cell of the histogram; least and most cells along each axis; least number
# of rays of a point.
_PER_CELL = 200
_FEWEST, _MOST = 4, 48
_PER_POINT = 24
# Least standard deviation of the smoothing kernel, in cells; subdivisions of a cell in the
# histogram of Lambertian points.
_SMOOTH = 0.6
_FINER = 4
# Cells of the lens along each axis for comparing model and rays, and samples along an axis of each.
_COMPARED, _WITHIN = 8, 6
# Least and largest distance of the points from the lens, in half-widths.
_NEAREST, _FARTHEST = 1e-2, 1e4
# Most rays of a point in Lloyd's method, and its iterations.
_PLACING, _ROUNDS = 256, 20


class Size(NamedTuple):
    """Distribution of ray starts in a plane across the axis.

    ``middle`` and ``deviation`` are mean and standard deviation along x and y; ``round`` says
    whether an ellipse fits better than a rectangle.
    """

    middle: tuple[float, float]
    deviation: tuple[float, float]
    round: bool

    @classmethod
    def of(cls, start: Array, flux: Array) -> Self:
        """Return the distribution of starts (m, 2) weighted by flux (m,).

        Examples
        --------
        Corners of a square, and the middle:

        >>> import numpy as np
        >>> start = np.array([[1.0, 1], [1, -1], [-1, 1], [-1, -1], [0, 0]])
        >>> Size.of(start, np.ones(5))
        Size(middle=(0.0, 0.0), deviation=(0.894..., 0.894...), round=False)
        """
        part = flux / flux.sum()
        x, y = (part @ start).tolist()
        squares = np.square(start - (x, y))
        v_x, v_y = (part @ squares).tolist()
        both = float(part @ squares.prod(axis=1))
        fourth_x, fourth_y = (part @ np.square(squares)).tolist()
        round_ = fourth_x * v_y**2 + fourth_y * v_x**2 > _ROUND * both * v_x * v_y
        return cls((x, y), (v_x**0.5, v_y**0.5), round_)

    @property
    def half_width(self) -> tuple[float, float]:
        """Half-widths of a uniform rectangle or ellipse of the same deviation."""
        times = 2.0 if self.round else 3**0.5
        return times * self.deviation[0], times * self.deviation[1]


class RayModel(NamedTuple):
    """Point sources that stand for the rays of a file."""

    places: Array  # (k, 3), the points, scene units; all have the same z
    # (k, n, n), intensity over its cosine to +z of each point, towards middles of equal cells of
    # the lens's plane along x and y: constant for a Lambertian emitter.
    radiance: Array
    extent: tuple[float, float]  # the cells fill −extent to extent along x and y
    z: float  # z of the plane
    size: Size  # distribution of ray starts at the z of the points
    # RMS distance of ray starts from their points, relative to that from a single point.
    spread: float = 0.0
    # Part of the flux on the lens in other cells than that of the rays, of 8 × 8 cells.
    off: float = 0.0

    @property
    def note(self) -> Message:
        """Accuracy of the model, in words."""
        return Message(
            "{points} points stand for the rays of the file: {off:.1f} % of their light on the "
            "lens is elsewhere, and rays start {spread:.0f} % as far from their point as from the "
            "middle of all",
            points=len(self.places),
            off=100 * self.off,
            spread=100 * self.spread,
        )

    def density(self, x: Array, y: Array) -> Array:
        """Irradiance of the lens's plane by all points together."""
        total = np.zeros(np.broadcast(x, y).shape)
        for k, place in enumerate(self.places):
            offset = x - place[0], y - place[1], np.full_like(total, self.z - place[2])
            far = np.sqrt(np.square(offset[0]) + np.square(offset[1]) + np.square(offset[2]))
            direction = offset[0] / far, offset[1] / far, offset[2] / far
            lit = self.intensity(np.full(total.shape, k), direction)
            total += lit * direction[2] / far**2
        return total

    def intensity(self, origin: Index, direction: tuple[Array, Array, Array]) -> Array:
        """Intensity of points in directions; the source's total flux is 1."""
        d_x, d_y, d_z = direction
        distance = self.z - self.places[0, 2]
        ahead = np.where(d_z > 0, d_z, 1.0)
        x = self.places[origin, 0] + distance * d_x / ahead
        y = self.places[origin, 1] + distance * d_y / ahead
        return np.asarray(np.where(d_z > 0, self._at(origin, x, y) * d_z, 0.0))

    def _at(self, origin: Index, x: Array, y: Array) -> Array:
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
    """Return the model of the rays that reach a lens, with at most so many points.

    ``half_width`` is that of the lens, ``z`` that of its entrance face. Raise ValueError if no ray
    reaches the lens.
    """
    extent = (_WIDER * half_width[0], _WIDER * half_width[1])
    x, y, arriving = rays.onto(z)
    arriving &= (np.abs(x) <= extent[0]) & (np.abs(y) <= extent[1]) & (rays.flux > 0)
    if not arriving.any():
        raise ValueError(Message("no ray of it comes to the lens"))
    flux, crossing = rays.flux[arriving], np.column_stack([x, y])[arriving]
    slope = rays.direction[arriving, :2] / rays.direction[arriving, 2:]
    distance = _point_distance(crossing, slope, flux, max(half_width))
    start = crossing - distance * slope
    groups = _nearest(start, _point_positions(start, flux, points))
    k = int(groups.max()) + 1
    share = np.bincount(groups, flux, k)
    middle = np.column_stack([np.bincount(groups, flux * s, k) for s in start.T]) / share[:, None]
    size = Size.of(start, flux)
    all_of_it = float(np.hypot(*size.deviation))
    near = float(np.sqrt(flux @ np.square(start - middle[groups]).sum(axis=1) / flux.sum()))
    places = np.column_stack([middle, np.full(k, z - distance)])
    radiance = _radiance(groups, crossing, flux, middle, distance, extent)
    spread = near / all_of_it if all_of_it > 0 else 0.0
    model = RayModel(places, radiance, extent, z, size, spread)
    return model._replace(off=_misplaced_flux(model, crossing, flux, half_width))


def _misplaced_flux(
    model: RayModel, crossing: Array, flux: Array, half_width: tuple[float, float]
) -> float:
    ends = [np.linspace(-r, r, _COMPARED + 1) for r in half_width]
    of_rays, _, _ = np.histogram2d(crossing[:, 0], crossing[:, 1], bins=ends, weights=flux)
    m = _COMPARED * _WITHIN
    x, y = (r * (2 * (np.arange(m) + 0.5) / m - 1) for r in half_width)
    lit = model.density(x[:, None], y) * 4 * half_width[0] * half_width[1] / m**2
    cells = lit.reshape(_COMPARED, _WITHIN, _COMPARED, _WITHIN).sum(axis=(1, 3))
    total = float(of_rays.sum())
    return float(np.abs(cells - of_rays).sum()) / (2 * total) if total > 0 else 0.0


# The points lie where ray directions deviate least from those of a single point: there each lights
# the whole lens. At the waist of the bundle that can fail: the waist of a lamp with a collimator is
# at its rim, and each point there lights a spot of the lens.
def _point_distance(crossing: Array, slope: Array, flux: Array, size: float) -> float:
    part = flux / flux.sum()
    from_middle, turned = (each - part @ each for each in (crossing, slope))
    wide = float(part @ np.square(from_middle).sum(axis=1))
    together = float(part @ (from_middle * turned).sum(axis=1))
    if together * _FARTHEST * size <= wide:  # parallel, or it converges
        return _FARTHEST * size
    return max(wide / together, _NEAREST * size)


def _point_positions(start: Array, flux: Array, points: int) -> Array:
    sample = _sample(start, flux, _PLACING * points)
    count = max(min(points, len(flux) // _PER_POINT), 1)
    places = _bisect(sample, count)
    for _ in range(_ROUNDS):
        nearest = _nearest(sample, places)
        mine = np.bincount(nearest)
        sums = [np.bincount(nearest, along) for along in sample.T]
        places = np.column_stack(sums) / mine[:, None]
    return np.asarray(places)


def _sample(start: Array, flux: Array, count: int) -> Array:
    sums = np.cumsum(flux)
    step = sums[-1] / count
    chosen = np.searchsorted(sums, (np.arange(count) + 0.5) * step)
    return np.asarray(start[np.minimum(chosen, len(flux) - 1)])


def _bisect(sample: Array, count: int) -> Array:
    if count == 1 or len(sample) < 2:
        return np.asarray(sample.mean(axis=0, keepdims=True))
    along = sample[:, int(np.argmax(np.ptp(sample, axis=0)))]
    order, first = np.argsort(along, kind="stable"), count // 2
    cut = max(len(sample) * first // count, 1)
    parts = (sample[order[:cut]], first), (sample[order[cut:]], count - first)
    return np.concatenate([_bisect(*part) for part in parts])


def _nearest(start: Array, places: Array) -> Index:
    from scipy.spatial import cKDTree  # slow import

    nearest = cKDTree(places).query(start)[1]
    return np.unique(nearest, return_inverse=True)[1].astype(np.intp)


# The radiance of all points together, times the smoothed ratio of each point's own histogram to it.
# The smoothing is so wide that some of the point's rays fall into it.
def _radiance(
    groups: Index,
    crossing: Array,
    flux: Array,
    middle: Array,
    distance: float,
    extent: tuple[float, float],
) -> Array:
    k = len(middle)
    n = int(np.clip(np.sqrt(len(flux) / _PER_CELL), _FEWEST, _MOST))
    counted = _histograms(groups, crossing, flux, (k, n), extent)
    share = np.bincount(groups, flux, k)[:, None, None]
    even = _lambertian(middle, distance, n, extent)
    common = _smooth(counted.sum(axis=0), _SMOOTH) / _smooth((share * even).sum(axis=0), _SMOOTH)
    expected = share * even * common
    wide = max(_SMOOTH, n * np.sqrt(_PER_CELL * k / (4 * np.pi * len(flux))))
    with np.errstate(divide="ignore", invalid="ignore"):
        other = _smooth(counted, wide) / _smooth(expected, wide)
    return np.asarray(np.where(np.isfinite(other), other, 0.0) * share * common)


def _histograms(
    groups: Index, crossing: Array, flux: Array, shape: tuple[int, int], extent: tuple[float, float]
) -> Array:
    k, n = shape
    i, j = (
        np.clip(((c / e + 1) * n / 2).astype(np.intp), 0, n - 1)
        for c, e in zip(crossing.T, extent, strict=True)
    )
    return np.asarray(np.bincount((groups * n + i) * n + j, flux, k * n * n).reshape(k, n, n))


def _smooth(cells: Array, deviation: float) -> Array:
    from scipy.ndimage import gaussian_filter1d  # slow import

    for axis in (-2, -1):
        cells = gaussian_filter1d(cells, deviation, axis=axis, mode="reflect")
    return np.asarray(cells)


def _lambertian(middle: Array, distance: float, n: int, extent: tuple[float, float]) -> Array:
    m = n * _FINER
    x, y = (
        ((2 * (np.arange(m) + 0.5) / m - 1) * e - place[:, None]) ** 2
        for e, place in zip(extent, middle.T, strict=True)
    )
    across = (x[:, :, None] + y[:, None, :]) / distance**2
    lit = 1 / (1 + across) ** 2 * 4 * extent[0] * extent[1] / (m * distance) ** 2
    return np.asarray(lit.reshape(len(middle), n, _FINER, n, _FINER).sum(axis=(2, 4)))
