"""Light of samples of the aperture, followed through the fixed faces before the first freeform one.

Fixed faces do not change during a run: rays pass them once, in float64.
"""

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
import torch
from torch import Tensor

from workbench.geometry.frames import Frame
from workbench.geometry.outlines import Outline
from workbench.optics.rays import RayBundle, Vector, seen
from workbench.optics.samples import Places, areas_of
from workbench.optics.sources.origins import Origins, vector
from workbench.optics.steps import FaceStep
from workbench.optics.surfaces.intersection import RIM

# No place is nearer to the axis, as a part of the way to the rim: the root has a slope.
_TINY = 1e-15


class Followed(NamedTuple):
    """Rays behind fixed faces, in float64."""

    rays: RayBundle  # they stay in the rows and columns of their samples, also those that are lost
    rim: Tensor  # their distance to the rims of the faces, see `workbench.optics.images.rim`
    # Flux lost before the aperture and at the faces, by its name in the light account.
    lost: dict[str, float]


def through_aperture(
    origins: Origins, lines: tuple[Places, Places], outline: Outline, z: float
) -> RayBundle:
    """Rays of all origins through samples of an aperture; shape (m_x, origins × m_y).

    `origins`: where the light comes from; `lines`: samples along x and y; `outline`: of the
    aperture; `z`: where the aperture is, scene units.
    """
    across, up = lines
    count, (r_x, r_y) = len(origins.places), outline.half_width
    x, y = (2 * across.part[:, None] - 1) * r_x, np.tile((2 * up.part - 1) * r_y, count)
    area = np.tile(areas_of(outline, *lines), count)
    lit = origins.light(x, y, z, np.repeat(np.arange(count), len(up.part)))
    place = vector(np.broadcast_arrays(x, y, np.full(area.shape, z)))
    alive = torch.ones(area.shape, dtype=torch.bool)
    flux = torch.as_tensor(lit.density * area)
    return RayBundle(place, vector(lit.direction), flux, alive)


def follow(
    rays: RayBundle,
    steps: Sequence[FaceStep],
    changes: Sequence[Frame],
    aperture: tuple[Outline, str],
    copies: int = 1,
) -> Followed:
    """Follow rays from an aperture through some faces.

    `rays`: rays in the aperture; `steps`, `changes`: the faces; changes of coordinates before each
    of them, and behind the last one; `aperture`: its outline, and the name of light that misses it;
    `copies`: how many times the flux of the rays is that of the aperture; the source has 1.
    """
    outline, missed = aperture
    sums = {missed: 1 / copies - rays.flux.sum()}
    rim = torch.full_like(rays.flux, torch.inf)
    begin: tuple[Vector, Outline] | None = (rays.position, outline)
    for step, change in zip(steps, changes[:-1], strict=True):
        rays, rim, lost = pass_face(step, seen(rays, change), {}, rim, begin)
        begin = None
        for name, part in lost.items():
            sums[name] = sums.get(name, 0.0) + part.sum()
    lost_before = {name: copies * flux.item() for name, flux in sums.items()}
    return Followed(seen(rays, changes[-1]), rim, lost_before)


def pass_face(
    step: FaceStep,
    rays: RayBundle,
    heights: Mapping[str, Tensor],
    rim: Tensor | None,
    begin: tuple[Vector, Outline] | None,
) -> tuple[RayBundle, Tensor, dict[str, Tensor]]:
    """Rays of samples behind a face, their distance to the rims so far, and losses by name.

    `step`, `rays`, `heights`: the face, the rays before it in its frame, and control heights;
    `rim`: the distance before; `begin`: samples and what cuts the parts that they stand for, if
    this is the next face behind them.
    """
    outline = step.surface.outline
    meeting = step.surface.meet_unbounded(rays, heights)
    own = RIM - _radius(outline, meeting.position)
    if begin is not None and not begin[1].whole:
        # Samples beside a curved outline stand for parts that it cuts: for these its rim is
        # where they are.
        samples, first = begin
        beyond = _radius(first, samples).clamp_min(1.0) - 1.0
        own = own + beyond * beyond_rim(first, outline)
    meeting = meeting._replace(met=meeting.met & (own >= 0))
    # Rays that do not come to the face leave at the side, but for those without a way.
    own = torch.where(meeting.met, own.clamp_min(0.0), torch.where(rays.alive, -1.0, 0.0))
    passed = step.interface.turn(rays, meeting)
    missed = torch.where(meeting.met, 0.0, rays.flux)
    lost = {step.missed: missed.detach(), **passed.lost}
    return passed.rays, own if rim is None else torch.minimum(own, rim), lost


def beyond_rim(first: Outline, outline: Outline) -> float:
    """Distance from the axis, as a part of that of an outline, over the same of the first one."""
    return RIM * math.sqrt(math.prod(first.half_width) / math.prod(outline.half_width))


def _radius(outline: Outline, place: Vector) -> Tensor:
    """Distance from the axis as a part of that of the rim."""
    (x, y, _), (r_x, r_y) = place, outline.half_width
    if outline.whole:
        return torch.maximum((x / r_x).abs(), (y / r_y).abs())
    return ((x / r_x).square() + (y / r_y).square()).clamp_min(_TINY**2).sqrt()
