"""Intensity of a designed lens: IES LM-63-2002 and EULUMDAT.

The nadir is the direction of the light: +z behind a lens, −z before a mirror. C0 is +x and C90 is
−y for a lens, +y for a mirror. The source is the only lamp, with its flux; a source of unknown flux
counts as 1000 lm.
"""

from collections.abc import Iterable
from datetime import UTC, datetime
from typing import BinaryIO

import numpy as np

from workbench import __version__
from workbench.arrays import Array
from workbench.files.export.design import Design, Deviation
from workbench.files.export.far_light import FarLight, far_light
from workbench.files.export.fitted_table import MOST_VALUES, FittedTable, error_of, fitted_table
from workbench.measured.lamps import light_unit, ray_model
from workbench.measured.photometry import IntensityTable
from workbench.measured.photometry.ies import read_ies
from workbench.measured.photometry.ldt import read_ldt
from workbench.scene import RayFileSource

_UNKNOWN = 1000.0  # lm, of a source of unknown flux
_PER_LAMPS = 1000.0  # EULUMDAT gives intensities per 1000 lm of lamps
_TOLERABLE = 0.02  # largest error of a table without a warning
_MM = 1e-3
_PROGRAM = f"Freeform Lens Workbench {__version__}"


def write_ies(design: Design, file: BinaryIO) -> Deviation:
    """Write the intensity as IES LM-63-2002; raise Refused if no light leaves the lens."""
    light, lumens = far_light(design), _lumens(design)
    lamp = fitted_table(light).times(lumens)
    width, length = (f"{side:.6g}" for side in _luminous_sides(design))
    lines = [
        "IESNA:LM-63-2002",
        "[TEST] simulated",
        f"[TESTLAB] {_PROGRAM}",
        f"[ISSUEDATE] {datetime.now(UTC):%Y-%m-%d}",
        "[MANUFAC] -",
        "[LUMCAT] -",
        "TILT=NONE",
        f"1 {lumens:.6g} 1 {len(lamp.gamma)} {len(lamp.c)} 1 2 {width} {length} 0",
        "1 1 0",
        *_rows(lamp.gamma, 9),
        *_rows(lamp.c, 9),
        *(row for plane in lamp.intensity for row in _rows(plane, 6)),
    ]
    return _deviation(read_ies(_written(lines, file)), light, lumens, design)


def write_ldt(design: Design, file: BinaryIO) -> Deviation:
    """Write the intensity as EULUMDAT; raise as `write_ies`."""
    light, lumens = far_light(design), _lumens(design)
    optic = design.scene.optic
    lamp = fitted_table(light).times(_PER_LAMPS)
    symmetry, planes = _all_planes(lamp)
    steps = [_step(np.append(planes, 360.0)), _step(lamp.gamma)]
    # Type of luminaire (a point source with and without symmetry about the axis).
    kind = 1 if symmetry == 1 else 3
    head: list[object] = [_PROGRAM, kind, symmetry, len(planes), steps[0]]
    angles: list[object] = [len(lamp.gamma), steps[1]]
    names: list[object] = ["simulated", f"Freeform {optic.called}", "", ""]
    date = f"{datetime.now(UTC):%Y-%m-%d}"
    length, width = (2 * half * design.metres / _MM for half in reversed(optic.half_width))
    if optic.outline == "ellipse" and length == width:
        width = 0.0  # round
    sizes: list[object] = [length, width, 0, length, width, 0, 0, 0, 0]
    # Downward flux and light output ratio in per cent, factor, tilt, sets of lamps.
    factors: list[object] = [100, round(100 * light.flux, 4), 1, 0, 1]
    lamps: list[object] = [1, "-", f"{lumens:.6g}", "-", "-", 0]
    ratios = [0] * 10
    stored = lamp.intensity[:-1] if symmetry == 0 else lamp.intensity
    numbers = [f"{angle:.9g}" for angle in (*planes, *lamp.gamma)]
    values = [f"{value:.6g}" for value in stored.ravel()]
    text = [
        f"{line:.7g}" if isinstance(line, float) else str(line)
        for line in (*head, *angles, *names, date, *sizes, *factors, *lamps, *ratios)
    ]
    content = _written([*text, *numbers, *values], file)
    return _deviation(read_ldt(content), light, lumens, design)


def _lumens(design: Design) -> float:
    return light_unit(design.scene).lumens or _UNKNOWN


def _luminous_sides(design: Design) -> tuple[float, float]:
    optic = design.scene.optic
    sign = -1 if optic.outline == "ellipse" else 1
    r_x, r_y = optic.half_width
    return sign * 2 * r_y * design.metres, sign * 2 * r_x * design.metres


def _all_planes(lamp: FittedTable) -> tuple[int, Array]:
    if len(lamp.c) == 1:
        return 1, lamp.c
    return {90.0: 4, 180.0: 2, 360.0: 0}[float(lamp.c[-1])], lamp.table.c[:-1]


def _step(angles: Array) -> float:
    steps = np.diff(angles)
    return float(steps[0]) if np.allclose(steps, steps[0], rtol=1e-6) else 0.0


def _rows(values: Iterable[float], digits: int) -> list[str]:
    words = [f"{value:.{digits}g}" for value in values]
    return [" ".join(words[first : first + 10]) for first in range(0, len(words), 10)]


def _written(lines: list[str], file: BinaryIO) -> bytes:
    content = ("\r\n".join(lines) + "\r\n").encode("ascii")
    file.write(content)
    return content


def _deviation(table: IntensityTable, light: FarLight, lumens: float, design: Design) -> Deviation:
    optic = design.scene.optic
    read = IntensityTable(table.c, table.gamma, table.candela / lumens)
    error = error_of(read, light)
    cell, pixel = light.cell, light.cell / light.finer
    notes = [
        f"averaged over cells of {cell:.2g}° ({100 * error.in_pixels:.2g} % over {pixel:.2g}°)",
        f"uncertainty of the traced light {100 * light.uncertainty:.2g} %, without ray noise",
        f"{len(table.c) - 1} × {len(table.gamma)} angles",
        f"{lumens * light.flux:.4g} lm of {lumens:.4g} lm leave the {optic.body_called}",
        f"the nadir is {'+z' if optic.onwards > 0 else '−z'}",
    ]
    if error.in_cells > _TOLERABLE:
        reason = (
            "more rays would take too long"
            if light.uncertainty > error.in_cells / 2
            else f"a file of {MOST_VALUES:,} intensities is too coarse for the edges of this light"
        )
        notes.insert(1, f"more than {100 * _TOLERABLE:g} %: {reason}")
    if isinstance(design.scene.source, RayFileSource):
        model = ray_model(design.scene.source, optic, light.origins)
        notes.append(str(model.note))
    return Deviation("intensity error", 100 * error.in_cells, "%", "; ".join(notes))
