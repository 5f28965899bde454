"""The face that comes closest to given slopes."""

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from scipy.linalg import eigh
from scipy.sparse import csr_array

from workbench.arrays import Array
from workbench.geometry.basis import clamped_knots, sparse_basis
from workbench.geometry.surface import ControlNet


class SlopeFit:
    """Least squares on a tensor grid of even places, for one net and many fields of slopes.

    The normal equations are a sum of two Kronecker products; the eigenvectors of the pairs of
    small matrices along each axis make them diagonal (Lynch, Rice and Thomas 1964).

    `net`: where the control heights sit; `places`: places along each axis, at least as many as
    control points: the middles of equal cells.
    """

    def __init__(self, net: ControlNet, places: int) -> None:
        self._x, self._y = (
            _axis(count, degree, places)
            for count, degree in zip(net.shape, net.degree, strict=True)
        )
        self._width_x, self._width_y = (2 * r for r in net.half_width)
        stretch_x, stretch_y = (
            self._x.stretch / self._width_x**2,
            self._y.stretch / self._width_y**2,
        )
        self._stretch = stretch_x[:, None] + stretch_y[None, :]
        # The mean height does not matter to slopes, nor do heights that no place sees.
        self._seen = self._stretch > 1e-10 * self._stretch.max()

    def surface(self, heights: Array) -> Array:
        """Heights of the face at the places, shape (places, places)."""
        return np.asarray((self._y.value @ (self._x.value @ heights).T).T)

    def slopes(self, heights: Array) -> tuple[Array, Array]:
        """Slopes dz/dx and dz/dy of the face at the places, each of shape (places, places)."""
        x, y = self._x, self._y
        along_x = (y.value @ (x.slope @ heights).T).T / self._width_x
        along_y = (y.slope @ (x.value @ heights).T).T / self._width_y
        return np.asarray(along_x), np.asarray(along_y)

    def heights(self, slope_x: Array, slope_y: Array) -> Array:
        """Control heights of the face, up to a constant.

        `slope_x`, `slope_y` (places, places): wanted slopes dz/dx and dz/dy at the places.
        """
        x, y = self._x, self._y
        moments = (y.value.T @ (x.slope.T @ (slope_x / self._width_x)).T).T
        moments += (y.slope.T @ (x.value.T @ (slope_y / self._width_y)).T).T
        amplitudes = np.zeros_like(moments)
        np.divide(x.modes.T @ moments @ y.modes, self._stretch, out=amplitudes, where=self._seen)
        return np.asarray(x.modes @ amplitudes @ y.modes.T)


class _Axis(NamedTuple):
    """Splines along an axis from 0 to 1."""

    # (places, count), basis functions and their derivatives at the places.
    value: csr_array
    slope: csr_array
    # (count, count), vectors that make the mass matrix the identity and the stiffness matrix
    # diagonal.
    modes: Array
    stretch: Array  # (count,), that diagonal


@lru_cache(maxsize=8)  # both axes of most nets, one design after the other, and refits share it
def _axis(count: int, degree: int, places: int) -> _Axis:
    knots, middles = clamped_knots(count, degree), (np.arange(places) + 0.5) / places
    value, slope = (sparse_basis(knots, degree, middles, derivative) for derivative in (0, 1))
    mass = (value.T @ value).toarray()
    # A trace of ridge: with few places a mass matrix need not be definite.
    mass += 1e-12 * np.trace(mass) / count * np.eye(count)
    stretch, modes = eigh((slope.T @ slope).toarray(), mass)
    return _Axis(value, slope, modes, stretch)
