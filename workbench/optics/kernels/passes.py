"""A tensor grid of rays traced by threads, and what mirror symmetry makes of it."""

from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import Any

import numpy as np

from workbench.arrays import AnyArray
from workbench.optics.kernels import threads
from workbench.optics.kernels.function import Sums
from workbench.optics.kernels.grid import Axis
from workbench.optics.kernels.rows import Loops
from workbench.optics.kernels.spread import Spread, add_up, make_canvases, pad


class GridLanding:
    """The trace of a grid to where its rays land; `workbench.optics.kernels.function.Passes`."""

    def __init__(self, grid: "GridPasses") -> None:
        self.forward, self.backward = grid.land, grid.land_back


class GridPasses(ABC):
    """The trace of one tensor grid of rays onto one screen, and its adjoint.

    Parameters
    ----------
    loops : Loops
        The kernels.
    bases : tuple of two `Axis`
        Basis functions at the rays, along x and y.
    spread : Spread
        Screen and filter.
    mirrored : tuple of two bool
        Whether the rays are one half of all in x, in y, and the others their mirror images.
    sums : int
        How many sums the kernels give.
    """

    def __init__(
        self,
        loops: Loops,
        bases: tuple[Axis, Axis],
        spread: Spread,
        mirrored: tuple[bool, ...],
        sums: int,
    ) -> None:
        self._loops, self._bases, self._spread = loops, bases, spread
        self._mirrored = [axis for axis in (0, 1) if mirrored[axis]]
        self._sums = sums
        columns, rows = (len(basis.place) for basis in bases)
        self._bounds = threads.split(columns, columns * rows)
        self._parts = len(self._bounds) - 1

    @property
    def copies(self) -> int:
        """How many mirror images of the rays there are, themselves included."""
        return int(2 ** len(self._mirrored))

    @abstractmethod
    def light(self, heights: AnyArray) -> tuple[Any, ...]:
        """What the kernels need to know of the light, for a lens."""

    @abstractmethod
    def account(self, sums: list[float]) -> Sums:
        """What became of the light, from the sums of the kernel for all rays."""

    def forward(self, heights: AnyArray) -> tuple[AnyArray, Sums]:
        """See `workbench.optics.kernels.function.Passes`."""
        canvases = make_canvases(self._spread, self._parts)
        sums = np.zeros((self._parts, self._sums))
        self._run(self._loops.trace, heights, canvases, sums)
        image = add_up(self._spread, canvases)
        for axis in self._mirrored:
            image = image + np.flip(image, 1 - axis)
        account = self.account((self.copies * sums.sum(axis=0)).tolist())
        return np.ascontiguousarray(image), account

    def backward(self, heights: AnyArray, cotangent: AnyArray) -> AnyArray:
        """See `workbench.optics.kernels.function.Passes`."""
        for axis in self._mirrored:
            cotangent = cotangent + np.flip(cotangent, 1 - axis)
        canvas = pad(self._spread, cotangent)
        gradients = np.zeros((self._parts, *heights.shape))
        self._run(self._loops.trace_back, heights, [canvas] * self._parts, gradients)
        return self._of_both_halves(gradients.sum(axis=0))

    def land(self, heights: AnyArray) -> tuple[AnyArray, Sums]:
        """Where the rays land, in place of an image, without mirror images; see `Loops.land`."""
        nodes = np.empty((3, *(len(basis.place) for basis in self._bases[::-1])), heights.dtype)
        sums = np.zeros((self._parts, self._sums))
        self._run(self._loops.land, heights, [nodes] * self._parts, sums)
        return nodes, self.account((self.copies * sums.sum(axis=0)).tolist())

    def land_back(self, heights: AnyArray, cotangent: AnyArray) -> AnyArray:
        """The adjoint of `land`, for a cotangent to which mirror images have been added."""
        gradients = np.zeros((self._parts, *heights.shape))
        self._run(self._loops.land_back, heights, [cotangent] * self._parts, gradients)
        return self._of_both_halves(gradients.sum(axis=0))

    def _of_both_halves(self, gradient: AnyArray) -> AnyArray:
        for axis in self._mirrored:  # the other half would have given the mirror image of this
            gradient = (gradient + np.flip(gradient, axis)) / 2
        return gradient

    def _run(
        self, kernel: Callable[..., None], heights: AnyArray, canvases: Any, results: AnyArray
    ) -> None:
        """Run a kernel on all parts of the rays, each with a canvas and a result of its own."""
        given = heights, self._bases, self.light(heights), self._spread

        def work(part: int) -> None:
            span = self._bounds[part], self._bounds[part + 1]
            kernel(*given, *span, canvases[part], results[part])

        threads.run(work, self._parts)
