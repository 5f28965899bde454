"""Estimate of the slopes that a face needs, before it is designed.

Each point of the face sends light to the point of the picture in the same relative position. The
steepest slopes of designs are about the same.
"""

from dataclasses import dataclass

import numpy as np

from workbench.arrays import Array
from workbench.geometry.reach import largest_turn
from workbench.scene import Scene

_POINTS = 17  # along each axis


@dataclass(frozen=True, eq=False)
class Slopes:
    """Slopes that a face needs."""

    gradient: Array  # (n, n, 2), slope along x and y, x along the first axis; NaN where impossible
    turn: float  # largest deflection that is needed, degrees
    most: float  # largest possible deflection, degrees
    rise: float  # estimate of highest less lowest z of the face, scene units

    @property
    def possible(self) -> bool:
        """Whether all points can deflect their light as needed."""
        return bool(np.isfinite(self.gradient).all())

    @property
    def steepest(self) -> float:
        """Largest slope, degrees."""
        slope = np.hypot(*np.moveaxis(self.gradient, -1, 0))
        return float(np.degrees(np.arctan(np.nanmax(slope, initial=0.0))))


def needed_slopes(scene: Scene, part: tuple[float, float, float, float] | None = None) -> Slopes:
    """Return the slopes that the last face needs for a point source or collimated light.

    `part`: left, right, bottom and top of the lit part of the receiver; all of it by default.
    """
    (wide, high), scene = scene.receiver.half_extent, scene.alone
    optic, receiver = scene.optic, scene.receiver
    r_u, r_v = receiver.half_extent  # as the element sees it
    steps = np.linspace(-1, 1, _POINTS)
    x, y = np.meshgrid(*(half * steps for half in optic.half_width), indexing="ij")
    left, right, bottom, top = receiver.bounds
    if part:
        factors = r_u / wide, r_u / wide, r_v / high, r_v / high
        left, right, bottom, top = (end * by for end, by in zip(part, factors, strict=True))
    u, v = np.meshgrid(
        *((low + high + (high - low) * steps) / 2 for low, high in ((left, right), (bottom, top))),
        indexing="ij",
    )
    place = (x, y, np.full_like(x, optic.leaving_z))
    there = np.stack(receiver.towards(optic, place, u, v), axis=-1)
    here = _coming(scene, x, y)
    index = optic.index
    if optic.onwards > 0:
        here = here / index
        here[..., 2] = np.sqrt(1 - np.square(here[..., :2]).sum(axis=-1))
    normal = index * here - there
    along = (here * there).sum(axis=-1)
    most = np.degrees(largest_turn(index)) if optic.onwards > 0 else 90.0
    turns = np.degrees(np.arccos(np.clip(along, -1, 1)))
    if optic.onwards < 0:
        turns = 180 - turns
    with np.errstate(divide="ignore", invalid="ignore"):
        gradient = -normal[..., :2] / normal[..., 2:]
    gradient[(turns >= most) | (normal[..., 2] <= 0)] = np.nan
    half = _POINTS // 2
    across, up = gradient[:, half, 0], gradient[half, :, 1]
    rise = sum(_range(slope, h) for slope, h in zip((across, up), optic.half_width, strict=True))
    return Slopes(gradient, float(turns.max()), float(most), rise)


def _coming(scene: Scene, x: Array, y: Array) -> Array:
    source, optic = scene.source.sharp, scene.optic
    if source.place is None:
        way = source.heading
    else:
        way = np.stack([x, y, np.full_like(x, optic.front_z)], axis=-1) - source.place
    way = np.broadcast_to(way, (*x.shape, 3))
    return np.asarray(way / np.linalg.norm(way, axis=-1, keepdims=True))


def _range(slope: Array, half: float) -> float:
    """Range of the heights along a line with these slopes at equal steps."""
    slope = np.nan_to_num(slope)
    step = 2 * half / (len(slope) - 1)
    heights = np.append(0.0, np.cumsum((slope[1:] + slope[:-1]) / 2 * step))
    return float(np.ptp(heights))
