"""Knot vectors: clamped and equispaced, their Greville abscissae, exact knot insertion."""

import numpy as np

from workbench.arrays import Array


def clamped_knots(count: int, degree: int) -> Array:
    """Clamped, equispaced knot vector on [0, 1].

    Parameters
    ----------
    count : int
        Number of control points, at least ``degree + 1``.
    degree : int
        Polynomial degree p.

    Returns
    -------
    ndarray, shape (count + degree + 1,)

    Raises
    ------
    ValueError
        If there are too few control points for the degree.

    Notes
    -----
    Piegl & Tiller, The NURBS Book, eq. 2.13; de Koning et al. (2023), eq. 5.
    """
    if count < degree + 1:
        raise ValueError(f"{count} control points are too few for degree {degree}")
    spans = count - degree
    # A division, not linspace: equal fractions give equal knots, so that nets nest exactly.
    inner = np.arange(spans + 1) / spans
    return np.concatenate([np.zeros(degree), inner, np.ones(degree)])


def greville(knots: Array, degree: int) -> Array:
    """Greville abscissae: the coefficients with which a B-spline is the identity.

    Parameters
    ----------
    knots : ndarray, shape (count + degree + 1,)
        Clamped knot vector.
    degree : int
        Polynomial degree p.

    Returns
    -------
    ndarray, shape (count,)
        Means of p consecutive knots (Farin, Curves and Surfaces for CAGD, section 8.6).
    """
    count = len(knots) - degree - 1
    return np.array([knots[i + 1 : i + degree + 1].mean() for i in range(count)])


def insertion_matrix(coarse: Array, fine: Array, degree: int) -> Array:
    """Matrix that carries control points to a refined knot vector without changing the spline.

    Parameters
    ----------
    coarse, fine : ndarray
        Clamped knot vectors of the same degree; ``fine`` contains ``coarse``.
    degree : int
        Polynomial degree p.

    Returns
    -------
    ndarray, shape (len(fine) - degree - 1, len(coarse) - degree - 1)

    Raises
    ------
    ValueError
        If a knot of ``coarse`` is missing in ``fine``.

    Notes
    -----
    Oslo algorithm of Cohen, Lyche and Riesenfeld (1980): row j holds the discrete B-splines
    α_{i,p}(j), which obey the Cox-de Boor recursion with ``fine[j + p]`` in place of u.
    """
    rows = len(fine) - degree - 1
    fine_knots, fine_counts = np.unique(fine, return_counts=True)
    for knot, multiplicity in zip(*np.unique(coarse, return_counts=True), strict=True):
        if multiplicity > fine_counts[fine_knots == knot].sum():
            raise ValueError(f"knot {knot:g} of the coarse knot vector is missing in the fine one")

    spans = np.searchsorted(coarse, fine[:rows], side="right") - 1
    spans = np.minimum(spans, len(coarse) - degree - 2)
    alpha = np.zeros((rows, len(coarse) - 1))
    alpha[np.arange(rows), spans] = 1.0
    for p in range(1, degree + 1):
        u = fine[p : rows + p, None]
        width = coarse[p:] - coarse[:-p]
        ratio = np.divide(1.0, width, out=np.zeros_like(width), where=width > 0)
        rising = (u - coarse[: -p - 1]) * ratio[:-1]
        falling = (coarse[p + 1 :] - u) * ratio[1:]
        alpha = rising * alpha[:, :-1] + falling * alpha[:, 1:]
    return alpha
