"""Irradiance of light whose rays are nodes of a grid: every cell of the grid is a beam.

Between four neighbouring rays runs a beam of light. It is split into two triangles of equal flux,
and each spreads its flux evenly over the area between its three hits. Neighbouring beams share
their hits, so that the image has neither gaps nor noise of rays, and it is exact in each pixel: no
filter spreads it further. Light that folds over itself adds up.

An image of points, which each count in the pixel that they hit or are spread by a filter, needs
some 36 rays a pixel and still is 1.5 to 3 % off, by noise and blur; 9 beams a pixel are 0.1 to
0.3 % off (see `workbench.optics.kernels.beam_nodes`). Triangles between hits were chosen before
parallelograms and Gaussians around each hit: these need second derivatives of the face, and
neighbours overlap or leave gaps.
"""

from torch import Tensor

from workbench.optics import ready
from workbench.optics.beam_reference import reference_beam_image
from workbench.optics.kernels.beam_image import compiled_beam_image
from workbench.optics.kernels.cell_image import Splits


def beam_image(
    nodes: Tensor, pixels: tuple[int, int], splits: Splits, fused: bool = True
) -> tuple[Tensor, float]:
    """Flux in each pixel of beams between rays.

    `nodes` (3, n, m): columns and rows of the image in which rays hit, infinite for those that
    never do; and their flux: a ray inside the grid stands for a cell around it, one at its rim for
    a half or a quarter of one. Rays are neighbours in the grid as they are in the lens; `splits`
    (m, 3) and (n, 3): which parts of the flux of a ray belong to the cells before and behind it,
    along the last axis and along the one before; and 1 for rays between two cells of equal width.
    Several grids may lie side by side: no flux belongs to the cells between them. Where there are
    so many times as many rows of rays, all grids are alike; `pixels`: (n_x, n_y); `fused`: False
    asks for the reference. Returns (n_y, n_x): flux in each pixel, row 0 at the top,
    differentiable; and the flux of all beams whose rays hit the plane of the image, on it or beside
    it.
    """
    compiled = fused and nodes.device.type == "cpu" and ready.obtain("beams", nodes.dtype)
    return (compiled_beam_image if compiled else reference_beam_image)(nodes, pixels, splits)
