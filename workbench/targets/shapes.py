"""Built-in targets, drawn as polygons with exact pixel coverage, centred on the receiver."""

from collections.abc import Sequence
from itertools import combinations

import numpy as np

from workbench.arrays import Array
from workbench.scene import (
    AnyReceiver,
    BallTarget,
    BeamTarget,
    FlameTarget,
    RectangleTarget,
    RingTarget,
    TextTarget,
    TopHatTarget,
)
from workbench.targets.raster import coverage, paint, put
from workbench.targets.text import picture_of_text

_CORNERS_OF_DISC = 1440
_POINTS_PER_CURVE = 64
_SAMPLES, _STEPS = 4, 4096  # samples of a beam along each side of a pixel; steps of its profile

# The flame: three tongues in a box of height 1 around the origin. Each is a closed chain of
# cubic Bézier curves; of each curve the first point and the two handles are listed, its end is
# the first point of the next.
_TONGUES = (
    (  # the middle one, leaning right and curling back at the tip
        ((0.02, -0.30), (-0.16, -0.22), (-0.17, -0.05)),
        ((-0.10, 0.06), (-0.03, 0.17), (0.09, 0.27)),
        ((0.03, 0.50), (0.22, 0.36), (0.25, 0.18)),
        ((0.13, 0.00), (0.07, -0.09), (0.06, -0.19)),
    ),
    (  # left, embracing it
        ((-0.03, -0.50), (-0.34, -0.46), (-0.46, -0.12)),
        ((-0.25, 0.16), (-0.22, 0.20), (-0.19, 0.25)),
        ((-0.20, 0.34), (-0.07, 0.22), (-0.095, 0.12)),
        ((-0.17, 0.02), (-0.32, -0.18), (-0.22, -0.38)),
    ),
    (  # right, embracing it
        ((0.03, -0.50), (0.34, -0.46), (0.42, -0.16)),
        ((0.30, 0.16), (0.30, 0.05), (0.26, -0.01)),
        ((0.19, -0.11), (0.12, -0.21), (0.19, -0.36)),
    ),
)

# The ball: light from the upper left, in front.
_TOWARDS_LIGHT = np.array([-0.6, 0.7, 0.35])
_DARKEST = 0.15


Builtin = (
    TopHatTarget | FlameTarget | BallTarget | RectangleTarget | RingTarget | BeamTarget | TextTarget
)
"""A target that is not read from a file."""


def draw(target: Builtin, receiver: AnyReceiver, scale: float) -> Array:
    """Draw a built-in target (n_y, n_x) in [0, 1], row 0 at +y, shrunk by ``scale``."""
    half_u, half_v = (scale * half for half in receiver.half_extent)
    unit = min(half_u, half_v)
    match target:
        case TopHatTarget():
            return top_hat(receiver, unit * target.radius)
        case FlameTarget():
            return flame(receiver, 2 * unit * target.height)
        case BallTarget():
            return ball(receiver, unit * target.radius)
        case RectangleTarget():
            return rectangle(receiver, (half_u * target.width, half_v * target.height))
        case RingTarget():
            radius = unit * target.radius
            return top_hat(receiver, radius) - top_hat(receiver, radius * target.inner)
        case BeamTarget():
            return beam(receiver, unit, target.profile)
        case TextTarget():
            return put(picture_of_text(target.text), receiver, (half_u, half_v))


def top_hat(receiver: AnyReceiver, radius: float) -> Array:
    """Uniform disc (n_y, n_x); ``radius`` in coordinates of the receiver."""
    angle = 2 * np.pi * np.arange(_CORNERS_OF_DISC) / _CORNERS_OF_DISC
    return coverage(radius * np.stack([np.cos(angle), np.sin(angle)], axis=1), receiver)


def beam(receiver: AnyReceiver, unit: float, profile: Sequence[tuple[float, float]]) -> Array:
    """Rotationally symmetric beam (n_y, n_x) through points of radius, in units, and level.

    Between the points the level is a monotone cubic (Fritsch and Carlson), flat in the middle.
    """
    from scipy.interpolate import PchipInterpolator  # slow import

    radii, levels = np.array(profile).T
    if radii[0] > 0:
        radii, levels = np.append(0.0, radii), np.append(levels[0], levels)
    curve = PchipInterpolator(np.append(-radii[:0:-1], radii), np.append(levels[:0:-1], levels))
    n_x, n_y = receiver.pixels
    columns, rows = ((np.arange(n * _SAMPLES) + 0.5) / _SAMPLES for n in (n_x, n_y))
    away = receiver.from_middle(*receiver.from_pixels(columns, rows[:, None])) / unit
    steps = np.linspace(0.0, radii[-1], _STEPS)
    light = np.interp(away, steps, np.maximum(curve(steps), 0.0), right=0.0)
    averages: Array = light.reshape(n_y, _SAMPLES, n_x, _SAMPLES).mean(axis=(1, 3))
    return averages


def rectangle(receiver: AnyReceiver, half_extent: tuple[float, float]) -> Array:
    """Uniform rectangle (n_y, n_x); half-extent in coordinates of the receiver."""
    corners = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    return coverage(corners * half_extent, receiver)


def flame(receiver: AnyReceiver, height: float) -> Array:
    """Logo of a flame with three curved tongues (n_y, n_x), of a height in receiver coordinates."""
    return paint(((height * _closed_curve(np.array(tongue)), 1.0) for tongue in _TONGUES), receiver)


def ball(receiver: AnyReceiver, radius: float) -> Array:
    """Ball of triangular facets (n_y, n_x), greys from 0.15 to 1, linear in Lambert's cosine."""
    facets, greys = _ball_facets()
    return paint(zip(radius * facets, greys, strict=True), receiver)


def _closed_curve(curves: Array) -> Array:
    ends = np.roll(curves[:, :1], -1, axis=0)
    control = np.concatenate([curves, ends], axis=1)  # [curve, 4, xy]
    t = np.arange(_POINTS_PER_CURVE) / _POINTS_PER_CURVE
    bernstein = np.stack([(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t**2 * (1 - t), t**3])
    points: Array = np.einsum("bt,cbx->ctx", bernstein, control).reshape(-1, 2)
    return points


def _ball_facets() -> tuple[Array, Array]:
    facets = _geodesic_sphere() @ _turned().T
    normals = np.cross(facets[:, 1] - facets[:, 0], facets[:, 2] - facets[:, 0])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    normals *= np.sign(np.sum(normals * facets[:, 0], axis=1, keepdims=True))  # outwards
    # The ball is convex: facets that face the viewer are fully visible.
    seen = normals[:, 2] > 0
    towards = _TOWARDS_LIGHT / np.linalg.norm(_TOWARDS_LIGHT)
    cosine = normals[seen] @ towards
    # Lambert's cosine, stretched over the visible facets: clipped at the terminator, the whole
    # shadow side would have one grey.
    grey = _DARKEST + (1 - _DARKEST) * (cosine - cosine.min()) / np.ptp(cosine)
    return facets[seen, :, :2], grey


def _geodesic_sphere() -> Array:
    golden = (1 + 5**0.5) / 2
    signs = [(a, b) for a in (-1.0, 1.0) for b in (-golden, golden)]
    corners = np.array([np.roll([0.0, a, b], k) for k in range(3) for a, b in signs])
    edge = 2.0
    faces = [
        face
        for face in map(np.array, combinations(corners, 3))
        if np.allclose(np.linalg.norm(face - np.roll(face, 1, axis=0), axis=1), edge)
    ]
    facets = []
    for a, b, c in faces:
        ab, bc, ca = a + b, b + c, c + a
        facets += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
    sphere = np.array(facets)
    unit: Array = sphere / np.linalg.norm(sphere, axis=2, keepdims=True)
    return unit


def _turned() -> Array:
    a, b = np.deg2rad([17.0, 27.0])
    about_x = np.array([[1, 0, 0], [0, np.cos(a), -np.sin(a)], [0, np.sin(a), np.cos(a)]])
    about_y = np.array([[np.cos(b), 0, np.sin(b)], [0, 1, 0], [-np.sin(b), 0, np.cos(b)]])
    rotation: Array = about_x @ about_y
    return rotation
