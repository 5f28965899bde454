"""Intensity of types A and B: by horizontal and vertical angles from the beam axis.

Looking along the beam, H counts to the right and V upwards. Type A, of headlamps: H turns about the
vertical axis, V is the elevation. Type B, of floodlights: V turns about the horizontal axis, H is
the angle from the plane across that axis. In a scene the beam axis is +z, up is +y, right is −x.
"""

import math

import numpy as np

from workbench.arrays import Array
from workbench.measured.photometry.table import IntensityTable, between, solid_angles
from workbench.said import Said

TYPES = {1: "C", 2: "B", 3: "A"}
"""Photometric types by their numbers in IES files."""

# Step of a table of type C over the least step of the file; bounds of the former, degrees; and most
# values of the table.
_FINER, _FINEST, _COARSEST, _MOST = 16, 0.05, 1.0, 1 << 20


def type_c_of(kind: str, h: Array, v: Array, candela: Array) -> IntensityTable:
    """Return a table of type C with the light of a table of type A or B.

    Parameters
    ----------
    kind : str
        "A" or "B".
    h, v : ndarray, shape (n_h,), (n_v,)
        Degrees, ascending. Angles that begin at 0 stand for their mirror images as well.
    candela : ndarray, shape (n_h, n_v)
        Intensity, cd: linear between the angles, 0 beyond them.

    Raises
    ------
    ValueError
        If the angles are not possible.
    """
    if h[0] == 0:
        h, candela = np.append(-h[:0:-1], h), np.vstack([candela[:0:-1], candela])
    if v[0] == 0:
        v, candela = np.append(-v[:0:-1], v), np.hstack([candela[:, :0:-1], candela])
    turn, elevation = (h, v) if kind == "A" else (v, h)
    for name, angles in (("H", h), ("V", v)):
        if len(angles) < 2:
            raise ValueError(Said("it has a single angle {name}; two are needed", name=name))
        most = 180 if angles is turn else 90
        if (np.diff(angles) <= 0).any() or angles[0] < -most or angles[-1] > most:
            raise ValueError(
                Said(
                    "its angles {name} go from {first:g}° to {last:g}°; they have to ascend within "
                    "−{most}° to {most}°",
                    name=name,
                    first=angles[0],
                    last=angles[-1],
                    most=most,
                )
            )
    values = candela if kind == "A" else candela.T  # [turn, elevation]
    lumens = np.trapezoid(values @ solid_angles(elevation + 90), np.radians(turn))
    last = 90.0 if max(-turn[0], turn[-1]) <= 90 else 180.0
    step = min(np.diff(turn).min(), np.diff(elevation).min()) / _FINER
    step = float(np.clip(step, max(_FINEST, math.sqrt(360 * last / _MOST)), _COARSEST))
    c = np.linspace(0, 360, 4 * math.ceil(90 / step) + 1)
    gamma = np.linspace(0, last, math.ceil(last / step) + 1)
    found = _at(kind, (turn, elevation), values, np.radians(c)[:, None], np.radians(gamma))
    found[-1] = found[0]
    table = IntensityTable(c, gamma, found)
    # The flux of the file, which steps of another kind change a bit.
    return IntensityTable(c, gamma, found * (lumens / table.lumens) if table.lumens > 0 else found)


def _at(kind: str, angles: tuple[Array, Array], values: Array, c: Array, gamma: Array) -> Array:
    """Intensity in directions of type C, in radians."""
    right, up, ahead = -np.sin(gamma) * np.cos(c), -np.sin(gamma) * np.sin(c), np.cos(gamma) + 0 * c
    side, height = (right, up) if kind == "A" else (up, right)
    turn = np.degrees(np.arctan2(side, ahead))
    elevation = np.degrees(np.arcsin(height.clip(-1, 1)))
    i, in_turn = between(angles[0], turn)
    j, in_elevation = between(angles[1], elevation)
    low = (1 - in_elevation) * values[i, j] + in_elevation * values[i, j + 1]
    high = (1 - in_elevation) * values[i + 1, j] + in_elevation * values[i + 1, j + 1]
    rounding = 1e-9
    within = (turn >= angles[0][0] - rounding) & (turn <= angles[0][-1] + rounding)
    within &= (elevation >= angles[1][0] - rounding) & (elevation <= angles[1][-1] + rounding)
    return np.where(within, (1 - in_turn) * low + in_turn * high, 0.0)
