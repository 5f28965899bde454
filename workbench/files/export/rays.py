"""Ray files: rays at the receiver, and rays behind the lens as IES TM-25."""

from datetime import UTC, datetime
from typing import BinaryIO, NamedTuple

import numpy as np
import torch

from workbench import __version__
from workbench.arrays import Array
from workbench.files.export.design import Design, Deviation
from workbench.files.export.tables import rounding, write_table
from workbench.measured.rays.tm25 import HEADER, VERSION
from workbench.optics.arrival import Arrival
from workbench.optics.path import Path

_MM = 1e-3  # lengths of the format, in metres


class LeavingRays(NamedTuple):
    """Rays at the exit face: position in scene units, unit direction (m, 3), flux (m,) > 0."""

    position: Array
    direction: Array
    flux: Array


def traced(design: Design) -> tuple[Path, Arrival]:
    """Return the traced path of the scene in float64, and its rays at the receiver."""
    path = Path.of(design.scene, design.net, torch.float64)
    heights = {face: torch.tensor(each) for face, each in design.result.state.heights.items()}
    with torch.no_grad():
        return path, path.walk(heights)


def leaving(design: Design) -> LeavingRays:
    """Trace the rays of the scene in float64 up to the exit face."""
    path, arrival = traced(design)
    rays = arrival.rays
    leaves = rays.flux > 0
    x, y, z, d_x, d_y, d_z, flux = (
        part.expand(leaves.shape)[leaves].numpy()
        for part in (*rays.position, *rays.direction, rays.flux)
    )
    position = np.column_stack([x, y, z + path.datum])
    return LeavingRays(position, np.column_stack([d_x, d_y, d_z]), flux)


def write_rays(design: Design, file: BinaryIO) -> Deviation:
    """Trace the scene's rays in float64 and write a line for each that reaches the receiver.

    Position, direction cosines and flux; their total is the flux on and beside the receiver. Rays
    to a far field are written at a distance behind the lens.
    """
    path, arrival = traced(design)
    arrives = (arrival.rays.flux > 0) & arrival.column.isfinite() & arrival.row.isfinite()
    ends = path.ends(arrival.rays)
    x, y, z, flux, *direction = (
        part.expand(arrives.shape)[arrives].numpy()
        for part in (*ends, arrival.rays.flux, *arrival.rays.direction)
    )
    unit = design.unit
    header = f"x [{unit}],y [{unit}],z [{unit}],cos x,cos y,cos z,flux"
    written = write_table(file, [x, y, z, *direction, flux], header, delimiter=",")
    return Deviation("rounding", max(rounding(written, 0, x), rounding(written, 1, y)), unit)


def write_tm25(design: Design, file: BinaryIO) -> Deviation:
    """Write the rays at the exit face as IES TM-25-13; radiant flux, of 1 W of the source."""
    rays = leaving(design)
    scale = design.metres / _MM
    table = np.empty((len(rays.flux), 7), "<f4")
    table[:, :3], table[:, 3:6], table[:, 6] = scale * rays.position, rays.direction, rays.flux
    header = np.zeros((), HEADER)
    header["magic"], header["version"], header["method"] = b"TM25", VERSION, 0
    header["luminous_flux"], header["radiant_flux"] = np.nan, rays.flux.sum()
    header["rays"] = len(table)
    header["date"] = datetime.now(UTC).strftime("%Y-%m-%dT%H:%M:%S+00:00").encode()
    header["start"] = 7  # on some other surface: the exit face
    for wavelength in ("wavelength", "shortest", "longest"):
        header[wavelength] = np.nan
    header["flags"] = [1, 1, 1, 0, 0, 0, 0, 0]
    program = f"Freeform Lens Workbench {__version__}"
    header["descriptions"] = ["Freeform lens", "", program, program, program, "", "", "", ""]
    file.write(header.tobytes())
    file.write(table.tobytes())
    error = np.abs(table[:, :3] / scale - rays.position).max(initial=0.0)
    return Deviation("rounding", float(error), design.unit, f"{len(table)} rays at the exit face")
