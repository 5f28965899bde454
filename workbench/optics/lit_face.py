"""Light of origins at a grid of samples of the first freeform face.

On a tensor grid of samples height and slopes are small matrix products, and the light of each
origin follows from the place alone. A sample stands for the part of the face around it, which
takes in more or less light as the face leans. A part is lit as far as its light comes through the
aperture, see `workbench.optics.glass_face`.
"""

from typing import NamedTuple

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.geometry.surface import ControlNet, GridBasis
from workbench.optics.glass_face import LitSamples, part_within, seen, side_by_side
from workbench.optics.path import Path
from workbench.optics.rays import RayBundle
from workbench.optics.samples import Places, areas_of
from workbench.optics.sources.origins import Origins
from workbench.optics.sources.patterns import Patterns, interpolated
from workbench.optics.surfaces import Meeting

# Light that is narrower than this in the aperture, over what it is at a sample, is all or nothing.
_GRAZING = 1e-12


class _Light(NamedTuple):
    """Light at samples before the face does anything to it."""

    slopes: tuple[Tensor, Tensor]  # dx/dz and dy/dz
    density: Tensor  # flux per area across the axis
    narrowed: Tensor  # how wide light is in the aperture that is of width 1 at samples


class LitFace:
    """Samples of a face with all that does not depend on its heights.

    `net`: where its control heights sit; `level`: z of the scene that heights are counted from;
    `lines`: samples along x and y; `origins`: where the light comes from; `path`: the path of the
    light; `patterns`: see `tabulated`, by the places in the plane of ``level``.
    """

    def __init__(
        self,
        net: ControlNet,
        level: float,
        lines: tuple[Places, Places],
        origins: Origins,
        path: Path,
        patterns: Patterns | None = None,
    ) -> None:
        self._half_width, self._level, self._lift = net.half_width, level, level - path.datum
        self._origins = origins

        def constant(values: Array) -> Tensor:
            return torch.as_tensor(values, dtype=path.dtype, device=path.device).contiguous()

        across, up = lines
        basis = net.grid(across.part, up.part)
        self._basis = GridBasis(*map(constant, vars(basis).values()))
        (r_x, r_y), shape_x, shape_y = net.half_width, (-1, 1, 1), (1, 1, -1)
        # [samples along x, origins, samples along y]
        self._x, *self._ends_x = (constant((2 * p - 1) * r_x).reshape(shape_x) for p in across)
        self._y, *self._ends_y = (constant((2 * p - 1) * r_y).reshape(shape_y) for p in up)
        self._whole, self._front = path.outline.whole, path.front_z - level
        self._areas = constant(areas_of(path.outline, *lines))[:, None]
        self._flux = constant(origins.flux).reshape(1, -1, 1)
        # Heights above the level: of light from infinitely far directions, which have none.
        above = np.array([0.0, 0.0, 0.0 if origins.infinite else level])
        self._at = tuple(constant(part).reshape(1, -1, 1) for part in (origins.places - above).T)
        self._ahead = self._front - self._at[2]
        self._patterns = patterns and patterns.as_tensor(path.dtype, path.device)

    def light(self, heights: Tensor) -> LitSamples:
        """The light that meets a face with control heights (n_u, n_v), z as in the scene."""
        above = (heights - self._level).to(self._x.dtype)
        z, face_x, face_y = (part[:, None] for part in self._basis.evaluate(above))
        light = self._come(z)
        (s_x, s_y), density, _ = light
        lean = 1 - s_x * face_x - s_y * face_y
        met = lean > 0  # a face that leans away further is not lit from before
        through = self._through_aperture(z - self._front, light, (face_x, face_y))
        flux = torch.where(met, density * lean * self._areas * through, 0.0)
        along = (s_x.square() + s_y.square() + 1).rsqrt()
        length = (face_x.square() + face_y.square() + 1).rsqrt()
        shape = flux.shape
        at = side_by_side((self._x, self._y, z + self._lift), shape)
        normal = side_by_side((-face_x * length, -face_y * length, length), shape)
        direction = side_by_side((s_x * along, s_y * along, along), shape)
        flux, met = (part.reshape(shape[0], -1) for part in (flux, met.expand(shape)))
        return LitSamples(RayBundle(at, direction, flux, met), Meeting(at, normal, met))

    def _through_aperture(
        self, behind: Tensor, light: "_Light", face_slopes: tuple[Tensor, Tensor]
    ) -> Tensor:
        """Part of the light of each sample that comes through the aperture before the face."""
        sides = (self._x, *self._ends_x), (self._y, *self._ends_y)
        x, y = (at - behind * s for (at, *_), s in zip(sides, light.slopes, strict=True))
        if not self._whole:
            here, size = (self._x, self._y), [high - low for _, low, high in sides]
            return part_within(here, (x, y), (size[0], size[1]), self._half_width)
        part = torch.ones_like(behind)
        slopes = zip(light.slopes, face_slopes, strict=True)
        for (at, low, high), u, r, (s, f) in zip(
            sides, (x, y), self._half_width, slopes, strict=True
        ):
            # The rim of the aperture as its light falls onto the face around a sample.
            wide = light.narrowed * (1 - s * f)
            leans = wide > _GRAZING
            begin, end = (at + (side - u) / torch.where(leans, wide, 1.0) for side in (-r, r))
            lit = seen(low, high, begin, end) / (high - low)
            part = part * torch.where(leans, lit, (u.abs() <= r).to(lit.dtype))
        return part

    def _come(self, z: Tensor) -> "_Light":
        origins = self._origins
        if origins.infinite:
            d_x, d_y, d_z = self._at
            behind = z - self._front  # beams of some radius have their middle in the aperture
            r2 = self._x.square() + self._y.square() + behind.square()
            beside2 = r2 - (self._x * d_x + self._y * d_y + behind * d_z).square()
            fall = torch.exp(-2 * beside2 / origins.waist**2)
            return _Light((d_x / d_z, d_y / d_z), self._flux * d_z * fall, torch.ones_like(z))
        p_x, p_y, p_z = self._at
        way = torch.where(z > p_z, z - p_z, torch.inf)  # dark is what does not lie ahead
        s_x, s_y = (self._x - p_x) / way, (self._y - p_y) / way
        cos = (1 + s_x.square() + s_y.square()).rsqrt()
        density = self._flux * cos.pow(4 if origins.lambertian else 3) / way.square()
        if self._patterns is not None:
            across = p_x - p_z * s_x, p_y - p_z * s_y
            density = density * interpolated(self._patterns, across)
        return _Light((s_x, s_y), density, self._ahead / way)
