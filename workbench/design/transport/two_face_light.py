"""Light in a lens behind a face that is not flat, as a first design needs it: quickly.

Freeform faces are known at even cells, and taken as straight between these: a search on the
B-splines themselves took three quarters of the time of a first design.
"""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.design.transport.cells import Pair, Vector, between, met, whence
from workbench.design.transport.faces import SlopeFit
from workbench.design.transport.view import ReceiverView
from workbench.geometry.surface import ControlNet
from workbench.optics.path import Path
from workbench.optics.rays import RayBundle
from workbench.optics.sources import emitter_of
from workbench.optics.sources.origins import through_cells
from workbench.optics.surfaces import Meeting
from workbench.optics.surfaces.intersection import RIM
from workbench.scene import Scene


class LightInLens(NamedTuple):
    """Light of each cell in a lens; arrays of shape (cells, cells), the first along x."""

    # Places where it meets the faces; of light that does not, stand-ins.
    entrance: Vector
    exit: Vector
    glass: Vector  # unit vectors along which it goes between the faces
    normal: Vector  # unit vectors upright on the exit face where it meets that
    # Of what leaves the lens, or would leave it by another exit face where this one reflects it
    # totally; all together 1. None where that is none.
    flux: Array | None
    inside: Array  # flux that meets the exit face, as parts of that of the source


class TwoFaceLight:
    """Light of a scene through even cells of the plane before the lens.

    `scene`: with a lens; an extended source counts as a point at its centre; `fits`: the splines of
    each freeform face in the middles of even cells; `cells`: along each axis.
    `coming`: unit vectors along which it comes.
    """

    def __init__(self, scene: Scene, fits: Mapping[str, SlopeFit], cells: int) -> None:
        lens = scene.optic
        scene = scene.model_copy(update={"source": scene.source.sharp})
        self._path = Path.of(scene, ControlNet.of(lens), torch.float64)
        origins = emitter_of(scene.source, lens).origins
        rays = through_cells(origins, lens, (cells, cells))
        x, y, z = (part.expand(cells, cells) for part in rays.position)
        self._rays = rays._replace(position=(x, y, z - self._path.datum))
        self.coming = to_arrays(rays.direction)
        self._widths = 2 * lens.half_width[0] / cells, 2 * lens.half_width[1] / cells
        self._fits = fits
        # From which cells light came to the cells of a face last.
        self._own, self._cells = ReceiverView.grid(cells), cells
        self._from = dict.fromkeys(fits, self._own)

    def through(self, heights: dict[str, Array]) -> LightInLens:
        """The light in a lens with these control heights, z as in the scene."""
        found: list[Vector] = []
        rays = self._rays
        with torch.no_grad():
            for step in self._path.steps:
                name = step.surface.name
                if name in self._fits:
                    meeting = self._meet(name, rays, heights[name])
                else:
                    meeting = step.surface.meet(rays, {})
                inside = torch.where(meeting.met, rays.flux, 0.0).numpy()
                rays = step.interface.turn(rays, meeting).rays
                found += [to_arrays(meeting.position), to_arrays(rays.direction)]
        flux = rays.flux.numpy()
        if flux.any():
            flux = np.where(flux > 0, flux, inside)
        entrance, glass, exit_face, _ = found
        total = float(flux.sum())
        return LightInLens(
            self._lifted(entrance),
            self._lifted(exit_face),
            glass,
            to_arrays(meeting.normal),
            flux / total if total > 0 else None,
            inside,
        )

    def evenly(self, values: tuple[Array, Array], face: str, place: Vector) -> tuple[Array, Array]:
        """Values of the light that comes to the middles of even cells of a face.

        `values` (cells, cells): of the light of each cell of the plane before the lens; `face`: its
        name; `place`: where that light meets it.
        """
        meets = self._in_cells(*place[:2])
        self._from[face] = cell = whence(meets, self._own, self._from[face])
        x, y = (between(each, cell) for each in values)
        return x, y

    def _meet(self, face: str, rays: RayBundle, heights: Array) -> Meeting:
        """Where rays meet a face that is straight between the middles of cells."""
        (x, y, z), (d_x, d_y, d_z) = to_arrays(rays.position), to_arrays(rays.direction)
        a, b = d_x / d_z, d_y / d_z
        heights, fit = heights - self._path.datum, self._fits[face]
        found = fit.surface(heights), *fit.slopes(heights)
        up, z_x, z_y = met(found, self._widths, (x - a * z, y - b * z), (a, b))
        x, y = x + a * (up - z), y + b * (up - z)
        length = 1 / np.sqrt(z_x**2 + z_y**2 + 1)
        inside = self._path.outline.contains(x / RIM, y / RIM)
        position, normal = (x, y, up), (-z_x * length, -z_y * length, length)
        return Meeting(to_tensors(position), to_tensors(normal), torch.as_tensor(inside))

    def _in_cells(self, x: Array, y: Array) -> Pair:
        at_x, at_y = (
            place / width + (self._cells - 1) / 2
            for place, width in zip((x, y), self._widths, strict=True)
        )
        return at_x, at_y

    def _lifted(self, place: Vector) -> Vector:
        x, y, z = place
        return x, y, z + self._path.datum


def to_arrays(vector: tuple[Tensor, Tensor, Tensor]) -> Vector:
    """The parts of a vector, all of the same shape."""
    shape = np.broadcast_shapes(*(part.shape for part in vector))
    x, y, z = (part.expand(shape).numpy() for part in vector)
    return x, y, z


def to_tensors(vector: Vector) -> tuple[Tensor, Tensor, Tensor]:
    """The same vector for what takes tensors."""
    x, y, z = map(torch.as_tensor, vector)
    return x, y, z
