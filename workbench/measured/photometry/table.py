"""Intensity by direction on planes of C and angles γ, as goniophotometers measure it."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from workbench.arrays import Array, Index
from workbench.said import Said

# Negative intensities over the largest one that measuring and rounding may leave.
_ROUNDED = 0.005
# Largest intensities of lamps, cd; the trace in float32 fails beyond 1e-38 and 1e38.
_DIMMEST, _BRIGHTEST = 1e-20, 1e20
_NODES = 8  # of the rule for one interval of γ: exact for the sine at any step
# Panels of `flux_nodes` over all of C, and over all light along γ, and nodes of each: the light
# within a circle about the nadir, which cuts all planes at one γ, is then 1e-3 off at most.
_OVER_C, _OVER_GAMMA, _PER_PANEL = 32, 512, 2


@dataclass(frozen=True, eq=False)
class IntensityTable:
    """Intensity in cd at angles of type C, all around; linear between them, 0 beyond the last γ.

    γ counts from the nadir of the luminaire. Looking along the nadir, as from above down on a
    luminaire, C counts counterclockwise.

    Attributes
    ----------
    c : ndarray, shape (n_c,)
        Degrees, ascending; the first is 0 and the last 360.
    gamma : ndarray, shape (n_g,)
        Degrees, ascending, within 0 to 180.
    candela : ndarray, shape (n_c, n_g)
        Finite, not negative, not all zero; the first and the last row are the same plane.
    remarks : tuple of Said
        What is odd about the file, though it can be read.
    """

    c: Array
    gamma: Array
    candela: Array
    remarks: tuple[Said, ...] = ()

    @property
    def note(self) -> str:
        """All remarks together; empty where there is none."""
        return "; ".join(str(remark) for remark in self.remarks)

    @cached_property
    def lumens(self) -> float:
        """Flux into all directions, lm: the exact integral of what is between the angles."""
        along = self.candela @ solid_angles(self.gamma)
        return float(np.trapezoid(along, np.radians(self.c)))

    @cached_property
    def flux_nodes(self) -> tuple[Array, Array]:
        """Directions, shape (n, 3), and the flux of each: together exactly `lumens`.

        The light through any aperture is the sum of the nodes that pass it. So it is never more
        than all light, however narrow the lamp is.
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
        ways = np.broadcast_arrays(sine * np.cos(c), -sine * np.sin(c), np.cos(gamma))
        lit = flux > 0
        flux = flux[lit]
        return np.stack([way[lit] for way in ways], axis=-1), flux * (self.lumens / flux.sum())

    def at(self, direction: Array) -> Array:
        """Intensity into directions, cd.

        Parameters
        ----------
        direction : ndarray, shape (..., 3)
            Unit vectors: the nadir is +z, C0 is +x and C90 is −y.
        """
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
    """Gauss-Legendre nodes between angles, degrees, and the angle of each, radians.

    Intervals have one panel at least, and so many ``shared`` ones in proportion to their weights.
    """
    panels = 1 + np.ceil(shared * weight / weight.sum()).astype(np.intp)
    number = np.arange(panels.sum()) - np.repeat(np.cumsum(panels) - panels, panels)
    wide = np.repeat(np.diff(angles) / panels, panels)
    start = np.repeat(angles[:-1], panels) + number * wide
    node, share = np.polynomial.legendre.leggauss(_PER_PANEL)
    places = start[:, None] + wide[:, None] * (node + 1) / 2
    return places.ravel(), np.radians(wide[:, None] * share / 2).ravel()


def solid_angles(gamma: Array) -> Array:
    """How much each angle γ counts in the flux of a table, sr per radian of C.

    It is the integral over the sphere of what falls linearly from 1 at that angle to 0 at the two
    beside it.

    Parameters
    ----------
    gamma : ndarray, shape (n_g,)
        Degrees, ascending, within 0 to 180.

    Returns
    -------
    ndarray, shape (n_g,)
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
    """A table of what a file holds.

    Parameters
    ----------
    c, candela
        As for `all_around`.
    gamma : ndarray, shape (n_g,)
        As of `IntensityTable`.

    Raises
    ------
    ValueError
        With what is wrong.
    """
    if len(gamma) < 2:
        raise ValueError(Said("it has a single angle γ; at least two are needed"))
    for name, angles in (("C", c), ("γ", gamma)):
        if (np.diff(angles) <= 0).any():
            raise ValueError(Said("its angles {name} do not ascend", name=name))
    if gamma[0] < 0 or gamma[-1] > 180:
        raise ValueError(
            Said(
                "its angles γ go from {first:g}° to {last:g}°; within 0° to 180°",
                first=gamma[0],
                last=gamma[-1],
            )
        )
    return IntensityTable(*all_around(c, candela, gamma))


def possible(candela: Array) -> tuple[Array, tuple[Said, ...]]:
    """Intensities that a lamp can have, of those of a file.

    Parameters
    ----------
    candela : ndarray
        Intensities, cd.

    Returns
    -------
    ndarray, and tuple of Said
        The intensities, of which small negative ones are 0; and a remark on these.

    Raises
    ------
    ValueError
        If there is no light, or intensities are negative, or beyond all lamps.
    """
    largest, least = float(candela.max()), float(candela.min())
    if -_ROUNDED * largest > least:
        raise ValueError(
            Said("it has an intensity of {least:g} cd; none can be negative", least=least)
        )
    if not largest > 0:
        raise ValueError(Said("it gives no light: all its intensities are 0"))
    if not _DIMMEST <= largest <= _BRIGHTEST:
        raise ValueError(
            Said(
                "its largest intensity is {largest:.3g} cd; from {least:g} to {most:g} cd can be "
                "used",
                largest=largest,
                least=_DIMMEST,
                most=_BRIGHTEST,
            )
        )
    if least >= 0:
        return candela, ()
    remark = Said(
        "intensities below 0 count as 0: {count}, the least is {least:g} cd",
        count=int((candela < 0).sum()),
        least=least,
    )
    return np.maximum(candela, 0.0), (remark,)


def all_around(c: Array, candela: Array, gamma: Array) -> tuple[Array, Array, Array]:
    """Planes from 0° to 360°, of those that stand for their mirror images as well.

    Parameters
    ----------
    c : ndarray, shape (n,)
        Ascending: one for all; or over a quarter from 0; or over a half; or over all, with the last
        one or without.
    candela : ndarray, shape (n, n_g)
        The planes.
    gamma : ndarray, shape (n_g,)
        Their angles.

    Returns
    -------
    tuple of ndarray
        Planes, angles, and intensities, as of `IntensityTable`.

    Raises
    ------
    ValueError
        If the angles are none of these.
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
            Said(
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
    """Planes over twice their way, the second half a mirror image of the first."""
    return np.append(c, 2 * c[-1] - c[-2::-1]), np.vstack([candela, candela[-2::-1]])


def between(angles: Array, values: Array) -> tuple[Index, Array]:
    """The interval that each value is in, and how far it is through it, in 0 to 1."""
    index = np.clip(np.searchsorted(angles, values, side="right") - 1, 0, len(angles) - 2)
    part = (values - angles[index]) / (angles[index + 1] - angles[index])
    return index, np.clip(part, 0.0, 1.0)
