"""Ray file: where the rays of the source cross the screen's plane, in which direction."""

from typing import BinaryIO

import numpy as np
import torch

from workbench.files.export.design import Design, Deviation
from workbench.files.export.tables import rounding, write_table
from workbench.optics.path import Path


def write_rays(design: Design, file: BinaryIO) -> Deviation:
    """Trace the scene's rays in float64 and write a line for each that gets to the plane.

    Position and direction cosines there, and flux; that of all lines is the flux on the screen
    and beside it.
    """
    z = design.scene.screen.z
    path = Path.of(design.scene, design.net, torch.float64)
    with torch.no_grad():
        arrival = path.walk({"exit": torch.tensor(design.heights)})
    arrives = (arrival.rays.flux > 0) & arrival.x.isfinite() & arrival.y.isfinite()
    x, y, flux, *direction = (
        part.expand(arrives.shape)[arrives].numpy()
        for part in (arrival.x, arrival.y, arrival.rays.flux, *arrival.rays.direction)
    )
    unit = design.unit
    header = f"x [{unit}],y [{unit}],z [{unit}],cos x,cos y,cos z,flux"
    written = write_table(file, [x, y, np.full_like(x, z), *direction, flux], header, delimiter=",")
    return Deviation("rounding", max(rounding(written, 0, x), rounding(written, 1, y)), unit)
