"""What the relief of manufacture makes of an image: a convolution by the slopes it adds."""

import math
from collections.abc import Mapping, Sequence

import numpy as np

from workbench.arrays import Array
from workbench.extended.blurring import ImageBlur
from workbench.geometry.as_made import AsMade
from workbench.geometry.outlines import outline_of
from workbench.geometry.surface import freeform_nets
from workbench.messages import Message
from workbench.scene import Scene
from workbench.scene.making.relief import FacePlaces, Relief

_PLACES = 200_000  # of each face
# Of light that goes farther, the distance does not count; and less than this, in pixels, is no
# blur.
_NEARLY_ALL, _UNSEEN = 0.9995, 0.05
# A uniform disc so many standard deviations wide damps the same waves to one half.
_DISC = 3.6


class ReliefBlurs:
    """Blurs by reliefs of a lens, each the same for all of its image.

    `scene`: without processes; `heights` (n_u, n_v): control heights as made.
    """

    def __init__(self, scene: Scene, heights: Mapping[str, Array]) -> None:
        self._pixels = scene.receiver.pixels
        # Of each face: pixels that light moves by a slope of 1, how it is seen, and places of it.
        self._faces: list[tuple[tuple[float, float], FacePlaces]] = []
        for focused in scene.focused:
            element, seen = focused.optic, focused.alone.receiver
            far = seen.per_radian(element.leaving_z)
            x, y = (
                element.deflection * each * n / (2 * half)
                for each, n, half in zip(far, seen.pixels, seen.half_extent, strict=True)
            )
            a, b = np.random.default_rng(0).random((2, _PLACES))
            at = outline_of(element).evenly(a, b)
            for face, net in freeform_nets(element).items():
                sign = element.outwards(face)
                _, slope_x, slope_y = net.at(*at, sign * heights[face])
                self._faces.append(((x, y), FacePlaces(*at, slope_x, slope_y)))

    def blur(self, reliefs: Sequence[tuple[Relief, float]]) -> ImageBlur | None:
        """The blur by reliefs, each smoothed by a width; None where there is nothing to see."""
        x, y = np.zeros((2, _PLACES))
        for (far_x, far_y), places in self._faces:
            for relief, smoothing in reliefs:
                slope_x, slope_y = relief.slopes(places, smoothing)
                x += far_x * slope_x
                y += far_y * slope_y
        widths = _DISC * float(x.std()), _DISC * float(y.std())
        if max(widths) < _DISC * _UNSEEN:
            return None
        farthest = (float(np.quantile(np.abs(shift), _NEARLY_ALL)) for shift in (x, y))
        m_x, m_y = (
            min(math.ceil(far), n) + 1 for far, n in zip(farthest, self._pixels, strict=True)
        )
        kernel = _shared_among_pixels(x, -y, (m_x, m_y))
        note = Message(
            "relief of manufacture blurs it over {x:.3g} × {y:.3g} pixels", x=widths[0], y=widths[1]
        )
        return ImageBlur(kernel[None, None], np.zeros((0, 1, 1)), (1.0, 1.0), widths, note)


def relief_blur_of(made: AsMade, heights: Mapping[str, Array]) -> ImageBlur | None:
    """Return the blur by the relief of a lens as made; None where there is nothing to see."""
    return ReliefBlurs(made.scene, heights).blur(made.reliefs) if made.reliefs else None


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
