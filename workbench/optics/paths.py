"""Whole paths of a few rays, for people to look at."""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
import torch

from workbench.arrays import Array, Mask
from workbench.geometry.outlines import outline_of
from workbench.geometry.surface import ControlNet
from workbench.optics.path import Path
from workbench.optics.rays import Vector
from workbench.scene import Element, Scene


class RayPaths(NamedTuple):
    """Paths of n rays."""

    # (n, k, 3), start, places on each face, screen plane; scene units. A ray that does not get to
    # the screen plane ends on the last face or the side: its last two points are the same.
    points: Array
    weight: Array  # (n,), part of the ray's light that arrives, 0 under total reflection
    on_screen: Mask  # (n,), whether it hits the screen


def ray_paths(scene: Scene, heights: Mapping[str, Array], count: tuple[int, int]) -> RayPaths:
    """Follow a grid of rays from before the lens to the screen.

    `heights` (n_u, n_v); `count`: numbers of rays along x and y, spread over the lens.
    """
    x, y = (torch.as_tensor(c) for c in _grid(scene.first, count))
    path = Path.of(scene, ControlNet.of(scene.optic), torch.float64)
    rays = path.emitter.towards(x, y)
    tensors = {face: torch.tensor(each) for face, each in heights.items()}
    places, arrival = path.follow(rays, tensors)
    hits = arrival.column.isfinite() & arrival.row.isfinite() & (arrival.rays.flux > 0)
    ends = _rows(path.ends(arrival.rays), len(x))
    before = [_rows(place, len(x)) for place in places]
    last = np.where(hits.numpy()[:, None], ends, before[-1])
    points = np.stack([*before, last], axis=1)
    share = (arrival.rays.flux / rays.flux).expand(len(x)).numpy()
    inside = scene.receiver.covers(arrival.column, arrival.row) & hits
    return RayPaths(points, share, inside.expand(len(x)).numpy())


def _rows(place: Vector, count: int) -> Array:
    """Places as rows, shape (count, 3)."""
    return np.stack([c.expand(count).numpy() for c in place], axis=-1)


def _grid(optic: Element, count: tuple[int, int]) -> tuple[Array, Array]:
    """Places (x, y) spread over the lens in rows, each of shape (n,); middles of its rectangles."""
    u, v = ((np.arange(m) + 0.5) / m * 2 - 1 for m in count)
    x, y = outline_of(optic).from_square(u[:, None], v)
    return x.ravel(), y.ravel()
