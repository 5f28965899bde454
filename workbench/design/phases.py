"""The phases of `workbench.design.auto`: from a blunt image of few rays to a sharp one of many."""

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from torch import Tensor

from workbench.design.heights import Mask
from workbench.design.wide_image import WideImage
from workbench.optics.plan import Plan
from workbench.scene import GaussianFilter, Scene

Array = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Phase:
    """A part of the run; every stage of a scene goes through all of them.

    Attributes
    ----------
    alpha : float
        Sharpness of the filter over 3 × 3 pixels.
    rays : int
        Rays along an axis for each pixel along it.
    cut : float
        See `Waves`.
    most : int, optional
        Iterations at most, and no more than a third of those that are left; all that are left by
        default.
    """

    alpha: float
    rays: int
    cut: float
    most: int | None = None

    def iterations(self, left: int) -> int:
        """How many of the iterations that are left it may take."""
        return left if self.most is None else min(self.most, math.ceil(left / 3))


SHARPEST = Phase(alpha=12.0, rays=6, cut=4.0)
"""The last phase, by whose image lenses are judged."""

PHASES = (
    Phase(alpha=1.0, rays=3, cut=1.0, most=30),
    Phase(alpha=4.0, rays=4, cut=2.0, most=40),
    SHARPEST,
)

# Rays along an axis for each control point along it, at least.
_RAYS_PER_CONTROL_POINT = 4
_MOST_RAYS = 4096
# What symmetry saves goes in part into rays, by this factor along each axis for each mirror: the
# smaller the error, the more of it is that of too few rays.
_MIRRORED_RAYS = 1.3
# Rays that tell how far the light of a lens reaches.
_FEW_RAYS = (256, 256)


def image_of(
    phase: Phase,
    scene: Scene,
    target: Array,
    reach: tuple[float, float],
    mirrored: tuple[bool, bool] = (False, False),
    locked: Mask | None = None,
) -> WideImage:
    """The image by which a phase compares lenses.

    Parameters
    ----------
    phase : Phase
        Says how sharp it is and how many rays make it.
    scene : Scene
        The design task.
    target : ndarray, shape (n_y, n_x)
        The wanted image in any scale, row 0 at +y.
    reach, mirrored, locked
        As for `WideImage`; see `reach_of`.
    """
    rays = phase.rays * _MIRRORED_RAYS ** sum(mirrored)
    per_axis = [
        max(
            math.ceil(rays * pixels),
            _RAYS_PER_CONTROL_POINT * count,
            least if phase is SHARPEST else 0,
        )
        for pixels, count, least in zip(
            scene.screen.pixels, scene.lens.control_points, scene.source.samples, strict=True
        )
    ]
    # An even number can be halved by symmetry.
    m_x, m_y = (min(2 * math.ceil(count / 2), _MOST_RAYS) for count in per_axis)
    filter = GaussianFilter(alpha=phase.alpha)
    return WideImage(scene, target, filter, (m_x, m_y), mirrored, reach, locked)


def reach_of(scene: Scene, heights: Mapping[str, Tensor]) -> tuple[float, float]:
    """How far from the axis, along x and y, the light of a lens falls; scene units."""
    return Plan(scene, samples=_FEW_RAYS).reach(heights)
