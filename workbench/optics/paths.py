"""Whole paths of a few rays, for people to look at."""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt
import torch

from workbench.geometry.surface import ControlNet
from workbench.optics.collimated import CollimatedRays
from workbench.scene import CollimatedSource, Scene

Array = npt.NDArray[np.float64]


class RayPaths(NamedTuple):
    """Paths of n rays.

    Attributes
    ----------
    points : ndarray, shape (n, 4, 3)
        Start before the lens, entrance face, exit face, screen plane; scene units. A totally
        reflected ray ends on the exit face, its last two points are the same.
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
    source = CollimatedSource(kind="collimated", rays=count)
    net = ControlNet.of(lens)
    few = CollimatedRays(scene.model_copy(update={"source": source}), net, dtype=torch.float64)
    hits = few.trace(torch.tensor(control_points))
    passes = hits.passes.numpy()

    u, v = ((np.arange(m) + 0.5) / m for m in count)
    z = net.grid(u, v).evaluate(control_points)[0]
    x = np.broadcast_to((2 * u[:, None] - 1) * lens.half_width[0], z.shape)
    y = np.broadcast_to((2 * v[None, :] - 1) * lens.half_width[1], z.shape)

    before = lens.entrance_z - 0.5 * max(lens.half_width)
    exit_face = np.stack([x, y, z], axis=-1)
    on_plane = np.stack([hits.x.numpy(), hits.y.numpy(), np.full(z.shape, screen.z)], axis=-1)
    points = np.stack(
        [
            np.stack([x, y, np.full(z.shape, before)], axis=-1),
            np.stack([x, y, np.full(z.shape, lens.entrance_z)], axis=-1),
            exit_face,
            np.where(passes[..., None], on_plane, exit_face),
        ],
        axis=-2,
    )
    column, row = screen.to_pixels(hits.x.numpy(), hits.y.numpy())
    inside = (column >= 0) & (column < screen.pixels[0]) & (row >= 0) & (row < screen.pixels[1])
    return RayPaths(
        points.reshape(-1, 4, 3),
        (hits.weight.numpy() / hits.arriving).ravel(),
        (inside & passes).ravel(),
    )
