"""Which place on the exit face is a sample of which point of the source."""

import math
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from workbench.optics.entering import entering
from workbench.scene import GridSource, Lens, PointSource

Array = npt.NDArray[np.float64]


class Axis(NamedTuple):
    """Samples along x (or y), each for one row (or column) of points; arrays of shape (m,).

    Attributes
    ----------
    place : ndarray
        Middles of equal cells of the aperture, scene units.
    width : ndarray
        What of the aperture is nearer to a sample than to others of its point.
    point : ndarray of int
        Number of the point.
    away : ndarray
        From the point to the place.
    reach, beyond : ndarray
        A point beside the aperture lights a place only if its ray crosses the entrance face, which
        ends ``reach`` from the point, counted in the direction away from the lens, and ``beyond``
        the place. 0 and one cell for points before the aperture.
    cell : float
        Distance of neighbouring samples of the same point.
    """

    place: Array
    width: Array
    point: npt.NDArray[np.int64]
    away: Array
    reach: Array
    beyond: Array
    cell: float


class Lattice(NamedTuple):
    """A tensor grid of samples that all points of a source share.

    Attributes
    ----------
    x, y : Axis
        Samples along the two axes.
    distance : float
        From the points to the entrance face.
    intensity : float
        Flux per solid angle of any point, straight ahead.
    missed, reflected : float
        Flux that passed the entrance face by, and flux reflected there.
    """

    x: Axis
    y: Axis
    distance: float
    intensity: float
    missed: float
    reflected: float


def make_lattice(source: PointSource | GridSource, lens: Lens, samples: tuple[int, int]) -> Lattice:
    """Samples of a source's light on the exit face.

    Parameters
    ----------
    source, lens
        The light and the aperture.
    samples : tuple[int, int]
        Samples along x and y; rounded up, so that all points of a grid have the same number.
    """
    x, y = (
        _axis(centre, r, count)
        for centre, r, count in zip(source.axes, lens.half_width, samples, strict=True)
    )
    light = entering(source, lens)
    # Nearer than this a source makes no other light, but float32 leaves its range.
    distance = max(lens.entrance_z - source.nearest_z, 1e-8 * max(lens.half_width))
    return Lattice(x, y, distance, light.intensity, light.missed, light.reflected)


def _axis(centre: Array, half_width: float, samples: int) -> Axis:
    points = len(centre)
    count = -(-samples // points) * points
    place = ((np.arange(count) + 0.5) / count * 2 - 1) * half_width
    cell = 2 * half_width / count * points
    width = np.full(count, cell)
    width[:points] += half_width + place[:points] - cell / 2
    width[-points:] += half_width - place[-points:] - cell / 2
    point = np.tile(_interleaving(points), count // points)
    sign = np.sign(centre) * (np.abs(centre) > half_width)
    reach = np.where(sign == 0, 0.0, half_width - np.abs(centre))[point]
    side = sign[point]
    # Not as a difference of two ways from the point, which may be far.
    beyond = np.where(side == 0, cell, half_width - side * place)
    return Axis(place, width, point, place - centre[point], reach, beyond, cell)


def _interleaving(points: int) -> npt.NDArray[np.int64]:
    """Order in which points take turns: mirror-symmetric, and without a trend.

    If the points came one after the other, those on the right would always sample the right part
    of each cell, which shifts the light. Steps of a fixed stride mix them.
    """
    turn = np.arange(points)
    best, least = turn, np.inf
    for stride in range(1, points):
        if math.gcd(stride, points) > 1:
            continue
        # Point m − 1 − k comes at turn m − 1 − j where point k comes at turn j.
        start = (stride - 1 if stride % 2 else stride - 1 + points) // 2
        order = (stride * turn + start) % points
        trend = abs(float((turn - turn.mean()) @ (order - order.mean())))
        # Short strides leave long runs.
        trend += points**2 * (min(stride, points - stride) < math.isqrt(points) - 1)
        if trend < least:
            best, least = order, trend
    return best
