"""Optimal transport of one image to another: the back-and-forth method.

Jacobs and Léger (2020), A fast approach to optimal transport: the back-and-forth method. The dual
problem is climbed in turns with respect to each of its two potentials, in the H¹ norm; between
the turns a c-transform makes the one potential the best for the other.
"""

import math

import numpy as np
import numpy.typing as npt
from scipy.fft import dctn, idctn

from workbench.design.transport.envelope import c_transform
from workbench.design.transport.push import mapped, push

Array = npt.NDArray[np.float64]

# A dozen rounds bring most pairs of images as near as a grid allows; one bright pixel takes more.
_MOST_ROUNDS = 60
# It is enough when so many rounds bring the images nearer by less than this part.
_PATIENCE, _PROGRESS = 3, 0.03


class Transport:
    """The map that carries one image to another with the least Σ w |x − y|².

    Parameters
    ----------
    source, target : ndarray, shape (m_0, m_1)
        Mass of the cells of equal grids with spacing 1; each sums to 1.
    weights : tuple[float, float]
        w along the two axes.
    """

    def __init__(self, source: Array, target: Array, weights: tuple[float, float]) -> None:
        self._target, self._weights = target, weights
        self._waves = _laplacian(source.shape, weights)
        self._there = np.zeros_like(source)  # potential whose map goes to the target
        # Each potential has a step of its own: that of a dim wide image may be a thousand times
        # that of a few bright pixels.
        self._steps = (4 / max(source.max(), target.max()),) * 2
        self.improve(source)

    def improve(self, source: Array) -> None:
        """Go on for a source that has changed a little."""
        target, weights = self._target, self._weights
        there, back = self._there, c_transform(self._there, *weights)
        value = float((there * source).sum() + (back * target).sum())
        step, step_back = self._steps
        nearest, idle = math.inf, 0
        for _ in range(_MOST_ROUNDS):
            before = step, step_back
            there, back, value, step, _ = self._climb(there, back, source, target, value, step)
            back, there, value, step_back, distance = self._climb(
                back, there, target, source, value, step_back
            )
            grows = step > before[0] or step_back > before[1]
            nearer = distance < (1 - _PROGRESS) * nearest
            idle = 0 if nearer or grows else idle + 1
            nearest = min(nearest, distance)
            if idle == _PATIENCE:
                break
        self._there, self._steps = there, (step, step_back)

    def map(self) -> tuple[Array, Array]:
        """Where the middles of the source's cells go, in cells of the target along each axis."""
        to_0, to_1 = mapped(self._there, *self._weights)
        return to_0, to_1

    def _climb(
        self, mine: Array, other: Array, here: Array, there: Array, value: float, step: float
    ) -> tuple[Array, Array, float, float, float]:
        """One step of a potential, then the best of the other for it, and of it for that."""
        missing = here - push(there, *mapped(other, *self._weights))
        amplitudes = dctn(missing, norm="ortho") / self._waves
        amplitudes[0, 0] = 0.0
        direction = idctn(amplitudes, norm="ortho")
        slope = float((direction * missing).sum())
        mine = mine + step * direction
        other = c_transform(mine, *self._weights)
        gain = float((mine * here).sum() + (other * there).sum()) - value
        # Armijo-Goldstein, as in the paper's section 3.3.
        if gain > 0.75 * step * slope:
            step *= 1.4
        elif gain < 0.25 * step * slope:
            step *= 0.7
        mine = c_transform(other, *self._weights)
        value = float((mine * here).sum() + (other * there).sum())
        return mine, other, value, step, math.sqrt(max(slope, 0.0))


def _laplacian(shape: tuple[int, ...], weights: tuple[float, float]) -> Array:
    """Eigenvalues of −∇·(1/w ∇) for cosine waves; the constant's is set to 1."""
    along_0, along_1 = (
        (2 - 2 * np.cos(np.pi * np.arange(m) / m)) / w for m, w in zip(shape, weights, strict=True)
    )
    waves: Array = along_0[:, None] + along_1[None, :]
    waves[0, 0] = 1.0
    return waves
