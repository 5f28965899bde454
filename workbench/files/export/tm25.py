"""Rays that leave the finished lens, as IES TM-25-13."""

from datetime import UTC, datetime
from typing import BinaryIO

import numpy as np

from workbench import __version__
from workbench.files.export.design import Design, Deviation
from workbench.files.export.leaving import leaving
from workbench.measured.rays.tm25 import HEADER, VERSION

_MM = 1e-3  # lengths of the format, in metres


def write_tm25(design: Design, file: BinaryIO) -> Deviation:
    """Write the rays at the exit face; their flux is radiant flux, of 1 W of the source."""
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
