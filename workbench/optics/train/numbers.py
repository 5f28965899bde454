"""A train in numbers, for its compiled loops; in their float type."""

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from workbench.arrays import AnyArray
from workbench.compiled import jit
from workbench.optics.kernels.patches import Net
from workbench.optics.kernels.spline import Bounds
from workbench.optics.train.aperture import Aperture
from workbench.optics.train.free_light import FarLight, NearLight
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
        See `workbench.optics.patterns.tabulated`; none where intensity is even or
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


class EvenLight(NamedTuple):
    """Light along the axis; see `Light`.

    Attributes
    ----------
    across, up : ndarray, shape (samples along x or y,)
        Parts of the flux, whose products are those of samples within the outline.
    inside : ndarray, shape (samples along y or 1, samples along x)
        Which part of what each sample stands for is inside the outline.
    flux : floating
        Of all samples together, were all inside.
    """

    across: AnyArray
    up: AnyArray
    inside: AnyArray
    flux: Number


class GivenRays(NamedTuple):
    """Rays that were followed up to the first freeform face; they search for it.

    Attributes
    ----------
    values : ndarray, shape (6, rows, columns)
        x, y, z of places on the rays, z counted from the level of that face; slopes; and flux,
        below 0 of rays that are lost. Light is absorbed from these places on.
    rims : ndarray, shape (rows, columns)
        Distances to the rims of the faces before; none where those of the faces do not matter.
    """

    values: AnyArray
    rims: AnyArray


EVEN, SKY, POINTS, FAR, NEAR, LINES = range(6)
"""Kinds of light: along the axis; behind a plane entrance face, of directions or of points; the
same two before the first face; rays that were followed up to the first freeform face."""


class Light(NamedTuple):
    """Light at samples of the first face of the train, or on its way to it.

    Attributes
    ----------
    kind : int
        Which of the following it is; the others are empty.
    even : EvenLight
    sky : Sky
    points : Points
    far : workbench.optics.train.free_light.FarLight
    near : workbench.optics.train.free_light.NearLight
    given : GivenRays
    aperture : Aperture
        Before a face that light meets from outside.
    areas : ndarray, shape (samples along y, samples along x)
        What samples stand for, as seen along the axis; of light before the first face.
    share_x, share_y : ndarray
        Factors of the flux of samples along x and y: which of them belong to a half that is traced
        alone. None where all are traced.
    rows : int
        Samples along y, or rows of rays.
    origins : int
        How many directions or points there are; 1 of given rays.
    """

    kind: int
    even: EvenLight
    sky: Sky
    points: Points
    far: FarLight
    near: NearLight
    given: GivenRays
    aperture: Aperture
    areas: AnyArray
    share_x: AnyArray
    share_y: AnyArray
    rows: int
    origins: int


class FirstFace(NamedTuple):
    """The first face of a train, and the medium before it.

    Attributes
    ----------
    kind : int
        See `workbench.optics.train.first_face`.
    ratio, ratio2_minus_1 : floating
        Refractive index n before the face over that behind it, and n² − 1.
    lift : floating
        Level that heights are counted from, above a plane entrance face.
    critical : floating
        Squared cosines below this count as total reflection.
    absorption : floating
        Of the medium, per length.
    law : TransmittanceLaw
        How much it refracts.
    reflectance : floating
        Of a mirror.
    """

    kind: int
    ratio: Number
    ratio2_minus_1: Number
    lift: Number
    critical: Number
    absorption: Number
    law: TransmittanceLaw
    reflectance: Number


CONIC, BSPLINE, ASPHERE = range(3)
"""Kinds of further faces; a plane is a conic of curvature 0."""


class Elements(NamedTuple):
    """The further faces of a train; arrays with one entry, or one row, for each.

    Attributes
    ----------
    kind : ndarray of int32
        `CONIC`, `BSPLINE` or `ASPHERE`.
    flags : ndarray of bool, shape (n, 5)
        Whether it reflects, has a curved outline, is the next face behind samples with a curved
        outline, its transmittance is exact, its frame is not along the axis of the one before.
    numbers : ndarray, shape (n, 25)
        See `element_of`.
    changes : ndarray, shape (n, 12)
        `Change` of coordinates before it.
    coefficients : ndarray, shape (n, m)
        a₄, a₆, … of aspheres.
    bounds : ndarray, shape (n, 9)
        `workbench.optics.kernels.spline.Bounds` of B-splines.
    spans : ndarray of int64, shape (n, 3)
        Numbers of knot spans of B-splines, and where their patches begin in the table of all.
    """

    kind: npt.NDArray[np.int32]
    flags: npt.NDArray[np.bool_]
    numbers: AnyArray
    changes: AnyArray
    coefficients: AnyArray
    bounds: AnyArray
    spans: npt.NDArray[np.int64]


class Change(NamedTuple):
    """A change of coordinates: rows of a rotation, and then a shift."""

    xx: Number
    xy: Number
    xz: Number
    yx: Number
    yy: Number
    yz: Number
    zx: Number
    zy: Number
    zz: Number
    x: Number
    y: Number
    z: Number


class Law(NamedTuple):
    """A `TransmittanceLaw`, of a file whose text names the folder of compiled code."""

    ratio: Number
    passing: Number
    grazing: Number
    exact: bool


class Element(NamedTuple):
    """One of the `Elements`, in scalars.

    Attributes
    ----------
    kind : int
        `CONIC`, `BSPLINE` or `ASPHERE`.
    reflects, curved, behind_samples, moves : bool
        See `Elements`.
    ratio2_minus_1, critical, absorption, reflectance : floating
        As in `FirstFace`.
    by_x2, by_y2 : floating
        One by the squares of half-widths or semi-axes.
    rim : floating
        `workbench.optics.intersection.RIM`.
    beyond : floating
        `workbench.optics.sampled.beyond_rim` of a face behind samples.
    first_x2, first_y2 : floating
        One by the squares of semi-axes of the outline of samples.
    curvature, conic : floating
        c and k of a conic.
    reach2, low, high, tolerance : floating
        Of an asphere, see `workbench.optics.surfaces.Conic`.
    change : Change
        Of coordinates before it; a shift along z alone if it does not move.
    law : TransmittanceLaw
    net : Net
    bounds : Bounds
    """

    kind: int
    reflects: bool
    curved: bool
    behind_samples: bool
    moves: bool
    ratio2_minus_1: Number
    critical: Number
    absorption: Number
    reflectance: Number
    by_x2: Number
    by_y2: Number
    rim: Number
    beyond: Number
    first_x2: Number
    first_y2: Number
    curvature: Number
    conic: Number
    reach2: Number
    low: Number
    high: Number
    tolerance: Number
    change: Change
    law: Law
    net: Net
    bounds: Bounds


@jit(allocates=False)
def element_of(elements, e):  # type: ignore[no-untyped-def]
    """Element number ``e`` in scalars: what lies in arrays is loaded again in every loop."""
    flags, n, b, spans = (
        elements.flags[e],
        elements.numbers[e],
        elements.bounds[e],
        elements.spans[e],
    )
    c = elements.changes[e]
    change = Change(
        c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8], c[9], c[10], c[11]
    )  # fmt: skip
    law = Law(n[16], n[17], n[18], flags[3])
    net = Net(n[19], n[20], n[21], n[22], n[23], n[24], (spans[0], spans[1]), spans[2])
    bounds = Bounds(b[0], b[1], b[2], b[3], b[4], b[5], b[6], b[7], b[8])
    return Element(
        elements.kind[e], flags[0], flags[1], flags[2], flags[4],
        n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8], n[9], n[10], n[11], n[12], n[13],
        n[14], n[15], change, law, net, bounds,
    )  # fmt: skip
