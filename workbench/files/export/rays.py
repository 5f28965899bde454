"""Ray file: where the rays of the source cross the screen's plane, in which direction."""

from typing import BinaryIO

import numpy as np
import torch

from workbench.files.export.design import Design, Deviation
from workbench.files.export.tables import rounding, write_table
from workbench.optics.collimated import CollimatedRays
from workbench.optics.hits import Hits
from workbench.optics.point import PointRays
from workbench.scene import CollimatedSource


def write_rays(design: Design, file: BinaryIO) -> Deviation:
    """Trace the scene's rays in float64 and write a line for each that gets to the plane.

    Position and direction cosines there, and flux; that of all lines is the flux on the screen
    and beside it.
    """
    z = design.scene.screen.z
    # A second plane, farther away than the lens, tells the directions.
    farther = z + max(z - design.scene.lens.entrance_z, *design.scene.lens.half_width)
    here, there = _hits(design, z), _hits(design, farther)
    arrives = (here.weight > 0) & here.x.isfinite() & there.x.isfinite()
    x, y, beyond_x, beyond_y, flux = (
        c[arrives].numpy() for c in (here.x, here.y, there.x, there.y, here.weight)
    )
    ray = np.stack([beyond_x - x, beyond_y - y, np.full_like(x, farther - z)])
    ray /= np.linalg.norm(ray, axis=0)
    unit = design.unit
    header = f"x [{unit}],y [{unit}],z [{unit}],cos x,cos y,cos z,flux"
    written = write_table(file, [x, y, np.full_like(x, z), *ray, flux], header, delimiter=",")
    return Deviation("rounding", max(rounding(written, 0, x), rounding(written, 1, y)), unit)


def _hits(design: Design, z: float) -> Hits:
    screen = design.scene.screen.model_copy(update={"z": z})
    scene, net = design.scene.model_copy(update={"screen": screen}), design.net
    rays: CollimatedRays | PointRays
    if isinstance(scene.source, CollimatedSource):
        rays = CollimatedRays(scene, net, scene.source.rays, torch.float64)
    else:
        rays = PointRays(scene, net, dtype=torch.float64)
    with torch.no_grad():
        hits = rays.trace(torch.tensor(design.heights))
    return Hits(*(part.expand(hits.x.shape) for part in hits))
