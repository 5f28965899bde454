"""How the kernels of a blur change where it becomes wider or leans: exact integrals over pixels.

A map of the plane that moves each place of a blur by a small vector d changes its light K by
-div(K d). Over a pixel that is what crosses its four sides: an integral over the part of each side
that is inside the outline. So the changes of all pixels add up to nothing, and there is no step of
finite differences to choose.
"""

import numpy as np

from workbench.arrays import Array
from workbench.extended.blur import Blur
from workbench.geometry.outlines import outline_named

# Half-width in pixels of what has none along an axis.
_LEAST = 1e-6


def changes_at(blur: Blur, places: Array) -> Array:
    """Derivatives of `Blur.at` for a middle at all pairs of places in a pixel.

    Parameters
    ----------
    blur : Blur
        An evenly bright rectangle or ellipse.
    places : ndarray, shape (m,)
        In (-0.5, 0.5], along each axis.

    Returns
    -------
    ndarray, shape (3, m m, 2 m_y + 1, 2 m_x + 1)
        By the width along x and by that along y, each relative to itself, and by the correlation of
        x and y: a shear, one half of which moves x and the other half y. Each sums to 0.

    Raises
    ------
    TypeError
        If the blur is made of points, whose light jumps from pixel to pixel.
    """
    if blur.points is not None:
        raise TypeError("light of points jumps from pixel to pixel as their distance changes")
    r_x, r_y = (max(width / 2, _LEAST) for width in blur.widths)
    area = outline_named(blur.shape, (r_x, r_y)).area
    # Sides of pixels, all with the axes [places along y, places along x, rows, columns].
    sides_x, sides_y = (np.arange(-m - 0.5, m + 1) - places[:, None] for m in blur.margin)
    x, y = sides_x[None, :, None, :], sides_y[:, None, :, None]
    across = r_y * _chord(blur.shape, x / r_x), y[:, :, :-1], y[:, :, 1:]
    along = r_x * _chord(blur.shape, y / r_y), x[..., :-1], x[..., 1:]
    wider = -np.diff(x * _length(*across), axis=3)
    higher = -np.diff(y * _length(*along), axis=2)
    by_y, by_x = np.diff(_moment(*across), axis=3), np.diff(_moment(*along), axis=2)
    leaning = -(r_x / r_y * by_y + r_y / r_x * by_x) / 2
    found = np.stack([wider, higher, leaning]) / area
    return np.asarray(found.reshape(3, -1, *found.shape[3:]))


def _chord(shape: str, part: Array) -> Array:
    """Half of what a line holds of a rectangle or disc of half-width 1, at so far from its middle.

    Exactly 0 beside it.
    """
    inside = np.abs(part) < 1
    half = np.sqrt(1 - np.square(part.clip(-1, 1))) if shape == "ellipse" else 1.0
    return np.where(inside, half, 0.0)


def _length(half: Array, low: Array, high: Array) -> Array:
    """How much of sides from low to high is inside chords from -half to half."""
    return np.asarray(np.clip(high, -half, half) - np.clip(low, -half, half))


def _moment(half: Array, low: Array, high: Array) -> Array:
    """The same, times the middle of that part."""
    ends = (np.square(np.clip(end, -half, half)) for end in (high, low))
    return np.asarray((next(ends) - next(ends)) / 2)
