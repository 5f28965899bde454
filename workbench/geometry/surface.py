"""Freeform faces: tensor-product B-splines whose x and y are linear in u and v."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, Generic, TypeVar

import numpy as np

from workbench.arrays import Array, Mask
from workbench.geometry.basis import (
    basis_matrix,
    clamped_knots,
    greville,
    insertion_matrix,
    local_basis,
)
from workbench.geometry.outlines import Outline, outline_of
from workbench.scene import Element, Scene

if TYPE_CHECKING:
    import torch

_AT_ONCE = 1 << 15  # points whose basis values are in memory at once
# Evaluation is indexing and matrix products only, for arrays and tensors alike.
Numeric = TypeVar("Numeric", Array, "torch.Tensor")


@dataclass(frozen=True)
class GridBasis(Generic[Numeric]):
    """Basis values on a tensor grid; evaluation is two small matrix products.

    ``along_x`` and ``slope_x`` (m_x, n_u) are basis functions and their derivatives with respect to
    x, ``along_y`` and ``slope_y`` (n_v, m_y) the same along y, transposed.
    """

    along_x: Numeric
    slope_x: Numeric
    along_y: Numeric
    slope_y: Numeric

    def evaluate(self, heights: Numeric) -> tuple[Numeric, Numeric, Numeric]:
        """Height and slopes dz/dx, dz/dy (m_x, m_y) for control heights (n_u, n_v)."""
        by_row = self.along_x @ heights
        return by_row @ self.along_y, self.slope_x @ heights @ self.along_y, by_row @ self.slope_y


@dataclass(frozen=True)
class PointBasis(Generic[Numeric]):
    """Basis values at m points: indices of control points (m, p + 1), values and slopes."""

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
    """B-spline space of a face."""

    shape: tuple[int, int]  # numbers of control points (n_u, n_v)
    degree: tuple[int, int]  # polynomial degrees (p, q)
    half_width: tuple[float, float]  # half-widths (r_x, r_y) of the aperture, scene units

    @classmethod
    def of(cls, optic: Element) -> "ControlNet":
        """Net of the designed face; see also `freeform_nets`."""
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

    @property
    def spacing(self) -> tuple[float, float]:
        """Widths of the knot spans along x and y, scene units."""
        x, y = (
            2 * r / (n - p)
            for r, n, p in zip(self.half_width, self.shape, self.degree, strict=True)
        )
        return x, y

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
        """Return x, y, height and slopes (m_x, m_y) of the face on a grid that fills an outline.

        ``u`` (m_x,) and ``v`` (m_y,) in [-1, 1] are coordinates of the square that is mapped onto
        the outline.
        """
        x, y = outline.from_square(u[:, None], v)
        if outline.whole:
            return x, y, *self.grid((u + 1) / 2, (v + 1) / 2).evaluate(heights)
        return x, y, *self.at(x, y, heights)

    def at(self, x: Array, y: Array, heights: Array) -> tuple[Array, Array, Array]:
        """Height and slopes dz/dx, dz/dy at points of any one shape, scene units."""
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
        """Mask (n_u, n_v) of the control points that affect the face inside an outline."""
        (left, right), (low, high) = (
            ((2 * knots[: -p - 1] - 1) * r, (2 * knots[p + 1 :] - 1) * r)
            for knots, p, r in zip(self.knots, self.degree, self.half_width, strict=True)
        )
        return outline.area_inside((left[:, None], right[:, None]), (low, high)) > 0

    def contains(self, coarser: "ControlNet") -> bool:
        """Whether each surface of a coarser net is one of this net; see `refine`."""
        return self.degree == coarser.degree and all(
            np.isin(theirs, mine).all()
            for mine, theirs in zip(self.knots, coarser.knots, strict=True)
        )

    def carry(self, heights: Array, other: "ControlNet") -> Array:
        """Return the heights for another net, exactly where its knots contain this net's.

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
        """Return the heights of the same surface on a finer net; raise ValueError if impossible."""
        into_u, into_v = (
            insertion_matrix(old, new, p)
            for old, new, p in zip(self.knots, finer.knots, self.degree, strict=True)
        )
        return np.asarray(into_u @ heights @ into_v.T)


def freeform_nets(optic: Element) -> dict[str, ControlNet]:
    """Nets of the freeform faces of an element, by face, in the order of the light."""
    if not optic.designed:
        return {}
    nets = {optic.designed_face: ControlNet.of(optic)}
    entrance, front = optic.entrance.net(optic.net_shape), optic.designed_front
    if entrance is None or front is None:
        return nets
    return {front: ControlNet(*entrance, optic.half_width), **nets}


def nets_of(scene: Scene) -> dict[str, ControlNet]:
    """Nets of the freeform faces of all elements of a scene, by id, in the order of the light."""
    return {face: net for element in scene.elements for face, net in freeform_nets(element).items()}


def even_counts(half_width: tuple[float, float], longer: int) -> tuple[int, int]:
    """Numbers of samples along x and y of equal density, ``longer`` along the longer side."""
    n_x, n_y = (max(round(longer * r / max(half_width)), 2) for r in half_width)
    return n_x, n_y


def sample_faces(
    optics: Element | Sequence[Element], heights: Mapping[str, Array], count: tuple[int, int]
) -> dict[str, Array]:
    """Return points (count_x, count_y, 3) of each freeform face on a grid including the rim.

    ``heights`` are (n_u, n_v) by face, scene units. The points of all faces of an element have the
    same x and y; they are in the coordinates of the element.
    """
    u, v = (2 * np.linspace(0, 1, n) - 1 for n in count)
    return {
        face: np.stack(net.over(outline_of(optic), u, v, heights[face])[:3], axis=-1)
        for optic in ([optics] if isinstance(optics, Element) else optics)
        for face, net in freeform_nets(optic).items()
    }
