"""Light of a point behind a flat face, at places in the glass.

A ray from a point at the distance d before the face crosses the face at the radius ρ_e from the
point's axis. Its slope behind the face is ρ_e g with

    g(ρ_e) = (n² d² + (n² − 1) ρ_e²)^(−½).

The ray through the radius ρ at the depth t behind the face solves

    ρ_e + t ρ_e g(ρ_e) = ρ.

The left side rises and is concave, so Newton's method from below never fails. The flux per area
of the plane at that depth is e(ρ_e) (ρ_e / ρ) dρ_e/dρ, where e is the flux per area right behind
the face. The code uses r = ρ_e / ρ, which has a limit on the axis.
"""

from typing import NamedTuple

import torch
from torch import Tensor

from workbench.optics.interfaces import TransmittanceLaw

_MOST_STEPS = 100


class LightInGlass(NamedTuple):
    """The light at places in the glass; tensors of any one shape."""

    radius_ratio: Tensor  # r = ρ_e / ρ
    steepness: Tensor  # g: slope of the ray over ρ_e
    # Flux per area of the plane z = const, over that right before the point on the entrance face
    # but for Fresnel's loss there.
    density: Tensor


class FlatGlass:
    """Glass behind a flat face, before it a point.

    `distance`: from the point to the face; `law`: the index, and how the face refracts;
    `lambertian`: whether the point's intensity falls with the cosine to the axis.
    """

    def __init__(self, distance: float, law: TransmittanceLaw, lambertian: bool) -> None:
        self._distance, self._law, self._lambertian = distance, law, lambertian
        self._index = 1 / law.ratio
        self._known: tuple[float, float, torch.dtype, int] | None = None

    def light(self, radius2: Tensor, depth: Tensor) -> LightInGlass:
        """The light at places ``radius2`` = ρ² from the axis, at depths t ≥ 0; smooth in t."""
        with torch.no_grad():
            radius_ratio = self._radius_ratio(radius2, depth.detach())
            spread = self._residual(radius_ratio, radius2, depth.detach())[1]
        # One step more with a constant slope has the derivative of the root.
        radius_ratio = radius_ratio - self._residual(radius_ratio, radius2, depth)[0] / spread

        steepness = self._steepness(radius_ratio, radius2)
        cos = (1 + radius_ratio.square() * (radius2 / self._distance**2)).rsqrt()
        inside = (1 + radius_ratio.square() * (radius2 * steepness.square())).rsqrt()
        behind = cos * cos.square() * self._law.at(cos, inside)
        if self._lambertian:
            behind = behind * cos
        spread = self._residual(radius_ratio, radius2, depth)[1]
        return LightInGlass(radius_ratio, steepness, behind * radius_ratio / spread)

    def slope(self, radius2: Tensor, depth: Tensor) -> Tensor:
        """Slope over ρ of the ray through places as in `light`, r g; without a derivative."""
        with torch.no_grad():
            radius_ratio = self._radius_ratio(radius2, depth)
            return radius_ratio * self._steepness(radius_ratio, radius2)

    def _radius_ratio(self, radius2: Tensor, depth: Tensor) -> Tensor:
        """The r of places, to rounding."""
        radius_ratio = self._start(radius2, depth)
        widest = radius2.max().sqrt().item()
        for _ in range(self.steps(widest, depth.max().item(), depth.dtype)):
            residual, spread = self._residual(radius_ratio, radius2, depth)
            radius_ratio = radius_ratio - residual / spread
        return radius_ratio

    def steps(self, widest: float, deepest: float, dtype: torch.dtype) -> int:
        """How many steps of Newton's method reach rounding at all radii and depths up to these.

        They are tried on some places, also on the rim of the cone that holds the light of a point
        right at the face: there they take longest. Depths below the last ones cost nothing.
        """
        if self._known and deepest <= self._known[0] and self._known[1:3] == (widest, dtype):
            return self._known[3]
        deepest *= 1.1
        eps = torch.finfo(dtype).eps
        fractions = torch.logspace(-6, 0, 61, dtype=torch.float64)
        cone = deepest / (self._index**2 - 1) ** 0.5
        radius = torch.cat([widest * fractions, (cone * fractions).clamp_max(widest)])
        depth, radius2 = deepest * fractions[:, None], radius.square()
        radius_ratio = self._start(radius2, depth)
        count = 0
        while count < _MOST_STEPS:
            residual, spread = self._residual(radius_ratio, radius2, depth)
            radius_ratio = radius_ratio - residual / spread
            # The residual has the rounding of 1.
            if (residual.abs() <= 4 * eps * (1 + radius_ratio * spread)).all():
                break
            count += 1
        self._known = (deepest, widest, dtype, count)
        return count

    @property
    def _apparent(self) -> float:
        """Distance at which the point seems to be from within the glass, on the axis."""
        return self._index * self._distance

    def _steepness(self, radius_ratio: Tensor, radius2: Tensor) -> Tensor:
        # In units of the distance: of a near point the squares of lengths leave float32's range.
        widening = (self._index**2 - 1) * (radius2 / self._apparent**2)
        return (1 + radius_ratio.square() * widening).rsqrt() / self._apparent

    def _start(self, radius2: Tensor, depth: Tensor) -> Tensor:
        """Two lower bounds of r: g is largest on the axis, and no slope exceeds (n² − 1)^(−½)."""
        widening = ((self._index**2 - 1) * radius2).sqrt()
        tiny = torch.finfo(depth.dtype).tiny
        return torch.maximum(
            self._apparent / (self._apparent + depth), 1 - depth / widening.clamp_min(tiny)
        )

    def _residual(
        self, radius_ratio: Tensor, radius2: Tensor, depth: Tensor
    ) -> tuple[Tensor, Tensor]:
        """By how much r leads too far, in units of ρ, and the derivative of that, dρ/dρ_e."""
        g = self._steepness(radius_ratio, radius2)
        return radius_ratio * (1 + depth * g) - 1, 1 + depth * (self._apparent * g).square() * g
