"""What the kernels of `workbench.optics.kernels.origins` need to know, in their float type."""

from typing import Any, NamedTuple

import numpy as np

from workbench.arrays import AnyArray
from workbench.optics.transmittance import TransmittanceLaw

Number = np.floating[Any]


class SampleLine(NamedTuple):
    """Samples of the exit face along one axis; arrays of shape (m,), scene units.

    Attributes
    ----------
    place : ndarray
        Where they are.
    low, high : ndarray
        Ends of what each stands for.
    half_width : floating
        Of the entrance face; infinite where an `OutlineNumbers` is curved.
    """

    place: AnyArray
    low: AnyArray
    high: AnyArray
    half_width: Number


class OutlineNumbers(NamedTuple):
    """A lens that is not all of its rectangle.

    Attributes
    ----------
    curved : bool
        Whether it is so at all; if not, the rest plays no part.
    inside : ndarray, shape (samples along y, samples along x)
        Which part of what each sample stands for is inside it.
    by_x2, by_y2 : floating
        One by the squares of its semi-axes.
    """

    curved: bool
    inside: AnyArray
    by_x2: Number
    by_y2: Number


class Sky(NamedTuple):
    """Light from infinitely far; arrays of shape (k,), a number for each direction.

    Attributes
    ----------
    slope_x, slope_y : ndarray
        Slopes in the glass.
    air_x, air_y : ndarray
        Unit vectors before it.
    flux : ndarray
        Flux per area behind the entrance face, in the middle of the beam.
    narrowing : floating
        Flux falls with exp(−narrowing × square of the distance to the middle of the beam).
    """

    slope_x: AnyArray
    slope_y: AnyArray
    air_x: AnyArray
    air_y: AnyArray
    flux: AnyArray
    narrowing: Number


class Points(NamedTuple):
    """Points at one distance before the entrance face; arrays of shape (k,).

    Attributes
    ----------
    x, y : ndarray
        Where they are, scene units.
    flux : ndarray
        Flux per area of the entrance face right before each, without its reflection.
    apparent, distance2 : floating
        c = n d and d², for the distance d.
    lambert : floating
        1 for Lambertian points, else 0.
    patterns : ndarray, shape (k or 0, n, n)
        See `workbench.optics.shared_grid.SharedGrid.patterns`; none where intensity is even or
        Lambertian.
    per_x, per_y : floating
        Steps between values of the patterns for each length.
    first_x, first_y : floating
        Step at x = 0, at y = 0.
    steps : int
        Of Newton's method.
    law : TransmittanceLaw
        Of the entrance face.
    """

    x: AnyArray
    y: AnyArray
    flux: AnyArray
    apparent: Number
    distance2: Number
    lambert: Number
    patterns: AnyArray
    per_x: Number
    per_y: Number
    first_x: Number
    first_y: Number
    steps: int
    law: TransmittanceLaw


class Medium(NamedTuple):
    """The lens but for its exit face.

    Attributes
    ----------
    ratio, ratio2_minus_1 : floating
        Refractive index n, and n² − 1.
    lift : floating
        Level that heights are counted from, above the entrance face.
    critical : floating
        Squared cosines below this count as total reflection.
    absorption : floating
        Per length.
    law : TransmittanceLaw
        Of the exit face.
    """

    ratio: Number
    ratio2_minus_1: Number
    lift: Number
    critical: Number
    absorption: Number
    law: TransmittanceLaw
