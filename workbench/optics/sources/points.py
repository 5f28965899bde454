"""Light of one point, or of a grid of points that stands for an extended source."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt
import torch
from torch import Tensor

from workbench.optics.emission import emit
from workbench.optics.entering import intensity_of
from workbench.optics.rays import RayBundle, Vector
from workbench.optics.samples import Corners, Samples, places, places_of_points
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
    samples : tuple[int, int] or Corners, optional
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
        samples: Samples | None = None,
    ) -> None:
        self.source, self.lens, self.samples = source, lens, samples

    @property
    def splits(self) -> tuple[Array, Array]:
        """See `Emitter`; points that make no grid come one after the other along y."""
        corners, axes = self._corners, self.source.axes
        points = (1, len(self.source.positions)) if axes is None else (len(axes[0]), len(axes[1]))
        along_x, along_y = (
            places_of_points(corners, axis, count).split for axis, count in enumerate(points)
        )
        return along_x, along_y

    @property
    def _corners(self) -> Corners:
        if not isinstance(self.samples, Corners):
            raise TypeError("these rays are no corners of cells")
        return self.samples

    def rays(self, seed: int, draw: int = 0) -> RayBundle:
        """Rays drawn by the seed, or at corners of cells; see `Emitter.rays`."""
        if isinstance(self.samples, Corners):
            return self._through_corners(self.samples)
        rays = emit(self.source, self.lens, seed, draw)
        onto_face = np.column_stack([rays.crossing, np.full(len(rays.flux), self.lens.entrance_z)])
        return _bundle(onto_face, rays.direction, rays.flux)

    def _through_corners(self, corners: Corners) -> RayBundle:
        """Rays through corners of cells of the entrance face, shape (m_x, m_y for each point)."""
        lens, points = self.lens, self.source.positions
        across, up = places(corners, 0), places_of_points(corners, 1, len(points))
        r_x, r_y = lens.half_width
        point = np.repeat(np.arange(len(points)), len(up.part) // len(points))
        x, y = ((2 * along.part - 1) * r for along, r in ((across, r_x), (up, r_y)))
        away = np.stack(
            np.broadcast_arrays(
                x[:, None] - points[point, 0],
                y - points[point, 1],
                lens.entrance_z - points[point, 2],
            )
        )
        distance = np.linalg.norm(away, axis=0)
        cos = away[2] / distance
        area = 4 * r_x * r_y * (across.high - across.low)[:, None] * (up.high - up.low)
        flux = intensity_of(self.source, lens) * cos / distance**2 * area
        if self.source.emission == "lambertian":
            flux *= cos
        place = np.broadcast_arrays(x[:, None], y, lens.entrance_z * np.ones_like(cos))
        alive = torch.ones(flux.shape, dtype=torch.bool)
        return RayBundle(_parts(place), _parts(away / distance), torch.as_tensor(flux), alive)

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


def _parts(values: Sequence[Array]) -> Vector:
    x, y, z = (torch.as_tensor(np.ascontiguousarray(part)) for part in values)
    return x, y, z


def _vector(rows: Array) -> Vector:
    x, y, z = torch.as_tensor(rows).unbind(1)
    return x.contiguous(), y.contiguous(), z.contiguous()
