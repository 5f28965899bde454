"""The face that comes closest to given slopes."""

import numpy as np
import numpy.typing as npt
from scipy.linalg import eigh

from workbench.geometry.surface import ControlNet

Array = npt.NDArray[np.float64]


class SlopeFit:
    """Least squares on a tensor grid of places, for one net and many fields of slopes.

    The normal equations are a sum of two Kronecker products; the eigenvectors of the pairs of
    small matrices along each axis make them diagonal (Lynch, Rice and Thomas 1964).

    Parameters
    ----------
    net : ControlNet
        Where the control heights sit.
    u, v : ndarray, shape (m_x,), (m_y,)
        Parameters of the places, at least as many as control points.
    """

    def __init__(self, net: ControlNet, u: Array, v: Array) -> None:
        self.basis = basis = net.grid(u, v)
        self._modes_x, stretch_x = _modes(basis.along_x, basis.slope_x)
        self._modes_y, stretch_y = _modes(basis.along_y.T, basis.slope_y.T)
        self._stretch = stretch_x[:, None] + stretch_y[None, :]
        # The mean height does not matter to slopes, nor do heights that no place sees.
        self._seen = self._stretch > 1e-10 * self._stretch.max()

    def heights(self, slope_x: Array, slope_y: Array) -> Array:
        """Control heights of the face, up to a constant.

        Parameters
        ----------
        slope_x, slope_y : ndarray, shape (m_x, m_y)
            Wanted slopes dz/dx and dz/dy at the places.
        """
        basis = self.basis
        moments = basis.slope_x.T @ slope_x @ basis.along_y.T
        moments += basis.along_x.T @ slope_y @ basis.slope_y.T
        amplitudes = np.zeros_like(moments)
        np.divide(
            self._modes_x.T @ moments @ self._modes_y,
            self._stretch,
            out=amplitudes,
            where=self._seen,
        )
        return np.asarray(self._modes_x @ amplitudes @ self._modes_y.T)


def _modes(value: Array, slope: Array) -> tuple[Array, Array]:
    """Vectors that make the mass matrix the identity and the stiffness matrix diagonal."""
    mass = value.T @ value
    # A trace of ridge: with few places a mass matrix need not be definite.
    mass += 1e-12 * np.trace(mass) / len(mass) * np.eye(len(mass))
    stretch, modes = eigh(slope.T @ slope, mass)
    return modes, stretch
