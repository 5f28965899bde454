"""Control point freedom: keeps every control height in its range, whatever the optimiser does."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import Array, Mask
from workbench.design.limits import HeightLimits
from workbench.geometry.surface import ControlNet
from workbench.scene import Element

_AT_END = 2.0  # parameters beyond it move heights by less than a tenth of what they do at 0


@dataclass(frozen=True)
class HeightRange:
    """Open interval of each control height of a face, entered through tanh.

    De Koning et al. (2023), eqs. 10 and 28. By the convex-hull property the whole face then keeps
    within the limits, and both faces apart by the minimal thickness, at every iteration.
    """

    # (n_u, n_v), ends of the interval, scene units.
    lower: Tensor
    upper: Tensor
    # (n_u, n_v), parameters of the undesigned lens: base plus the middle of the height range.
    rest: Tensor
    kept: Tensor | None = None  # (n_u, n_v), heights that no parameter changes; NaN where one does
    face: str = "lens.back"  # name of the face

    @classmethod
    def of(
        cls, optic: Element, net: ControlNet, device: torch.device | str = "cpu"
    ) -> "HeightRange":
        """The range that an optic allows on a control net of its shaped face; see `within`."""
        return cls.within(HeightLimits.of(optic, net), device, optic.designed_face)

    @classmethod
    def within(
        cls, limits: HeightLimits, device: torch.device | str = "cpu", face: str = "lens.back"
    ) -> "HeightRange":
        """The range between the limits of a face.

        Raises `ValueError` if the lens leaves its range to the run; see `workbench.design.room`.
        """
        if not np.isfinite(limits.upper).all():
            raise ValueError("the lens has neither a height range nor a maximal thickness")
        ends = limits.lower, limits.upper
        parts = (*ends, _inside(limits.undesigned, *ends))
        lower, upper, rest = (torch.as_tensor(part, device=device) for part in parts)
        return cls(lower, upper, rest, face=face)

    def keeping(self, locked: Mask | None, start: Array | None) -> "HeightRange":
        """The same range, but locked control points keep their heights exactly.

        `locked` (n_u, n_v): which; none by default; `start` (n_u, n_v): their heights, in the range
        or not; those of the undesigned lens by default.
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


class FreeHeights:
    """The ranges of all freeform faces of a lens; parameters and heights by the names of faces.

    `ranges`: one for each face, in the order in which light meets them. `ranges`: the same by the
    names of their faces.
    """

    def __init__(self, ranges: Iterable[HeightRange]) -> None:
        self.ranges = {each.face: each for each in ranges}

    @property
    def rest(self) -> dict[str, Tensor]:
        """Parameters of the undesigned lens."""
        return {face: each.rest for face, each in self.ranges.items()}

    @property
    def apart(self) -> dict[str, Tensor]:
        """The same, but faces that are all at an end of their range are in its middle.

        An entrance face with an automatic range begins at the lower end of it, for instance. There
        the tanh passes next to no gradient.
        """
        return {
            face: torch.where((z.abs() > _AT_END).all(), torch.zeros_like(z), z)
            for face, z in self.rest.items()
        }

    @property
    def widths(self) -> dict[str, float]:
        """How wide the ranges are on average, scene units."""
        return {face: (each.upper - each.lower).mean().item() for face, each in self.ranges.items()}

    def heights(self, parameters: Mapping[str, Tensor]) -> dict[str, Tensor]:
        """Control heights of parameters."""
        return {
            face: height
            for face, each in self.ranges.items()
            for height in each.heights(parameters[face]).values()
        }

    def parameters(self, heights: Mapping[str, Array]) -> dict[str, Tensor]:
        """Parameters of control heights; see `HeightRange.parameters`."""
        return {face: each.parameters(heights[face]) for face, each in self.ranges.items()}


def _inside(heights: Array, lower: Array, upper: Array) -> Array:
    # At the very ends the parameter would be infinite and its gradient 0 for ever.
    y = np.clip(2 * (heights - lower) / (upper - lower) - 1, -0.999, 0.999)
    return np.arctanh(y)
