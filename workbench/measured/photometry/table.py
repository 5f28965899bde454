"""Tables of intensity by direction, as goniophotometers measure them.

Tables are of type C: planes C and angles γ. Types A and B have horizontal and vertical angles from
the beam axis. Looking along the beam, H counts to the right and V upwards. Type A, of headlamps: H
turns about the vertical axis, V is the elevation. Type B, of floodlights: V turns about the
horizontal axis, H is the angle from the plane across that axis. In a scene the beam axis is +z, up
is +y, right is −x.
"""

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from workbench.arrays import Array, Index
from workbench.messages import Message

# Negative intensities, relative to the largest, that measurement noise and rounding explain.
_ROUNDED = 0.005
# Range of the largest intensity, cd; the trace in float32 fails beyond 1e-38 and 1e38.
_DIMMEST, _BRIGHTEST = 1e-20, 1e20
_NODES = 8  # of the Gauss rule for one interval of γ: exact for the sine at any step
# Panels of `flux_nodes` over C and over γ, and nodes of each: the flux within a circle about the
# nadir, which cuts all planes at one γ, then errs by at most 1e-3.
_OVER_C, _OVER_GAMMA, _PER_PANEL = 32, 512, 2
TYPES = {1: "C", 2: "B", 3: "A"}
"""Photometric types by number in IES files."""
# Steps of the table of type C per least step of the file; least and largest step, degrees; most
# values of the table.
_FINER, _FINEST, _COARSEST, _MOST_VALUES = 16, 0.05, 1.0, 1 << 20


@dataclass(frozen=True, eq=False)
class IntensityTable:
    """Intensity in cd at angles of type C, linear between them, 0 beyond the last γ.

    γ counts from the nadir of the luminaire. Looking along the nadir, as from above down on a
    luminaire, C counts counterclockwise.
    """

    c: Array  # (n_c,), degrees, ascending; the first is 0 and the last 360
    gamma: Array  # (n_g,), degrees, ascending, within 0 to 180
    # (n_c, n_g), finite, not negative, not all zero; the first and the last row are the same plane.
    candela: Array
    remarks: tuple[Message, ...] = ()  # anomalies of the file that do not prevent reading it

    @property
    def note(self) -> str:
        """All remarks in one text."""
        return "; ".join(str(remark) for remark in self.remarks)

    @cached_property
    def lumens(self) -> float:
        """Total flux, lm: the exact integral of the interpolated table."""
        along = self.candela @ solid_angles(self.gamma)
        return float(np.trapezoid(along, np.radians(self.c)))

    @cached_property
    def flux_nodes(self) -> tuple[Array, Array]:
        """Directions (n, 3) and the flux of each, which sum to `lumens`.

        The flux through an aperture is the sum of the nodes that pass it. So it never exceeds the
        total flux, however narrow the beam is.
        """
        c, along_c = _nodes_between(self.c, np.diff(self.c), _OVER_C)
        lit = self.candela.mean(axis=0) * np.sin(np.radians(self.gamma))
        in_intervals = np.diff(self.gamma) * (lit[1:] + lit[:-1])
        gamma, along_gamma = _nodes_between(self.gamma, in_intervals, _OVER_GAMMA)
        i, in_c = between(self.c, c)
        j, in_gamma = between(self.gamma, gamma)
        rows = (1 - in_gamma) * self.candela[:, j] + in_gamma * self.candela[:, j + 1]
        candela = (1 - in_c)[:, None] * rows[i] + in_c[:, None] * rows[i + 1]
        c, gamma = np.radians(c)[:, None], np.radians(gamma)
        flux = candela * along_c[:, None] * along_gamma * np.sin(gamma)
        sine = np.sin(gamma)
        directions = np.broadcast_arrays(sine * np.cos(c), -sine * np.sin(c), np.cos(gamma))
        lit = flux > 0
        flux = flux[lit]
        return np.stack([part[lit] for part in directions], axis=-1), flux * (
            self.lumens / flux.sum()
        )

    def at(self, direction: Array) -> Array:
        """Return the intensity, cd, in unit directions (..., 3): nadir +z, C0 +x, C90 −y."""
        x, y, z = np.moveaxis(direction, -1, 0)
        gamma = np.degrees(np.arctan2(np.hypot(x, y), z))
        c = np.degrees(np.arctan2(-y, x)) % 360.0
        i, in_c = between(self.c, c)
        j, in_gamma = between(self.gamma, gamma)
        table = self.candela
        low = (1 - in_gamma) * table[i, j] + in_gamma * table[i, j + 1]
        high = (1 - in_gamma) * table[i + 1, j] + in_gamma * table[i + 1, j + 1]
        within = (gamma >= self.gamma[0]) & (gamma <= self.gamma[-1])
        found: Array = np.where(within, (1 - in_c) * low + in_c * high, 0.0)
        return found


def _nodes_between(angles: Array, weight: Array, shared: int) -> tuple[Array, Array]:
    panels = 1 + np.ceil(shared * weight / weight.sum()).astype(np.intp)
    number = np.arange(panels.sum()) - np.repeat(np.cumsum(panels) - panels, panels)
    wide = np.repeat(np.diff(angles) / panels, panels)
    start = np.repeat(angles[:-1], panels) + number * wide
    node, share = np.polynomial.legendre.leggauss(_PER_PANEL)
    places = start[:, None] + wide[:, None] * (node + 1) / 2
    return places.ravel(), np.radians(wide[:, None] * share / 2).ravel()


def solid_angles(gamma: Array) -> Array:
    """Return the weights (n_g,) of angles γ in the flux of a table, sr per radian of C.

    The weight is the integral over the sphere of a hat function: 1 at that angle, 0 at its two
    neighbours. γ in degrees, ascending, within 0 to 180.
    """
    node, weight = np.polynomial.legendre.leggauss(_NODES)
    edges = np.radians(gamma)
    width = np.diff(edges)[:, None]
    part = (node + 1) / 2
    angle = edges[:-1, None] + width * part
    measure = np.sin(angle) * width * weight / 2  # [intervals, nodes]
    behind = (measure * part).sum(1)
    weights = np.append(measure.sum(1) - behind, 0.0)
    weights[1:] += behind
    return weights


def table_of(c: Array, gamma: Array, candela: Array) -> IntensityTable:
    """Return the table of a file's planes (see `all_around`); raise ValueError if invalid."""
    if len(gamma) < 2:
        raise ValueError(Message("it has a single angle γ; at least two are needed"))
    for name, angles in (("C", c), ("γ", gamma)):
        if (np.diff(angles) <= 0).any():
            raise ValueError(Message("its angles {name} do not ascend", name=name))
    if gamma[0] < 0 or gamma[-1] > 180:
        raise ValueError(
            Message(
                "its angles γ go from {first:g}° to {last:g}°; within 0° to 180°",
                first=gamma[0],
                last=gamma[-1],
            )
        )
    return IntensityTable(*all_around(c, candela, gamma))


def possible(candela: Array) -> tuple[Array, tuple[Message, ...]]:
    """Check the intensities of a file, cd; small negative ones become 0, with a remark.

    Raise ValueError if all are zero, one is negative, or the largest is out of range.
    """
    largest, least = float(candela.max()), float(candela.min())
    if -_ROUNDED * largest > least:
        raise ValueError(
            Message("it has an intensity of {least:g} cd; none can be negative", least=least)
        )
    if not largest > 0:
        raise ValueError(Message("it gives no light: all its intensities are 0"))
    if not _DIMMEST <= largest <= _BRIGHTEST:
        raise ValueError(
            Message(
                "its largest intensity is {largest:.3g} cd; from {least:g} to {most:g} cd can be "
                "used",
                largest=largest,
                least=_DIMMEST,
                most=_BRIGHTEST,
            )
        )
    if least >= 0:
        return candela, ()
    remark = Message(
        "intensities below 0 count as 0: {count}, the least is {least:g} cd",
        count=int((candela < 0).sum()),
        least=least,
    )
    return np.maximum(candela, 0.0), (remark,)


def all_around(c: Array, candela: Array, gamma: Array) -> tuple[Array, Array, Array]:
    """Complete planes by symmetry to 0° … 360°; return planes, γ and intensities.

    ``c`` (n,) ascends: one plane for all, or over a quarter from 0, a half, or all with or without
    the last plane; ``candela`` is (n, n_g), ``gamma`` (n_g,). Raise ValueError for other angles.
    """
    if len(c) == 1:
        return np.array([0.0, 360.0]), gamma, np.repeat(candela, 2, axis=0)
    if (c[0], c[-1]) == (0, 90):
        c, candela = _mirrored(c, candela)
    if c[-1] - c[0] == 180 and c[0] in (-90, 0, 90):
        c, candela = _mirrored(c, candela)
    if 180 < c[-1] - c[0] < 360 and (c[0] == 0 or 360 - c[-1] + c[0] <= 2 * np.diff(c).max()):
        c, candela = np.append(c, c[0] + 360.0), np.vstack([candela, candela[:1]])
    if c[-1] - c[0] != 360:
        raise ValueError(
            Message(
                "its planes of C go from {first:g}° to {last:g}°, which is no known symmetry",
                first=c[0],
                last=c[-1],
            )
        )
    turned = c[:-1] % 360  # the last plane is the first one
    order = np.argsort(turned)
    if turned[order[0]] != 0:  # C0 is between the last plane and the first one
        first, last = order[0], order[-1]
        part = (360 - turned[last]) / (360 - turned[last] + turned[first])
        between_them = (1 - part) * candela[last] + part * candela[first]
        turned, candela = np.append(turned, 0.0), np.vstack([candela[:-1], between_them])
        order = np.argsort(turned)
    around = np.append(order, order[0])
    return np.append(turned[order], 360.0), gamma, candela[around]


def _mirrored(c: Array, candela: Array) -> tuple[Array, Array]:
    return np.append(c, 2 * c[-1] - c[-2::-1]), np.vstack([candela, candela[-2::-1]])


def between(angles: Array, values: Array) -> tuple[Index, Array]:
    """Return the interval of each value and the relative position within it, 0 to 1."""
    index = np.clip(np.searchsorted(angles, values, side="right") - 1, 0, len(angles) - 2)
    part = (values - angles[index]) / (angles[index + 1] - angles[index])
    return index, np.clip(part, 0.0, 1.0)


def type_c_of(kind: str, h: Array, v: Array, candela: Array) -> IntensityTable:
    """Convert a table of type A or B to type C.

    `kind`: "A" or "B"; `h`, `v` (n_h,), (n_v,): degrees, ascending. Angles that begin at 0 are
    mirrored; `candela` (n_h, n_v): intensity, cd: linear between the angles, 0 beyond them. Raises
    `ValueError` if the angles are not possible.
    """
    if h[0] == 0:
        h, candela = np.append(-h[:0:-1], h), np.vstack([candela[:0:-1], candela])
    if v[0] == 0:
        v, candela = np.append(-v[:0:-1], v), np.hstack([candela[:, :0:-1], candela])
    turn, elevation = (h, v) if kind == "A" else (v, h)
    for name, angles in (("H", h), ("V", v)):
        if len(angles) < 2:
            raise ValueError(Message("it has a single angle {name}; two are needed", name=name))
        most = 180 if angles is turn else 90
        if (np.diff(angles) <= 0).any() or angles[0] < -most or angles[-1] > most:
            raise ValueError(
                Message(
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
    step = float(np.clip(step, max(_FINEST, math.sqrt(360 * last / _MOST_VALUES)), _COARSEST))
    c = np.linspace(0, 360, 4 * math.ceil(90 / step) + 1)
    gamma = np.linspace(0, last, math.ceil(last / step) + 1)
    found = _at(kind, (turn, elevation), values, np.radians(c)[:, None], np.radians(gamma))
    found[-1] = found[0]
    table = IntensityTable(c, gamma, found)
    # Resampling changes the flux slightly.
    return IntensityTable(c, gamma, found * (lumens / table.lumens) if table.lumens > 0 else found)


def _at(kind: str, angles: tuple[Array, Array], values: Array, c: Array, gamma: Array) -> Array:
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
