"""Light on a mirror by samples that all origins of the light share: no ray has to search for it.

All of the mirror is lit, wherever its light crosses the plane before it.
"""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
import numpy.typing as npt
import torch
from torch import Tensor

from workbench.geometry.surface import ControlNet, GridBasis
from workbench.optics.arrival import Arrival
from workbench.optics.interfaces import Reflection
from workbench.optics.path import Path
from workbench.optics.rays import RayBundle, Vector
from workbench.optics.samples import Corners, Places, Samples, parts_inside, places
from workbench.optics.sources.origins import Origins
from workbench.optics.steps import Step
from workbench.optics.surfaces import BSplineSurface, Meeting

Array = npt.NDArray[np.float64]


class SharedMirror(NamedTuple):
    """A path of which a mirror is sampled for all origins of its light.

    Attributes
    ----------
    origins : Origins
        Where the light comes from.
    samples : tuple[int, int] or Corners
        Middles of so many cells along x and y, or corners of cells.
    net : ControlNet
        Where the control heights of the mirror sit.
    step : Step
        The mirror.
    """

    origins: Origins
    samples: Samples
    net: ControlNet
    step: Step

    @classmethod
    def of(cls, path: Path) -> "SharedMirror | None":
        """Light without patterns of which samples are wanted, and a B-spline that reflects."""
        emitter, samples = path.emitter, path.emitter.samples
        if samples is None or emitter.origins.pattern is not None:
            return None
        # Middles of cells are those of the plane before it, unless rays are drawn at random.
        if not isinstance(samples, Corners) and emitter.by_area:
            return None
        match path.steps:
            case (Step(BSplineSurface(net=net, subdivisions=None), Reflection()) as step,):
                return cls(emitter.origins, samples, net, step)
        return None

    @property
    def lines(self) -> tuple[Places, Places]:
        """Samples along x and y, and what each stands for, as parts of the way across."""
        return places(self.samples, 0), places(self.samples, 1)

    @property
    def splits(self) -> tuple[Array, Array]:
        """See `workbench.optics.light.BeamTracer`: origins one after the other along y."""
        across, up = self.lines
        return across.split, np.tile(up.split, (len(self.origins.places), 1))


class MirrorSamples:
    """A tensor grid of samples of a mirror, with all that does not depend on the heights.

    Parameters
    ----------
    shared : SharedMirror
        What is sampled.
    path : Path
        The path of the light.
    """

    note = "samples on the mirror, shared by all origins of the light"

    def __init__(self, shared: SharedMirror, path: Path) -> None:
        self._shared, self._path = shared, path

        def constant(values: Array) -> Tensor:
            return torch.as_tensor(values, dtype=path.dtype, device=path.device).contiguous()

        across, up = shared.lines
        basis = shared.net.grid(across.part, up.part)
        self._basis = GridBasis(
            constant(basis.along_x),
            constant(basis.slope_x),
            constant(basis.along_y),
            constant(basis.slope_y),
        )
        r_x, r_y = shared.net.half_width
        area = (across.high - across.low)[:, None] * (up.high - up.low) * (4 * r_x * r_y)
        # Shapes are [samples along x, origins, samples along y].
        self._area = constant(area * parts_inside(path.outline, across, up))[:, None]
        self._x = constant((2 * across.part - 1) * r_x).reshape(-1, 1, 1)
        self._y = constant((2 * up.part - 1) * r_y).reshape(1, 1, -1)
        self._flux = constant(shared.origins.flux).reshape(1, -1, 1)
        places_ = shared.origins.places.T - (
            0.0 if shared.origins.infinite else np.array([[0.0], [0.0], [path.datum]])
        )
        self._from = tuple(constant(part).reshape(1, -1, 1) for part in places_)

    def walk(self, heights: Mapping[str, Tensor]) -> Arrival:
        """Follow the light from the mirror to the receiver; see `Path.walk`."""
        surface, interface, missed = self._shared.step
        above = (heights[surface.name] - self._path.datum).to(self._x.dtype)
        z, face_x, face_y = (part[:, None] for part in self._basis.evaluate(above))
        direction, density = self._light(z)
        d_x, d_y, d_z = direction
        # The mirror takes in more or less light than the plane z = const, as it leans.
        lean = 1 - (d_x * face_x + d_y * face_y) / d_z
        met = lean > 0  # a face that leans away further is not lit from before
        flux = torch.where(met, density * lean * self._area, 0.0)
        shape = flux.shape
        length = (face_x.square() + face_y.square() + 1).rsqrt()
        at = tuple(part.expand(shape) for part in (self._x, self._y, z))
        normal = -face_x * length, -face_y * length, length
        rays = RayBundle(_vector(at), direction, flux, met)
        passed = interface.turn(rays, Meeting(_vector(at), normal, met))
        with torch.no_grad():
            lost = {name: part.sum(dtype=torch.float64) for name, part in passed.lost.items()}
            lost[missed] = 1 - flux.sum(dtype=torch.float64)
        side_by_side = shape[0], shape[1] * shape[2]
        parts = [
            part.expand(shape).reshape(side_by_side)
            for part in (*passed.rays.position, *passed.rays.direction, *passed.rays[2:])
        ]
        out = RayBundle(_vector(parts[:3]), _vector(parts[3:6]), parts[6], parts[7])
        return Arrival(*self._path.receiver.places(out), out, lost)

    def _light(self, z: Tensor) -> tuple[Vector, Tensor]:
        """Directions of light that comes to heights z, and its flux per area of z = const."""
        origins = self._shared.origins
        f_x, f_y, f_z = self._from
        if origins.infinite:
            x, y = self._x - f_x / f_z * z, self._y - f_y / f_z * z
            beside2 = x.square() + y.square() - (x * f_x + y * f_y).square()
            return (f_x, f_y, f_z), self._flux * f_z * torch.exp(-2 * beside2 / origins.waist**2)
        away_x, away_y, away_z = self._x - f_x, self._y - f_y, z - f_z
        distance2 = away_x.square() + away_y.square() + away_z.square()
        near = distance2.rsqrt()
        direction = away_x * near, away_y * near, away_z * near
        density = self._flux * direction[2] / distance2
        return direction, density * direction[2] if origins.lambertian else density


def _vector(parts: "tuple[Tensor, ...] | list[Tensor]") -> Vector:
    x, y, z = parts
    return x, y, z
