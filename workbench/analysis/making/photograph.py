"""Comparison of a photograph of the projected light with the prediction, and likely causes.

A photograph shows the receiver at a slant, through a lens that darkens its corners, and with the
response of its sensor. Four corners of the receiver rectify it (Hartley and Zisserman, Multiple
View Geometry, section 4.1); darkening by even powers of the radius, a power of the response and
an even background are fitted along with causes in the set-up: distance and tilt of the receiver,
and the size of the source.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from workbench.analysis.scatter import STUDENT_T
from workbench.analysis.validation import DARK
from workbench.arrays import Array
from workbench.design.levels import as_compared
from workbench.errors import Refused, RunFailed
from workbench.messages import Message
from workbench.progress import Steps
from workbench.scene import Scene
from workbench.scene.making.uncertainty import (
    Uncertainty,
    farther,
    way_to,
    with_source_size,
)
from workbench.scene.turning import tilted
from workbench.targets.raster import averaged

if TYPE_CHECKING:
    from scipy.optimize import OptimizeResult

_PER_PIXEL = 3  # samples of the photograph along each axis of a pixel of the receiver
_LEAST_CORRELATION = 0.3  # of a photograph in which the picture is
_NOT_WITHIN = Message(
    "the picture of this lens is not within these corners; mark those of the receiver"
)
# Rms widths, in pixels, of the Gaussians that images are averaged by in each round of the fit: from
# coarse to fine, or details would meet the wrong details.
_ROUNDS = (6.0, 3.0, 1.5, 0.0, 0.0)
Corner = tuple[float, float]


class Cause(NamedTuple):
    """A deviation of the set-up that a photograph shows."""

    name: str
    value: float
    off: float  # half of the interval of 95 % by statistics alone
    unit: str  # "scene" for lengths in scene units
    # Part of the squares of differences that comes back without this cause, of what all explain.
    explains: float

    def to_data(self) -> dict[str, Any]:
        """The cause by names, for JSON."""
        return self._asdict()


class Photograph(NamedTuple):
    """A photograph compared with the light that a lens should throw."""

    light: Array  # (n_y, n_x), rectified, its mean 1
    predicted: Array  # (n_y, n_x), with the causes and seen by the same camera
    apart: float  # relative L2 difference to the exact set-up, after scale and camera alone
    left: float  # the same with the causes
    causes: tuple[Cause, ...]  # the likeliest first
    response: float  # power of the sensor's response, 1 if the photograph's tone is right
    darkening: float  # light in the farthest corner over that in the middle
    turned: str  # how the photograph shows the receiver: "" or what was turned


def rectified(picture: Array, corners: Sequence[Corner], shape: tuple[int, int]) -> Array:
    """Return the light (n_y, n_x) of a quadrilateral in a picture.

    `corners`: columns and rows in pixels of the picture of the receiver's corners, from that of row
    0 and column 0 around it along row 0. Raises `Refused` if they make no convex quadrilateral in
    the picture.
    """
    from scipy.ndimage import map_coordinates  # slow import

    column, row = _samples(corners, picture.shape, shape)
    return averaged(map_coordinates(picture, [row, column], order=1, mode="nearest"), shape)


def _samples(
    corners: Sequence[Corner], size: tuple[int, ...], shape: tuple[int, int]
) -> tuple[Array, Array]:
    """Columns and rows in a picture of samples of the pixels of a receiver."""
    n_y, n_x = (_PER_PIXEL * n for n in shape)
    u, v = np.meshgrid((np.arange(n_x) + 0.5) / n_x, (np.arange(n_y) + 0.5) / n_y)
    flat = np.stack([u, v, np.ones_like(u)])
    x, y, w = np.tensordot(_homography(corners, size), flat, axes=1)
    return x / w - 0.5, y / w - 0.5


def _homography(corners: Sequence[Corner], shape: tuple[int, ...]) -> Array:
    """What takes (u, v, 1) of the unit square to a multiple of (column, row, 1)."""
    places = np.array(corners, dtype=np.float64)
    _check_corners(places, shape)
    rows = []
    for (u, v), (x, y) in zip(((0, 0), (1, 0), (1, 1), (0, 1)), places, strict=True):
        rows.append([u, v, 1, 0, 0, 0, -u * x, -v * x, -x])
        rows.append([0, 0, 0, u, v, 1, -u * y, -v * y, -y])
    return np.asarray(np.linalg.svd(np.array(rows))[2][-1].reshape(3, 3))


def _check_corners(places: Array, shape: tuple[int, ...]) -> None:
    if places.shape != (4, 2) or not np.isfinite(places).all():
        raise Refused("corners", Message("four places x,y in pixels of the photograph are needed"))
    n_y, n_x = shape
    if (places < 0).any() or (places > (n_x, n_y)).any():
        beside = Message("are beside the photograph of {n_x} × {n_y} pixels", n_x=n_x, n_y=n_y)
        raise Refused("corners", beside)
    sides = np.roll(places, -1, axis=0) - places
    turns = sides[:, 0] * np.roll(sides[:, 1], -1) - sides[:, 1] * np.roll(sides[:, 0], -1)
    if not (np.all(turns > 0) or np.all(turns < 0)):
        raise Refused("corners", Message("make no convex quadrilateral in this order"))


_WAYS: dict[str, Callable[[Array], Array]] = {
    "": lambda image: image,
    Message("turned by 180°"): lambda image: image[::-1, ::-1],
    Message("mirrored left to right"): lambda image: image[:, ::-1],
    Message("mirrored top to bottom"): lambda image: image[::-1],
}


def comparing(
    scene: Scene,
    target: Array,
    heights: Mapping[str, Array],
    picture: Array,
    corners: Sequence[Corner],
) -> Steps[Photograph]:
    """Compare a photograph with the light of a lens in steps.

    `picture` (rows, columns): light by its tone; `corners`: see `rectified`. Raises `Refused` if
    the receiver is no plane, or the picture is not in the photograph; `RunFailed` if the lens sends
    no light to it.
    """
    from scipy.ndimage import gaussian_filter  # slow import

    first = scene.single[0].model_copy(update={"uncertainty": Uncertainty()})
    if first.receiver.stands_at is None:
        raise Refused("images[0].receiver.kind", Message("a photograph shows a plane; 'plane'"))
    changes = _changes(first)
    exact = _light(first, target, heights)
    seen = rectified(picture, corners, target.shape)
    if np.ptp(seen) == 0:
        raise Refused("photograph", _NOT_WITHIN)
    seen = seen / np.abs(seen).mean()
    way = max(_WAYS, key=lambda each: _correlation(_WAYS[each](seen), exact))
    seen, radius = (_WAYS[way](each) for each in (seen, _radii(corners, picture.shape, seen.shape)))
    if _correlation(seen, exact) < _LEAST_CORRELATION:
        raise Refused("photograph", _NOT_WITHIN)
    values, camera = np.zeros(len(changes)), _CAMERA
    for number, width in enumerate(_ROUNDS):
        base = _light(_changed(first, changes, values), target, heights)
        slopes = []
        for axis, change in enumerate(changes):
            high, low = (
                _light(_changed(first, changes, values + sign * step), target, heights)
                for sign in (1, -1)
                for step in [change.step * (np.arange(len(changes)) == axis)]
            )
            slopes.append((high - low) / (2 * change.step))
            yield (number + (axis + 1) / len(changes)) / len(_ROUNDS)
        averaged = partial(gaussian_filter, sigma=width, mode="nearest")
        model = _Model(averaged(seen), radius, averaged(base), [averaged(s) for s in slopes])
        fit = model.fitted(camera, range(len(changes)))
        camera, step = fit.x[: len(_CAMERA)], fit.x[len(_CAMERA) :]
        values = values + step
    spread = np.sqrt(np.diag(np.linalg.pinv(fit.jac.T @ fit.jac)) * 2 * fit.cost / seen.size)
    alone = _Model(seen, radius, exact, ()).fitted(_CAMERA, ())
    causes = []
    for axis, change in enumerate(changes):
        without = values.copy()
        without[axis] = 0.0
        base = _light(_changed(first, changes, without), target, heights)
        worse = _Model(seen, radius, base, ()).fitted(_CAMERA, ()).cost - fit.cost
        part = min(max(worse / max(alone.cost - fit.cost, np.finfo(float).tiny), 0.0), 1.0)
        off = STUDENT_T * float(spread[len(_CAMERA) + axis])
        causes.append(Cause(change.name, float(values[axis]), off, change.unit, part))
    causes.sort(key=lambda cause: -cause.explains)
    size = float(np.linalg.norm(seen))
    return Photograph(
        seen,
        model.image(fit.x),
        math.sqrt(2 * alone.cost) / size,
        math.sqrt(2 * fit.cost) / size,
        tuple(causes),
        math.exp(camera[2]),
        1 + camera[3] + camera[4],
        way,
    )


class _Change(NamedTuple):
    name: str
    unit: str
    step: float  # of differences
    apply: Callable[[Scene, float], Scene]


def _changes(scene: Scene) -> list[_Change]:
    """Deviations that are looked for, each by how much it is."""
    distance = float(np.linalg.norm(way_to(scene, scene.receiver)))
    found = [
        _Change(Message("distance"), "scene", 0.01 * distance, farther),
        _Change(Message("tilt about x"), "°", 1.0, partial(_tilted, 0)),
        _Change(Message("tilt about y"), "°", 1.0, partial(_tilted, 1)),
    ]
    if scene.source.continuous:
        found.append(_Change(Message("source size"), "times", 0.1, with_source_size))
    return found


def _changed(scene: Scene, changes: Sequence[_Change], values: Array) -> Scene:
    for change, value in zip(changes, values.tolist(), strict=True):
        scene = change.apply(scene, value)
    return scene


def _tilted(axis: int, scene: Scene, by: float) -> Scene:
    angles = [0.0, 0.0, 0.0]
    angles[axis] = by
    receiver = scene.receiver
    turn = receiver.sides.T @ tilted((angles[0], angles[1], angles[2]))
    return scene.with_receiver(receiver.seen(None, turn, 1.0))


def _light(scene: Scene, target: Array, heights: Mapping[str, Array]) -> Array:
    """Light of a lens on its receiver, its mean 1."""
    image = as_compared(scene, target, heights).irradiance
    if not image.any():
        raise RunFailed(DARK)
    return np.asarray(image / image.mean())


def _correlation(one: Array, other: Array) -> float:
    return float(np.corrcoef(one.ravel(), other.ravel())[0, 1])


def _radii(corners: Sequence[Corner], size: tuple[int, ...], shape: tuple[int, int]) -> Array:
    """Distances of pixels of the receiver from the middle of a photograph; 1 in its corners."""
    column, row = _samples(corners, size, shape)
    x, y = column - size[1] / 2, row - size[0] / 2
    return averaged(np.hypot(x, y) / math.hypot(*(n / 2 for n in size)), shape)


# Logarithm of the scale, background, logarithm of the response, darkening by r² and r⁴.
_CAMERA = np.zeros(5)


class _Model:
    """Photograph of light that changes linearly with causes, near a set-up."""

    def __init__(self, seen: Array, radius: Array, base: Array, slopes: Sequence[Array]) -> None:
        self._seen, self._square = seen, radius**2
        self._base, self._slopes = base, slopes

    def fitted(self, camera: Array, free: Sequence[int]) -> "OptimizeResult":
        """Camera, and the causes with these numbers, that come closest."""
        from scipy.optimize import least_squares  # slow import

        def residual(x: Array) -> Array:
            values = np.zeros(len(self._slopes))
            values[list(free)] = x[len(_CAMERA) :]
            return (self.image(np.concatenate([x[: len(_CAMERA)], values])) - self._seen).ravel()

        return least_squares(residual, np.concatenate([camera, np.zeros(len(free))]))

    def image(self, x: Array) -> Array:
        """The photograph by the camera and the causes."""
        scale, background, response, second, fourth = x[: len(_CAMERA)]
        light = self._base.copy()
        for value, slope in zip(x[len(_CAMERA) :], self._slopes, strict=True):
            light += value * slope
        dark = 1 + second * self._square + fourth * self._square**2
        shown = np.maximum(dark * light * math.exp(scale), 1e-9) ** math.exp(response)
        return np.asarray(shown + background)
