"""Light of one point, or of a grid of points that stands for an extended source."""

import numpy as np
import numpy.typing as npt
import torch
from torch import Tensor

from workbench.optics.emission import emit
from workbench.optics.rays import RayBundle, Vector
from workbench.scene import Lens, LightOfPoints

Array = npt.NDArray[np.float64]


class PointEmitter:
    """Rays into the cones that just cover the entrance face; an `Emitter`.

    Parameters
    ----------
    source : LightOfPoints
        Where the points are, and how they emit.
    lens : Lens
        Gives the entrance face.
    samples : tuple[int, int], optional
        Of the exit face along x and y; see `workbench.optics.face_samples`.

    Attributes
    ----------
    source, lens, samples
        As given.
    """

    def __init__(
        self,
        source: LightOfPoints,
        lens: Lens,
        samples: tuple[int, int] | None = None,
    ) -> None:
        self.source, self.lens, self.samples = source, lens, samples

    def rays(self, seed: int, draw: int = 0) -> RayBundle:
        """Rays drawn by the seed; see `Emitter.rays`."""
        rays = emit(self.source, self.lens, seed, draw)
        onto_face = np.column_stack([rays.crossing, np.full(len(rays.flux), self.lens.entrance_z)])
        return _bundle(onto_face, rays.direction, rays.flux)

    def towards(self, x: Tensor, y: Tensor) -> RayBundle:
        """Rays from the middle of the source and its corners in turn; see `Emitter.towards`."""
        corners = np.vstack([self.source.place, self.source.corners])
        place = np.column_stack([x, y, np.full(len(x), self.lens.entrance_z)])
        origin = corners[np.arange(len(place)) % len(corners)]
        direction = place - origin
        direction /= np.linalg.norm(direction, axis=1, keepdims=True)
        return _bundle(origin, direction, np.full(len(place), 1 / len(place)))


def _bundle(origin: Array, direction: Array, flux: Array) -> RayBundle:
    alive = torch.ones(len(flux), dtype=torch.bool)
    return RayBundle(_vector(origin), _vector(direction), torch.as_tensor(flux), alive)


def _vector(rows: Array) -> Vector:
    x, y, z = torch.as_tensor(rows).unbind(1)
    return x.contiguous(), y.contiguous(), z.contiguous()
