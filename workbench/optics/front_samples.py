"""Samples of a freeform entrance face: light starts there, and searches for the exit face alone.

Rays through a plane before the lens would search for both faces. On a tensor grid of samples of
the entrance face height and slopes are small matrix products, and what each origin of the light
sends there follows from the place alone: a sample stands for the part of the face around it, and
takes in more or less light than a plane across the axis, as the face leans to the light or away.

The compiled twin is `workbench.optics.kernels.two_faces`.
"""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
import numpy.typing as npt
import torch
from torch import Tensor

from workbench.geometry.outlines import Outline
from workbench.geometry.surface import ControlNet, GridBasis
from workbench.optics.arrival import Arrival
from workbench.optics.interfaces import Refraction
from workbench.optics.intersection import RIM
from workbench.optics.path import Path
from workbench.optics.patterns import interpolated, tabulated
from workbench.optics.rays import RayBundle, Vector
from workbench.optics.samples import Corners, Places, parts_inside, places
from workbench.optics.sources.origins import Origins
from workbench.optics.steps import Step
from workbench.optics.surfaces import BSplineSurface
from workbench.optics.surfaces.surface import Meeting

Array = npt.NDArray[np.float64]


class FrontGrid(NamedTuple):
    """What is sampled: two B-spline faces, the first of which light meets from without.

    Attributes
    ----------
    origins : Origins
        Where the light comes from.
    corners : Corners
        How many samples there are.
    entrance, exit : Step
        The two faces.
    leaving : BSplineSurface
        The surface of the exit face.
    net : ControlNet
        Where the control heights of the entrance face sit.
    level : float
        z of the scene that heights of the entrance face are counted from.
    outline : Outline
        Of the lens.
    """

    origins: Origins
    corners: Corners
    entrance: Step
    exit: Step
    leaving: BSplineSurface
    net: ControlNet
    level: float
    outline: Outline

    @classmethod
    def of(cls, path: Path) -> "FrontGrid | None":
        """Light whose corners are wanted, and two B-spline faces; else None."""
        emitter = path.emitter
        if not isinstance(emitter.samples, Corners):
            return None
        match path.steps:
            case (
                Step(BSplineSurface(net=net, level=level), Refraction()) as entrance,
                Step(BSplineSurface() as leaving, Refraction()) as last,
            ) if all(step.surface.kind == "B-spline" for step in path.steps):
                found = emitter.origins, emitter.samples, entrance, last, leaving
                return cls(*found, net, level, path.outline)
        return None

    @property
    def half_width(self) -> tuple[float, float]:
        """Of the faces, scene units."""
        return self.net.half_width

    @property
    def lines(self) -> tuple[Places, Places]:
        """Samples along x and y, and what each stands for, as parts of the way across the lens."""
        return places(self.corners, 0), places(self.corners, 1)

    @property
    def areas(self) -> Array:
        """Area of what each sample stands for, as seen along the axis, shape (m_x, m_y)."""
        across, up = self.lines
        (r_x, r_y), inside = self.half_width, parts_inside(self.outline, across, up)
        wide, high = across.high - across.low, up.high - up.low
        return np.asarray(4 * r_x * r_y * wide[:, None] * high * inside)

    @property
    def splits(self) -> tuple[Array, Array]:
        """See `workbench.optics.light.BeamTracer`: origins one after the other along y."""
        across, up = self.lines
        return across.split, np.tile(up.split, (len(self.origins.places), 1))

    def patterns(self) -> Array | None:
        """Intensities of each origin over its flux; see `tabulated`.

        By the places at which light would cross the plane of `level`.
        """
        return tabulated(self.origins, self.half_width, self.level)


class FrontSamples:
    """A tensor grid of samples of the entrance face, with all that does not depend on the heights.

    Parameters
    ----------
    front : FrontGrid
        What is sampled.
    path : Path
        The path of the light.
    """

    note = "samples on the entrance face, shared by all origins of the light"

    def __init__(self, front: FrontGrid, path: Path) -> None:
        self._front, self._path = front, path

        def constant(values: Array) -> Tensor:
            return torch.as_tensor(values, dtype=path.dtype, device=path.device).contiguous()

        across, up = front.lines
        basis = front.net.grid(across.part, up.part)
        self._basis = GridBasis(*map(constant, vars(basis).values()))
        (r_x, r_y), shape_x, shape_y = front.half_width, (-1, 1, 1), (1, 1, -1)
        # [samples along x, origins, samples along y]
        self._x = constant((2 * across.part - 1) * r_x).reshape(shape_x)
        self._y = constant((2 * up.part - 1) * r_y).reshape(shape_y)
        self._areas = constant(front.areas)[:, None]
        self._flux = constant(front.origins.flux).reshape(1, -1, 1)
        # Heights above the level: of light from infinitely far directions, which have none.
        above = np.array([0.0, 0.0, 0.0 if front.origins.infinite else front.level])
        places = front.origins.places - above
        self._at = tuple(constant(part).reshape(1, -1, 1) for part in places.T)
        patterns = front.patterns()
        self._patterns = None if patterns is None else constant(patterns)

    def walk(self, heights: Mapping[str, Tensor]) -> Arrival:
        """Follow the light from the entrance face to the receiver; see `Path.walk`."""
        surface, interface, missed = self._front.entrance
        above = (heights[surface.name] - self._front.level).to(self._x.dtype)
        z, face_x, face_y = (part[:, None] for part in self._basis.evaluate(above))
        (s_x, s_y), density = self._light(z)
        lean = 1 - s_x * face_x - s_y * face_y
        met = lean > 0  # a face that leans away further has met the light before
        flux = torch.where(met, density * lean * self._areas, 0.0)
        along = (s_x.square() + s_y.square() + 1).rsqrt()
        length = (face_x.square() + face_y.square() + 1).rsqrt()

        shape = flux.shape
        place = (self._x, self._y, z + (self._front.level - self._path.datum))
        at = _side_by_side(place, shape)
        normal = _side_by_side((-face_x * length, -face_y * length, length), shape)
        direction = _side_by_side((s_x * along, s_y * along, along), shape)
        flux, met = (part.reshape(shape[0], -1) for part in (flux, met.expand(shape)))
        passed = interface.turn(RayBundle(at, direction, flux, met), Meeting(at, normal, met))
        with torch.no_grad():
            lost = {name: part.sum(dtype=torch.float64) for name, part in passed.lost.items()}
            lost[missed] = 1 - flux.sum(dtype=torch.float64)
        return self._arrive(passed.rays, heights, lost)

    def _arrive(
        self, rays: RayBundle, heights: Mapping[str, Tensor], lost: dict[str, Tensor]
    ) -> Arrival:
        """From the entrance face through the exit face to the receiver."""
        _, interface, missed = self._front.exit
        meeting = self._front.leaving.meet_rectangle(rays, heights)
        if not self._front.outline.whole:
            # Samples beside a curved outline stand for parts that it cuts: for these its rim is
            # where they are.
            rim2 = self._radius2(rays.position).clamp_min(1.0)
            within = self._radius2(meeting.position) <= rim2 * RIM**2
            meeting = meeting._replace(met=meeting.met & within)
        passed = interface.turn(rays, meeting)
        with torch.no_grad():
            more = {missed: torch.where(meeting.met, 0.0, rays.flux), **passed.lost}
            for name, part in more.items():
                lost[name] = lost.get(name, 0.0) + part.sum(dtype=torch.float64)
        return Arrival(*self._path.receiver.places(passed.rays), passed.rays, lost)

    def _radius2(self, place: Vector) -> Tensor:
        """Square of the distance to the axis, in semi-axes of the outline."""
        (x, y, _), (r_x, r_y) = place, self._front.half_width
        return (x / r_x).detach().square() + (y / r_y).detach().square()

    def _light(self, z: Tensor) -> tuple[tuple[Tensor, Tensor], Tensor]:
        """Slopes of the light at the samples, and its flux per area across the axis."""
        origins = self._front.origins
        if origins.infinite:
            d_x, d_y, d_z = self._at
            r2 = self._x.square() + self._y.square() + z.square()
            beside2 = r2 - (self._x * d_x + self._y * d_y + z * d_z).square()
            fall = torch.exp(-2 * beside2 / origins.waist**2)
            return (d_x / d_z, d_y / d_z), self._flux * d_z * fall
        p_x, p_y, p_z = self._at
        way = z - p_z
        s_x, s_y = (self._x - p_x) / way, (self._y - p_y) / way
        cos = (1 + s_x.square() + s_y.square()).rsqrt()
        density = self._flux * cos.pow(4 if origins.lambertian else 3) / way.square()
        if self._patterns is not None:
            across = p_x - p_z * s_x, p_y - p_z * s_y
            density = density * interpolated(self._patterns, across, self._front.half_width)
        return (s_x, s_y), density


def _side_by_side(parts: Vector, shape: torch.Size) -> Vector:
    """Vectors of [samples along x, origins, samples along y], one origin beside the other."""
    x, y, z = (part.expand(shape).reshape(shape[0], -1) for part in parts)
    return x, y, z
