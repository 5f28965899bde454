"""The exit face of a lens as `scipy.interpolate` sees it: where rays meet it, how they go on."""

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt
from scipy.interpolate import NdBSpline

from workbench.scene import Lens

Array = npt.NDArray[np.float64]
Flags = npt.NDArray[np.bool_]

# Looks for a change of sign per knot span, along rays that may meet the face more than once.
_LOOKS = 16
# Steps of the false position, which needs some ten, and then halves what is left.
_STEPS = 100


class Refracted(NamedTuple):
    """Rays behind the exit face, without the totally reflected ones.

    Attributes
    ----------
    x, y : ndarray, shape (m,)
        Where they cross the screen's plane; infinite for those that never do.
    reflectance : ndarray, shape (m,)
        Part of their light that the face reflected.
    passes : ndarray of bool, shape (n,)
        Which of the n arriving rays these m are.
    """

    x: Array
    y: Array
    reflectance: Array
    passes: Flags


class Face:
    """The exit face, lit from inside.

    Parameters
    ----------
    lens : Lens
        The lens.
    control_points : ndarray, shape (n_u, n_v)
        Control heights, scene units.
    """

    def __init__(self, lens: Lens, control_points: Array) -> None:
        knots = [
            np.concatenate([np.full(p, -r), np.linspace(-r, r, n - p + 1), np.full(p, r)])
            for r, n, p in zip(lens.half_width, lens.control_points, lens.degree, strict=True)
        ]
        self._height = NdBSpline(tuple(knots), control_points, lens.degree)
        self._half_width = np.array(lens.half_width)
        self._index = lens.index
        self._entrance = lens.entrance_z
        spans = np.array(lens.control_points) - np.array(lens.degree)
        self._density = spans / (2 * self._half_width)  # knot spans per length
        self._span = float(control_points.min()), float(control_points.max())
        # A spline is never steeper than the steepest of its derivative's coefficients.
        self._steepest = []
        for axis, (t, p) in enumerate(zip(knots, lens.degree, strict=True)):
            width = np.expand_dims(t[p + 1 : -1] - t[1 : -p - 1], 1 - axis)
            slopes = np.abs(np.diff(control_points, axis=axis)) * p / width
            self._steepest.append(float(slopes.max()))

    def height(self, places: Array) -> Array:
        """Height of the face at places of shape (m, 2)."""
        return np.asarray(self._height(places))

    def meet(self, start: Array, slope: Array) -> tuple[Array, Flags]:
        """First meetings of rays with the face.

        Parameters
        ----------
        start : ndarray, shape (m, 2)
            Where the rays leave the entrance face.
        slope : ndarray, shape (m, 2)
            How far they go sideways per height.

        Returns
        -------
        rise : ndarray, shape (m,)
            Height above the entrance face where they meet the exit face.
        meets : ndarray of bool, shape (m,)
            False for rays that leave through the side before.
        """

        def over(rise: Array, rays: Any = slice(None)) -> Array:
            places = start[rays] + slope[rays] * rise[:, None]
            inside = np.clip(places, -self._half_width, self._half_width)
            return self.height(inside) - self._entrance - rise

        room = np.where(slope > 0, self._half_width - start, self._half_width + start)
        side = np.divide(room, np.abs(slope), out=np.full_like(room, np.inf), where=slope != 0).min(
            axis=1
        )
        lowest, highest = (z - self._entrance for z in self._span)
        slack = 1e-13 * highest
        low = np.minimum(side, lowest - slack)
        high = np.minimum(side, highest + slack)
        # A face that climbs slower than a ray is met but once.
        climb = np.abs(slope) @ self._steepest
        ray = np.flatnonzero(climb >= 1)
        if len(ray):
            crossed = (np.abs(slope[ray]) @ self._density) * (high - low)[ray]
            looks = _LOOKS * (2 + int(crossed.max()))
            low[ray], high[ray] = _first_change(over, ray, low[ray], high[ray], looks)
        at_high = over(high)
        meets = (side > lowest) & (at_high <= 0)
        rays = np.flatnonzero(meets)
        rise = high
        rise[rays] = _false_position(over, rays, low[rays], high[rays], at_high[rays])
        return rise, meets

    def refract(self, places: Array, height: Array, direction: Array, screen_z: float) -> Refracted:
        """Follow rays from the face to the plane z = screen_z.

        Snell's law enlarges the angle between ray and normal, in the plane that holds both.

        Parameters
        ----------
        places : ndarray, shape (n, 2)
            Where the rays meet the face.
        height : ndarray, shape (n,)
            The face's height there.
        direction : ndarray, shape (n, 3)
            Unit vectors of the rays in the lens.
        screen_z : float
            Where the screen is.
        """
        normal = np.stack(
            [
                -self._height(places, nu=(1, 0)),
                -self._height(places, nu=(0, 1)),
                np.ones(len(places)),
            ],
            axis=-1,
        )
        normal /= np.linalg.norm(normal, axis=1, keepdims=True)
        along = (direction * normal).sum(axis=1, keepdims=True)
        aside = direction - along * normal
        sine = np.linalg.norm(aside, axis=1)
        passes = (self._index * sine < 1) & (along[:, 0] > 0)
        places, height, normal, aside, sine = (
            a[passes] for a in (places, height, normal, aside, sine)
        )
        angle = np.arcsin(self._index * sine)
        out = np.cos(angle)[:, None] * normal + self._index * aside
        onward = out[:, 2] > 0
        path = np.divide(
            screen_z - height, out[:, 2], out=np.full_like(height, np.inf), where=onward
        )
        hit = np.where(onward[:, None], places + out[:, :2] * path[:, None], np.inf)
        return Refracted(hit[:, 0], hit[:, 1], schlick(self._index, angle), passes)


def schlick(index: float, angle: Any) -> Any:
    """Schlick's reflectance (1994, eq. 24) for an angle in the thinner medium."""
    head_on = ((index - 1) / (index + 1)) ** 2
    return head_on + (1 - head_on) * (1 - np.cos(angle)) ** 5


def _first_change(over: Any, rays: Any, low: Array, high: Array, looks: int) -> tuple[Array, Array]:
    """The first of many equal steps of each ray at whose end it is no longer below the face."""
    bottom, width, last = low, (high - low) / looks, high
    below = np.ones(len(low), dtype=bool)
    for look in range(1, looks + 1):
        here = bottom + look * width if look < looks else last
        crossed = below & (over(here, rays) <= 0)
        high = np.where(crossed, here, high)
        below &= ~crossed
        low = np.where(below & (look < looks), here, low)
    return low, high


def _false_position(over: Any, rays: Any, low: Array, high: Array, at_high: Array) -> Array:
    """Roots of a function that is positive at low and not at high: the Illinois algorithm."""
    at_low = over(low, rays)
    kept = np.zeros(len(low))  # +1: the upper end stayed, −1: the lower one
    middle = high
    for step in range(_STEPS):
        slope = np.where(at_low > at_high, at_low - at_high, 1)
        share = np.where(at_low > 0, at_low / slope, 0) if step % 8 < 7 else 0.5
        middle = low + share * (high - low)
        value = over(middle, rays)
        if (np.abs(value) <= 1e-14 * np.abs(high)).all():
            break
        above = value > 0
        # An end that stays twice counts half: else it would stay for ever.
        at_high = np.where(above, np.where(kept == 1, at_high / 2, at_high), value)
        at_low = np.where(above, value, np.where(kept == -1, at_low / 2, at_low))
        low, high = np.where(above, middle, low), np.where(above, high, middle)
        kept = np.where(above, 1, -1)
    return middle
