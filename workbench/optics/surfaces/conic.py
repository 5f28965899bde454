"""A conic of revolution about the axis, with an outline."""

from collections.abc import Mapping

import torch
from torch import Tensor

from workbench.geometry.outlines import Outline
from workbench.optics.rays import RayBundle
from workbench.optics.surfaces.surface import Meeting


class Conic:
    """Surface z = c r² / (1 + √(1 − (1 + k) c² r²)) about its vertex; a `Surface`.

    Parameters
    ----------
    name : str
        What it is called.
    z : float
        Where its vertex is, counted from the datum of the path.
    curvature : float
        c, one over the radius: positive where the centre of curvature lies on the +z side.
    conic : float
        The conic constant k: 0 of a sphere, −1 of a paraboloid.
    outline : Outline
        What of it is glass.

    Notes
    -----
    The intersection is in closed form: W. T. Welford, *Aberrations of Optical Systems* (1986),
    section 4.3.
    """

    kind = "conic"
    freeform = False

    def __init__(
        self, name: str, z: float, curvature: float, conic: float, outline: Outline
    ) -> None:
        self.name, self.outline = name, outline
        self.z, self.curvature, self.conic = z, curvature, conic

    def meet(self, rays: RayBundle, heights: Mapping[str, Tensor]) -> Meeting:
        """Where rays meet the conic; see `Surface.meet`."""
        meeting = self.meet_unbounded(rays, heights)
        x, y, _ = meeting.position
        return meeting._replace(met=meeting.met & self.outline.contains(x, y))

    def meet_unbounded(self, rays: RayBundle, heights: Mapping[str, Tensor]) -> Meeting:
        """As `meet`, also beside the outline."""
        (x, y, z), (d_x, d_y, d_z) = rays.position, rays.direction
        c, k_1 = self.curvature, 1 + self.conic
        forward = d_z > 0
        steep = torch.where(forward, d_z, 1.0)
        a, b = d_x / steep, d_y / steep
        x, y = x + a * (self.z - z), y + b * (self.z - z)
        half = 1 - c * (a * x + b * y)
        first = c * (x.square() + y.square())
        square = half.square() - c * (a.square() + b.square() + k_1) * first
        there = forward & (square > 0)
        root = half + torch.where(there, square, 1.0).sqrt()
        there = there & (root > 0)
        depth = first / torch.where(there, root, 1.0)
        x, y = x + a * depth, y + b * depth
        rest = 1 - k_1 * c**2 * (x.square() + y.square())
        there = there & (rest > 0) & (1 - k_1 * c * depth > 0)
        bend = c * torch.where(there, rest, 1.0).rsqrt()
        length = (1 + (bend * x).square() + (bend * y).square()).rsqrt()
        normal = -bend * x * length, -bend * y * length, length
        return Meeting((x, y, depth + self.z), normal, rays.alive & there)
