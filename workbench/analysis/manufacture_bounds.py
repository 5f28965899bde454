"""Bounds of slope and curvature of a face, and of the thickness of a lens.

On a part of a knot span, second derivatives are averages of the matrices of their Bernstein
coefficients, with non-negative weights. The largest eigenvalue of an average is at most the largest
eigenvalue of the averaged matrices, so a few small matrices bound all curvatures.
"""

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from scipy.sparse import csr_array

from workbench.arrays import Array, Mask
from workbench.geometry.curvature import equal_parts, to_bernstein
from workbench.geometry.surface import ControlNet
from workbench.progress import check_given_up

_AT_ONCE = 1 << 20  # coefficients in memory
_ORDERS = ((1, 0), (0, 1), (2, 0), (1, 1), (0, 2))


class FaceBounds(NamedTuple):
    """Upper bounds of slope and curvature over a face."""

    slope: float  # magnitude of the gradient of z
    # Curvature of hollows and of humps, 1 / scene unit; 0 without any.
    hollow: float
    hump: float


def shape_bounds(
    net: ControlNet, heights: Array, parts: tuple[int, int], where: Mask | None = None
) -> FaceBounds:
    """Return bounds of slope and curvature, which tighten with the number of parts.

    `heights` (n_u, n_v): scene units; `parts`: equal parts of a knot span along x and y; `where`
    (parts along x, parts along y): mask of the parts to use.

    Notes
    -----
    The curvature in a direction a is aᵀHa / (aᵀIa √(1 + |g|²)), with the slopes g and I = 1 + g gᵀ.
    With slopes within δ of g₀ and any 0 < ε ≤ 1, I is not less than
    (1 − (1 / ε − 1) δ²) + (1 − ε) g₀ g₀ᵀ; here ε = δ / |g₀|, or 1.
    """
    most = [0.0, 0.0, 0.0]
    first = 0
    for p, q, r, s, t in _coefficients(net, heights, parts):
        check_given_up()
        last = first + len(p)
        seen = True if where is None else where[first:last, None, :, None]
        first = last
        most[0] = max(most[0], float(np.hypot(p, q).max(where=seen, initial=0.0)))
        (mid_p, half_p), (mid_q, half_q) = _box(p), _box(q)
        off, size = np.hypot(half_p, half_q), np.hypot(mid_p, mid_q)
        even = 1 - (size - off).clip(0) * off
        along = 1 - np.divide(off, size, out=np.ones_like(off), where=size > off)
        # The eigenvalues of M⁻¹ H, where M = even + along g₀ g₀ᵀ.
        m_pp, m_qq = even + along * mid_p**2, even + along * mid_q**2
        m_pq = along * mid_p * mid_q
        determinant = m_pp * m_qq - m_pq**2
        mean = (m_qq * r - 2 * m_pq * s + m_pp * t) / (2 * determinant)
        apart = np.sqrt((mean**2 - (r * t - s**2) / determinant).clip(0))
        stretch = np.sqrt(1 + (size - off).clip(0) ** 2)
        for number, curvature in ((1, mean + apart), (2, apart - mean)):
            largest = (curvature / stretch).max(where=seen, initial=0.0)
            most[number] = max(most[number], float(largest))
    return FaceBounds(*most)


def difference_range(
    upper: tuple[ControlNet, Array], lower: tuple[ControlNet, Array], least: int
) -> tuple[Array, Array, tuple[Array, Array]]:
    """Bound the distance of two faces along z, on parts between the knots of both.

    `upper`, `lower`: net and control heights (n_u, n_v) over the same rectangle; `least`: parts
    along each axis, at least. Returns bounds `low`, `high` (m_x, m_y) and the ends of the parts in
    [0, 1]. On each part the distance is a polynomial, within its Bernstein coefficients.
    """
    faces = (upper, lower)
    ends = [_parts([net.knots[axis] for net, _ in faces], least) for axis in (0, 1)]
    apart = np.zeros(())
    for sign, (net, heights) in zip((1, -1), faces, strict=True):
        coefficients = heights
        for axis in (0, 1):
            degree = max(each.degree[axis] for each, _ in faces)
            into = to_bernstein(net, axis, 0, ends[axis])
            raised = _raised(into, degree).reshape(len(into), degree + 1, -1)
            coefficients = np.tensordot(coefficients, raised, axes=(0, 2))
        apart = apart + sign * coefficients
    return apart.min(axis=(1, 3)), apart.max(axis=(1, 3)), (ends[0], ends[1])


def _parts(knots: Sequence[Array], least: int) -> Array:
    """Ends of parts without knots inside."""
    strips = np.unique(np.concatenate(knots))
    count = math.ceil(least / (len(strips) - 1))
    inner = strips[:-1, None] + np.diff(strips)[:, None] * (np.arange(count) / count)
    return np.append(inner, 1.0)


def _coefficients(
    net: ControlNet, heights: Array, parts: tuple[int, int]
) -> Iterator[tuple[Array, ...]]:
    """Yield Bernstein coefficients of z_x, z_y, z_xx, z_xy, z_yy on some of the parts.

    Each is (parts along x, p + 1, parts along y, q + 1), raised to the net's degree.
    """
    sizes = [degree + 1 for degree in net.degree]
    # Sparse: few control points influence a part.
    into_x, into_y = (
        [
            csr_array(_raised(to_bernstein(net, axis, order, ends), net.degree[axis]))
            for order in (0, 1, 2)
        ]
        for axis, ends in enumerate(equal_parts(net, axis, parts[axis]) for axis in (0, 1))
    )
    by_column = [np.ascontiguousarray((into @ heights.T).T) for into in into_y]
    step = sizes[0] * max(_AT_ONCE // (by_column[0].shape[1] * sizes[0]), 1)
    for first in range(0, into_x[0].shape[0], step):
        yield tuple(
            (into_x[i][first : first + step] @ by_column[j]).reshape(
                -1, sizes[0], by_column[j].shape[1] // sizes[1], sizes[1]
            )
            for i, j in _ORDERS
        )


def _raised(into: Array, degree: int) -> Array:
    """Raise the degree of polynomials (Farin, section 5.1): (parts * (degree + 1), count)."""
    low = into.shape[1] - 1
    raising = np.array(
        [
            [
                math.comb(low, j) * math.comb(degree - low, i - j) / math.comb(degree, i)
                if 0 <= i - j <= degree - low
                else 0.0
                for j in range(low + 1)
            ]
            for i in range(degree + 1)
        ]
    )
    return np.asarray(np.einsum("ij,kjn->kin", raising, into).reshape(-1, into.shape[-1]))


def _box(coefficients: Array) -> tuple[Array, Array]:
    """Middle and half width of the range of the coefficients of each part."""
    low = coefficients.min(axis=(1, 3), keepdims=True)
    high = coefficients.max(axis=(1, 3), keepdims=True)
    return (low + high) / 2, (high - low) / 2
