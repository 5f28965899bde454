"""Optimal transport of one image to another: the back-and-forth method.

Jacobs and Léger (2020), A fast approach to optimal transport: the back-and-forth method. The dual
problem is climbed in turns with respect to each of its two potentials, in the H¹ norm; between
the turns a c-transform makes the one potential the best for the other.
"""

import math

import numpy as np
from scipy.fft import dctn, idctn

from workbench.arrays import Array
from workbench.design.transport.envelope import c_transform
from workbench.design.transport.halves import doubled, halved
from workbench.design.transport.push import mapped, push
from workbench.optics.kernels import threads
from workbench.progress import check_given_up

# Light and target are first carried on grids of half as many cells along each axis, down to this.
_COARSEST = 64
# A few rounds bring most pairs of images as near as a grid allows; one bright pixel takes more.
MOST_ROUNDS = 60
# It is enough when light and target are this near to each other, in cells: a root mean square over
# both directions. What a further round brings nearer then is the rounding of maps to cells.
_NEAR = 0.25
# It is enough as well when so many rounds bring the images nearer by less than this part: on the
# coarsest grid, where rounds cost little, and on finer ones.
_PATIENCE, _COARSE_PROGRESS, _FINE_PROGRESS = 3, 0.03, 0.1


class Transport:
    """The map that carries one image to another with the least Σ w |x − y|².

    It is found on a coarse grid first; each finer one takes its potential and step lengths over.

    `source`, `target` (m_0, m_1): mass of the cells of equal grids with spacing 1; each sums to 1;
    `weights`: w along the two axes; `rounds`: at most so many on the grid itself; see `improve`.
    """

    def __init__(
        self,
        source: Array,
        target: Array,
        weights: tuple[float, float],
        rounds: int = MOST_ROUNDS,
    ) -> None:
        self._target, self._weights = target, weights
        self._waves = _laplacian(source.shape, weights)
        # Each potential has a step of its own: that of a dim wide image may be a thousand times
        # that of a few bright pixels.
        if all(m % 2 == 0 and m >= 2 * _COARSEST for m in source.shape):
            self._progress = _FINE_PROGRESS
            coarse = Transport(halved(source), halved(target), weights)
            # The potential whose map goes to the target, in cells squared. A finer one has four
            # times the numbers; steps a bit more, to smooth it soon.
            self._there: Array = 4 * doubled(coarse._there)
            self._steps: tuple[float, float] = 6 * coarse._steps[0], 6 * coarse._steps[1]
        else:
            self._progress = _COARSE_PROGRESS
            self._there = np.zeros_like(source)
            self._steps = (4 / max(source.max(), target.max()),) * 2
        self.improve(source, rounds)

    def improve(self, source: Array, rounds: int = MOST_ROUNDS) -> None:
        """Go on for a source that has changed a little, for so many rounds or fewer."""
        target, weights = self._target, self._weights
        there, back = self._there, c_transform(self._there, *weights)
        value = _product(there, source) + _product(back, target)
        step, step_back = self._steps
        nearest, idle = math.inf, 0
        best = there
        for _ in range(rounds):
            check_given_up()
            before = step, step_back
            there, back, value, step, far = self._climb(there, back, source, target, value, step)
            back, there, value, step_back, far_back = self._climb(
                back, there, target, source, value, step_back
            )
            grows = step > before[0] or step_back > before[1]
            distance = far + far_back
            nearer = distance < (1 - self._progress) * nearest
            idle = 0 if nearer or grows else idle + 1
            if distance < nearest:
                nearest, best = distance, there  # steps may be too long for a while
            if idle == _PATIENCE or distance * math.sqrt(source.size) < _NEAR:
                step, step_back = before  # shorter ones are for what this grid cannot show
                break
        self._there, self._steps = best, (step, step_back)

    def map(self) -> tuple[Array, Array]:
        """Where the middles of the source's cells go, in cells of the target along each axis."""
        to_0, to_1 = mapped(self._there, *self._weights)
        return to_0, to_1

    def back(self) -> tuple[Array, Array]:
        """Where the middles of the target's cells come from, in cells of the source."""
        from_0, from_1 = mapped(c_transform(self._there, *self._weights), *self._weights)
        return from_0, from_1

    def _climb(
        self, mine: Array, other: Array, here: Array, there: Array, value: float, step: float
    ) -> tuple[Array, Array, float, float, float]:
        """One step of a potential, then the best of the other for it, and of it for that."""
        missing = here - push(there, *mapped(other, *self._weights))
        workers = threads.workers(missing.size)
        amplitudes = dctn(missing, norm="ortho", workers=workers) / self._waves
        amplitudes[0, 0] = 0.0
        direction = idctn(amplitudes, norm="ortho", workers=workers, overwrite_x=True)
        slope = _product(direction, missing)
        mine = mine + step * direction
        other = c_transform(mine, *self._weights)
        gain = _product(mine, here) + _product(other, there) - value
        # Armijo-Goldstein, as in the paper's section 3.3.
        if gain > 0.75 * step * slope:
            step *= 1.4
        elif gain < 0.25 * step * slope:
            step *= 0.7
        mine = c_transform(other, *self._weights)
        value = _product(mine, here) + _product(other, there)
        return mine, other, value, step, math.sqrt(max(slope, 0.0))


def _product(values: Array, others: Array) -> float:
    """Sum of the products of two images, without an image of these."""
    return float(np.vdot(values, others))


def _laplacian(shape: tuple[int, ...], weights: tuple[float, float]) -> Array:
    """Eigenvalues of −∇·(1/w ∇) for cosine waves; the constant's is set to 1."""
    along_0, along_1 = (
        (2 - 2 * np.cos(np.pi * np.arange(m) / m)) / w for m, w in zip(shape, weights, strict=True)
    )
    waves: Array = along_0[:, None] + along_1[None, :]
    waves[0, 0] = 1.0
    return waves
