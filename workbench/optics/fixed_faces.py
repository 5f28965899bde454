"""Light of samples of the aperture, followed through the fixed faces before the first freeform one.

Fixed faces do not change during a run: rays pass them once, in float64.
"""

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple, Self

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.geometry.frames import Frame
from workbench.geometry.outlines import Outline
from workbench.optics.rays import RayBundle, Vector, seen
from workbench.optics.samples import Places, areas_of
from workbench.optics.sources.origins import Origins, vector
from workbench.optics.steps import FaceStep
from workbench.optics.surfaces.intersection import RIM

# Rays with a smaller square of the cosine to the axis do not come to an aperture.
_HORIZON = 1e-9
# Parts of distances and cosines by which rays are moved to see where they meet again.
_SMALL = 1e-5
_ALL = torch.ones(5, dtype=torch.bool)
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


class EvenDirections(NamedTuple):
    """Samples of an aperture that are even in the cosines of directions from several points.

    A Lambertian origin sends the same flux in each, however close to the aperture it is.
    """

    # Cosines along x and y between which all light comes to the aperture, from an origin on the
    # axis. From others they change by `lean` (2, 2), which makes light of a sample meet again.
    ends: tuple[tuple[float, float], tuple[float, float]]
    lean: Array

    @classmethod
    def of(
        cls,
        origins: Origins,
        outline: Outline,
        z: float,
        steps: Sequence[FaceStep],
        changes: Sequence[Frame],
        goal: float,
    ) -> Self:
        """Directions from points, whose light is to meet again at `goal` behind some faces.

        `outline`, `z`: of the aperture, in coordinates of the origins; `steps`, `changes`: see
        `follow`; `goal`: z of the place, behind the faces.
        """
        lean = _lean(origins.places.mean(axis=0), z, steps, changes, goal)
        leaning, away = origins.places[:, :2] @ lean.T, z - origins.places[:, 2]
        ends = []
        for axis, r in enumerate(outline.half_width):
            place = origins.places[:, axis]
            low, high = (
                (end - place) / np.hypot(end - place, away) - leaning[:, axis] for end in (-r, r)
            )
            ends.append((float(low.min()), float(high.max())))
        return cls((ends[0], ends[1]), lean)

    def rays(
        self, origins: Origins, lines: tuple[Places, Places], outline: Outline, z: float
    ) -> tuple[RayBundle, Tensor]:
        """Rays of all origins, see `through_aperture`, and their distances to its rim.

        Those beside it do not exist.
        """
        across, up = lines
        leaning = origins.places[:, :2] @ self.lean.T
        (left, right), (low, high) = self.ends
        # (m_x, origins, m_y)
        p = (left + (right - left) * across.part)[:, None, None] + leaning[:, :1]
        q = low + (high - low) * up.part + leaning[:, 1:]
        area = (right - left) * (high - low) * (across.high - across.low)[:, None, None]
        area = area * (up.high - up.low)
        ahead2 = 1 - p**2 - q**2
        ahead = np.sqrt(ahead2.clip(min=_HORIZON))
        x_0, y_0, away = (part[:, None] for part in (origins.places - [0, 0, z]).T)
        x, y = x_0 - away * p / ahead, y_0 - away * q / ahead
        lit = origins.light(x, y, z, np.arange(len(x_0))[:, None])
        flux = lit.density * (away / ahead**2) ** 2 * area

        def flat(values: Array) -> Array:
            return np.broadcast_to(values, x.shape).reshape(len(x), -1)

        place = vector([flat(each) for each in (x, y, np.full(x.shape, z))])
        rim = RIM - _radius(outline, place)
        alive = (rim >= 0) & torch.as_tensor(flat(ahead2) > _HORIZON)
        whole = torch.as_tensor(flat(flux).copy())
        direction = vector([flat(each) for each in lit.direction])
        rays = RayBundle(place, direction, torch.where(alive, whole, 0.0), alive)
        return rays, torch.where(alive, rim, -1.0)


def _lean(
    place: Array, z: float, steps: Sequence[FaceStep], changes: Sequence[Frame], goal: float
) -> Array:
    """How cosines have to change with the origin for light to meet again; zeros if none comes.

    `place` (3,): an origin; for the others see `EvenDirections.of`.
    """
    size = abs(z - place[2])
    moves = _SMALL * np.array([[0, 0], [size, 0], [0, size], [0, 0], [0, 0]])
    p, q = _SMALL * np.array([[0.0, 0, 0, 1, 0], [0, 0, 0, 0, 1]])
    cosine = np.sqrt(1 - p**2 - q**2)
    x, y = (place[:2] + moves).T + (z - place[2]) * np.stack([p, q]) / cosine
    rays = RayBundle(vector([x, y, np.full(5, z)]), vector([p, q, cosine]), torch.ones(5), _ALL)
    for step, change in zip(steps, changes[:-1], strict=True):
        rays = seen(rays, change)
        rays = step.interface.turn(rays, step.surface.meet_unbounded(rays, {})).rays
    (along_x, along_y, along_z), way = seen(rays, changes[-1])[:2]
    ahead = (goal - along_z) / way[2]
    met = torch.stack([along_x + ahead * way[0], along_y + ahead * way[1]]).numpy()
    by_place, by_cosine = ((met[:, k : k + 2] - met[:, :1]) / _SMALL for k in (1, 3))
    if not (rays.alive.all() and np.linalg.cond(by_cosine) < 1 / _SMALL):
        return np.zeros((2, 2))
    return np.asarray(np.linalg.solve(by_cosine, -by_place) / size)


def follow(
    rays: RayBundle,
    steps: Sequence[FaceStep],
    changes: Sequence[Frame],
    aperture: tuple[Outline, str],
    copies: int = 1,
    rim: Tensor | None = None,
) -> Followed:
    """Follow rays from an aperture through some faces.

    `rays`: rays in the aperture; `steps`, `changes`: the faces; changes of coordinates before each
    of them, and behind the last one; `aperture`: its outline, and the name of light that misses it;
    `copies`: how many times the flux of the rays is that of the aperture; the source has 1; `rim`:
    distances to the rim of the aperture; by default rays stand for parts that it cuts.
    """
    outline, missed = aperture
    sums = {missed: 1 / copies - rays.flux.sum()}
    begin: tuple[Vector, Outline] | None = None
    if rim is None:
        begin, rim = (rays.position, outline), torch.full_like(rays.flux, torch.inf)
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
