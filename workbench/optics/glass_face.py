"""Light behind a plane entrance face at samples of the freeform face behind it, in torch.

The samples are places of the freeform face, the same for all origins: the face is evaluated once,
and no ray has to search for it. The compiled twin is `workbench.optics.train.glass_light`.

The aperture of an element is its outline in the plane of its front vertex, `Element.front_z`. The
source lights the first face through it, also where that face is before or behind this plane.
"""

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.geometry.outlines import Outline
from workbench.geometry.surface import ControlNet, GridBasis
from workbench.optics.glass import FlatGlass
from workbench.optics.interfaces import TransmittanceLaw
from workbench.optics.path import Path
from workbench.optics.rays import RayBundle, Vector
from workbench.optics.samples import Places, parts_inside
from workbench.optics.sources.origins import Origins
from workbench.optics.sources.patterns import Patterns, interpolated, tabulated
from workbench.optics.steps import FaceStep
from workbench.optics.surfaces import Meeting

# In the middle of the aperture no distance to the outline has a direction.
_CENTRE = 1e-12


def seen(low: Tensor, high: Tensor, begin: Tensor | float, end: Tensor | float) -> Tensor:
    """Length of what of intervals lies between two ends."""
    return (high.clamp(max=end) - low.clamp(min=begin)).clamp(min=0)


def part_within(
    here: tuple[Tensor, Tensor],
    crossing: tuple[Tensor, Tensor],
    size: tuple[Tensor, Tensor],
    half_width: tuple[float, float],
) -> Tensor:
    """Part of what an elliptic outline holds of each sample whose light it lets through.

    Exactly 1 of light that goes straight on.

    `here`, `crossing`: x and y of samples, and of where their light crosses the aperture, scene
    units; `size`: widths along x and y of what the samples stand for; `half_width`: semi-axes of
    the outline.
    """
    holds = _held(*here, size, half_width)
    part = _held(*crossing, size, half_width) / torch.where(holds > 0, holds, 1.0)
    return torch.where(holds > 0, part.clamp_max(1), 1.0)


def _held(
    x: Tensor, y: Tensor, size: tuple[Tensor, Tensor], half_width: tuple[float, float]
) -> Tensor:
    """About how much of what a sample stands for is inside the outline around (x, y)."""
    (wide, high), (r_x, r_y) = size, half_width
    level = ((x / r_x).square() + (y / r_y).square()).clamp_min(_CENTRE).sqrt()
    across = (x.abs() * wide / r_x**2 + y.abs() * high / r_y**2).clamp_min(_CENTRE)
    return (0.5 + level * (1 - level) / across).clamp(0, 1)


_NODE, _WEIGHT = np.polynomial.legendre.leggauss(20)
_MetLight = tuple[tuple[Array, Array], tuple[Array, Array, Array], Tensor]


class LitSamples(NamedTuple):
    """Rays at a face, before it does anything to them, and where they meet it.

    Shapes are (samples along x, origins × samples along y).
    """

    rays: RayBundle
    meeting: Meeting


class Glass(NamedTuple):
    """A plane entrance face, the light before it and the freeform face behind it."""

    # Where the light comes from; points are all at one distance from the entrance face.
    origins: Origins
    step: FaceStep  # the entrance face
    reflected: str  # name of the light that it reflects
    law: TransmittanceLaw  # how much of the light it refracts
    z: float  # where it is, scene units
    net: ControlNet  # where the control heights of the face behind it sit
    level: float  # z of the scene that these heights are counted from
    outline: Outline  # of both faces
    # Samples of the face behind it along x and y; None where they are even.
    crowded: tuple[Places, Places] | None

    @property
    def distance(self) -> float:
        """From points to the entrance face; 0 of light from infinitely far."""
        return 0.0 if self.origins.infinite else self.z - float(self.origins.places[0, 2])

    def before(self) -> dict[str, float]:
        """Flux that is lost before the glass, by its names in the light account: by quadrature."""
        met = passed = 0.0
        for place, direction, flux in self._met():
            met += float(flux.sum())
            passed += float(_turned(self.step, place, direction, flux).flux.sum())
        return {self.step.missed: 1 - met, self.reflected: met - passed}

    def _met(self) -> Iterator[_MetLight]:
        """Places of the entrance face, directions and flux of the light of each origin there."""
        origins, z = self.origins, self.z
        if origins.emitted is not None:  # the sum over directions is 1, and within the outline less
            lit, x, y = origins.emitted.onto(self.distance)
            x, y = x + origins.places[0, 0], y + origins.places[0, 1]
            met = self.outline.contains(x, y)
            d_x, d_y, d_z = lit.direction[met].T
            yield (x[met], y[met]), (d_x, d_y, d_z), torch.as_tensor(lit.flux[met])
            return
        for origin, place in enumerate(origins.places):
            x, y, area = _nodes(origins, place, self.outline, z)
            lit_there = origins.light(x, y, z, np.array(origin))
            yield (x, y), lit_there.direction, torch.as_tensor(lit_there.density * area)

    def patterns(self) -> Patterns | None:
        """Intensities of each origin towards places of the entrance face; see `tabulated`."""
        if self.origins.pattern is None:
            return None
        entered = None
        if self.crowded is not None:
            across, up = self.crowded
            entered = self._entered(0, across), self._entered(1, up)
        return tabulated(self.origins, self.net.half_width, self.z, entered)

    def _entered(self, axis: int, samples: Places) -> Places:
        """Where light of samples of a flat face crosses the entrance face, scene units."""
        foot = float(self.origins.places[:, axis].mean())
        glass = FlatGlass(self.distance, self.law, lambertian=False)
        depth = torch.tensor(max(self.level - self.z, 0.0), dtype=torch.float64)

        def crossing(part: Array) -> Array:
            away = (2 * part - 1) * self.net.half_width[axis] - foot
            ratio = glass.light(torch.as_tensor(away).square(), depth).radius_ratio
            return np.asarray(foot + ratio.numpy() * away)

        return Places(*map(crossing, samples))


def _turned(
    entrance: FaceStep,
    place: tuple[Array, Array],
    direction: tuple[Array, Array, Array],
    flux: Tensor,
) -> RayBundle:
    """Light behind the entrance face."""
    alive = torch.ones(flux.shape, dtype=torch.bool)
    x, y, d_x, d_y, d_z = (torch.tensor(part) for part in (*place, *direction))
    zero, one = torch.zeros_like(flux), torch.ones_like(flux)
    position = (x, y, zero)
    rays = RayBundle(position, (d_x, d_y, d_z), flux, alive)
    return entrance.interface.turn(rays, Meeting(position, (zero, zero, one), alive)).rays


def _nodes(
    origins: Origins, place: Array, outline: Outline, entrance_z: float
) -> tuple[Array, Array, Array]:
    """Gauss-Legendre nodes on the entrance face as an origin sees it, and their areas."""
    if origins.infinite:
        middle, scale = (0.0, 0.0), min(origins.waist, max(outline.half_width))
    else:
        middle, scale = (place[0], place[1]), entrance_z - place[2]
    (u, w_u), (v, w_v) = (
        _along(m / r, scale / r) for m, r in zip(middle, outline.half_width, strict=True)
    )
    x, y = outline.from_square(u[:, None], v)
    return x, y, outline.stretch(u[:, None], v) * w_u[:, None] * w_v


def _along(middle: float, scale: float) -> tuple[Array, Array]:
    """Nodes from −1 to 1, and their widths.

    In a = arsinh((u − middle) / scale) the light is smooth at a scale of 1, however near its
    origin is.
    """
    low, high = (math.asinh((end - middle) / scale) for end in (-1.0, 1.0))
    panels = max(math.ceil(high - low), 1)  # 0 for an origin so far aside that all is one place
    part = ((np.arange(panels)[:, None] + (_NODE + 1) / 2) / panels).ravel()
    a = low + (high - low) * part
    weight = (high - low) / panels * np.tile(_WEIGHT / 2, panels)
    return middle + scale * np.sinh(a), scale * weight * np.cosh(a)


class GlassFace:
    """Samples of the face behind the glass, with all that does not depend on its heights.

    `glass`: what is sampled; `lines`: samples along x and y; `path`: the path of the light.
    """

    def __init__(self, glass: Glass, lines: tuple[Places, Places], path: Path) -> None:
        self._glass = glass
        # Near the mean height of the surface float32 keeps the digits that make its shape.
        self._level, self._thickness = glass.level, glass.level - glass.z
        self._entrance = glass.z - path.datum
        self._index = 1 / glass.law.ratio

        def constant(values: Array) -> Tensor:
            return torch.as_tensor(values, dtype=path.dtype, device=path.device).contiguous()

        across, up = lines
        basis = glass.net.grid(across.part, up.part)
        self._basis = GridBasis(*map(constant, vars(basis).values()))
        r_x, r_y = glass.net.half_width
        shape_x, shape_y = (-1, 1, 1), (1, 1, -1)  # [samples along x, origins, samples along y]
        self._x, self._low_x, self._high_x = (
            constant((2 * part - 1) * r_x).reshape(shape_x) for part in across
        )
        self._y, self._low_y, self._high_y = (
            constant((2 * part - 1) * r_y).reshape(shape_y) for part in up
        )
        # A curved outline leaves light out by what of a sample's part it holds.
        whole = glass.outline.whole
        self._half_width = (r_x, r_y) if whole else (math.inf, math.inf)
        self._inside = None if whole else constant(parts_inside(glass.outline, *lines))[:, None]
        patterns = glass.patterns()
        self._patterns = patterns and patterns.as_tensor(path.dtype, path.device)
        self._flux = constant(glass.origins.flux).reshape(1, -1, 1)
        self._at = tuple(constant(part).reshape(1, -1, 1) for part in glass.origins.places.T)

    def light(self, heights: Tensor) -> LitSamples:
        """The light that meets a face with control heights (n_u, n_v), z as in the scene."""
        above = (heights - self._level).to(self._x.dtype)
        z, face_x, face_y = (part[:, None] for part in self._basis.evaluate(above))
        depth = z + self._thickness
        inside = depth > 0
        depth = torch.where(inside, depth, 0.0)
        from_origin = self._from_sky if self._glass.origins.infinite else self._from_points
        place, direction, flux = from_origin(depth)
        if self._inside is not None:
            size = self._high_x - self._low_x, self._high_y - self._low_y
            held = part_within((self._x, self._y), place, size, self._glass.outline.half_width)
            flux = flux * self._inside * held

        shape = flux.shape
        zero, one = flux.new_zeros(()), flux.new_ones(())
        alive = inside.expand(shape)
        rays = RayBundle((*place, flux.new_tensor(self._entrance)), direction, flux, alive)
        behind = self._glass.step.interface.turn(
            rays, Meeting(rays.position, (zero, zero, one), alive)
        )
        d_x, d_y, d_z = behind.rays.direction
        # The face takes in more or less light than the plane z = const, as it leans to it or away.
        lean = 1 - (d_x * face_x + d_y * face_y) / d_z
        met = alive & (lean > 0)  # a face that leans away further has met the light before
        flux = torch.where(met, behind.rays.flux * lean, 0.0)
        length = (face_x.square() + face_y.square() + 1).rsqrt()
        at = side_by_side((self._x, self._y, depth + self._entrance), shape)
        normal = side_by_side((-face_x * length, -face_y * length, length), shape)
        begin = side_by_side(rays.position, shape)
        direction = side_by_side(behind.rays.direction, shape)
        flux, met = (part.reshape(shape[0], -1) for part in (flux, met.expand(shape)))
        return LitSamples(RayBundle(begin, direction, flux, met), Meeting(at, normal, met))

    def _seen(self, low: Tensor, high: Tensor, axis: int) -> Tensor:
        """What of intervals lies within the entrance face."""
        half_width = self._half_width[axis]
        return seen(low, high, -half_width, half_width)

    def _from_sky(self, depth: Tensor) -> tuple[tuple[Tensor, Tensor], Vector, Tensor]:
        """Places on the entrance face, directions before it and flux that meets it."""
        d_x, d_y, d_z = self._at
        down = (1 - (d_x.square() + d_y.square()) / self._index**2).sqrt() * self._index
        shift_x, shift_y = d_x / down * depth, d_y / down * depth
        wide_x = self._seen(self._low_x - shift_x, self._high_x - shift_x, 0)
        wide_y = self._seen(self._low_y - shift_y, self._high_y - shift_y, 1)
        x, y = self._x - shift_x, self._y - shift_y
        beside2 = x.square() + y.square() - (x * d_x + y * d_y).square()
        even = self._flux * d_z * torch.exp(-2 * beside2 / self._glass.origins.waist**2)
        flux = even * wide_x * wide_y
        return (x, y), (d_x, d_y, d_z), flux

    def _from_points(self, depth: Tensor) -> tuple[tuple[Tensor, Tensor], Vector, Tensor]:
        """As `_from_sky`."""
        p_x, p_y, _ = self._at
        distance = self._glass.distance
        away_x, away_y = self._x - p_x, self._y - p_y
        radius2 = away_x.square() + away_y.square()
        flat = FlatGlass(distance, self._glass.law, lambertian=False)
        light = flat.light(radius2, depth)
        radius_ratio = light.radius_ratio
        apparent = distance * self._index
        narrow = 1 / (1 + depth * (apparent * light.steepness).square() * light.steepness)
        # p_x + p (x − p_x), without the cancellation for a point far beside the lens: 1 − p is
        # the slope times the depth.
        way = radius_ratio * light.steepness * depth
        (low_x, high_x), (low_y, high_y) = (
            (low - way * (low - p), high - way * (high - p))
            for low, high, p in ((self._low_x, self._high_x, p_x), (self._low_y, self._high_y, p_y))
        )
        wide_x = self._seen(low_x, high_x, 0)
        wide_y = self._seen(low_y, high_y, 1)
        cos = (1 + radius_ratio.square() * radius2 / distance**2).rsqrt()
        lit = cos.square() * cos / distance**2
        if self._glass.origins.lambertian:
            lit = lit * cos
        # Of a ring around the axis 1 / (p dρ_e/dρ) is lit, of a sample's part 1 / p².
        flux = self._flux * lit * wide_x * wide_y * narrow / radius_ratio
        x, y = self._x - way * away_x, self._y - way * away_y
        if self._patterns is not None:
            flux = flux * interpolated(self._patterns, (x, y))
        slope_x, slope_y = radius_ratio * away_x / distance, radius_ratio * away_y / distance
        return (x, y), (slope_x * cos, slope_y * cos, cos), flux


def side_by_side(parts: Vector, shape: torch.Size) -> Vector:
    """Vectors of [samples along x, origins, samples along y], one origin beside the other."""
    x, y, z = (part.expand(shape).reshape(shape[0], -1) for part in parts)
    return x, y, z
