"""A train in numbers, for its compiled loops; in their float type."""

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from workbench.arrays import AnyArray
from workbench.compiled import jit
from workbench.optics.interfaces import TransmittanceLaw
from workbench.optics.kernels.patches import Net
from workbench.optics.kernels.spline import Bounds
from workbench.optics.train.free_light import Aperture, FarLight, NearLight

Number = np.floating[Any]


class SampleLine(NamedTuple):
    """Samples of the exit face along one axis; arrays of shape (m,), scene units."""

    place: AnyArray  # where they are
    # Ends of what each stands for.
    low: AnyArray
    high: AnyArray
    half_width: Number  # of the entrance face; infinite where an `OutlineNumbers` is curved


class OutlineNumbers(NamedTuple):
    """A lens that is not all of its rectangle."""

    curved: bool  # whether it is so at all; if not, the rest plays no part
    # (samples along y, samples along x), which part of what each sample stands for is inside it.
    inside: AnyArray
    # One by the squares of its semi-axes.
    by_x2: Number
    by_y2: Number


class Sky(NamedTuple):
    """Light from infinitely far; arrays of shape (k,), a number for each direction."""

    # Slopes in the glass.
    slope_x: AnyArray
    slope_y: AnyArray
    # Unit vectors before it.
    air_x: AnyArray
    air_y: AnyArray
    flux: AnyArray  # flux per area behind the entrance face, in the middle of the beam
    # Flux falls with exp(−narrowing × square of the distance to the middle of the beam).
    narrowing: Number


class Points(NamedTuple):
    """Points at one distance before the entrance face; arrays of shape (k,)."""

    # Where they are, scene units.
    x: AnyArray
    y: AnyArray
    flux: AnyArray  # flux per area of the entrance face right before each, without its reflection
    # C = n d and d², for the distance d.
    apparent: Number
    distance2: Number
    lambert: Number  # 1 for Lambertian points, else 0
    # (k or 0, n, n), see `workbench.optics.sources.patterns.tabulated`; none where intensity is
    # even or Lambertian.
    patterns: AnyArray
    # Steps between values of the patterns for each length.
    per_x: Number
    per_y: Number
    # Step at x = 0, at y = 0.
    first_x: Number
    first_y: Number
    steps: int  # of Newton's method
    law: TransmittanceLaw  # of the entrance face


class EvenLight(NamedTuple):
    """Light along the axis; see `Light`."""

    # (samples along x or y,), parts of the flux, whose products are those of samples within the
    # outline.
    across: AnyArray
    up: AnyArray
    # (samples along y or 1, samples along x), which part of what each sample stands for is inside
    # the outline.
    inside: AnyArray
    flux: Number  # of all samples together, were all inside


class GivenRays(NamedTuple):
    """Rays that were followed up to the first freeform face; they search for it."""

    # (6, rows, columns), x, y, z of places on the rays, z counted from the level of that face;
    # slopes; and flux, below 0 of rays that are lost. Light is absorbed from these places on.
    values: AnyArray
    # (rows, columns), distances to the rims of the faces before; none where those of the faces do
    # not matter.
    rims: AnyArray


EVEN, SKY, POINTS, FAR, NEAR, LINES = range(6)
"""Kinds of light: along the axis; behind a plane entrance face, of directions or of points; the
same two before the first face; rays that were followed up to the first freeform face."""


class Light(NamedTuple):
    """Light at samples of the first face of the train, or on its way to it."""

    kind: int  # which of the following it is; the others are empty
    even: EvenLight
    sky: Sky
    points: Points
    far: FarLight
    near: NearLight
    given: GivenRays
    aperture: Aperture  # before a face that light meets from outside
    # (samples along y, samples along x), what samples stand for, as seen along the axis; of light
    # before the first face.
    areas: AnyArray
    # Factors of the flux of samples along x and y: which of them belong to a half that is traced
    # alone. None where all are traced.
    share_x: AnyArray
    share_y: AnyArray
    rows: int  # samples along y, or rows of rays
    origins: int  # how many directions or points there are; 1 of given rays


class FirstFace(NamedTuple):
    """The first face of a train, and the medium before it."""

    kind: int  # see `workbench.optics.train.first_face`
    # Refractive index n before the face over that behind it, and n² − 1.
    ratio: Number
    ratio2_minus_1: Number
    lift: Number  # level that heights are counted from, above a plane entrance face
    critical: Number  # squared cosines below this count as total reflection
    absorption: Number  # of the medium, per length
    law: TransmittanceLaw  # how much it refracts
    reflectance: Number  # of a mirror


CONIC, BSPLINE, ASPHERE = range(3)
"""Kinds of further faces; a plane is a conic of curvature 0."""


class Elements(NamedTuple):
    """The further faces of a train; arrays with one entry, or one row, for each."""

    kind: npt.NDArray[np.int32]  # `CONIC`, `BSPLINE` or `ASPHERE`
    # (n, 5), whether it reflects, has a curved outline, is the next face behind samples with a
    # curved outline, its transmittance is exact, its frame is not along the axis of the one before.
    flags: npt.NDArray[np.bool_]
    numbers: AnyArray  # (n, 25), see `element_of`
    changes: AnyArray  # (n, 12), `Change` of coordinates before it
    coefficients: AnyArray  # (n, m), a₄, a₆, … of aspheres
    bounds: AnyArray  # (n, 9), `workbench.optics.kernels.spline.Bounds` of B-splines
    # (n, 3), numbers of knot spans of B-splines, and where their patches begin in the table of all.
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
    """One of the `Elements`, in scalars."""

    kind: int  # `CONIC`, `BSPLINE` or `ASPHERE`
    # See `Elements`.
    reflects: bool
    curved: bool
    behind_samples: bool
    moves: bool
    ratio2_minus_1: Number
    critical: Number
    absorption: Number
    reflectance: Number
    # One by the squares of half-widths or semi-axes.
    by_x2: Number
    by_y2: Number
    rim: Number  # `workbench.optics.surfaces.intersection.RIM`
    beyond: Number  # `workbench.optics.fixed_faces.beyond_rim` of a face behind samples
    # One by the squares of semi-axes of the outline of samples.
    first_x2: Number
    first_y2: Number
    # C and k of a conic.
    curvature: Number
    conic: Number
    # Of an asphere, see `workbench.optics.surfaces.Conic`.
    reach2: Number
    low: Number
    high: Number
    tolerance: Number
    change: Change  # of coordinates before it; a shift along z alone if it does not move
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
