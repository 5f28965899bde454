"""Changes of a control net as cosine waves, scaled so that a descent finds the long ones easy.

Irradiance answers to the second derivatives of the face. Short waves of the same height change it
far more than long ones, and a descent that treats all heights alike spends its steps on them.
"""

from collections.abc import Mapping

import numpy as np
import torch
from scipy.fft import dct
from torch import Tensor


class Waves:
    """Cosine waves over a control net.

    Parameters
    ----------
    like : Tensor, shape (n_u, n_v)
        Gives size, float type and device.
    cut : float
        Waves with more periods per lens than this are made small in proportion.
    mirrored : tuple[bool, bool]
        Whether to leave out all waves that are not mirror images of themselves in u, in v.
    """

    def __init__(self, like: Tensor, cut: float, mirrored: tuple[bool, bool]) -> None:
        self._waves, periods = [], []
        for count, even in zip(like.shape, mirrored, strict=True):
            numbers = np.arange(0, count, 2 if even else 1)
            waves = dct(np.eye(count), axis=0, norm="ortho")[numbers]
            self._waves.append(torch.as_tensor(waves).to(like))
            periods.append(torch.as_tensor(numbers / 2).to(like))
        periods2 = periods[0][:, None].square() + periods[1][None, :].square()
        self._size = (1 + periods2 / cut**2).rsqrt()
        self.nothing = torch.zeros_like(self._size).flatten()

    def change(self, amplitudes: Tensor) -> Tensor:
        """Change of the net, shape (n_u, n_v), of amplitudes of shape (waves,)."""
        along_u, along_v = self._waves
        return along_u.T @ (self._size * amplitudes.view_as(self._size)) @ along_v


class FaceWaves:
    """Waves over the nets of several faces, their amplitudes one after the other.

    Parameters
    ----------
    like : mapping of str to Tensor, shape (n_u, n_v)
        Gives size, float type and device for each face.
    cut, mirrored
        See `Waves`.
    widths : mapping of str to float
        By how much about heights change with a parameter of each face. A wave of any face then
        changes heights by as much: light does not mind how wide the range of a face is.

    Attributes
    ----------
    nothing : Tensor, shape (waves,)
        Amplitudes of no change.
    """

    def __init__(
        self,
        like: Mapping[str, Tensor],
        cut: float,
        mirrored: tuple[bool, bool],
        widths: Mapping[str, float],
    ) -> None:
        self._waves = {face: Waves(each, cut, mirrored) for face, each in like.items()}
        widest = max(widths.values())
        self._factors = {face: widest / widths[face] for face in like}
        self.nothing = torch.cat([each.nothing for each in self._waves.values()])

    def change(self, amplitudes: Tensor) -> dict[str, Tensor]:
        """Change of the net of each face, of amplitudes of shape (waves,)."""
        counts = [len(each.nothing) for each in self._waves.values()]
        parts = zip(self._waves.items(), torch.split(amplitudes, counts), strict=True)
        return {face: self._factors[face] * waves.change(part) for (face, waves), part in parts}

    def longest(self, amplitudes: Tensor) -> float:
        """The most by which amplitudes change anything."""
        return max(change.abs().max().item() for change in self.change(amplitudes).values())
