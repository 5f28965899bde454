"""Intensity of the finished lens by direction: IES LM-63-2002 and EULUMDAT.

The nadir is where light goes on to: +z behind a lens, −z before a mirror. C0 is +x and C90 is −y
for a lens, +y for a mirror. The source counts as one lamp of 1000 lm.
"""

import math
from collections.abc import Iterable
from typing import BinaryIO

import numpy as np

from workbench import __version__
from workbench.arrays import Array
from workbench.errors import Refused
from workbench.files.export.design import Design, Deviation
from workbench.files.export.leaving import LeavingRays, leaving
from workbench.measured.photometry import IntensityTable
from workbench.measured.photometry.ies import read_ies
from workbench.measured.photometry.ldt import read_ldt
from workbench.measured.photometry.table import solid_angles, table_of
from workbench.said import Said
from workbench.scene import Optic

_LUMENS = 1000.0  # of the source
_PLANES = 24
# Steps of γ, degrees: the coarsest that makes so many of nearly all light is taken.
_STEPS = (0.1, 0.25, 0.5, 1.0, 2.5)
_FEWEST, _NEARLY_ALL = 36, 0.999
_PROGRAM = f"Freeform Lens Workbench {__version__}"


def write_ies(design: Design, file: BinaryIO) -> Deviation:
    """Write the intensity as IES LM-63-2002."""
    rays = leaving(design)
    table = intensity_of_rays(rays, design.scene.optic)
    lines = [
        "IESNA:LM-63-2002",
        "[TEST] simulated",
        f"[TESTLAB] {_PROGRAM}",
        "[MANUFAC] -",
        "[LUMCAT] -",
        "TILT=NONE",
        f"1 {_LUMENS:g} 1 {len(table.gamma)} {len(table.c)} 1 2 0 0 0",
        "1 1 0",
        *_rows(table.gamma),
        *_rows(table.c),
        *(row for plane in table.candela for row in _rows(plane)),
    ]
    return _deviation(read_ies(_written(lines, file)), rays, design.scene.optic)


def write_ldt(design: Design, file: BinaryIO) -> Deviation:
    """Write the intensity as EULUMDAT, all planes of it."""
    rays = leaving(design)
    optic = design.scene.optic
    table = intensity_of_rays(rays, optic)
    step_c, step_gamma = 360 / _PLANES, table.gamma[1]
    out = 100 * float(rays.flux.sum())
    # Type of luminaire, symmetry (none), planes of C, their distance, angles γ, theirs.
    head: list[object] = [_PROGRAM, 1, 0, _PLANES, step_c, len(table.gamma), step_gamma]
    names: list[object] = ["simulated", f"Freeform {optic.called}", "", "", ""]
    size = 2e3 * max(optic.half_width) * design.metres
    sizes: list[object] = [round(size), 0, 0, round(size), *[0] * 5]
    # Downward flux and light output ratio in per cent, factor, tilt, sets of lamps.
    factors: list[object] = [100, round(out, 4), 1, 0, 1]
    lamps: list[object] = [1, "-", _LUMENS, "-", "-", 0]
    ratios = [0] * 10
    angles = [*table.c[:-1], *table.gamma]
    lines = [*head, *names, *sizes, *factors, *lamps, *ratios, *angles, *table.candela[:-1].ravel()]
    text = [f"{line:.7g}" if isinstance(line, float) else str(line) for line in lines]
    return _deviation(read_ldt(_written(text, file)), rays, optic)


def intensity_of_rays(rays: LeavingRays, optic: Optic) -> IntensityTable:
    """Intensity of rays on planes of C and angles γ, cd.

    A ray counts for the nearest plane and, by its distance from each, for the two nearest angles:
    then the flux of the table, which is linear between its angles, is that of the rays, at the
    poles as well.

    Parameters
    ----------
    rays : LeavingRays
        At least one.
    optic : Optic
        What they leave: it says where the nadir is.

    Raises
    ------
    Refused
        If no ray leaves the optic.
    """
    if not len(rays.flux):
        raise Refused(
            "session",
            Said(
                "no light leaves its {body}, so that it has no intensity",
                body=Said(optic.body_called),
            ),
        )
    x, y, z = rays.direction.T * np.array([[1.0], [optic.onwards], [optic.onwards]])
    angle = np.degrees(np.arctan2(np.hypot(x, y), z))
    gamma = _angles(angle, rays.flux)
    plane = np.degrees(np.arctan2(-y, x)) % 360 * _PLANES / 360
    j = np.rint(plane).astype(np.intp) % _PLANES
    i = np.minimum((angle / gamma[1]).astype(np.intp), len(gamma) - 2)
    part = angle / gamma[1] - i
    counted = np.zeros(_PLANES * len(gamma))
    for node, share in ((i, 1 - part), (i + 1, part)):
        counted += np.bincount(j * len(gamma) + node, _LUMENS * rays.flux * share, len(counted))
    flux = counted.reshape(_PLANES, len(gamma))
    poles = np.isin(gamma, (0.0, 180.0))  # one direction in all planes
    flux[:, poles] = flux[:, poles].mean(axis=0)
    candela = flux / (2 * np.pi / _PLANES * solid_angles(gamma))
    c = np.linspace(0.0, 360.0, _PLANES + 1)
    return table_of(c, gamma, np.vstack([candela, candela[:1]]))


def _angles(angle: Array, flux: Array) -> Array:
    """Angles γ up to a half-space or, where light is behind it, to all of the sphere."""
    order = np.argsort(angle)
    outermost = np.searchsorted(np.cumsum(flux[order]), _NEARLY_ALL * flux.sum())
    wide = float(angle[order[min(int(outermost), len(order) - 1)]])
    step = next((step for step in reversed(_STEPS) if wide >= _FEWEST * step), _STEPS[0])
    last = 90.0 if angle.max() <= 90 else 180.0
    return np.linspace(0.0, last, round(last / step) + 1)


def _rows(values: Iterable[float]) -> list[str]:
    """Numbers in lines that old programs can read."""
    words = [f"{value:.6g}" for value in values]
    return [" ".join(words[first : first + 10]) for first in range(0, len(words), 10)]


def _written(lines: list[str], file: BinaryIO) -> bytes:
    """Write lines to a file, and return what stands there."""
    content = ("\r\n".join(lines) + "\r\n").encode("ascii")
    file.write(content)
    return content


def _deviation(table: IntensityTable, rays: LeavingRays, optic: Optic) -> Deviation:
    """How far the flux of the table, as read again, is from that of the rays."""
    out = float(rays.flux.sum())
    off = abs(table.lumens / (_LUMENS * out) - 1)
    noise = 1 / math.sqrt(len(rays.flux))
    note = (
        f"of {len(rays.flux)} rays, {_LUMENS * out:.1f} lm of {_LUMENS:g} lm leave the "
        f"{optic.body_called}; the nadir is {'+z' if optic.onwards > 0 else '−z'}"
    )
    return Deviation("flux off by", off, f"of it, scatter about {noise:.1g}", note)
