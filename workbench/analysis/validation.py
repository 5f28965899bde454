"""An independent check of a lens: fresh random rays, another tracer, the untouched target.

Nothing of the optimiser's path is used: the face comes from `scipy.interpolate`, refraction from
the angles at it, the image from counting rays in pixels, all in float64. A lens that is fitted to
the optimiser's fixed ray grid or to its smoothing filter is found out here.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt
from scipy.interpolate import NdBSpline

from workbench.errors import RunFailed
from workbench.optics.ledger import Ledger
from workbench.scene import Lens, Scene, Screen

Array = npt.NDArray[np.float64]

# Batches of rays, 4 × 4: enough to estimate their scatter.
_SIDE = 4
_BATCHES = _SIDE * _SIDE
# Rays traced at once: their arrays stay within the cache.
_AT_ONCE = 1 << 15


@dataclass(frozen=True)
class Validation:
    """What an independent trace says of a lens.

    Attributes
    ----------
    loss : float
        Paper's loss (section 2.4): Frobenius norm of the difference between image and target,
        each divided by its sum, over √(n_x n_y).
    relative_l2 : float
        The same norm over that of the normalised target; independent of the number of pixels.
        Scatter of the rays from pixel to pixel is in it, and falls with the number of rays.
    efficiency : float
        Part of the emitted flux that lands on the screen.
    ledger : Ledger
        Where the light went.
    rays : int
        Rays traced.
    noise : float
        Monte-Carlo standard error of ``relative_l2``: standard deviation of its value for 16
        batches of the rays, over √16. The batches exclude each other, which makes the image of
        all rays better than this tells: an upper estimate.
    irradiance : ndarray, shape (n_y, n_x)
        Flux per area on the screen, row 0 at +y.
    """

    loss: float
    relative_l2: float
    efficiency: float
    ledger: Ledger
    rays: int
    noise: float
    irradiance: Array


def validate(
    scene: Scene, target: Array, control_points: Array, rays: int = 4_000_000, seed: int = 1
) -> Validation:
    """Trace a lens anew.

    One ray starts at a random place in each of ``rays`` equal cells of the aperture. Memory does
    not grow with their number.

    Parameters
    ----------
    scene : Scene
        Lens, source and screen; filter and run settings play no part.
    target : ndarray, shape (n_y, n_x)
        The wished image in any scale, row 0 at +y.
    control_points : ndarray, shape (n_u, n_v)
        Heights z of the exit face's control points, scene units.
    rays : int
        Rays to trace at least; rounded up to whole batches of a grid.
    seed : int
        The same seed gives the same rays.

    Raises
    ------
    RunFailed
        If no light reaches the screen.
    """
    lens, screen = scene.lens, scene.screen
    face = _Face(lens, control_points)
    bundle = _Bundle(lens.half_width, rays, seed)
    wanted = (target / target.max()).ravel()
    wanted /= wanted.sum()
    entrance_loss = _schlick(lens.index, 0.0)
    power = (1 - entrance_loss) / bundle.rays  # of each ray behind the entrance face

    flux = np.zeros(wanted.size)  # of each pixel
    off_screen = reflected = total_reflection = 0.0
    distances = []  # of the batches' images to the target
    for batch in range(_BATCHES):
        batch_flux = np.zeros_like(flux)
        for x, y in bundle.batch(batch):
            hits = face.refract(x, y, screen.z)
            arriving = power * (1 - hits.reflectance)
            pixel = _pixels(screen, hits)
            inside = pixel >= 0
            np.add.at(batch_flux, pixel[inside], arriving[inside])
            off_screen += float(arriving[~inside].sum())
            reflected += power * float(hits.reflectance.sum())
            total_reflection += power * (x.size - hits.x.size)
        flux += batch_flux
        distances.append(_distance(batch_flux, wanted))

    ledger = Ledger(
        emitted=1.0,
        on_screen=float(flux.sum()),
        off_screen=off_screen,
        missed_lens=0.0,
        left_side=0.0,
        total_reflection=total_reflection,
        fresnel_entrance=entrance_loss,
        fresnel_exit=reflected,
    )
    if ledger.on_screen == 0:
        raise RunFailed("no light of this lens reaches the screen, so there is no image to judge")
    distance = _distance(flux, wanted)
    return Validation(
        loss=distance / math.sqrt(wanted.size),
        relative_l2=distance / float(np.linalg.norm(wanted)),
        efficiency=ledger.efficiency,
        ledger=ledger,
        rays=bundle.rays,
        noise=float(np.std(distances, ddof=1) / np.linalg.norm(wanted)) / math.sqrt(_BATCHES),
        irradiance=flux.reshape(target.shape) / screen.pixel_area,
    )


class _Hits(NamedTuple):
    """Rays on the screen plane, without the totally reflected ones; arrays of shape (m,)."""

    x: Array
    y: Array
    reflectance: Array  # at the exit face


class _Bundle:
    """Places on the aperture, one at random in each of equal cells.

    The cells lie in blocks of 4 × 4, and each batch of rays has one of every block. A batch is an
    even sample by itself, and all of them together fill every cell.
    """

    def __init__(self, half_width: tuple[float, float], rays: int, seed: int) -> None:
        r_x, r_y = half_width
        blocks = max(rays, 1) / _BATCHES
        self._half_width = half_width
        self._columns = math.ceil(math.sqrt(blocks * r_x / r_y))
        self._rows = math.ceil(blocks / self._columns)
        self._seed = seed
        self.rays = _BATCHES * self._columns * self._rows

    def batch(self, batch: int) -> Iterator[tuple[Array, Array]]:
        """Positions x and y, scene units, each of shape (m,), some columns of blocks at a time."""
        order = np.random.default_rng([self._seed, 0])  # the same for each batch
        jitter = np.random.default_rng([self._seed, 1 + batch])
        r_x, r_y = self._half_width
        step = max(_AT_ONCE // self._rows, 1)
        for first in range(0, self._columns, step):
            column = np.arange(first, min(first + step, self._columns))[:, None]
            row = np.arange(self._rows)[None, :]
            size = (column.size, self._rows)
            cell = (order.integers(_BATCHES, size=size) + batch) % _BATCHES
            across = column + (cell // _SIDE + jitter.random(size)) / _SIDE
            up = row + (cell % _SIDE + jitter.random(size)) / _SIDE
            x = (across.ravel() * (2 / self._columns) - 1) * r_x
            y = (up.ravel() * (2 / self._rows) - 1) * r_y
            yield x, y


class _Face:
    """The exit face of a lens, lit from inside by light along +z."""

    def __init__(self, lens: Lens, control_points: Array) -> None:
        knots = tuple(
            np.concatenate([np.full(p, -r), np.linspace(-r, r, n - p + 1), np.full(p, r)])
            for r, n, p in zip(lens.half_width, lens.control_points, lens.degree, strict=True)
        )
        self._height = NdBSpline(knots, control_points, lens.degree)
        self._index = lens.index

    def refract(self, x: Array, y: Array, screen_z: float) -> _Hits:
        """Follow rays from (x, y) on the face to the plane z = screen_z.

        The face's normal leans back by the angle arctan |∇z| from the ray, in the plane that
        holds ∇z. Snell's law enlarges this angle, which turns the ray towards ∇z by the difference.
        """
        places = np.stack([x, y], axis=-1)
        height = self._height(places)
        slope_x = self._height(places, nu=(1, 0))
        slope_y = self._height(places, nu=(0, 1))
        slope = np.hypot(slope_x, slope_y)
        incidence = np.arctan(slope)
        sine = self._index * np.sin(incidence)
        passes = sine < 1  # the rest is totally reflected
        if not passes.all():
            kept = (x, y, height, slope_x, slope_y, slope, incidence, sine)
            x, y, height, slope_x, slope_y, slope, incidence, sine = (a[passes] for a in kept)
        refraction = np.arcsin(sine)
        sideways = np.tan(refraction - incidence) * (screen_z - height)
        per_slope = np.divide(sideways, slope, out=np.zeros_like(slope), where=slope > 0)
        return _Hits(
            x + slope_x * per_slope, y + slope_y * per_slope, _schlick(self._index, refraction)
        )


def _schlick(index: float, angle: Any) -> Any:
    """Schlick's reflectance (1994, eq. 24) for an angle in the thinner medium."""
    head_on = ((index - 1) / (index + 1)) ** 2
    return head_on + (1 - head_on) * (1 - np.cos(angle)) ** 5


def _pixels(screen: Screen, hits: _Hits) -> npt.NDArray[np.int64]:
    """Number of the pixel of each ray, counted along the rows; −1 beside the screen."""
    column, row = screen.to_pixels(hits.x, hits.y)
    n_x, n_y = screen.pixels
    inside = (column >= 0) & (column < n_x) & (row >= 0) & (row < n_y)
    column, row = np.where(inside, column, 0), np.where(inside, row, 0)
    return np.where(inside, row.astype(np.int64) * n_x + column.astype(np.int64), -1)


def _distance(flux: Array, wanted: Array) -> float:
    """Frobenius norm of the difference of images that sum to 1; no light counts as a dark image."""
    total = flux.sum()
    return float(np.linalg.norm((flux / total if total > 0 else flux) - wanted))
