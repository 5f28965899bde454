"""Changes of a control net as cosine waves, scaled so that a descent finds the long ones easy.

Irradiance answers to the second derivatives of the face. Short waves of the same height change it
far more than long ones, and a descent that treats all heights alike spends its steps on them. A
wave is made small in proportion to a power of its periods per lens. Errors as the run sees them of
256 × 256 pixels after 2 s (top hat) and 4 s (all others) of evaluations on one core:

| power | top hat | ball | flame | letter |
|---|---|---|---|---|
| 1, of waves with more than 4 periods | 0.43 % | 0.51 % | 1.57 % | 1.07 % |
| 1.25, of waves with more than 4 periods | 0.40 % | 0.49 % | 1.56 % | 1.07 % |
| 1.25, of waves with more than 2 periods | 0.37 % | 0.47 % | 1.54 % | 1.07 % |
| 1.5, of waves with more than 4 periods | 0.38 % | 0.49 % | 1.69 % | 1.10 % |
| 1.1 | 0.38 % | 0.48 % | 1.52 % | – |
| 1.25 | 0.36 % | 0.46 % | 1.55 % | – |

Where the size of the source blurs the image, waves that are shorter than about two widths of the
blur are damped as they come to the image: the shorter, the more. They are what is left to gain, and
all of them are of one size. Errors as the run sees them of 256 × 256 pixels in the sun, which blurs
them over 5.9 pixels, after 30 steps:

| waves | photograph | ball | letter |
|---|---|---|---|
| power 1, all waves | 2.05 % | 3.11 % | 5.56 % |
| power 1.25, short ones of one size | 1.82 % | 3.06 % | 5.52 % |
| power 1.25, short ones larger as the root of their number | 1.81 % | – | 5.54 % |
"""

import math
from collections.abc import Mapping, Sequence

import numpy as np
import torch
from scipy.fft import dctn, idctn
from torch import Tensor

# A blur damps waves of which it is wider than this part of a period: what is left of a wave through
# a disc is 2 J₁(πf) / (πf), which falls as 2 √(2/π) (πf)^-1.5 from here on.
_DAMPED = 0.435


class Waves:
    """Cosine waves over a control net.

    `shape`: (n_u, n_v) of the net; `power`: waves are made small in proportion to this power of
    their periods per lens; `mirrored`: whether to leave out all waves that are not mirror images of
    themselves in u, in v; `blur_widths`: full widths of a blur of what the waves make along u and
    v, parts of the lens: the waves that it damps are all of one size; `longest`: part of the waves
    along each axis, the longest ones, that are left.
    """

    def __init__(
        self,
        shape: Sequence[int],
        power: float,
        mirrored: tuple[bool, bool],
        blur_widths: tuple[float, float] = (0.0, 0.0),
        longest: float = 1.0,
    ) -> None:
        self.shape = tuple(shape)
        (along_u, along_v), (b_u, b_v) = (np.arange(count) / 2 for count in shape), blur_widths
        periods = 1 + along_u[:, None] ** 2 + along_v**2
        damped = 1 + ((b_u * along_u[:, None]) ** 2 + (b_v * along_v) ** 2) / _DAMPED**2
        self._squares = (periods / damped) ** -power  # of sizes
        for axis, count in enumerate(shape):
            np.moveaxis(self._squares, axis, 0)[math.ceil(longest * count) :] = 0.0
        if mirrored[0]:
            self._squares[1::2] = 0.0
        if mirrored[1]:
            self._squares[:, 1::2] = 0.0

    def eased(self, gradient: Tensor) -> Tensor:
        """What a descent along the amplitudes of waves changes the net by.

        `gradient` (n_u, n_v): gradient with respect to the net.
        """
        amplitudes = self._squares * dctn(gradient.cpu().numpy(), norm="ortho")
        return torch.as_tensor(idctn(amplitudes, norm="ortho")).to(gradient)


class FaceWaves:
    """Waves over the nets of several faces, whose values lie one after the other.

    `like` (n_u, n_v): A net of each face; `power`, `mirrored`, `blur_widths`, `longest`: see
    `Waves`; `widths`: by how much about heights change with a parameter of each face. A wave of any
    face then changes heights by as much: light does not mind how wide the range of a face is.
    """

    def __init__(
        self,
        like: Mapping[str, Tensor],
        power: float,
        mirrored: tuple[bool, bool],
        widths: Mapping[str, float],
        blur_widths: tuple[float, float] = (0.0, 0.0),
        longest: float = 1.0,
    ) -> None:
        self._waves = {
            face: Waves(each.shape, power, mirrored, blur_widths, longest)
            for face, each in like.items()
        }
        widest = max(widths.values())
        self._factors = {face: widest / widths[face] for face in like}

    def values(self, nets: Mapping[str, Tensor]) -> Tensor:
        """The values of the net of each face one after the other, shape (points,)."""
        return torch.cat([nets[face].flatten() for face in self._waves])

    def nets(self, values: Tensor) -> dict[str, Tensor]:
        """The net of each face, shape (n_u, n_v), of all values: the inverse of `values`."""
        shapes = [each.shape for each in self._waves.values()]
        parts = torch.split(values, [math.prod(shape) for shape in shapes])
        views = (part.view(shape) for part, shape in zip(parts, shapes, strict=True))
        return dict(zip(self._waves, views, strict=True))

    def eased(self, gradient: Tensor) -> Tensor:
        """See `Waves`; shape (points,) for all faces."""
        nets = self.nets(gradient)
        return self.values(
            {
                face: self._factors[face] ** 2 * each.eased(nets[face])
                for face, each in self._waves.items()
            }
        )
