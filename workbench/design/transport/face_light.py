"""Light where it meets the exit face, or a mirror, from inside."""

import math

import numpy as np
import torch

from workbench.arrays import Array
from workbench.design.transport.between import Pair
from workbench.design.transport.face import SlopeFit
from workbench.geometry.surface import ControlNet
from workbench.optics.glass import FlatGlass
from workbench.optics.interfaces import TransmittanceLaw
from workbench.optics.path import Path
from workbench.optics.plan import precision_of
from workbench.optics.reference import Reference
from workbench.optics.sources import emitter_of
from workbench.scene import ExactMethod, PointSource, Scene

# Light that leaves a face changes little from one of these cells to the next: each stands for so
# many along an axis.
_SHARED = 2
# In half-widths of the optic: rays that meet the face so near to the middles of cells are theirs.
_NEAR = 1e-6


class FaceLight:
    """Light on the exit face: its flux in each cell, and its direction from inside.

    It comes from one place, the middle of the source; what a file says of its intensity counts.
    """

    def __init__(self, scene: Scene, net: ControlNet, fit: SlopeFit, cells: int) -> None:
        r_x, r_y = scene.optic.half_width
        middle = 2 * (np.arange(cells) + 0.5) / cells - 1
        self.x, self.y = (middle * r_x)[:, None], (middle * r_y)[None, :]
        self._entrance_z, self._face = scene.optic.front_z, scene.optic.designed_face
        self._along: tuple[float, float, float] | None = None
        self._glass: FlatGlass | None = None
        self._fit, self._given = fit, emitter_of(scene.source, scene.optic).origins
        sharp = scene.source.sharp
        if self._given.pattern is not None:  # a file's origin need not be where its light is
            x, y, z = (float(c) for c in self._given.middle(self.x, self.y, self._entrance_z))
            sharp = PointSource(kind="point", position=(x, y, z))
        if isinstance(sharp, PointSource):  # a first lens needs no triangles
            sharp = sharp.model_copy(update={"intersection": ExactMethod()})
        scene = scene.model_copy(update={"source": sharp})
        self._scene, self._net = scene, net
        origins = emitter_of(scene.source, scene.optic).origins
        (x, y, z), n = origins.places[0], scene.optic.index
        if origins.infinite:  # by Snell's law, one direction in the glass
            self._along = x / n, y / n, math.sqrt(1 - (x**2 + y**2) / n**2)
        else:
            self._away_x, self._away_y = self.x - x, self.y - y
            self._from_z = z
            if n > 1:
                entering = TransmittanceLaw.constant(1 / n, 0.0)  # it bends as any other
                self._glass = FlatGlass(self._entrance_z - z, entering, origins.lambertian)
        self._sharp = origins
        samples = cells // _SHARED, cells // _SHARED
        self._reference = Reference(Path.of(scene, net, torch.float64, samples=samples))

    def flux(self, heights: Array) -> Array | None:
        """Flux that leaves the face, in each cell; all together 1. None if there is none."""
        with torch.no_grad():
            leaving = self._reference.arrival({self._face: torch.as_tensor(heights)}).rays.flux
        flux = leaving.numpy().astype(np.float64)
        flux = flux.repeat(_SHARED, 0).repeat(_SHARED, 1)
        if self._given.pattern is not None:
            flux = flux * self._brighter(self._fit.surface(heights))
        total = float(flux.sum())
        return flux / total if total > 0 else None

    def flux_or(self, heights: Array, flux: Array) -> Array:
        """`flux`, or another one if a lens reflects all light: it is improved blindly."""
        passed = self.flux(heights)
        return flux if passed is None else passed

    def goes_to(self, heights: Array) -> Pair | None:
        """Where on the receiver the light of each cell lands, in the receiver's coordinates.

        None where some of it lands nowhere, or where rays do not meet the face in the middles of
        cells.
        """
        cells = len(self.x), self.y.size
        kind = precision_of(self._scene)
        reference = Reference(Path.of(self._scene, self._net, kind, samples=cells))
        with torch.no_grad():
            face = torch.tensor(heights, dtype=kind)
            column, row, rays, *_ = reference.arrival({self._face: face})
        at, middles = rays.position[:2], (self.x, self.y)
        away = [np.abs(found.numpy() - m).max() for found, m in zip(at, middles, strict=True)]
        if max(away) > _NEAR * max(self._scene.optic.half_width) or not (
            column.isfinite().all() and row.isfinite().all()
        ):
            return None
        u, v = self._scene.receiver.from_pixels(column.double().numpy(), row.double().numpy())
        return u, v

    def _brighter(self, z: Array) -> Array:
        """Light that enters on its way to each place, over that of the point in the middle."""
        d_x, d_y, d_z = self.direction(z)
        depth = z - self._entrance_z
        x, y = self.x - depth * d_x / d_z, self.y - depth * d_y / d_z
        given, even = (o.density(x, y, self._entrance_z) for o in (self._given, self._sharp))
        return given / even

    def direction(self, z: Array) -> tuple[Array, Array, Array]:
        """Unit vectors at places of the face with heights z."""
        if self._along is not None:
            d_x, d_y, d_z = (np.full_like(z, part) for part in self._along)
            return d_x, d_y, d_z
        if self._glass is None:
            return _unit(self._away_x, self._away_y, z - self._from_z)
        depth = torch.as_tensor((z - self._entrance_z).clip(0))
        radius2 = torch.as_tensor(self._away_x**2 + self._away_y**2)
        slope = self._glass.slope(radius2, depth).numpy()
        return _unit(self._away_x * slope, self._away_y * slope, np.ones_like(z))


def _unit(x: Array, y: Array, z: Array) -> tuple[Array, Array, Array]:
    """Vectors of length 1 along others."""
    length = np.sqrt(x**2 + y**2 + z**2)
    return x / length, y / length, z / length
