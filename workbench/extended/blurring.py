"""Blurring of light and its adjoint, by Fourier transforms."""

import numpy as np
import numpy.typing as npt
from scipy import fft

from workbench.arrays import AnyArray, Array


class Blurring:
    """Blurs light at some positions in a pixel, by kernels (positions, 2 m_y + 1, 2 m_x + 1).

    Light lies on a periodic grid: the image (n_y, n_x) with twice the blur's margin on each side,
    so that light beside the image does not wrap around.

    `grid`: shape of the grid; `places`: part of the grid whose light may reach the image: (n_y + 2
    m_y, n_x + 2 m_x); `seen`: the image on the grid: (n_y, n_x); `kernels` (positions, ...): the
    blur of each frequency.
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
        """Fourier transforms of images on the grid; smaller ones are padded."""
        return np.asarray(fft.rfft2(images, self.grid, workers=-1))

    def images(self, waves: npt.NDArray[np.complexfloating]) -> Array:
        """Images on the grid of their Fourier transforms."""
        return np.asarray(fft.irfft2(waves, self.grid, workers=-1, overwrite_x=True))

    def on_grid(self, image: AnyArray) -> AnyArray:
        """An image at its position on the grid, dark around it."""
        wide = np.zeros(self.grid, image.dtype)
        wide[self.seen] = image
        return wide

    def image(self, light: Array) -> Array:
        """The image of light on the grid, (positions, *grid)."""
        return self.images((self.waves(light) * self.kernels).sum(axis=0))[self.seen]

    def back(self, image: Array) -> Array:
        """Mean of an image over the blur about each position, (positions, *grid).

        The adjoint of `image`.
        """
        return self.back_from(self.waves(self.on_grid(image)))

    def back_from(self, waves: npt.NDArray[np.complexfloating]) -> Array:
        """`back` of the image on the grid with this Fourier transform."""
        return self.images(waves * self.kernels.conj())
