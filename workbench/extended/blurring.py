"""Light to its blurred image and back, by Fourier transforms."""

import numpy as np
import numpy.typing as npt
from scipy import fft

from workbench.arrays import AnyArray, Array


class Blurring:
    """Blurs light at a few places in each pixel.

    Light lies on a grid whose opposite ends meet. It is as large as the image with twice the blur's
    margin on each side, so that light beside the image does not come in from the other end.

    Parameters
    ----------
    kernels : ndarray, shape (places, 2 m_y + 1, 2 m_x + 1)
        The blur of light at each of the places; see `Blur.kernels`.
    shape : tuple[int, int]
        (n_y, n_x) of the image.

    Attributes
    ----------
    grid : tuple[int, int]
        Shape of the grid.
    places : tuple of two slice
        Where on the grid light may reach the image: shape (n_y + 2 m_y, n_x + 2 m_x).
    seen : tuple of two slice
        Where on the grid the image is: shape (n_y, n_x).
    kernels : ndarray, complex, shape (places, ...)
        The blur of each frequency.
    """

    def __init__(self, kernels: Array, shape: tuple[int, int]) -> None:
        margins = m_y, m_x = kernels.shape[1] // 2, kernels.shape[2] // 2
        n_y, n_x = shape
        g_y, g_x = (
            fft.next_fast_len(n + 4 * m, real=True) for n, m in zip(shape, margins, strict=True)
        )
        self.grid = g_y, g_x
        self.places = slice(0, n_y + 2 * m_y), slice(0, n_x + 2 * m_x)
        self.seen = slice(2 * m_y, 2 * m_y + n_y), slice(2 * m_x, 2 * m_x + n_x)
        self.kernels = self.waves(kernels)

    def waves(self, images: AnyArray) -> npt.NDArray[np.complexfloating]:
        """Frequencies of images on the grid; smaller ones are padded."""
        return np.asarray(fft.rfft2(images, self.grid, workers=-1))

    def images(self, waves: npt.NDArray[np.complexfloating]) -> Array:
        """Images on the grid of their frequencies."""
        return np.asarray(fft.irfft2(waves, self.grid, workers=-1, overwrite_x=True))

    def on_grid(self, image: AnyArray) -> AnyArray:
        """An image in its place on the grid, dark around it."""
        wide = np.zeros(self.grid, image.dtype)
        wide[self.seen] = image
        return wide

    def image(self, light: Array) -> Array:
        """What light on the grid, shape (places, *grid), makes of the image."""
        return self.images((self.waves(light) * self.kernels).sum(axis=0))[self.seen]

    def back(self, image: Array) -> Array:
        """Mean of an image over the blur about each place, without the sum: shape (places, *grid).

        The adjoint of `image`.
        """
        return self.back_from(self.waves(self.on_grid(image)))

    def back_from(self, waves: npt.NDArray[np.complexfloating]) -> Array:
        """`back` of the image on the grid that has these frequencies."""
        return self.images(waves * self.kernels.conj())
