"""Collimated light through a flat entrance face and a B-spline exit face.

The bundle is parallel to z and meets the entrance face at a right angle, so it goes straight on
and can start on the exit face (de Koning et al. 2023, section 2.2): no entrance refraction, no
intersection, and slopes on a tensor grid by small matrix products.
"""

import numpy as np
import torch
from torch import Tensor

from workbench.geometry.surface import ControlNet, GridBasis
from workbench.optics.hits import Hits
from workbench.optics.refraction import (
    normal_reflectance,
    root_where_positive,
    schlick_transmittance,
)
from workbench.scene import Scene


class CollimatedRays:
    """A tensor grid of rays, with everything that does not depend on the control heights.

    Parameters
    ----------
    scene : Scene
        Lens and screen.
    net : ControlNet
        Where the control heights sit.
    count : tuple[int, int]
        Numbers of rays along x and y.
    dtype, device
        Float type and device of the trace.
    """

    emitted = 1.0
    missed_lens = 0.0

    def __init__(
        self,
        scene: Scene,
        net: ControlNet,
        count: tuple[int, int],
        dtype: torch.dtype = torch.float32,
        device: torch.device | str = "cpu",
    ) -> None:
        u, v = ((np.arange(m) + 0.5) / m for m in count)
        r_x, r_y = scene.lens.half_width

        def constant(values: np.ndarray) -> Tensor:
            return torch.as_tensor(values, dtype=dtype, device=device).contiguous()

        basis = net.grid(u, v)
        self._basis = GridBasis(
            constant(basis.along_x),
            constant(basis.slope_x),
            constant(basis.along_y),
            constant(basis.slope_y),
        )
        self._x = constant((2 * u - 1) * r_x)[:, None]
        self._y = constant((2 * v - 1) * r_y)[None, :]
        self._index = scene.lens.index
        self.screen = scene.screen
        # Near the mean height of the surface float32 keeps the digits that make its shape.
        self._level = scene.lens.base.height
        self.fresnel_entrance = normal_reflectance(self._index) * self.emitted
        self._arriving = (self.emitted - self.fresnel_entrance) / (count[0] * count[1])

    def trace(self, heights: Tensor) -> Hits:
        """Follow the rays from the exit face to the screen plane.

        Parameters
        ----------
        heights : Tensor, shape (n_u, n_v)
            Control heights, float64 or the trace's float type.
        """
        level = self._level
        z, slope_x, slope_y = self._basis.evaluate((heights - level).to(self._x.dtype))
        n = self._index
        # Snell's law with d = (0, 0, 1) and N = (−z_x, −z_y, 1)/s, s² = 1 + k, k = z_x² + z_y²,
        # leaves one root: q = s cos θ_t = √(1 − (n² − 1) k); per unit of z the refracted ray
        # moves sideways by (z_x, z_y) (n² − 1) / (1 + n q).
        k = slope_x.square() + slope_y.square()
        q, passes = root_where_positive(1 - (n * n - 1) * k)
        bend = ((self.screen.z - level) - z) * (n * n - 1) / (1 + n * q)
        x = self._x + slope_x * bend
        y = self._y + slope_y * bend
        transmitted = schlick_transmittance(q * (1 + k).rsqrt(), n) * self._arriving
        weight = torch.where(passes, transmitted, 0.0)
        arriving = torch.full_like(weight, self._arriving)
        return Hits(x, y, weight, arriving, passes, left_side=weight.new_zeros(()))
