"""What a reconstruction filter does, on average, to light that is even within each pixel."""

import numpy as np
import numpy.typing as npt
from scipy.ndimage import convolve1d

from workbench.scene import Filter

Array = npt.NDArray[np.float64]


def expected_image(image: Array, filter: Filter) -> Array:
    """Image that rays drawn from ``image`` give after reconstruction, without their noise.

    A target sent through this can be compared with a reconstructed image without bias: the
    unfiltered one asks the lens to undo the filter's blur.

    Parameters
    ----------
    image : ndarray, shape (n_y, n_x)
        Flux in each pixel.
    filter : BoxFilter or GaussianFilter
        The reconstruction filter.
    """
    for axis, size in zip((1, 0), filter.size, strict=True):
        image = convolve1d(image, _mean_taps(filter.alpha, size), axis=axis, mode="constant")
    return np.asarray(image)


def _mean_taps(alpha: float, size: int) -> Array:
    """Normalised filter weights, averaged over where in its pixel a ray lands."""
    nodes, weights = np.polynomial.legendre.leggauss(64)
    distance = nodes[:, None] / 2 - np.arange(-(size // 2), size // 2 + 1)
    # Scaled as in `irradiance._taps`, against underflow.
    scale = np.exp(-alpha * (np.square(distance) - np.square(nodes[:, None] / 2)))
    taps = -scale * np.expm1(alpha * (np.square(distance) - (size / 2) ** 2))
    if size == 1:
        return np.ones(1)
    return np.asarray(weights @ (taps / taps.sum(axis=1, keepdims=True)) / 2)
