"""Surface as one polynomial per knot span, the fastest evaluation at scattered points.

Evaluation is a row of a table and Horner's rule, without basis functions. The table is linear in
the control heights, so the result is differentiable with respect to heights and points.
"""

import math
from typing import NamedTuple

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.geometry.basis import greville, local_basis
from workbench.geometry.surface import ControlNet


class Place(NamedTuple):
    """Position of points in the table of patches."""

    row: Tensor  # (m,), patch of each point
    # (m,), local coordinates in it, [−½, ½], along x and y.
    s: Tensor
    t: Tensor


class Patches:
    """Evaluates faces of one control net at scattered points."""

    def __init__(
        self, net: ControlNet, dtype: torch.dtype, device: torch.device | str = "cpu"
    ) -> None:
        self.net, self._degree = net, net.degree
        self._spans = tuple(n - p for n, p in zip(net.shape, net.degree, strict=True))
        self._half_width = net.half_width
        self._knots = net.knots
        self._positions = net.positions
        self.to_powers = [
            torch.as_tensor(_power_basis(*each), dtype=dtype, device=device)
            for each in zip(net.knots, net.degree, self._spans, strict=True)
        ]

    def table(self, heights: Tensor) -> Tensor:
        """Coefficients of s^a t^b of every patch, shape (patches, (p + 1)(q + 1))."""
        (p, q), (across, up) = self._degree, self._spans
        # Axis by axis: gathering the heights around each patch would copy 16 times as many values
        # for degree 3.
        strips = torch.einsum("kia,kji->kaj", self.to_powers[0], heights.unfold(0, p + 1, 1))
        table = torch.einsum("kalj,ljb->klab", strips.unfold(2, q + 1, 1), self.to_powers[1])
        return table.reshape(across * up, (p + 1) * (q + 1))

    def slope_bounds(self, heights: Tensor) -> tuple[float, float]:
        """Bounds of |dz/dx| and |dz/dy|, by the convex-hull property.

        The slope along x is a B-spline of degree p − 1, with differences of control heights over
        differences of Greville abscissae as control values.
        """
        steepest_x, steepest_y = (slopes.abs().max().item() for slopes in self._slopes(heights))
        return steepest_x, steepest_y

    def curvature_bounds(self, heights: Tensor) -> tuple[float, float, float]:
        """Bounds of |d²z/dx²|, |d²z/dxdy| and |d²z/dy²|; infinite for jumps of degree 1."""
        slopes = self._slopes(heights)
        twist = _slopes_between(slopes[0], self._positions[1], axis=1)
        curvatures: list[float] = []
        for axis, (knots, degree, r) in enumerate(
            zip(self._knots, self._degree, self._half_width, strict=True)
        ):
            if degree == 1:
                curvatures.append(math.inf if self._spans[axis] > 1 else 0.0)
                continue
            sites = greville(knots[1:-1], degree - 1) * (2 * r)
            curvatures.append(_slopes_between(slopes[axis], sites, axis).abs().max().item())
        return curvatures[0], twist.abs().max().item(), curvatures[1]

    def _slopes(self, heights: Tensor) -> tuple[Tensor, Tensor]:
        x, y = self._positions
        return _slopes_between(heights, x, axis=0), _slopes_between(heights, y, axis=1)

    def place(self, x: Tensor, y: Tensor) -> Place:
        """Patch and local coordinates of points; outside the aperture of the nearest patch.

        The patch is a constant, the coordinates are differentiable. Points on the far rim belong to
        the last span.
        """
        spans, local = [], []
        for c, r, count in zip((x, y), self._half_width, self._spans, strict=True):
            scaled = (c + r) * (count / (2 * r))
            span = scaled.detach().floor().clamp(0, count - 1)
            spans.append(span)
            local.append(scaled - (span + 0.5))
        row = (spans[0] * self._spans[1] + spans[1]).long()
        return Place(row, local[0], local[1])

    def height(self, table: Tensor, place: Place) -> Tensor:
        """Surface height at the points, shape (m,)."""
        return self._horner(table[place.row], place)[0]

    def evaluate(self, table: Tensor, place: Place) -> tuple[Tensor, Tensor, Tensor]:
        """Height and slopes dz/dx, dz/dy at the points, each of shape (m,)."""
        z, z_s, z_t = self._horner(table[place.row], place)
        (r_x, r_y), (across, up) = self._half_width, self._spans
        return z, z_s * (across / (2 * r_x)), z_t * (up / (2 * r_y))

    def _horner(self, rows: Tensor, place: Place) -> tuple[Tensor, Tensor, Tensor]:
        (p, q) = self._degree
        s, t = place.s, place.t
        coefficient = rows.unbind(1)  # of s^a t^b at a (q + 1) + b
        z = z_s = z_t = torch.zeros_like(s)
        for a in range(p, -1, -1):
            inner = coefficient[a * (q + 1) + q]
            inner_t = torch.zeros_like(t)
            for b in range(q - 1, -1, -1):
                inner_t = inner_t * t + inner
                inner = inner * t + coefficient[a * (q + 1) + b]
            z_s = z_s * s + z
            z = z * s + inner
            z_t = z_t * s + inner_t
        return z, z_s, z_t


def _slopes_between(values: Tensor, sites: Array, axis: int) -> Tensor:
    # Tensors only: numpy cannot read those of `torch.func`.
    distance = torch.as_tensor(np.diff(sites)).to(values)
    return values.diff(dim=axis) / (distance[:, None] if axis == 0 else distance)


# Taylor series at the middle of the span, where rounding is least: coefficient m is the m-th
# derivative times h^m/m!.
def _power_basis(knots: Array, degree: int, spans: int) -> Array:
    middle = (np.arange(spans) + 0.5) / spans
    powers = np.zeros((spans, degree + 1, degree + 1))
    for m in range(degree + 1):
        _, derivative = local_basis(knots, degree, middle, derivative=m)
        powers[:, :, m] = derivative / (math.factorial(m) * float(spans) ** m)
    return powers
