"""Control point freedom: keeps every control height in its range, whatever the optimiser does."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt
import torch
from torch import Tensor

from workbench.design.limits import HeightLimits
from workbench.geometry.surface import ControlNet
from workbench.scene import Optic

Array = npt.NDArray[np.float64]
Mask = npt.NDArray[np.bool_]


@dataclass(frozen=True)
class HeightRange:
    """Open interval of each control height of a face, entered through tanh.

    De Koning et al. (2023), eqs. 10 and 28. By the convex-hull property the whole exit face then
    clears the entrance face by the minimal thickness, at every iteration.

    Attributes
    ----------
    lower, upper : Tensor, shape (n_u, n_v), float64
        Ends of the interval, scene units.
    rest : Tensor, shape (n_u, n_v), float64
        Parameters of the undesigned lens: base plus the middle of the height range.
    kept : Tensor, shape (n_u, n_v), float64, optional
        Heights that no parameter changes; NaN where one does.
    face : str
        Name of the face.
    """

    lower: Tensor
    upper: Tensor
    rest: Tensor
    kept: Tensor | None = None
    face: str = "exit"

    @classmethod
    def of(cls, optic: Optic, net: ControlNet, device: torch.device | str = "cpu") -> "HeightRange":
        """The range that a lens allows on a control net.

        Raises
        ------
        ValueError
            If the lens leaves its range to the run; see `workbench.design.room`.
        """
        limits = HeightLimits.of(optic, net)
        if not np.isfinite(limits.upper).all():
            raise ValueError("the lens has neither a height range nor a maximal thickness")
        ends = limits.lower, limits.upper
        parts = (*ends, _inside(limits.undesigned, *ends))
        lower, upper, rest = (torch.as_tensor(part, device=device) for part in parts)
        return cls(lower, upper, rest, face=optic.face)

    def keeping(self, locked: Mask | None, start: Array | None) -> "HeightRange":
        """The same range, but locked control points keep their heights exactly.

        Parameters
        ----------
        locked : ndarray of bool, shape (n_u, n_v), optional
            Which; none by default.
        start : ndarray, shape (n_u, n_v), optional
            Their heights, in the range or not; those of the undesigned lens by default.
        """
        if locked is None:
            return self
        heights = self._heights(self.rest).cpu().numpy() if start is None else start
        kept = torch.as_tensor(np.where(locked, heights, np.nan), device=self.lower.device)
        return replace(self, kept=kept)

    def heights(self, parameters: Tensor) -> Mapping[str, Tensor]:
        """Control heights (n_u, n_v) of parameters, by the name of the face."""
        return {self.face: self._heights(parameters)}

    def _heights(self, parameters: Tensor) -> Tensor:
        free = self.lower + (self.upper - self.lower) * (0.5 * torch.tanh(parameters) + 0.5)
        return free if self.kept is None else torch.where(self.kept.isnan(), free, self.kept)

    def parameters(self, heights: Array) -> Tensor:
        """Parameters of control heights; heights at or beyond an end go just inside it."""
        lower, upper = self.lower.cpu().numpy(), self.upper.cpu().numpy()
        return torch.as_tensor(_inside(heights, lower, upper), device=self.lower.device)


def _inside(heights: Array, lower: Array, upper: Array) -> Array:
    # At the very ends the parameter would be infinite and its gradient 0 for ever.
    y = np.clip(2 * (heights - lower) / (upper - lower) - 1, -0.999, 0.999)
    return np.arctanh(y)
