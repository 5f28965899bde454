"""What becomes of light in parts of pixels: kernels, their change over an image, convolutions.

A source is a set of points or directions (`workbench.optics.sources`). Where all places of a lens
make the same of it, light of its middle alone is traced, and `ImageBlur` is what remains of its
size. A diffuser is an `ImageBlur` too.
"""

import math
from dataclasses import dataclass, replace
from typing import Self

import numpy as np
import numpy.typing as npt
import scipy

from workbench.arrays import AnyArray, Array
from workbench.messages import Message


@dataclass(frozen=True, eq=False)
class ImageBlur:
    """A blur of an image: a mean kernel, and changes of it with the place on the image."""

    # (1 + k, parts parts, 2 m_y + 1, 2 m_x + 1), the mean and its changes, by pixels: what becomes
    # of the light in each part of a pixel, row by row. Light that goes farther is missing.
    kernels: Array
    factors: Array  # (k, degree + 1, degree + 1), of the changes, by powers of y and of x
    # Pixels from the middle of the image where x and y are 1; beyond, it stays. Rows go down.
    half_extent: tuple[float, float]
    widths: tuple[float, float]  # full widths along x and y of a disc that blurs as much, pixels
    note: Message

    @property
    def parts(self) -> int:
        """Parts of a pixel along each axis."""
        return math.isqrt(self.kernels.shape[1])

    @property
    def of_pixels(self) -> Array:
        """The mean kernel of light that is uniform in a pixel."""
        return np.asarray(self.kernels[0].mean(axis=0))

    @property
    def of_rays(self) -> Self:
        """The same for rays that quadratic B-splines spread over parts of pixels.

        Kernels are interpolated by where light is: the spread does not blur the image further.
        """
        from scipy.ndimage import spline_filter1d  # late: it takes a tenth of a second to import

        count, parts = len(self.kernels), self.parts
        wide = np.pad(self.kernels, ((0, 0), (0, 0), (1, 1), (1, 1)))[..., ::-1, ::-1]
        rows, columns = wide.shape[2:]
        by_place = wide.reshape(count, parts, parts, rows, columns).transpose(0, 3, 1, 4, 2)
        found = by_place.reshape(count, rows * parts, columns * parts)
        for axis in (1, 2):
            found = spline_filter1d(found, 2, axis)
        by_place = found.reshape(by_place.shape).transpose(0, 2, 4, 1, 3)
        kernels = np.ascontiguousarray(by_place.reshape(wide.shape)[..., ::-1, ::-1])
        return replace(self, kernels=kernels)

    def factors_at(self, pixels: tuple[int, int], margin: tuple[int, int]) -> Array:
        """Factors (k, n_y + 2 m_y, n_x + 2 m_x) of the changes in the middles of pixels.

        `pixels`, `margin`: pixels of the image along x and y, and beyond it on each side.
        """
        x, y = (
            ((np.arange(n + 2 * m) - (n + 2 * m - 1) / 2) / far).clip(-1, 1)
            for n, m, far in zip(pixels, margin, self.half_extent, strict=True)
        )
        by_powers = np.moveaxis(self.factors, 0, -1)
        return np.asarray(np.polynomial.polynomial.polygrid2d(y, x, by_powers))


def convolved(image: Array, kernel: Array) -> Array:
    """All of an image convolved with a kernel, larger than the image by the kernel less a pixel.

    As `scipy.signal.fftconvolve`, which takes most of a second to import.
    """
    n_y, n_x = np.add(image.shape, kernel.shape) - 1
    size = scipy.fft.next_fast_len(n_y, real=True), scipy.fft.next_fast_len(n_x, real=True)
    waves = scipy.fft.rfft2(image, size) * scipy.fft.rfft2(kernel, size)
    return np.asarray(scipy.fft.irfft2(waves, size)[:n_y, :n_x])


def convolved_in_place(image: Array, kernel: Array) -> Array:
    """An image convolved with a kernel, on the pixels of the image."""
    top, left = ((n - 1) // 2 for n in kernel.shape)
    return convolved(image, kernel)[top:, left:][: image.shape[0], : image.shape[1]]


def powers(x: Array, y: Array, degree: int) -> Array:
    """Products (n, (degree + 1)²) of powers of y and x (n,), as `ImageBlur.factors` has them."""
    return np.asarray(np.polynomial.polynomial.polyvander2d(y, x, [degree, degree]), np.float64)


def near(kernels: Array, shape: tuple[int, ...]) -> Array:
    """Kernels (..., rows, columns) as far as half an image of a shape, with all of their light."""
    middles = [size // 2 for size in kernels.shape[-2:]]
    reach = [min(m, n // 2) for m, n in zip(middles, shape, strict=True)]
    rows, columns = (slice(m - k, m + k + 1) for m, k in zip(middles, reach, strict=True))
    found = kernels[..., rows, columns]
    return np.asarray(found / found.sum(axis=(-2, -1), keepdims=True))


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
            scipy.fft.next_fast_len(n + 4 * m, real=True)
            for n, m in zip(shape, margins, strict=True)
        )
        self.grid = g_y, g_x
        self.places = slice(0, n_y + 2 * m_y), slice(0, n_x + 2 * m_x)
        self.seen = slice(2 * m_y, 2 * m_y + n_y), slice(2 * m_x, 2 * m_x + n_x)
        self.kernels = self.waves(kernels)

    def waves(self, images: AnyArray) -> npt.NDArray[np.complexfloating]:
        """Fourier transforms of images on the grid; smaller ones are padded."""
        return np.asarray(scipy.fft.rfft2(images, self.grid, workers=-1))

    def images(self, waves: npt.NDArray[np.complexfloating]) -> Array:
        """Images on the grid of their Fourier transforms."""
        return np.asarray(scipy.fft.irfft2(waves, self.grid, workers=-1, overwrite_x=True))

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
