"""Whole paths of a few rays, for people to look at."""

import math
from typing import NamedTuple

import numpy as np
import numpy.typing as npt
import torch
from torch import Tensor

from workbench.geometry.surface import ControlNet
from workbench.optics.collimated import CollimatedRays
from workbench.optics.emission import Rays, enter
from workbench.optics.hits import Hits
from workbench.optics.point import PointRays
from workbench.scene import CollimatedSource, GridSource, Lens, PointSource, Scene

Array = npt.NDArray[np.float64]


class RayPaths(NamedTuple):
    """Paths of n rays.

    Attributes
    ----------
    points : ndarray, shape (n, 4, 3)
        Start, entrance face, exit face, screen plane; scene units. A ray that does not get to
        the screen plane ends on the exit face or the side: its last two points are the same.
    weight : ndarray, shape (n,)
        Part of the ray's light that arrives, 0 under total reflection.
    on_screen : ndarray of bool, shape (n,)
        Whether it hits the screen.
    """

    points: Array
    weight: Array
    on_screen: npt.NDArray[np.bool_]


def ray_paths(scene: Scene, control_points: Array, count: tuple[int, int]) -> RayPaths:
    """Follow a grid of rays from before the lens to the screen.

    Parameters
    ----------
    scene : Scene
        The scene.
    control_points : ndarray, shape (n_u, n_v)
        Control heights, scene units.
    count : tuple[int, int]
        Numbers of rays along x and y, spread over the aperture.
    """
    lens, screen = scene.lens, scene.screen
    net = ControlNet.of(lens)
    heights = torch.tensor(control_points)
    if isinstance(scene.source, CollimatedSource):
        before, entrance, hits, exit_face = _collimated(scene, net, heights, count)
    else:
        before, entrance, hits, exit_face = _from_points(scene, scene.source, net, heights, count)
    hit = np.stack([hits.x.numpy().ravel(), hits.y.numpy().ravel()], axis=-1)
    arrives = (hits.weight > 0).numpy().ravel() & np.isfinite(hit).all(axis=1)
    on_plane = np.column_stack([hit, np.full(len(hit), screen.z)])
    points = np.stack(
        [before, entrance, exit_face, np.where(arrives[:, None], on_plane, exit_face)], axis=1
    )
    share = (hits.weight / hits.arriving.clamp_min(1e-300)).numpy().ravel()
    return RayPaths(points, share, screen.contains(*hit.T) & arrives)


def _collimated(
    scene: Scene, net: ControlNet, heights: Tensor, count: tuple[int, int]
) -> tuple[Array, Array, Hits, Array]:
    lens = scene.lens
    few = CollimatedRays(scene, net, count, torch.float64)
    places = _grid(lens, count)
    u, v = ((np.arange(m) + 0.5) / m for m in count)
    z = net.grid(u, v).evaluate(heights.numpy())[0]
    before = lens.entrance_z - 0.5 * max(lens.half_width)
    return (
        _at(places, np.full(len(places), before)),
        _at(places, np.full(len(places), lens.entrance_z)),
        few.trace(heights),
        _at(places, z.ravel()),
    )


def _from_points(
    scene: Scene,
    source: PointSource | GridSource,
    net: ControlNet,
    heights: Tensor,
    count: tuple[int, int],
) -> tuple[Array, Array, Hits, Array]:
    """Rays from the middle of the source, and from its corners, to places on the entrance face."""
    lens = scene.lens
    origins = _middle_and_corners(source)
    places = _at(_grid(lens, count), np.full(math.prod(count), lens.entrance_z))
    origin = origins[np.arange(len(places)) % len(origins)]
    direction = places - origin
    direction /= np.linalg.norm(direction, axis=1, keepdims=True)
    rays = enter(Rays(places[:, :2], direction, np.full(len(places), 1 / len(places))), lens)
    few = PointRays(scene, net, rays, dtype=torch.float64)
    hits = few.trace(heights)
    depth = few.depths(heights).numpy()
    exit_xy = np.stack([rays.x + rays.slope_x * depth, rays.y + rays.slope_y * depth], axis=-1)
    return origin, places, hits, _at(exit_xy, lens.entrance_z + depth)


def _middle_and_corners(source: PointSource | GridSource) -> Array:
    if isinstance(source, GridSource):
        corners = source.model_copy(update={"points": (2, 2)}).positions
        return np.vstack([source.center, corners])
    return source.positions


def _grid(lens: Lens, count: tuple[int, int]) -> Array:
    """Cell centres of the aperture, shape (n, 2)."""
    x, y = (
        ((np.arange(m) + 0.5) / m * 2 - 1) * r for m, r in zip(count, lens.half_width, strict=True)
    )
    return np.stack([c.ravel() for c in np.meshgrid(x, y, indexing="ij")], axis=-1)


def _at(xy: Array, z: Array) -> Array:
    return np.column_stack([xy, z])
