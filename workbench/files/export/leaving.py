"""Rays that leave the finished lens."""

from typing import NamedTuple

import numpy as np
import torch

from workbench.arrays import Array
from workbench.files.export.design import Design
from workbench.optics.arrival import Arrival
from workbench.optics.path import Path


class LeavingRays(NamedTuple):
    """Rays where they leave the exit face.

    Attributes
    ----------
    position, direction : ndarray, shape (m, 3)
        Places in scene units, and unit vectors.
    flux : ndarray, shape (m,)
        Above 0; what the source emits in all is 1.
    """

    position: Array
    direction: Array
    flux: Array


def traced(design: Design) -> tuple[Path, Arrival]:
    """The path of the scene in float64, and its rays where they come to the receiver."""
    path = Path.of(design.scene, design.net, torch.float64)
    heights = {face: torch.tensor(each) for face, each in design.result.state.heights.items()}
    with torch.no_grad():
        return path, path.walk(heights)


def leaving(design: Design) -> LeavingRays:
    """Trace the rays of the scene in float64 up to where they leave the lens."""
    path, arrival = traced(design)
    rays = arrival.rays
    leaves = rays.flux > 0
    x, y, z, d_x, d_y, d_z, flux = (
        part.expand(leaves.shape)[leaves].numpy()
        for part in (*rays.position, *rays.direction, rays.flux)
    )
    position = np.column_stack([x, y, z + path.datum])
    return LeavingRays(position, np.column_stack([d_x, d_y, d_z]), flux)
