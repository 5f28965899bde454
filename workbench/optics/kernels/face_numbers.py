"""What the kernels of `workbench.optics.kernels.face` need to know, in the trace's float type."""

from typing import Any, NamedTuple

import numpy as np

from workbench.arrays import AnyArray
from workbench.optics.transmittance import TransmittanceLaw

Number = np.floating[Any]


class Across(NamedTuple):
    """Samples along x: see `workbench.optics.lattice.SampleAxis`; arrays of shape (m,).

    Attributes
    ----------
    place : ndarray
        In columns of the image.
    away, rim_from_point, rim_from_place : ndarray
        Scene units.
    per_cell : floating
        One by the distance of neighbouring samples of a point.
    bright : ndarray
        Flux over width along y of a sample were it right before its point.
    """

    place: AnyArray
    away: AnyArray
    rim_from_point: AnyArray
    rim_from_place: AnyArray
    per_cell: Number
    bright: AnyArray


class Up(NamedTuple):
    """Samples along y in the same way, ``place`` in rows; ``width`` as there."""

    place: AnyArray
    away: AnyArray
    rim_from_point: AnyArray
    rim_from_place: AnyArray
    per_cell: Number
    width: AnyArray


class FaceOptics(NamedTuple):
    """Numbers of a trace, in its float type.

    Attributes
    ----------
    ratio, ratio2_minus_1 : floating
        Refractive index n, and n² − 1.
    apparent : floating
        c = n d, for points at the distance d before the entrance face.
    distance2 : floating
        d².
    lambert : floating
        1 for Lambertian points, else 0.
    lift : floating
        Level that heights are counted from, above the entrance face.
    drop : floating
        How far the screen is above that level.
    critical : floating
        Squared cosines below this count as total reflection.
    absorption : floating
        Of the glass, per length.
    entering, leaving : TransmittanceLaw
        How entrance and exit face refract.
    near : bool
        Whether points are so near that Newton's method needs the better start.
    rims : bool
        Whether points lie beside the aperture.
    """

    ratio: Number
    ratio2_minus_1: Number
    apparent: Number
    distance2: Number
    lambert: Number
    lift: Number
    drop: Number
    critical: Number
    absorption: Number
    entering: TransmittanceLaw
    leaving: TransmittanceLaw
    near: bool
    rims: bool
