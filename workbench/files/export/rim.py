"""The upper rim of a lens with an elliptic outline: where its exit face meets its wall."""

from typing import NamedTuple

import numpy as np
from scipy.interpolate import BSpline, make_interp_spline

from workbench.files.export.design import Design

# Pieces of a quarter of the rim, at least and at most.
_FEWEST, _MOST = 64, 4096
_DEGREE = 3


class Rim(NamedTuple):
    """Curves along the quarters of the rim, counterclockwise from +x.

    Attributes
    ----------
    quarters : tuple of BSpline
        Cubic, from 0 to 1, to places of shape (3,) in scene units; they begin and end on the axes.
    off : float
        The farthest that they are from the exit face and from the wall, scene units.
    """

    quarters: tuple[BSpline, ...]
    off: float

    @classmethod
    def of(cls, design: Design, tolerance: float) -> "Rim":
        """The rim of a lens, as near to both faces as a tolerance says if so many pieces allow."""
        count = _FEWEST
        while True:
            found = cls._through(design, count)
            if found.off <= tolerance or count >= _MOST:
                return found
            count *= 2

    @classmethod
    def _through(cls, design: Design, count: int) -> "Rim":
        """The rim through so many places of each quarter, and one."""
        r_x, r_y = design.net.half_width
        part = np.linspace(0, 1, count + 1)
        between = (part[1:] + part[:-1]) / 2
        quarters, off = [], 0.0
        for number in range(4):
            angle = (number + part) * (np.pi / 2)
            x, y = r_x * np.cos(angle), r_y * np.sin(angle)
            for ends, r in ((x, r_x), (y, r_y)):  # exactly on the axes
                ends[np.abs(ends) < 1e-9 * r] = 0.0
            z = design.net.at(x, y, design.heights)[0]
            curve = make_interp_spline(part, np.stack([x, y, z], axis=1), _DEGREE)
            x, y, z = curve(between).T
            aside = np.abs(np.hypot(x / r_x, y / r_y) - 1).max() * max(r_x, r_y)
            above = np.abs(z - design.net.at(x, y, design.heights)[0]).max()
            quarters.append(curve)
            off = max(off, float(aside), float(above))
        return cls(tuple(quarters), off)
