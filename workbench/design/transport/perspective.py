"""The light of an image in the cells of a plane on which it is seen in perspective."""

import numpy as np

from workbench.arrays import Array
from workbench.compiled import jit
from workbench.optics.kernels import threads


def in_perspective(image: Array, onto: Array, cells: int, samples: int) -> Array:
    """The light in each cell.

    Parameters
    ----------
    image : ndarray, shape (n_0, n_1)
        The light of each pixel; beside them is none.
    onto : ndarray, shape (3, 3)
        Takes (x, y, 1) of a place, in cells from the rim of the first one, to a multiple of
        (a, b, 1) of the same in pixels.
    cells : int
        Along each axis.
    samples : int
        Along each axis of a cell; they find its light.

    Returns
    -------
    ndarray, shape (cells, cells)
    """
    light = np.empty((cells, cells))
    image, onto = (np.ascontiguousarray(each, np.float64) for each in (image, onto))
    area = abs(float(np.linalg.det(onto))) / samples**2

    def work(begin: int, end: int) -> None:
        _in_perspective(image, onto, area, samples, begin, end, light)

    threads.run_lines(work, cells, cells**2 * samples**2)
    return light


@jit(allocates=False)
def _in_perspective(image, onto, area, samples, begin, end, light):  # type: ignore[no-untyped-def]
    """The lines of cells from number ``begin`` to ``end``; see `in_perspective`."""
    n_0, n_1 = image.shape
    for k in range(begin, end):
        for n in range(light.shape[1]):
            light[k, n] = 0.0
            for i in range(samples):
                x = k + (i + 0.5) / samples
                for j in range(samples):
                    y = n + (j + 0.5) / samples
                    far = onto[2, 0] * x + onto[2, 1] * y + onto[2, 2]
                    a = (onto[0, 0] * x + onto[0, 1] * y + onto[0, 2]) / far
                    b = (onto[1, 0] * x + onto[1, 1] * y + onto[1, 2]) / far
                    if 0 <= a < n_0 and 0 <= b < n_1:
                        light[k, n] += image[int(a), int(b)] * area / abs(far) ** 3
