"""Which place on the exit face is a sample of which point of the source."""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from workbench.arrays import Array
from workbench.geometry.outlines import Outline
from workbench.optics.entering import entering
from workbench.optics.samples import (
    Corners,
    Places,
    Samples,
    counts,
    interleaving,
    places_of_points,
)
from workbench.optics.transmittance import TransmittanceLaw
from workbench.scene import LightOfPoints, Optic

# Part of the aperture's half-width that samples are made denser for, at least: a lens that becomes
# thicker than it began still has enough of them elsewhere.
_NARROWEST = 0.002


class SampleAxis(NamedTuple):
    """Samples along x (or y), each for one row (or column) of points; arrays of shape (m,).

    Attributes
    ----------
    place : ndarray
        Middles of cells of the aperture, scene units: of equal ones, unless the source is near.
    low, high : ndarray
        Ends of what of the aperture is nearer to a sample than to others of its point.
    t : ndarray
        The same as parts of the way from one side of the aperture to the other.
    width : ndarray
        From one end to the other.
    point : ndarray of int
        Number of the point.
    away : ndarray
        From the point to the place.
    rim_from_point, rim_from_place : ndarray
        A point beside the aperture lights a place only if its ray crosses the entrance face, which
        ends so far from the point, counted in the direction away from the lens, and so far from
        the place. 0 and one cell for points before the aperture.
    cell : float
        Distance of neighbouring samples of the same point, where cells are equal: they are for all
        points beside the aperture.
    """

    place: Array
    low: Array
    high: Array
    t: Array
    width: Array
    point: npt.NDArray[np.int64]
    away: Array
    rim_from_point: Array
    rim_from_place: Array
    cell: float


class Lattice(NamedTuple):
    """A tensor grid of samples that all points of a source share.

    Attributes
    ----------
    x, y : SampleAxis
        Samples along the two axes.
    distance : float
        From the points to the entrance face.
    intensity : float
        Flux per solid angle of any point, straight ahead.
    missed, reflected : float
        Flux that passed the entrance face by, and flux reflected there.
    """

    x: SampleAxis
    y: SampleAxis
    distance: float
    intensity: float
    missed: float
    reflected: float

    def areas(self, outline: Outline) -> Array:
        """Area inside an outline of what each sample stands for, shape (m_x, m_y)."""
        x, y = self.x, self.y
        return outline.area_inside((x.low[:, None], x.high[:, None]), (y.low, y.high))


def make_lattice(
    source: LightOfPoints, optic: Optic, samples: Samples, law: TransmittanceLaw
) -> Lattice:
    """Samples of a source's light on the exit face.

    Parameters
    ----------
    source, optic
        The light and the aperture.
    samples : tuple[int, int] or Corners
        Samples along x and y; rounded up, so that all points of a grid have the same number.
        Corners are those of each point, one point after the other.
    law : TransmittanceLaw
        How the entrance face refracts.
    """
    if source.axes is None:
        raise TypeError("points that are no grid cannot share samples of the exit face")
    # Nearer than this a source makes no other light, but float32 leaves its range.
    distance = max(optic.front_z - source.nearest_z, 1e-8 * max(optic.half_width))
    # About as far as this from its axis a point lights the exit face.
    lit = distance / law.ratio + max(optic.base.height - optic.front_z, 0.0)
    x, y = (
        _axis(
            centre,
            r,
            _places(samples, axis, len(centre)),
            _turns(samples, axis, len(centre)),
            max(lit, _NARROWEST * r),
        )
        for axis, (centre, r) in enumerate(zip(source.axes, optic.half_width, strict=True))
    )
    light = entering(source, optic, law)
    return Lattice(x, y, distance, light.intensity, light.missed, light.reflected)


def _places(samples: Samples, axis: int, points: int) -> Places:
    """Places of samples, and what of the aperture each of its point's stands for."""
    if isinstance(samples, Corners):
        return places_of_points(samples, axis, points)
    count = -(-counts(samples)[axis] // points) * points
    part = (np.arange(count) + 0.5) / count
    low, high = part - points / count / 2, part + points / count / 2
    low[:points], high[-points:] = 0.0, 1.0
    return Places(part, low, high)


def _turns(samples: Samples, axis: int, points: int) -> npt.NDArray[np.int64]:
    """Number of the point that each sample belongs to."""
    if isinstance(samples, Corners):
        each = counts(samples)[axis] + (1 if points == 1 else 2)
        return np.repeat(np.arange(points), each)
    return np.tile(interleaving(points), -(-counts(samples)[axis] // points))


def _axis(
    centre: Array, half_width: float, sampled: Places, point: npt.NDArray[np.int64], lit: float
) -> SampleAxis:
    part, low, high = sampled
    place = _spread(part, centre, half_width, lit)
    begin, end = (_spread(ends, centre, half_width, lit) for ends in (low, high))
    cell = 2 * half_width * float((high - low).max())
    sign = np.sign(centre) * (np.abs(centre) > half_width)
    rim_from_point = np.where(sign == 0, 0.0, half_width - np.abs(centre))[point]
    side = sign[point]
    # Not as a difference of two ways from the point, which may be far.
    rim_from_place = np.where(side == 0, cell, half_width - side * place)
    return SampleAxis(
        place,
        begin,
        end,
        (place / half_width + 1) / 2,
        end - begin,
        point,
        place - centre[point],
        rim_from_point,
        rim_from_place,
        cell,
    )


def _spread(part: Array, centre: Array, half_width: float, lit: float) -> Array:
    """Places at parts of the way along an axis: even, or denser before a source that is near.

    In a = arsinh(x / wide) the light is smooth at a scale of 1, as on the entrance face.
    """
    middle, wide = (centre[0] + centre[-1]) / 2, lit + (centre[-1] - centre[0]) / 2
    if wide >= half_width or np.abs(centre).max() > half_width:
        return (2 * part - 1) * half_width
    low, high = np.arcsinh((-half_width - middle) / wide), np.arcsinh((half_width - middle) / wide)
    return np.asarray(middle + wide * np.sinh(low + (high - low) * part)).clip(
        -half_width, half_width
    )
