"""The exit face of a lens in the independent trace: rays meet it and go on behind it."""

import math
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt
from scipy.interpolate import BSpline

from workbench.analysis.face_kernels import Spline, follow, heights_at
from workbench.scene import Lens

Array = npt.NDArray[np.float64]


class Followed(NamedTuple):
    """What becomes of rays at the exit face.

    Attributes
    ----------
    leaving : ndarray, shape (7, m)
        Of those that pass: x, y, z where they meet the face, the unit vector behind it, and the
        part of their light that it reflected.
    fate : ndarray of int8, shape (m,)
        LEFT_SIDE, REFLECTED or PASSES.
    """

    leaving: Array
    fate: npt.NDArray[np.int8]


class Face:
    """The exit face, lit from inside.

    Parameters
    ----------
    lens : Lens
        The lens.
    control_points : ndarray, shape (n_u, n_v)
        Control heights, scene units.
    """

    def __init__(self, lens: Lens, control_points: Array) -> None:
        knots = [
            np.concatenate([np.full(p, -r), np.linspace(-r, r, n - p + 1), np.full(p, r)])
            for r, n, p in zip(lens.half_width, lens.control_points, lens.degree, strict=True)
        ]
        # A spline is never steeper than the steepest of its derivative's coefficients.
        steepest = []
        for axis, (t, p) in enumerate(zip(knots, lens.degree, strict=True)):
            width = np.expand_dims(t[p + 1 : -1] - t[1 : -p - 1], 1 - axis)
            slopes = np.abs(np.diff(control_points, axis=axis)) * p / width
            steepest.append(float(slopes.max()))
        heights = np.ascontiguousarray(control_points - lens.entrance_z, dtype=np.float64)
        along_x, along_y = (_pieces(t, p) for t, p in zip(knots, lens.degree, strict=True))
        r_x, r_y = lens.half_width
        self._entrance = lens.entrance_z
        self._spline = Spline(
            heights,
            along_x,
            along_y,
            r_x,
            r_y,
            density_x=len(along_x) / (2 * r_x),
            density_y=len(along_y) / (2 * r_y),
            entrance=lens.entrance_z,
            lowest=float(heights.min()),
            highest=float(heights.max()),
            steepest_x=steepest[0],
            steepest_y=steepest[1],
            refractive_index=lens.index,
        )

    def height(self, places: Array) -> Array:
        """Height of the face at places of shape (m, 2)."""
        heights = np.empty(len(places))
        heights_at(self._spline, np.ascontiguousarray(places), heights)
        return heights + self._entrance

    def follow(self, start: Array, direction: Array) -> Followed:
        """Follow rays from the entrance face through this one.

        Parameters
        ----------
        start : ndarray, shape (m, 2)
            Where they begin on the entrance face, x and y.
        direction : ndarray, shape (m, 3)
            Unit vectors in the lens, upwards.
        """
        leaving = np.empty((7, len(start)))
        fate = np.empty(len(start), dtype=np.int8)
        follow(self._spline, start, direction, leaving, fate)
        return Followed(leaving, fate)


def schlick(index: float, cosine: Any) -> Any:
    """Schlick's reflectance (1994, eq. 24) for a cosine of the angle in the thinner medium."""
    head_on = ((index - 1) / (index + 1)) ** 2
    return head_on + (1 - head_on) * (1 - cosine) ** 5


def _pieces(knots: Array, degree: int) -> Array:
    """Basis functions as polynomials on each knot span, as in `Spline`: Taylor's, by scipy."""
    count = len(knots) - degree - 1
    spans = count - degree
    basis = BSpline(knots, np.eye(count), degree)
    begin, width = knots[degree:count], (knots[-1] - knots[0]) / spans
    span, of_span = np.arange(spans)[:, None], np.arange(degree + 1)[None, :]
    terms = [
        basis(begin, nu=power)[span, span + of_span] * (width**power / math.factorial(power))
        for power in range(degree, -1, -1)
    ]
    return np.ascontiguousarray(np.stack(terms, axis=-1))
