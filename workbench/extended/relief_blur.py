"""What the relief of manufacture makes of an image: a convolution by the slopes it adds."""

import math
from collections.abc import Mapping

import numpy as np

from workbench.arrays import Array
from workbench.extended.blurring import ImageBlur
from workbench.geometry.as_made import AsMade
from workbench.geometry.outlines import outline_of
from workbench.geometry.surface import freeform_nets
from workbench.messages import Message
from workbench.scene.making.relief import FacePlaces

_PLACES = 200_000  # of each face
# Of light that goes farther, the distance does not count; and less than this, in pixels, is no
# blur.
_NEARLY_ALL, _UNSEEN = 0.9995, 0.05
# A uniform disc so many standard deviations wide damps the same waves to one half.
_DISC = 3.6


def relief_blur_of(made: AsMade, heights: Mapping[str, Array]) -> ImageBlur | None:
    """Return the blur by the relief of a lens as made, the same for all of its image.

    `heights` (n_u, n_v): control heights as made. Returns None where there is nothing to see.
    """
    if not made.reliefs:
        return None
    receiver = made.scene.receiver
    x, y = shifts = np.zeros((2, _PLACES))
    for focused in made.scene.focused:
        element, seen = focused.optic, focused.alone.receiver
        sizes = zip(seen.per_radian(element.leaving_z), seen.pixels, seen.half_extent, strict=True)
        pixels = [element.deflection * far * n / (2 * half) for far, n, half in sizes]
        a, b = np.random.default_rng(0).random((2, _PLACES))
        at = outline_of(element).evenly(a, b)
        for face, net in freeform_nets(element).items():
            sign = element.outwards(face)
            _, slope_x, slope_y = net.at(*at, heights[face])
            places = FacePlaces(*at, sign * slope_x, sign * slope_y)
            for relief, smoothing in made.reliefs:
                for shift, far, more in zip(
                    shifts, pixels, relief.slopes(places, smoothing), strict=True
                ):
                    shift += far * more
    far_x, far_y = (float(np.quantile(np.abs(shift), _NEARLY_ALL)) for shift in shifts)
    widths = x.std(), y.std()
    if max(widths) < _UNSEEN:
        return None
    n_x, n_y = receiver.pixels
    m_x, m_y = (min(math.ceil(far), n) + 1 for far, n in ((far_x, n_x), (far_y, n_y)))
    kernel = _shared_among_pixels(x, -y, (m_x, m_y))
    blurred = _DISC * float(widths[0]), _DISC * float(widths[1])
    note = Message(
        "relief of manufacture blurs it over {x:.3g} × {y:.3g} pixels", x=blurred[0], y=blurred[1]
    )
    return ImageBlur(kernel[None, None], np.zeros((0, 1, 1)), (1.0, 1.0), blurred, note)


def _shared_among_pixels(x: Array, y: Array, margin: tuple[int, int]) -> Array:
    """Parts (2 m_y + 1, 2 m_x + 1) of light that goes x and y pixels on from uniform pixels."""
    m_x, m_y = margin
    x, y = x.clip(-m_x, m_x - 1e-9), y.clip(-m_y, m_y - 1e-9)
    column, row = np.floor(x).astype(int), np.floor(y).astype(int)
    kernel = np.zeros((2 * m_y + 2, 2 * m_x + 2))
    for right in (0, 1):
        for down in (0, 1):
            part = np.abs(1 - right - (x - column)) * np.abs(1 - down - (y - row))
            np.add.at(kernel, (row + m_y + down, column + m_x + right), part)
    return np.asarray(kernel[:-1, :-1] / len(x))
