"""The cones of light that just cover the entrance face, for the independent check.

Everything comes from how far apart the corners of the face are on the sphere around a point. These
distances are found without a difference of long ways, so a point may be as far as one likes.
"""

from itertools import combinations
from typing import NamedTuple

import numpy as np

from workbench.arrays import Array

# Of the rule that adds up the light of a cone.
_NODES = 48


class Cones(NamedTuple):
    """For each of k points the smallest circular cone that holds the face."""

    centre: Array  # (k, 2), where the axis crosses the plane of the face, scene units
    axis: Array  # (k, 3), unit vectors
    distance: Array  # (k,), from the point to the centre
    versine: Array  # (k,), 1 − cosine of the half-angle; the solid angle is 2π times that


def covering_cones(points: Array, half_width: tuple[float, float], z: float) -> Cones:
    """Cones from points that just cover a centred rectangle in the plane z.

    `points` (k, 3): the points, before the plane; `half_width`: half-widths of the rectangle; `z`:
    where the rectangle is.

    Notes
    -----
    The smallest ball around the four unit vectors to the corners has its centre on the axis, and
    the sine of the half-angle is its radius. The centre is that of an edge, of a diagonal, or of
    the circle through three corners.
    """
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1)]) * [*half_width, 1.0]
    ways = corners - points[:, None]
    length = np.linalg.norm(ways, axis=2)  # [points, corners]
    chord2 = _squared_chords(corners, ways, length)
    weights = np.stack(_centres(chord2), axis=1)  # [points, centres, corners]
    # Of a centre Σ wᵢ uᵢ with Σ wᵢ = 1, squared distances to all corners.
    across = np.einsum("kmi,kij->kmj", weights, chord2)
    radius2 = across.max(axis=2) - np.einsum("kmj,kmj->km", across, weights) / 2
    radius2[np.isnan(radius2)] = np.inf  # three corners on a line have no circle
    smallest = radius2.argmin(axis=1)
    rows = np.arange(len(points))
    part = weights[rows, smallest] / length
    part /= part.sum(axis=1, keepdims=True)
    centre = (part @ corners)[:, :2]
    way = np.column_stack([centre, np.full(len(points), z)]) - points
    distance = np.linalg.norm(way, axis=1)
    least = radius2[rows, smallest]
    return Cones(
        centre,
        way / distance[:, None],
        distance,
        versine=least / (1 + np.sqrt((1 - least).clip(min=0))),
    )


def powers(cones: Cones, upwards: Array) -> Array:
    """Flux of points of intensity 1 / 2π in their cones, shape (k,).

    `cones`: the cones; `upwards` (3,): intensity goes with the cosine to this unit vector, as far
    as that is positive; 0 for light that is even.
    """
    if not upwards.any():
        return cones.versine
    # Gauss's rule over the angle to the axis, on both sides of where the cone meets the horizon.
    node, weight = np.polynomial.legendre.leggauss(_NODES)
    rim = 2 * np.arcsin(np.sqrt(cones.versine / 2))
    found = np.zeros(len(rim))
    cosine = (cones.axis @ upwards)[:, None]
    sine = np.sqrt((1 - cosine**2).clip(min=0))
    level = np.minimum(np.pi / 2 - np.arccos(cosine[:, 0].clip(-1, 1)), rim).clip(min=0)
    for low, high in ((np.zeros_like(rim), level), (level, rim)):
        angle = low[:, None] + (high - low)[:, None] * (node + 1) / 2
        light = _around(np.cos(angle) * cosine, np.sin(angle) * sine)
        found += (np.sin(angle) * light) @ weight * (high - low) / 2
    return np.asarray(found / (2 * np.pi))


def _around(mean: Array, amplitude: Array) -> Array:
    """∫ max(mean + amplitude cos φ, 0) dφ over a full turn; amplitudes are not negative."""
    part = np.divide(-mean, amplitude, out=np.where(mean >= 0, -1.0, 1.0), where=amplitude > 0)
    half = np.arccos(part.clip(-1, 1))
    return np.asarray(2 * (mean * half + amplitude * np.sin(half)))


def _squared_chords(corners: Array, ways: Array, length: Array) -> Array:
    """Squared distances of the corners' unit vectors, shape (k, 4, 4)."""
    apart = corners[:, None] - corners
    sums = ways[:, :, None] + ways[:, None, :]
    longer = (apart * sums).sum(axis=3) / (length[:, :, None] + length[:, None, :])
    chord2 = np.square(apart).sum(axis=2) - np.square(longer)
    return np.asarray(chord2 / (length[:, :, None] * length[:, None, :]))


def _centres(chord2: Array) -> list[Array]:
    """Weights of the corners, shape (k, 4), that make the possible centres of the ball."""
    found = []
    for pair in combinations(range(4), 2):
        weights = np.zeros((len(chord2), 4))
        weights[:, pair] = 0.5
        found.append(weights)
    for i, j, k in combinations(range(4), 3):
        a, b, c = chord2[:, j, k], chord2[:, i, k], chord2[:, i, j]
        weights = np.zeros((len(chord2), 4))
        # Barycentric coordinates of the centre of the circle, from squared sides.
        weights[:, [i, j, k]] = np.stack(
            [a * (b + c - a), b * (c + a - b), c * (a + b - c)], axis=1
        )
        with np.errstate(invalid="ignore", divide="ignore"):
            found.append(weights / weights.sum(axis=1, keepdims=True))
    return found
