"""Receivers as Mitsuba's camera sees them: as pictures of a screen."""

import math
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np
from scipy.sparse import csr_array

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.messages import Message
from workbench.scene import AnyReceiver, FarField, Scene, Screen
from workbench.scene.part import row_of

# How far a screen stands for a far field, in half-widths of the lens: light of opposite rims is
# apart by twice as small an angle, 2e-6 radians or 0.0001 degrees.
_FAR = 1e6
# Beyond this angle from the axis such a screen is too wide.
_MOST = 75.0
# Pixels of the screen for each of the far field along an axis.
_FINER = 24
_MOST_PIXELS = 2048


class Picture(NamedTuple):
    """What the camera takes a picture of.

    Attributes
    ----------
    screen : Screen
        With square pixels.
    to_receiver : csr_array or None
        Which part of the light of each of its pixels, along the rows, goes to each of the
        receiver's; None where they are the same.
    """

    screen: Screen
    to_receiver: csr_array | None = None

    def light(self, flux: Array, receiver: AnyReceiver) -> Array:
        """The light in the receiver's pixels, shape (n_y, n_x)."""
        if self.to_receiver is None:
            return flux
        n_x, n_y = receiver.pixels
        found: Array = (self.to_receiver @ flux.ravel()).reshape(n_y, n_x)
        return found


def picture_of(scene: Scene) -> Picture:
    """The picture of the light on the receiver of a scene.

    Raises
    ------
    Refused
        If pixels of a screen are not square, a far field goes too far to the side, or Mitsuba has
        no camera for receivers of this kind.
    """
    if not isinstance(scene.receiver, tuple(_PICTURES)):
        unknown = Message(
            "Mitsuba has no camera for {kind}; use a plane or a far field", kind=scene.receiver.kind
        )
        raise Refused("images[0].receiver.kind", unknown)
    return row_of(_PICTURES, scene.receiver)(scene.receiver, scene)


def _of_screen(screen: Screen, scene: Scene) -> Picture:
    (r_x, r_y), (n_x, n_y) = screen.half_width, screen.pixels
    if not math.isclose(r_x / n_x, r_y / n_y, rel_tol=1e-6):
        raise Refused(
            "images[0].receiver.pixels",
            f"[{n_x}, {n_y}] on [{r_x:g}, {r_y:g}] are not square, as Mitsuba's camera has "
            "them; as many per length along x and y are needed",
        )
    return Picture(screen)


def _of_far_field(far_field: FarField, scene: Scene) -> Picture:
    """A screen so far that its places are directions."""
    widest = max(abs(c) + r for c, r in zip(far_field.center, far_field.half_angle, strict=True))
    if widest > _MOST:
        raise Refused(
            "images[0].receiver.half_angle",
            f"goes up to {widest:g} degrees; Mitsuba's camera sees up to {_MOST:g}",
        )
    h, v = (
        np.radians(np.linspace(c - r, c + r, 65))
        for c, r in zip(far_field.center, far_field.half_angle, strict=True)
    )
    slope_x, slope_y = np.tan(h), np.tan(v) / np.cos(h)[:, None]
    size = min(
        math.radians(2 * r) / n for r, n in zip(far_field.half_angle, far_field.pixels, strict=True)
    )
    size = max(size / _FINER, max(np.ptp(slope_x), np.ptp(slope_y)) / _MOST_PIXELS)
    middle, counts = [], []
    for slope in (slope_x, slope_y):
        middle.append(float(slope.max() + slope.min()) / 2)
        counts.append(math.ceil(float(np.ptp(slope)) / size))
    last = scene.elements[-1]
    away = _FAR * max(last.half_width)
    x, y, z = last.in_scene(np.array([0.0, 0.0, last.leaving_z])).tolist()
    half_width = counts[0] * size / 2 * away, counts[1] * size / 2 * away
    screen = Screen(
        kind="plane",
        position=(x + middle[0] * away, y + middle[1] * away, z + scene.onwards(far_field) * away),
        half_width=half_width,
        pixels=(min(counts[0], 4096), min(counts[1], 4096)),
    )
    return Picture(screen, _to_far_field(far_field, middle, counts, size))


def _to_far_field(
    far_field: FarField, middle: list[float], counts: list[int], size: float
) -> csr_array:
    """See `Picture`; light is even over a pixel of the screen, which lies in up to 2 × 2 others."""
    n_x, n_y = counts
    x = middle[0] + (np.arange(n_x + 1) - n_x / 2) * size
    y = middle[1] - (np.arange(n_y + 1) - n_y / 2) * size
    column, _ = far_field.to_pixels(np.degrees(np.arctan(x)), 0.0)  # it depends on x alone
    across = np.hypot(1.0, (x[1:] + x[:-1]) / 2)
    _, row = far_field.to_pixels(0.0, np.degrees(np.arctan2(y[:, None], across)))
    fine = np.arange(n_x * n_y).reshape(n_y, n_x)
    parts, places, pixels = [], [], []
    for i, in_row in _shares(row[:-1], row[1:]):
        for j, in_column in _shares(column[:-1], column[1:]):
            lands = far_field.covers(*np.broadcast_arrays(j, i)) & (in_row * in_column > 0)
            parts.append((in_row * in_column)[lands])
            places.append((i * far_field.pixels[0] + j)[lands].astype(int))
            pixels.append(fine[lands])
    into = np.concatenate(places), np.concatenate(pixels)
    shape = math.prod(far_field.pixels), n_x * n_y
    return csr_array((np.concatenate(parts), into), shape=shape)


def _shares(begin: Array, end: Array) -> list[tuple[Array, Array]]:
    """Which part of each interval, shorter than 1, lies in the cells that it begins and ends in."""
    first = np.floor(begin)
    before = (np.minimum(first + 1, end) - begin) / (end - begin)
    return [(first, before), (first + 1, 1 - before)]


_PICTURES: Mapping[type, Callable[[Any, Scene], Picture]] = {
    Screen: _of_screen,
    FarField: _of_far_field,
}
