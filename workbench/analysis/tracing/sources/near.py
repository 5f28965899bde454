"""Random places of a face that are as dense as the light of points close to it."""

import numpy as np

from workbench.arrays import Array

# A point at the plane, or behind it where the face leans, gives no light: it needs some distance.
_LEAST = 1e-15


def near_places(
    a: Array, b: Array, points: Array, half_width: tuple[float, float]
) -> tuple[Array, Array, Array]:
    """Places for pairs that fill a square evenly, and the area that each stands for.

    A point at a distance d lights a plane as (d² + r²)^-2, with r from its foot, where it is
    Lambertian. Along x places are as dense as the light of whole lines of the plane,
    (d² + x²)^-3/2. Along each line, which is q² = d² + x² from the point, they are as dense as
    (q² + y²)^-3/2, whose sum has a closed form. Rays that each stand for the area of their place
    then carry almost the same flux: their image scatters least.

    `a`, `b` (m,): in [0, 1]; `points` (m, 3): where each ray begins as the lens sees it, before the
    plane z = 0; one point may stand for all; `half_width`: of the rectangle that the places fill.
    Returns (m,): x, y and areas, whose mean is that of the rectangle.

    Examples
    --------
    >>> import numpy as np
    >>> a, b = np.meshgrid((np.arange(200) + 0.5) / 200, (np.arange(200) + 0.5) / 200)
    >>> point = np.array([[0.5, 0.0, -1.0]])
    >>> x, y, area = near_places(a.ravel(), b.ravel(), point, (2.0, 1.0))
    >>> bool(abs(x).max() < 2 and abs(y).max() < 1), area.mean().round(1).item()
    (True, 8.0)
    """
    r_x, r_y = half_width
    foot_x, foot_y, z = points.T
    distance = np.maximum(-z, _LEAST * max(half_width))
    x, along_x = _along(a, distance, foot_x, r_x)
    y, along_y = _along(b, np.hypot(distance, x - foot_x), foot_y, r_y)
    return x, y, along_x * along_y


def _along(part: Array, distance: Array, foot: Array, half: float) -> tuple[Array, Array]:
    """Places between both ends of a line, and the length that each stands for."""
    low, high = ((end - foot) / np.hypot(distance, end - foot) for end in (-half, half))
    sine = low + (high - low) * part
    with np.errstate(divide="ignore"):  # rounding may make a sine 1
        away = distance * sine / np.sqrt(1 - sine**2)
    place = (foot + away).clip(-half, half)
    length = (high - low) * np.hypot(distance, place - foot) ** 3 / distance**2
    return place, length
