"""Samples of a face where the light of a narrow beam or of a near source is.

Even cells of a lens that is many times as wide as the light on it would each hold a large part of
it: the sum over their corners may be several times the light. So corners lie within a beam, evenly,
and become fewer beyond; and about the foot of a near source they are as close as its light changes.
"""

import math
from typing import NamedTuple, Self

import numpy as np

from workbench.arrays import Array
from workbench.geometry.outlines import outline_of
from workbench.geometry.surface import freeform_nets
from workbench.optics.samples import EVERYWHERE, Corners, Crowd
from workbench.optics.sources.origins import bulk_of
from workbench.optics.sources.points import light_of_table
from workbench.scene import (
    AreaSource,
    CollimatedSource,
    Element,
    LightOfPoints,
    PhotometricSource,
    Source,
)

# Radii of a beam within which its corners are even: e^(−2 · 2.5²) of its brightness is at the end.
_RADII = 2.5
# Part of a lamp's light on either side of where its corners are closest.
_TAIL = 0.1
# Of the larger half-width, how far the face may come from its place where no range says so.
_MOVES = 0.2


class _Face(NamedTuple):
    depth: float  # how far it is behind the aperture
    moves: float  # how far it may come from there
    inside: float  # refractive index of what is before it

    @classmethod
    def of(cls, optic: Element) -> Self:
        face = next(iter(freeform_nets(optic)), None)
        if face is None:  # fixed faces come first: the aperture itself is sampled
            return cls(0.0, 0.0, 1.0)
        low, high = optic.range_of(face) or (-_MOVES * max(optic.half_width),) * 2
        depth = float(optic.place_of(face, 0.0, 0.0)) - optic.front_z
        return cls(
            depth, max(abs(low), abs(high)), optic.index if face == optic.designed_face else 1.0
        )


def where_lit(corners: Corners, source: Source, optic: Element) -> Corners:
    """Corners of cells where light is.

    `corners`: how many there are; `source`, `optic`: the light, and the element whose first
    freeform face is sampled.
    """
    face = _Face.of(optic)
    if isinstance(source, CollimatedSource):
        if math.isinf(source.profile.radius):
            return corners
        x, y = (_of_beam(source, optic, face, axis) for axis in (0, 1))
    elif isinstance(source, PhotometricSource):
        x, y = _of_lamp(source, optic, face)
    elif isinstance(source, (AreaSource, LightOfPoints)):
        x, y = (_of_points(source, optic, face, axis) for axis in (0, 1))
    else:
        return corners
    return corners._replace(crowd_x=x, crowd_y=y)


def _of_beam(source: CollimatedSource, optic: Element, face: _Face, axis: int) -> Crowd:
    half, rim = optic.half_width[axis], np.linspace(0, 2 * math.pi, 8, endpoint=False)
    ways = source.directions(np.append(0.0, np.cos(rim)), np.append(0.0, np.sin(rim)))
    slopes = ways[:, axis] / np.sqrt(face.inside**2 - 1 + ways[:, 2] ** 2)
    shadow = source.profile.radius / float(ways[:, 2].min())
    moved = float(np.abs(slopes).max()) * face.moves
    spread = abs(face.depth) * float(np.abs(slopes - slopes[0]).max())
    middle = face.depth * float(slopes[0])
    return Crowd.of((_RADII * shadow + spread + moved) / half, middle / half)


def _of_points(source: AreaSource | LightOfPoints, optic: Element, face: _Face, axis: int) -> Crowd:
    half, place = optic.half_width[axis], source.place
    away = (optic.front_z - place[2]) * face.inside + face.depth
    wide = max((abs(corner[axis] - place[axis]) for corner in source.corners), default=0.0)
    return Crowd.about((away + wide) / half, min(max(place[axis] / half, -1.0), 1.0))


def _of_lamp(source: PhotometricSource, optic: Element, face: _Face) -> tuple[Crowd, Crowd]:
    light, *away = light_of_table(source).onto(optic.front_z - source.position[2])
    entered = np.stack(away) + np.array(source.position[:2])[:, None]
    slopes = light.direction.T[:2] / np.sqrt(face.inside**2 - 1 + light.direction[:, 2] ** 2)
    met = outline_of(optic).contains(*entered)
    if not met.any():
        return EVERYWHERE, EVERYWHERE
    x, y = (
        _of_bulk(place[met], slope[met], light.flux[met], half, face.moves)
        for place, slope, half in zip(
            entered + face.depth * slopes, slopes, optic.half_width, strict=True
        )
    )
    return x, y


def _of_bulk(place: Array, slope: Array, flux: Array, half: float, moves: float) -> Crowd:
    low, high = bulk_of(place, flux, _TAIL)
    moved = moves * abs(float(np.average(slope, weights=flux)))
    middle = min(max((low + high) / 2 / half, -1.0), 1.0)
    return Crowd.about(((high - low) / 2 + moved) / half, middle)
