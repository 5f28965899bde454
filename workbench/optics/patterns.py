"""Intensities of origins by where their light crosses a plane, in tables.

The reference and its compiled twins interpolate between the same values.
"""

import math

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.optics.sources.origins import Origins

# Places along an axis at which patterns are looked up: of all origins together, and of each at
# least and at most.
_ALL, _FEWEST, _MOST = 2048, 65, 513


def tabulated(origins: Origins, half_width: tuple[float, float], z: float) -> Array | None:
    """Intensities of each origin towards places of a rectangle across the axis, over its flux.

    Parameters
    ----------
    origins : Origins
        Points before the rectangle.
    half_width : tuple[float, float]
        Of the rectangle, scene units.
    z : float
        Where it is.

    Returns
    -------
    ndarray, shape (origins, n, n), optional
        From −x to x, and from −y to y in the last axis. None where no pattern was given.
    """
    if origins.pattern is None:
        return None
    count = len(origins.flux)
    n = min(max(int(_ALL / math.sqrt(count)), _FEWEST), _MOST)
    (r_x, r_y), way = half_width, np.linspace(-1, 1, n)
    place = origins.places[:, None, None]
    x, y = way[:, None] * r_x - place[..., 0], way * r_y - place[..., 1]
    away = np.broadcast_arrays(x, y, z - place[..., 2])
    distance = np.sqrt(np.square(away).sum(axis=0))
    direction = (away[0] / distance, away[1] / distance, away[2] / distance)
    return origins.pattern.at(np.arange(count)[:, None, None], direction)


def interpolated(
    patterns: Tensor, place: tuple[Tensor, Tensor], half_width: tuple[float, float]
) -> Tensor:
    """Values of tables at places; bilinear, and constant beyond the rectangle.

    Parameters
    ----------
    patterns : Tensor, shape (origins, n, n)
        What `tabulated` gives.
    place : tuple of two Tensor, shape (samples along x, origins, samples along y)
        x and y of the places.
    half_width : tuple[float, float]
        Of the rectangle.
    """
    last = patterns.shape[1] - 1
    origin = torch.arange(len(patterns), device=patterns.device).reshape(1, -1, 1)
    (i, u), (j, v) = (
        _cell((along / r + 1) * (last / 2), last)
        for along, r in zip(place, half_width, strict=True)
    )
    low = patterns[origin, i, j] * (1 - v) + patterns[origin, i, j + 1] * v
    high = patterns[origin, i + 1, j] * (1 - v) + patterns[origin, i + 1, j + 1] * v
    return low * (1 - u) + high * u


def _cell(place: Tensor, last: int) -> tuple[Tensor, Tensor]:
    """Number of the cell of a place, and which part of the cell is before it."""
    place = place.clamp(0, last)
    cell = place.detach().floor().clamp(0, last - 1)
    return cell.long(), place - cell
