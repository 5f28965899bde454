"""Light of many origins by samples of the exit face that they all share: the reference.

A grid of places on the exit face sees the light of each origin once, wherever that entered. So the
face is evaluated once for all origins, no ray has to search for it, and the compiled twin
(`workbench.optics.kernels.origins`) needs some 10 ns for a ray.
"""

import math
from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.geometry.outlines import Outline
from workbench.geometry.surface import ControlNet, GridBasis
from workbench.optics.aperture import part_within, seen
from workbench.optics.arrival import Arrival
from workbench.optics.glass import FlatGlass
from workbench.optics.interfaces import Refraction
from workbench.optics.path import Path
from workbench.optics.patterns import Patterns, interpolated, tabulated
from workbench.optics.rays import RayBundle, Vector
from workbench.optics.samples import Corners, Places, parts_inside, places, splits_side_by_side
from workbench.optics.sources.origins import Origins
from workbench.optics.steps import FaceStep
from workbench.optics.surfaces import BSplineSurface, Meeting, Plane
from workbench.optics.transmittance import TransmittanceLaw
from workbench.said import Said

_NODE, _WEIGHT = np.polynomial.legendre.leggauss(20)
_MetLight = tuple[tuple[Array, Array], tuple[Array, Array, Array], Tensor]


class SharedGrid(NamedTuple):
    """A path whose exit face is sampled for all origins of its light.

    Attributes
    ----------
    origins : Origins
        Where the light comes from; points are all at one distance from the entrance face.
    corners : Corners
        Cells between the samples.
    entrance_z : float
        Where the entrance face is, scene units.
    entrance, exit : FaceStep
        The faces.
    law : TransmittanceLaw
        Of the entrance face.
    net : ControlNet
        Where the control heights of the exit face sit.
    level : float
        z of the scene that kernels count these heights from.
    outline : Outline
        Of the lens.
    missed, reflected : str
        Names of light that is lost before and at the entrance face.
    """

    origins: Origins
    corners: Corners
    entrance_z: float
    entrance: FaceStep
    exit: FaceStep
    law: TransmittanceLaw
    net: ControlNet
    level: float
    outline: Outline
    missed: str
    reflected: str

    @classmethod
    def of(cls, path: Path) -> "SharedGrid | None":
        """Light whose corners are wanted, a flat face and a B-spline; else None."""
        emitter = path.emitter
        if not isinstance(emitter.samples, Corners):
            return None
        origins = emitter.origins
        match path.steps:
            case (
                FaceStep(Plane(z=z), Refraction(law=law, reflected=reflected), missed) as entrance,
                FaceStep(
                    BSplineSurface(net=net, subdivisions=None, level=level), Refraction()
                ) as exit_face,
            ) if origins.infinite or np.ptp(origins.places[:, 2]) == 0:
                z, corners = z + path.datum, emitter.samples
                elements = z, entrance, exit_face, law, net, level, path.outline
                return cls(origins, corners, *elements, missed, reflected)
        return None

    @property
    def half_width(self) -> tuple[float, float]:
        """Of the faces, scene units."""
        return self.net.half_width

    @property
    def distance(self) -> float:
        """From points to the entrance face; 0 of light from infinitely far."""
        if self.origins.infinite:
            return 0.0
        return self.entrance_z - float(self.origins.places[0, 2])

    def before(self) -> dict[str, float]:
        """Flux that is lost before the glass, by its names in the light account: by quadrature."""
        met = passed = 0.0
        for place, direction, flux in self._met():
            met += float(flux.sum())
            passed += float(_turned(self.entrance, place, direction, flux).flux.sum())
        return {self.missed: 1 - met, self.reflected: met - passed}

    def _met(self) -> Iterator[_MetLight]:
        """Places of the entrance face, directions and flux of the light of each origin there."""
        origins, z = self.origins, self.entrance_z
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
        entered = None if self.corners.even else (self._entered(0), self._entered(1))
        return tabulated(self.origins, self.half_width, self.entrance_z, entered)

    def _entered(self, axis: int) -> Places:
        """Where light of samples of a flat face crosses the entrance face, scene units."""
        foot = float(self.origins.places[:, axis].mean())
        glass = FlatGlass(self.distance, self.law, lambertian=False)
        depth = torch.tensor(max(self.level - self.entrance_z, 0.0), dtype=torch.float64)

        def crossing(part: Array) -> Array:
            away = (2 * part - 1) * self.half_width[axis] - foot
            ratio = glass.light(torch.as_tensor(away).square(), depth).radius_ratio
            return np.asarray(foot + ratio.numpy() * away)

        return Places(*map(crossing, self.lines[axis]))

    @property
    def lines(self) -> tuple[Places, Places]:
        """Samples along x and y, and what each stands for, as parts of the way across the lens."""
        return places(self.corners, 0), places(self.corners, 1)

    @property
    def inside(self) -> Array:
        """Which part of what each sample stands for is inside the outline, shape (m_x, m_y)."""
        return parts_inside(self.outline, *self.lines)

    @property
    def splits(self) -> tuple[Array, Array]:
        """See `workbench.optics.light.BeamTracer`: origins one after the other along y."""
        return splits_side_by_side(*self.lines, len(self.origins.places))


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
    panels = math.ceil(high - low)
    part = ((np.arange(panels)[:, None] + (_NODE + 1) / 2) / panels).ravel()
    a = low + (high - low) * part
    weight = (high - low) / panels * np.tile(_WEIGHT / 2, panels)
    return middle + scale * np.sinh(a), scale * weight * np.cosh(a)


class SharedSamples:
    """A tensor grid of samples of the exit face, with all that does not depend on the heights.

    Parameters
    ----------
    shared : SharedGrid
        What is sampled.
    path : Path
        The path of the light.
    """

    note = Said("samples on the exit face, shared by all origins of the light")

    def __init__(self, shared: SharedGrid, path: Path) -> None:
        self._shared, self._path, self._before = shared, path, shared.before()
        # Near the mean height of the surface float32 keeps the digits that make its shape.
        self._level, self._thickness = shared.level, shared.level - shared.entrance_z
        self._entrance = shared.entrance_z - path.datum
        self._index = 1 / shared.law.ratio

        def constant(values: Array) -> Tensor:
            return torch.as_tensor(values, dtype=path.dtype, device=path.device).contiguous()

        across, up = shared.lines
        basis = shared.net.grid(across.part, up.part)
        self._basis = GridBasis(
            *(constant(part) for part in (
                basis.along_x, basis.slope_x, basis.along_y, basis.slope_y
            ))
        )  # fmt: skip
        r_x, r_y = shared.net.half_width
        shape_x, shape_y = (-1, 1, 1), (1, 1, -1)  # [samples along x, origins, samples along y]
        self._x, self._low_x, self._high_x = (
            constant((2 * part - 1) * r_x).reshape(shape_x) for part in across
        )
        self._y, self._low_y, self._high_y = (
            constant((2 * part - 1) * r_y).reshape(shape_y) for part in up
        )
        # A curved outline leaves light out by what of a sample's part it holds.
        whole = shared.outline.whole
        self._half_width = (r_x, r_y) if whole else (math.inf, math.inf)
        self._inside = None if whole else constant(shared.inside)[:, None]
        patterns = shared.patterns()
        self._patterns = patterns and patterns.as_tensor(path.dtype, path.device)
        self._flux = constant(shared.origins.flux).reshape(1, -1, 1)
        self._at = tuple(constant(part).reshape(1, -1, 1) for part in shared.origins.places.T)

    def walk(self, heights: Mapping[str, Tensor]) -> Arrival:
        """Follow the light from the exit face to the receiver; see `Path.walk`."""
        surface, interface, missed = self._shared.exit
        above = (heights[surface.name] - self._level).to(self._x.dtype)
        z, face_x, face_y = (part[:, None] for part in self._basis.evaluate(above))
        depth = z + self._thickness
        inside = depth > 0
        depth = torch.where(inside, depth, 0.0)
        from_origin = self._from_sky if self._shared.origins.infinite else self._from_points
        place, direction, flux = from_origin(depth)
        if self._inside is not None:
            size = self._high_x - self._low_x, self._high_y - self._low_y
            held = part_within((self._x, self._y), place, size, self._shared.half_width)
            flux = flux * self._inside * held

        shape = flux.shape
        zero, one = flux.new_zeros(()), flux.new_ones(())
        alive = inside.expand(shape)
        rays = RayBundle((*place, flux.new_tensor(self._entrance)), direction, flux, alive)
        behind = self._shared.entrance.interface.turn(
            rays, Meeting(rays.position, (zero, zero, one), alive)
        )
        d_x, d_y, d_z = behind.rays.direction
        # The face takes in more or less light than the plane z = const, as it leans to it or away.
        lean = 1 - (d_x * face_x + d_y * face_y) / d_z
        met = alive & (lean > 0)  # a face that leans away further has met the light before
        flux = torch.where(met, behind.rays.flux * lean, 0.0)
        length = (face_x.square() + face_y.square() + 1).rsqrt()
        at = (self._x, self._y, depth + self._entrance)
        normal = (-face_x * length, -face_y * length, length)
        rays = RayBundle(rays.position, behind.rays.direction, flux, met)
        passed = interface.turn(rays, Meeting(at, normal, met))
        with torch.no_grad():
            lost = {name: part.sum(dtype=torch.float64) for name, part in passed.lost.items()}
            for name, before in self._before.items():
                lost[name] = flux.new_tensor(before, dtype=torch.float64)
            # What entered and did not come to the face; with the error of the sum over samples.
            entered = 1 - sum(self._before.values())
            lost[missed] = entered - flux.sum(dtype=torch.float64)
        side_by_side = shape[0], shape[1] * shape[2]
        out = _reshaped(passed.rays, shape, side_by_side)
        return Arrival(*self._path.receiver.places(out), out, lost)

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
        even = self._flux * d_z * torch.exp(-2 * beside2 / self._shared.origins.waist**2)
        flux = even * wide_x * wide_y
        return (x, y), (d_x, d_y, d_z), flux

    def _from_points(self, depth: Tensor) -> tuple[tuple[Tensor, Tensor], Vector, Tensor]:
        """As `_from_sky`."""
        p_x, p_y, _ = self._at
        distance = self._shared.distance
        away_x, away_y = self._x - p_x, self._y - p_y
        radius2 = away_x.square() + away_y.square()
        glass = FlatGlass(distance, self._shared.law, lambertian=False)
        light = glass.light(radius2, depth)
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
        if self._shared.origins.lambertian:
            lit = lit * cos
        # Of a ring around the axis 1 / (p dρ_e/dρ) is lit, of a sample's part 1 / p².
        flux = self._flux * lit * wide_x * wide_y * narrow / radius_ratio
        x, y = self._x - way * away_x, self._y - way * away_y
        if self._patterns is not None:
            flux = flux * interpolated(self._patterns, (x, y))
        slope_x, slope_y = radius_ratio * away_x / distance, radius_ratio * away_y / distance
        return (x, y), (slope_x * cos, slope_y * cos, cos), flux


def _reshaped(rays: RayBundle, shape: torch.Size, to: tuple[int, int]) -> RayBundle:
    def vector(parts: Vector) -> Vector:
        x, y, z = (part.expand(shape).reshape(to) for part in parts)
        return x, y, z

    flux, alive = (part.expand(shape).reshape(to) for part in (rays.flux, rays.alive))
    return RayBundle(vector(rays.position), vector(rays.direction), flux, alive)
