"""How steep a face has to be, before it is designed: each place sends light to its place.

The light keeps its order: the left edge of the optic lights the left edge of the picture, evenly
between. Designs differ where pictures are uneven; the steepest places are about the same.
"""

from dataclasses import dataclass

import numpy as np

from workbench.arrays import Array
from workbench.scene import Scene

_PLACES = 17  # along each axis


@dataclass(frozen=True, eq=False)
class Slopes:
    """What a face needs."""

    # (n, n, 2), slope along x and y at places with x along the first axis; NaN where no slope sends
    # light there.
    gradient: Array
    turn: float  # the largest angle by which the face has to turn light, degrees
    # The largest angle by which it can turn light, degrees; less just inside that is lost to
    # reflection.
    most: float
    rise: float  # highest less lowest place of the face, about, scene units

    @property
    def possible(self) -> bool:
        """Whether every place can send its light where it is wanted."""
        return bool(np.isfinite(self.gradient).all())

    @property
    def steepest(self) -> float:
        """The largest slope, degrees, of places that have one."""
        slope = np.hypot(*np.moveaxis(self.gradient, -1, 0))
        return float(np.degrees(np.arctan(np.nanmax(slope, initial=0.0))))


def needed_slopes(scene: Scene, part: tuple[float, float, float, float] | None = None) -> Slopes:
    """The slopes that the last face of an optic needs.

    `scene`: its source counts as a point, or as light from one direction; `part`: left, right,
    bottom and top of what shall be lit, in coordinates of the receiver; all of it by default.
    """
    optic, receiver = scene.optic, scene.receiver
    steps = np.linspace(-1, 1, _PLACES)
    x, y = np.meshgrid(*(half * steps for half in optic.half_width), indexing="ij")
    left, right, bottom, top = part or receiver.bounds
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
    most = np.degrees(np.arccos(1 / index)) if optic.onwards > 0 else 90.0
    turns = np.degrees(np.arccos(np.clip(along, -1, 1)))
    if optic.onwards < 0:
        turns = 180 - turns
    with np.errstate(divide="ignore", invalid="ignore"):
        gradient = -normal[..., :2] / normal[..., 2:]
    gradient[(turns >= most) | (normal[..., 2] <= 0)] = np.nan
    half = _PLACES // 2
    across, up = gradient[:, half, 0], gradient[half, :, 1]
    rise = sum(_range(slope, h) for slope, h in zip((across, up), optic.half_width, strict=True))
    return Slopes(gradient, float(turns.max()), float(most), rise)


def _coming(scene: Scene, x: Array, y: Array) -> Array:
    """Unit vectors (n, n, 3) of light before it meets the optic, of a source that is small."""
    source, optic = scene.source.sharp, scene.optic
    if source.place is None:
        way = source.heading
    else:
        way = np.stack([x, y, np.full_like(x, optic.front_z)], axis=-1) - source.place
    way = np.broadcast_to(way, (*x.shape, 3))
    return np.asarray(way / np.linalg.norm(way, axis=-1, keepdims=True))


def _range(slope: Array, half: float) -> float:
    """How far heights along a line are apart whose slopes are these; steps are even."""
    slope = np.nan_to_num(slope)
    step = 2 * half / (len(slope) - 1)
    heights = np.append(0.0, np.cumsum((slope[1:] + slope[:-1]) / 2 * step))
    return float(np.ptp(heights))
