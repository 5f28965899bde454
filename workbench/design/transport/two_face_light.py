"""Light in a lens of two freeform faces, as a first lens needs it: quickly, and nearly right.

Both faces are known at even cells, and taken as straight between these: a search on the B-splines
themselves took three quarters of the time of a first lens.
"""

from typing import NamedTuple

import numpy as np
import torch
from torch import Tensor
from torch.nn.functional import grid_sample

from workbench.arrays import Array
from workbench.geometry.surface import freeform_nets
from workbench.optics.intersection import RIM
from workbench.optics.path import Path
from workbench.optics.rays import RayBundle
from workbench.optics.samples import places
from workbench.optics.sources import emitter_of
from workbench.optics.sources.origins import through_cells
from workbench.optics.surfaces import Meeting
from workbench.scene import Scene

Vector = tuple[Array, Array, Array]

# Steps of a search at most, and how near it comes on average, in cells.
_MOST_STEPS, _NEAR = 40, 0.01
# How far each step of one for places goes at most, in half-widths, and the least area of a cell
# there, as a part of what it was.
_FAR, _LEAST_AREA = 0.2, 1e-3
# How fast a face is taken to fall away from a ray, for each length, at least: with less, Newton
# steps of light that comes steeply to a steep face do not settle.
_LEAST_FALL = 0.5


class LightInLens(NamedTuple):
    """Light of each cell in a lens; arrays of shape (cells, cells), the first along x.

    Attributes
    ----------
    entrance, exit : tuple of three ndarray
        Places where it meets the faces; of light that does not, stand-ins.
    glass : tuple of three ndarray
        Unit vectors along which it goes between the faces.
    flux : ndarray, optional
        Of what leaves the lens, all together 1; None where that is none.
    """

    entrance: Vector
    exit: Vector
    glass: Vector
    flux: Array | None


class TwoFaceLight:
    """Light of a scene through even cells of the plane before the lens.

    Parameters
    ----------
    scene : Scene
        With a lens of two freeform faces; an extended source counts as a point at its centre.
    cells : int
        Along each axis.

    Attributes
    ----------
    coming : tuple of three ndarray
        Unit vectors along which it comes.
    """

    def __init__(self, scene: Scene, cells: int) -> None:
        lens = scene.optic
        nets = freeform_nets(lens)
        scene = scene.model_copy(update={"source": scene.source.sharp})
        self._path = Path.of(scene, nets["exit"], torch.float64)
        origins = emitter_of(scene.source, lens).origins
        rays = through_cells(origins, lens, (cells, cells))
        x, y, z = (part.expand(cells, cells) for part in rays.position)
        self._rays = rays._replace(position=(x, y, z - self._path.datum))
        self.coming = _arrays(rays.direction)
        middles = places((cells, cells), 0).part
        self._bases = {face: net.grid(middles, middles) for face, net in nets.items()}
        # Middles of cells in half-widths, and from which of them light came to these places of a
        # face last.
        even = torch.as_tensor(2 * middles - 1)
        self._own, self._cells = torch.stack(torch.meshgrid(even, even, indexing="ij")), cells
        self._from = dict.fromkeys(nets, self._own)

    def through(self, heights: dict[str, Array]) -> LightInLens:
        """The light in a lens with these control heights, z as in the scene."""
        found: list[Vector] = []
        rays = self._rays
        with torch.no_grad():
            for surface, interface, _ in self._path.steps:
                meeting = self._meet(surface.name, rays, heights[surface.name])
                rays = interface.turn(rays, meeting).rays
                found += [_arrays(meeting.position), _arrays(rays.direction)]
        flux = rays.flux.numpy()
        entrance, glass, exit_face, _ = found
        total = float(flux.sum())
        return LightInLens(
            self._lifted(entrance),
            self._lifted(exit_face),
            glass,
            flux / total if total > 0 else None,
        )

    def evenly(self, values: tuple[Array, Array], face: str, place: Vector) -> tuple[Array, Array]:
        """Values of the light that comes to the middles of even cells of a face.

        Parameters
        ----------
        values : tuple of two ndarray, shape (cells, cells)
            Of the light of each cell of the plane before the lens.
        face : str
            Its name.
        place : tuple of three ndarray
            Where that light meets it.
        """
        meets = self._in_half_widths(*map(torch.as_tensor, place[:2]))
        cell = _whence(meets, self._own, self._from[face])
        self._from[face] = cell
        x, y = _between(torch.stack([*map(torch.as_tensor, values)]), cell).numpy()
        return x, y

    def _meet(self, face: str, rays: RayBundle, heights: Array) -> Meeting:
        """Where rays meet a face that is straight between the middles of cells."""
        grid = [
            torch.as_tensor(part) for part in self._bases[face].evaluate(heights - self._path.datum)
        ]
        face_at = torch.stack(grid)
        (x, y, z), (d_x, d_y, d_z) = rays.position, rays.direction
        a, b = d_x / d_z, d_y / d_z
        up = grid[0].mean() - z
        near = 2 * _NEAR * min(self._path.outline.half_width) / self._cells
        for _ in range(_MOST_STEPS):
            met_z, z_x, z_y = _between(face_at, self._in_half_widths(x + a * up, y + b * up))
            step = (met_z - z - up) / (1 - a * z_x - b * z_y).clamp_min(_LEAST_FALL)
            up = up + step
            if step.abs().mean() < near:
                break
        x, y = x + a * up, y + b * up
        _, z_x, z_y = _between(face_at, self._in_half_widths(x, y))
        length = (z_x.square() + z_y.square() + 1).rsqrt()
        met = torch.as_tensor(self._path.outline.contains((x / RIM).numpy(), (y / RIM).numpy()))
        return Meeting((x, y, z + up), (-z_x * length, -z_y * length, length), met)

    def _in_half_widths(self, x: Tensor, y: Tensor) -> Tensor:
        r_x, r_y = self._path.outline.half_width
        return torch.stack([x / r_x, y / r_y])

    def _lifted(self, place: Vector) -> Vector:
        x, y, z = place
        return x, y, z + self._path.datum


def _whence(places: Tensor, wanted: Tensor, begin: Tensor) -> Tensor:
    """Where places of even cells are wanted ones, all of them in half-widths, (2, n, m).

    Newton steps, halved where they lead no nearer: where an image is dark, faces spread light over
    many times the area that it comes from. Beyond the last light the nearest counts.
    """
    cells = places.shape[-1]
    along_x, along_y = torch.gradient(places * (cells / 2), dim=(1, 2))
    near = 2 * _NEAR / cells
    known = torch.cat([places, along_x, along_y])
    nearest, least = begin, torch.full_like(begin[0], torch.inf)
    step, cell = torch.zeros_like(begin), begin
    for _ in range(_MOST_STEPS):
        found = _between(known, cell)
        off, (x_x, y_x, x_y, y_y) = found[:2] - wanted, found[2:]
        far = off.square().sum(0)
        nearer = far < least
        nearest, least = torch.where(nearer, cell, nearest), torch.minimum(far, least)
        if least.sqrt().mean() < near:
            break
        area = (x_x * y_y - x_y * y_x).clamp_min(_LEAST_AREA)
        newton = torch.stack([y_y * off[0] - x_y * off[1], x_x * off[1] - y_x * off[0]]) / area
        step = torch.where(nearer, newton.clamp(-_FAR, _FAR), step / 2)
        cell = (nearest - step).clamp(-1, 1)
    return nearest


def _between(values: Tensor, at: Tensor) -> Tensor:
    """Values (k, cells, cells) of even cells at places (2, n, m) in half-widths, (k, n, m)."""
    grid = at.flip(0).movedim(0, -1)[None]  # torch wants the last axis first
    return grid_sample(values[None], grid, padding_mode="border", align_corners=False)[0]


def _arrays(vector: tuple[Tensor, Tensor, Tensor]) -> Vector:
    shape = np.broadcast_shapes(*(part.shape for part in vector))
    x, y, z = (part.expand(shape).numpy() for part in vector)
    return x, y, z
