"""Freeform faces: tensor-product B-splines whose x and y are linear in u and v."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, Generic, TypeVar

import numpy as np

from workbench.arrays import Array, Mask
from workbench.geometry.basis import basis_matrix, local_basis
from workbench.geometry.knots import clamped_knots, greville, insertion_matrix
from workbench.geometry.outlines import Outline, outline_of
from workbench.scene import Element

if TYPE_CHECKING:
    import torch

_AT_ONCE = 1 << 15  # places at which basis functions are held at once
# Evaluation is indexing and matrix products alone, so arrays and tensors go the same way.
Numeric = TypeVar("Numeric", Array, "torch.Tensor")


@dataclass(frozen=True)
class GridBasis(Generic[Numeric]):
    """Basis values on a tensor grid; evaluation is two small matrix products.

    Attributes
    ----------
    along_x, slope_x : array, shape (m_x, n_u)
        Basis functions and their derivatives with respect to x.
    along_y, slope_y : array, shape (n_v, m_y)
        The same along y, transposed.
    """

    along_x: Numeric
    slope_x: Numeric
    along_y: Numeric
    slope_y: Numeric

    def evaluate(self, heights: Numeric) -> tuple[Numeric, Numeric, Numeric]:
        """Height and slopes dz/dx, dz/dy on the grid.

        Parameters
        ----------
        heights : array, shape (n_u, n_v)
            Control heights.

        Returns
        -------
        tuple of three arrays, shape (m_x, m_y)
        """
        by_row = self.along_x @ heights
        return by_row @ self.along_y, self.slope_x @ heights @ self.along_y, by_row @ self.slope_y


@dataclass(frozen=True)
class PointBasis(Generic[Numeric]):
    """Basis values at scattered points.

    Attributes
    ----------
    index_x : integer array, shape (m, p + 1)
        Control points along x that matter at each point.
    index_y : integer array, shape (m, q + 1)
        The same along y.
    along_x, slope_x : array, shape (m, p + 1)
        Their basis functions and the derivatives with respect to x.
    along_y, slope_y : array, shape (m, q + 1)
        The same along y.
    """

    index_x: Numeric
    index_y: Numeric
    along_x: Numeric
    slope_x: Numeric
    along_y: Numeric
    slope_y: Numeric

    def evaluate(self, heights: Numeric) -> tuple[Numeric, Numeric, Numeric]:
        """Height and slopes dz/dx, dz/dy at the points, each of shape (m,)."""
        near = heights[self.index_x[:, :, None], self.index_y[:, None, :]]  # [m, p+1, q+1]
        by_row = (near * self.along_y[:, None, :]).sum(2)  # [m, p+1]
        slope_row = (near * self.slope_y[:, None, :]).sum(2)
        return (
            (by_row * self.along_x).sum(1),
            (by_row * self.slope_x).sum(1),
            (slope_row * self.along_x).sum(1),
        )


@dataclass(frozen=True)
class ControlNet:
    """The B-spline space of a face: all that is known of it but the heights.

    Attributes
    ----------
    shape : tuple[int, int]
        Numbers of control points (n_u, n_v).
    degree : tuple[int, int]
        Polynomial degrees (p, q).
    half_width : tuple[float, float]
        Half-widths (r_x, r_y) of the aperture, scene units.
    """

    shape: tuple[int, int]
    degree: tuple[int, int]
    half_width: tuple[float, float]

    @classmethod
    def of(cls, optic: Element) -> "ControlNet":
        """The net of the face that the task shapes; see also `freeform_nets`."""
        return cls(optic.net_shape, optic.degree, optic.half_width)

    @cached_property
    def knots(self) -> tuple[Array, Array]:
        """Knot vectors along u and v."""
        return (
            clamped_knots(self.shape[0], self.degree[0]),
            clamped_knots(self.shape[1], self.degree[1]),
        )

    @cached_property
    def positions(self) -> tuple[Array, Array]:
        """X (n_u,) and y (n_v,) of the control points (de Koning et al. 2023, eq. 13)."""
        u, v = (greville(knots, p) for knots, p in zip(self.knots, self.degree, strict=True))
        return (2 * u - 1) * self.half_width[0], (2 * v - 1) * self.half_width[1]

    def grid(self, u: Array, v: Array) -> GridBasis[Array]:
        """Basis values on the tensor grid of parameters u (m_x,) and v (m_y,) in [0, 1]."""
        (along_x, slope_x), (along_y, slope_y) = self._axes(u, v)
        return GridBasis(along_x, slope_x, along_y.T, slope_y.T)

    def _axes(self, u: Array, v: Array) -> list[tuple[Array, Array]]:
        return [
            (
                basis_matrix(knots, degree, t),
                basis_matrix(knots, degree, t, derivative=1) / (2 * r),
            )
            for knots, degree, r, t in zip(
                self.knots, self.degree, self.half_width, (u, v), strict=True
            )
        ]

    def points(self, u: Array, v: Array) -> PointBasis[Any]:
        """Basis values at the points (u[k], v[k]), parameters in [0, 1]."""
        parts: list[tuple[Any, Array, Array]] = []
        for knots, degree, r, t in zip(
            self.knots, self.degree, self.half_width, (u, v), strict=True
        ):
            first, values = local_basis(knots, degree, t)
            slopes = local_basis(knots, degree, t, derivative=1)[1] / (2 * r)
            parts.append((first[:, None] + np.arange(degree + 1), values, slopes))
        (index_x, along_x, slope_x), (index_y, along_y, slope_y) = parts
        return PointBasis(index_x, index_y, along_x, slope_x, along_y, slope_y)

    def over(self, outline: Outline, u: Array, v: Array, heights: Array) -> tuple[Array, ...]:
        """The face on a grid that fills an outline of the lens.

        Parameters
        ----------
        outline : Outline
            Within the aperture.
        u, v : ndarray, shapes (m_x,), (m_y,)
            Coordinates in [-1, 1] of the square that is mapped onto the outline.
        heights : ndarray, shape (n_u, n_v)
            Control heights.

        Returns
        -------
        tuple of five ndarray, shape (m_x, m_y)
            x, y, height and slopes dz/dx, dz/dy.
        """
        x, y = outline.from_square(u[:, None], v)
        if outline.whole:
            return x, y, *self.grid((u + 1) / 2, (v + 1) / 2).evaluate(heights)
        return x, y, *self.at(x, y, heights)

    def at(self, x: Array, y: Array, heights: Array) -> tuple[Array, Array, Array]:
        """Height and slopes dz/dx, dz/dy at any places of one shape, in scene units."""
        u, v = (
            ((place.ravel() / r + 1) / 2).clip(0, 1)
            for place, r in zip((x, y), self.half_width, strict=True)
        )
        found = np.empty((3, u.size))
        for first in range(0, u.size, _AT_ONCE):
            some = slice(first, first + _AT_ONCE)
            found[:, some] = self.points(u[some], v[some]).evaluate(heights)
        z, slope_x, slope_y = found.reshape(3, *x.shape)
        return z, slope_x, slope_y

    def shaping(self, outline: Outline) -> Mask:
        """Which control points bear on the face inside an outline, shape (n_u, n_v).

        The others move nothing but what of the aperture is no glass.
        """
        (left, right), (low, high) = (
            ((2 * knots[: -p - 1] - 1) * r, (2 * knots[p + 1 :] - 1) * r)
            for knots, p, r in zip(self.knots, self.degree, self.half_width, strict=True)
        )
        return outline.area_inside((left[:, None], right[:, None]), (low, high)) > 0

    def contains(self, coarser: "ControlNet") -> bool:
        """Whether each surface of a coarser net is one of this net too: see `refine`."""
        return self.degree == coarser.degree and all(
            np.isin(theirs, mine).all()
            for mine, theirs in zip(self.knots, coarser.knots, strict=True)
        )

    def carry(self, heights: Array, other: "ControlNet") -> Array:
        """Heights for another net: by knot insertion, exactly, where its knots contain this net's.

        Otherwise the surface is interpolated at the other net's Greville abscissae.
        """
        if other.contains(self):
            return self.refine(heights, other)
        into_x, into_y = other.embedding(self)
        return np.asarray(into_x @ heights @ into_y.T)

    def embedding(self, coarser: "ControlNet") -> tuple[Array, Array]:
        """Matrices A_u, A_v that carry a coarser net's heights to this net, A_u P A_vᵀ.

        They interpolate the coarser surface at this net's Greville abscissae: close for any two
        nets, and exact where this net's knots contain the coarser net's (see also `refine`).
        """
        parts: list[Array] = []
        for axis in (0, 1):
            fine, coarse = self.knots[axis], coarser.knots[axis]
            sites = greville(fine, self.degree[axis])
            here = basis_matrix(fine, self.degree[axis], sites)
            there = basis_matrix(coarse, coarser.degree[axis], sites)
            parts.append(np.asarray(np.linalg.solve(here, there), dtype=np.float64))
        return parts[0], parts[1]

    def refine(self, heights: Array, finer: "ControlNet") -> Array:
        """The same surface on a finer net, exactly.

        Parameters
        ----------
        heights : ndarray, shape (n_u, n_v)
            Control heights on this net.
        finer : ControlNet
            A net whose knots contain this net's.

        Raises
        ------
        ValueError
            If the knots of ``finer`` do not contain this net's.
        """
        into_u, into_v = (
            insertion_matrix(old, new, p)
            for old, new, p in zip(self.knots, finer.knots, self.degree, strict=True)
        )
        return np.asarray(into_u @ heights @ into_v.T)


def freeform_nets(optic: Element) -> dict[str, ControlNet]:
    """The net of each freeform face of an optic by the name of the face, as light meets them."""
    nets = {optic.designed_face: ControlNet.of(optic)}
    entrance = optic.entrance.net(optic.net_shape)
    if entrance is None:
        return nets
    return {"entrance": ControlNet(*entrance, optic.half_width), **nets}


def even_counts(half_width: tuple[float, float], longer: int) -> tuple[int, int]:
    """Numbers of places along x and y, as dense along both: ``longer`` along the longer side."""
    n_x, n_y = (max(round(longer * r / max(half_width)), 2) for r in half_width)
    return n_x, n_y


def sample_faces(
    optic: Element, heights: Mapping[str, Array], count: tuple[int, int]
) -> dict[str, Array]:
    """Points of each freeform face on a grid that includes the rim: regular where that is straight.

    Parameters
    ----------
    optic : Element
        The lens.
    heights : mapping of str to ndarray, shape (n_u, n_v)
        Control heights of each freeform face by its name, scene units.
    count : tuple[int, int]
        Numbers of points along x and y.

    Returns
    -------
    dict of str to ndarray, shape (count_x, count_y, 3)
        Scene units; points of the faces are above each other.
    """
    u, v = (2 * np.linspace(0, 1, n) - 1 for n in count)
    outline = outline_of(optic)
    return {
        face: np.stack(net.over(outline, u, v, heights[face])[:3], axis=-1)
        for face, net in freeform_nets(optic).items()
    }
