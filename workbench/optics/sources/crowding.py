"""Samples of a face where the light of a narrow beam is.

Even cells of a lens that is many times as wide as the beam would each hold a large part of it: the
sum over their corners may be several times its light. So corners lie within the beam, evenly, and
become fewer beyond.
"""

import math

import numpy as np

from workbench.geometry.surface import freeform_nets
from workbench.optics.samples import Corners, Crowd
from workbench.scene import CollimatedSource, Optic

# Radii of a beam within which its corners are even: e^(−2 · 2.5²) of its brightness is at the end.
_RADII = 2.5
# Of the larger half-width, how far the face may come from its place where no range says so.
_MOVES = 0.2


def where_lit(corners: Corners, source: CollimatedSource, optic: Optic) -> Corners:
    """Corners of cells where light is: those of a beam crowd there, others stay.

    Parameters
    ----------
    corners : Corners
        How many there are.
    source, optic
        The light, and the optic whose first freeform face is sampled.
    """
    if math.isinf(source.profile.radius):
        return corners
    x, y = (_crowd(source, optic, axis) for axis in (0, 1))
    return corners._replace(crowd_x=x, crowd_y=y)


def _crowd(source: CollimatedSource, optic: Optic, axis: int) -> Crowd:
    """Where a beam is on the first freeform face along an axis."""
    face, inside = next(iter(freeform_nets(optic))), 1.0
    place = float(optic.place_of(face, 0.0, 0.0))
    if face == optic.face:  # behind a flat entrance face, if it is that of a lens
        inside = optic.index
    half, depth = optic.half_width[axis], place - optic.front_z
    rim = np.linspace(0, 2 * math.pi, 8, endpoint=False)
    ways = source.directions(np.append(0.0, np.cos(rim)), np.append(0.0, np.sin(rim)))
    slopes = ways[:, axis] / np.sqrt(inside**2 - 1 + ways[:, 2] ** 2)
    shadow = source.profile.radius / float(ways[:, 2].min())
    low, high = optic.range_of(face) or (-_MOVES * max(optic.half_width),) * 2
    moved = float(np.abs(slopes).max()) * max(abs(low), abs(high))
    middle = depth * float(slopes[0])
    spread = abs(depth) * float(np.abs(slopes - slopes[0]).max())
    return Crowd.of((_RADII * shadow + spread + moved) / half, middle / half)
