"""Deflections that a face can make and a receiver needs, and projected solid angles."""

import math

import numpy as np

from workbench.arrays import Array
from workbench.scene import AnyReceiver, FarField, Screen


def largest_turn(index: float) -> float:
    """Return the largest deflection at a face of glass, radians: 90° less the critical angle.

    Examples
    --------
    >>> round(math.degrees(largest_turn(1.5)), 1)
    48.2
    """
    return math.acos(1 / index)


def incidence(turn: Array, index: float) -> Array:
    """Angles in the glass at which a face deflects light by given angles, radians.

    By Snell's law: n sin a = sin(a + turn).
    """
    return np.arctan2(np.sin(turn), index - np.cos(turn))


def least_turn(receiver: AnyReceiver, place: Array, way: Array, onwards: int = 1) -> Array:
    """Return the least deflections (m,) that bring rays to a receiver, radians.

    Light that goes on from its place, and is deflected farther on or several times, needs at least
    as much in all: the way to a place of the receiver is between the directions that follow each
    other.

    `place`, `way` (m, 3): of the rays in the scene; `onwards`: 1 if light comes to a far field
    along +z, -1 if it goes to -z.
    """
    if isinstance(receiver, FarField):
        return _to_far_field(receiver, way * [1.0, 1.0, onwards])
    if isinstance(receiver, Screen):
        return _to_screen(receiver, place, way)
    return np.zeros(len(way))  # of another kind nothing is known


def projected_solid_angle(rim: Array, place: Array, normal: Array) -> Array:
    """Return the solid angles (m,) of a polygon, weighted by the cosine to a normal, steradians.

    By its edges (Lambert, 1760); negative if they run clockwise about the normal.

    `rim` (n, 3): all on one side of the planes through `place` (m, 3) across the `normal` (3,).
    """
    unit = rim - place[:, None]
    unit /= np.linalg.norm(unit, axis=2, keepdims=True)
    following = np.roll(unit, -1, axis=1)
    across = np.cross(unit, following)
    sine = np.linalg.norm(across, axis=2)
    angle = np.arctan2(sine, (unit * following).sum(axis=2))
    parts = angle / np.where(sine > 0, sine, 1.0) * (across @ normal)
    return np.asarray(parts.sum(axis=1) / 2)


def _to_screen(screen: Screen, place: Array, way: Array) -> Array:
    right, up, across = screen.sides
    r_x, r_y = screen.half_width
    middle = screen.stands_at - place
    with np.errstate(divide="ignore", invalid="ignore"):
        far = (middle @ across) / (way @ across)
        hit = far[:, None] * way - middle
        inside = (far > 0) & (np.abs(hit @ right) <= r_x) & (np.abs(hit @ up) <= r_y)
    cosine = np.full(len(way), -1.0)
    for side, along, r_side, r_along in ((right, up, r_x, r_y), (up, right, r_y, r_x)):
        for sign in (-1, 1):
            start = middle + sign * r_side * side - r_along * along
            np.maximum(cosine, _along_edge(start, along, 2 * r_along, way), out=cosine)
    return np.where(inside, 0.0, np.arccos(cosine.clip(-1, 1)))


def _along_edge(start: Array, along: Array, length: float, way: Array) -> Array:
    """Largest cosines (m,) between rays and directions to places of an edge that starts there."""
    way_along, start_along = way @ along, start @ along
    way_start, square = (way * start).sum(axis=1), (start * start).sum(axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        best = (way_start * start_along - way_along * square) / (
            way_along * start_along - way_start
        )
    found = np.full(len(way), -1.0)
    for part in (
        np.zeros(len(way)),
        np.nan_to_num(best).clip(0, length),
        np.full(len(way), length),
    ):
        there = start + part[:, None] * along
        away = np.linalg.norm(there, axis=1)
        np.maximum(found, (way * there).sum(axis=1) / np.where(away > 0, away, 1.0), out=found)
    return found


def _to_far_field(field: FarField, way: Array) -> Array:
    """Sides of constant H are great circles; of the others the nearest place has the ray's H."""
    left, right, bottom, top = np.radians(field.bounds)
    h, v = np.arctan2(way[:, 0], way[:, 2]), np.arcsin(way[:, 1].clip(-1, 1))
    cosine = np.full(len(way), -1.0)
    for there in (h.clip(left, right), left, right):
        aside = np.cos(h - there)
        foot = np.arctan2(np.sin(v), np.cos(v) * aside).clip(bottom, top)
        found = np.sin(v) * np.sin(foot) + np.cos(v) * np.cos(foot) * aside
        np.maximum(cosine, found, out=cosine)
    return np.asarray(np.arccos(cosine.clip(-1, 1)))
