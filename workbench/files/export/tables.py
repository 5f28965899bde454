"""Text tables of a face and of rays: OpticStudio grid sag and point cloud.

Grid sag (.dat): knots of the B-spline are points of the grid. For degrees 2 and 3 the bicubic
interpolation between these is therefore the B-spline itself, rim included. A face of degree 1 has
edges, which only a linear interpolation keeps. Sag is height over the vertex x = y = 0, so the
thickness of the lens in OpticStudio is that at its vertex. A freeform entrance face has its own
file. Points without any cell on an elliptic lens are flagged as without data.
"""

import io
from collections.abc import Callable, Sequence
from datetime import UTC, datetime
from typing import BinaryIO, NamedTuple

import numpy as np
import torch
from scipy.interpolate import CubicHermiteSpline, RectBivariateSpline
from torch import Tensor

from workbench import __version__
from workbench.arrays import Array, Mask
from workbench.files.export.design import Design, Deviation
from workbench.measured.rays.tm25 import HEADER, VERSION
from workbench.optics.path import Path
from workbench.optics.rays import Arrival, Vector

_ROWS_AT_ONCE = 1 << 16  # limits the memory for text
_UNIT_FLAG = {"mm": 0, "cm": 1, "inch": 2, "m": 3}
_MARGIN = 3  # steps beyond the edge, where the end conditions of a bicubic spline have decayed


def write_table(
    file: BinaryIO, columns: Sequence[Array], header: str, delimiter: str, newline: str = "\n"
) -> Array:
    """Write columns (m,) below a line of text, with 15 digits; return them (m, columns) as read."""
    file.write((header + newline).encode())
    table = np.column_stack(columns)
    written = np.empty_like(table)
    for first in range(0, len(table), _ROWS_AT_ONCE):
        rows = slice(first, first + _ROWS_AT_ONCE)
        with io.BytesIO() as text:
            np.savetxt(text, table[rows], "%.15g", delimiter, newline)
            file.write(text.getbuffer())
            text.seek(0)
            written[rows] = np.loadtxt(text, delimiter=delimiter.strip() or None, ndmin=2)
    return written


def rounding(written: Array, column: int, exact: Array) -> float:
    """Largest deviation of a written column."""
    return float(np.abs(written[:, column] - exact).max(initial=0.0))


def write_grid_sag(design: Design, file: BinaryIO) -> Deviation:
    """Write the Grid Sag file, and measure the bicubic interpolation between its points.

    The first line has the numbers of points, their distances, the unit and the decentre; then
    follow the points in rows along x, from (−x, +y) on.
    """
    x, y = design.lattice()
    basis = design.basis(x, y)
    z, slope_x, slope_y = basis.evaluate(design.heights)
    twist = basis.slope_x @ design.heights @ basis.slope_y
    vertex = design.surface(np.zeros(1), np.zeros(1))[0].item()
    no_data = _without_data(design, x, y)
    columns = [_in_rows(c) for c in (z - vertex, slope_x, slope_y, twist, no_data)]
    step_x, step_y = (float(c[-1] - c[0]) / (len(c) - 1) for c in (x, y))
    header = f"{len(x)} {len(y)} {step_x!r} {step_y!r} {_UNIT_FLAG[design.unit]} 0 0"
    written = write_table(file, columns, header, delimiter=" ", newline="\r\n")

    sag, along_x, along_y, cross = written.T[:4].reshape(4, len(y), len(x))[:, ::-1]
    between_x, between_y = ((c[1:] + c[:-1]) / 2 for c in (x, y))
    values = CubicHermiteSpline(x, sag, along_x, axis=1)(between_x)
    slopes = CubicHermiteSpline(x, along_y, cross, axis=1)(between_x)
    found = CubicHermiteSpline(y, values, slopes)(between_y)
    exact = design.surface(between_x, between_y)[0].T - vertex
    error = float(np.abs(found - exact).max())
    return Deviation(
        "error of the bicubic interpolation",
        error,
        design.unit,
        f"thickness at the vertex {_thickness(design):.10g} {design.unit}",
    )


def _thickness(design: Design) -> float:
    z, *other = (face.surface(np.zeros(1), np.zeros(1))[0].item() for face in design.faces)
    return abs(z - (other[0] if other else design.flat_z))


def _without_data(design: Design, x: Array, y: Array) -> Array:
    glass = design.outline.area_inside((x[:-1, None], x[1:, None]), (y[:-1], y[1:])) > 0
    around = np.pad(glass, 1)
    near = around[1:, 1:] | around[:-1, 1:] | around[1:, :-1] | around[:-1, :-1]
    return np.where(near, 0.0, 1.0)


def _in_rows(values: Array) -> Array:
    return values[:, ::-1].T.ravel()


def _near(design: Design, x: Array, y: Array) -> Mask:
    if design.outline.whole:
        return np.ones((len(x), len(y)), dtype=np.bool_)
    x, y = (
        at * (r / (r + _MARGIN * float(at[1] - at[0])))
        for at, r in zip((x, y), design.net.half_width, strict=True)
    )
    return design.outline.contains(x[:, None], y)


def write_points(design: Design, file: BinaryIO) -> Deviation:
    """Write points and normals, and measure a bicubic spline through the points.

    Programs that fit a surface through points guess at its edges. So each point has its outward
    normal, and the points continue beyond the edge or the elliptic outline, on the polynomials that
    end there.
    """
    x, y = design.lattice(_MARGIN)
    z, slope_x, slope_y = design.surface(x, y)
    length = np.sqrt(1 + slope_x**2 + slope_y**2)
    length *= design.outward
    columns = np.broadcast_arrays(
        x[:, None], y, z, -slope_x / length, -slope_y / length, 1 / length
    )
    near = _near(design, x, y)
    written = write_table(
        file,
        [column[near] for column in columns],
        f"# freeform lens: x y z nx ny nz, unit {design.unit}",
        delimiter=" ",
    )
    z[near] = written[:, 2]
    spline = RectBivariateSpline(x, y, z)
    between_x, between_y = (
        (c[_MARGIN : -_MARGIN - 1] + c[_MARGIN + 1 : -_MARGIN]) / 2 for c in (x, y)
    )
    exact = design.surface(between_x, between_y)[0]
    inside = design.outline.contains(between_x[:, None], between_y)
    error = float(np.abs(spline(between_x, between_y) - exact)[inside].max())
    return Deviation(
        "error of a bicubic spline through the points",
        error,
        design.unit,
        f"lengths in {design.unit}",
    )


_MM = 1e-3  # lengths of the format, in metres


class Rays(NamedTuple):
    """Rays: position in scene units and unit direction (m, 3), flux (m,) > 0, wavelength (m,), nm.

    There are wavelengths only where the light has several; see `Scene.lines`.
    """

    position: Array
    direction: Array
    flux: Array
    nm: Array | None


def _traced(design: Design, ends: Callable[[Path, Arrival], tuple[Vector, Tensor]]) -> Rays:
    """Rays of all lines of the light in float64: those that ``ends`` takes, and where they end."""
    design.scene.check_no_diffuser("a file of rays")
    heights = {face: torch.tensor(each) for face, each in design.result.state.heights.items()}
    lines = design.scene.lines
    tables, wavelengths = [], []
    for line in lines:
        path = Path.of(line.scene, design.net, torch.float64)
        with torch.no_grad():
            arrival = path.walk(heights)
        places, taken = ends(path, arrival)
        parts = *places, *arrival.rays.direction, line.part * arrival.rays.flux
        columns = [part.expand(taken.shape)[taken].numpy() for part in parts]
        tables.append(np.column_stack(columns))
        wavelengths.append(np.full(len(columns[0]), 1000 * line.scene.source.wavelength))
    table = np.concatenate(tables)
    nm = np.concatenate(wavelengths) if len(lines) > 1 else None
    return Rays(table[:, :3], table[:, 3:6], table[:, 6], nm)


def _leaving(path: Path, arrival: Arrival) -> tuple[Vector, Tensor]:
    x, y, z = arrival.rays.position
    return (x, y, z + path.datum), arrival.rays.flux > 0


def _arriving(path: Path, arrival: Arrival) -> tuple[Vector, Tensor]:
    arrives = (arrival.rays.flux > 0) & arrival.column.isfinite() & arrival.row.isfinite()
    return path.ends(arrival.rays), arrives


def leaving(design: Design) -> Rays:
    """Trace the rays of the scene in float64 up to the exit face."""
    return _traced(design, _leaving)


def write_rays(design: Design, file: BinaryIO) -> Deviation:
    """Trace the scene's rays in float64 and write a line for each that reaches the receiver.

    Position, direction cosines and flux; their total is the flux on and beside the receiver. Rays
    to a far field are written at a distance behind the lens. The wavelength follows where the light
    has several.
    """
    rays, unit = _traced(design, _arriving), design.unit
    columns = [*rays.position.T, *rays.direction.T, rays.flux]
    header = f"x [{unit}],y [{unit}],z [{unit}],cos x,cos y,cos z,flux"
    if rays.nm is not None:
        columns, header = [*columns, rays.nm], f"{header},wavelength [nm]"
    written = write_table(file, columns, header, delimiter=",")
    off = (rounding(written, axis, rays.position[:, axis]) for axis in (0, 1))
    return Deviation("rounding", max(off), unit)


def write_tm25(design: Design, file: BinaryIO) -> Deviation:
    """Write the rays at the exit face as IES TM-25-13; radiant flux, of 1 W of the source."""
    rays = leaving(design)
    scale = design.metres / _MM
    coloured = [] if rays.nm is None else [rays.nm]
    columns = scale * rays.position, rays.direction, rays.flux, *coloured
    table = np.column_stack(columns).astype("<f4")
    header = np.zeros((), HEADER)
    header["magic"], header["version"], header["method"] = b"TM25", VERSION, 0
    header["luminous_flux"], header["radiant_flux"] = np.nan, rays.flux.sum()
    header["rays"] = len(table)
    header["date"] = datetime.now(UTC).strftime("%Y-%m-%dT%H:%M:%S+00:00").encode()
    header["start"] = 7  # on some other surface: the exit face
    for wavelength in ("wavelength", "shortest", "longest"):
        header[wavelength] = np.nan
    if rays.nm is not None:
        header["shortest"], header["longest"] = rays.nm.min(), rays.nm.max()
    header["flags"] = [1, 1, 1, len(coloured), 0, 0, 0, 0]
    program = f"Freeform Lens Workbench {__version__}"
    header["descriptions"] = ["Freeform lens", "", program, program, program, "", "", "", ""]
    file.write(header.tobytes())
    file.write(table.tobytes())
    error = np.abs(table[:, :3] / scale - rays.position).max(initial=0.0)
    return Deviation("rounding", float(error), design.unit, f"{len(table)} rays at the exit face")
