"""Light in parts of pixels to its blurred image, by Fourier transforms, and back for gradients."""

import math
from typing import Any

import torch
from scipy.fft import next_fast_len
from torch import Tensor
from torch.autograd.function import once_differentiable

from workbench.arrays import Array
from workbench.optics.account import Account
from workbench.optics.light import Light


class LightBlurring:
    """Blurs light that lies in parts of pixels, and adds changes of the blur.

    Its own adjoint takes real transforms, where torch's of a real transform is a complex one.

    `kernels` (parts parts, 2 m_y + 1, 2 m_x + 1): blurs about the middles of the parts of a pixel,
    row by row; `changes` (k, parts parts, 2 m_y + 1, 2 m_x + 1): their changes; `factors` (k, n_y,
    n_x): what light in each pixel is multiplied by before it is blurred by a change.
    """

    def __init__(self, kernels: Tensor, changes: Tensor, factors: Tensor) -> None:
        n_y, n_x = self._shape = factors.shape[1], factors.shape[2]
        m_y, m_x = self._margin = kernels.shape[1] // 2, kernels.shape[2] // 2
        self._grid = next_fast_len(n_y + 2 * m_y), next_fast_len(n_x + 2 * m_x)
        self._kernels, self._factors = self._waves(_by_parts(kernels)), factors
        self._changes = [self._waves(_by_parts(each)) for each in changes]

    @classmethod
    def of(
        cls, kernels: Array, changes: Array, factors: Array, device: torch.device
    ) -> "LightBlurring":
        """Return the blurring by arrays, in float32 on a device."""
        parts = kernels, changes, factors
        return cls(*(torch.as_tensor(part, dtype=torch.float32, device=device) for part in parts))

    def light(
        self, light: Light, pixels: tuple[int, int], margin: tuple[int, int], parts: int = 1
    ) -> Light:
        """Light of a receiver and some pixels beyond, blurred, and its account.

        ``parts`` of a pixel along each axis have their own blurred light, which is added up.
        """
        (n_x, n_y), (m_x, m_y), account = pixels, margin, light.account
        # Not negative but for rounding, and at the rims of spots that are narrower than the mean.
        image = self.image(light.flux.float()).clamp_min(0)
        if parts > 1:
            rows, columns = n_y + 2 * m_y, n_x + 2 * m_x
            image = image.view(rows, parts, columns, parts).sum((1, 3))
        seen = image.detach()[m_y : m_y + n_y, m_x : m_x + n_x]
        on_screen = seen.sum(dtype=torch.float64).item()
        lost = {**account.lost, "off_screen": account.arrived - on_screen}
        return Light(image, Account(on_screen, lost))

    def image(self, light: Tensor) -> Tensor:
        """The image (n_y, n_x) of light in parts (parts n_y, parts n_x); differentiable."""
        image: Tensor = _Blurred.apply(self, light)  # type: ignore[no-untyped-call]
        return image

    def forward(self, light: Tensor) -> Tensor:
        """See `image`."""
        (n_y, n_x), (m_y, m_x) = self._shape, self._margin
        # One image for each place in a pixel: [parts, parts, n_y, n_x].
        places = light.view(n_y, len(light) // n_y, n_x, -1).permute(1, 3, 0, 2)
        waves = (self._waves(places) * self._kernels).sum((0, 1))
        for kernels, factor in zip(self._changes, self._factors, strict=True):
            waves += (self._waves(places * factor) * kernels).sum((0, 1))
        image: Tensor = torch.fft.irfft2(waves, s=self._grid)
        return image[m_y : m_y + n_y, m_x : m_x + n_x]

    def backward(self, cotangent: Tensor) -> Tensor:
        """Cotangent of the light from that of the image."""
        (n_y, n_x), (m_y, m_x) = self._shape, self._margin
        wide = cotangent.new_zeros(self._grid)
        wide[m_y : m_y + n_y, m_x : m_x + n_x] = cotangent
        waves = torch.fft.rfft2(wide)
        places = self._means(waves, self._kernels)
        for kernels, factor in zip(self._changes, self._factors, strict=True):
            places = places + self._means(waves, kernels) * factor
        rows, columns, *_ = places.shape
        return places.permute(2, 0, 3, 1).reshape(rows * n_y, columns * n_x)

    def _waves(self, images: Tensor) -> Tensor:
        waves: Tensor = torch.fft.rfft2(images, s=self._grid)
        return waves

    def _means(self, waves: Tensor, kernels: Tensor) -> Tensor:
        """Means over blurs about each place, without the sum: adjoint to blurring."""
        n_y, n_x = self._shape
        means: Tensor = torch.fft.irfft2(waves * kernels.conj(), s=self._grid)
        return means[..., :n_y, :n_x]


class _Blurred(torch.autograd.Function):
    """`LightBlurring` as a step that torch differentiates."""

    @staticmethod
    def forward(ctx: Any, blurring: LightBlurring, light: Tensor) -> Tensor:
        ctx.blurring = blurring
        return blurring.forward(light)

    @staticmethod
    @once_differentiable
    def backward(ctx: Any, cotangent: Tensor) -> tuple[None, Tensor]:
        return None, ctx.blurring.backward(cotangent)


def _by_parts(kernels: Tensor) -> Tensor:
    """Kernels by rows and columns of the parts of a pixel, shape (parts, parts, ...)."""
    parts = math.isqrt(len(kernels))
    return kernels.reshape(parts, parts, *kernels.shape[1:])
