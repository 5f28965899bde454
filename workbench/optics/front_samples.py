"""Samples of a freeform entrance face: light starts there, and searches for the exit face alone.

What they are lit by is in `workbench.optics.lit_face`; the compiled twin is
`workbench.optics.kernels.two_faces`.
"""

from collections.abc import Mapping
from typing import NamedTuple

import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.geometry.outlines import Outline
from workbench.geometry.surface import ControlNet
from workbench.optics.arrival import Arrival
from workbench.optics.interfaces import Refraction
from workbench.optics.intersection import RIM
from workbench.optics.lit_face import LitFace
from workbench.optics.path import Path
from workbench.optics.patterns import Patterns, tabulated
from workbench.optics.rays import RayBundle, Vector
from workbench.optics.samples import Corners, Places, areas_of, places, splits_side_by_side
from workbench.optics.sources.origins import Origins
from workbench.optics.steps import FaceStep
from workbench.optics.surfaces import BSplineSurface
from workbench.said import Said

# No place is nearer to the axis, as a part of the way to the rim: the root has a slope.
_TINY = 1e-15


class FrontGrid(NamedTuple):
    """What is sampled: two B-spline faces, the first of which light meets from without.

    Attributes
    ----------
    origins : Origins
        Where the light comes from.
    corners : Corners
        How many samples there are.
    entrance, exit : FaceStep
        The two faces.
    leaving : BSplineSurface
        The surface of the exit face.
    net : ControlNet
        Where the control heights of the entrance face sit.
    level : float
        z of the scene that heights of the entrance face are counted from.
    outline : Outline
        Of the lens, and of the aperture before it.
    front_z : float
        z of the scene where that is.
    """

    origins: Origins
    corners: Corners
    entrance: FaceStep
    exit: FaceStep
    leaving: BSplineSurface
    net: ControlNet
    level: float
    outline: Outline
    front_z: float

    @classmethod
    def of(cls, path: Path) -> "FrontGrid | None":
        """Light whose corners are wanted, and two B-spline faces; else None."""
        emitter = path.emitter
        if not isinstance(emitter.samples, Corners):
            return None
        match path.steps:
            case (
                FaceStep(BSplineSurface(net=net, level=level), Refraction()) as entrance,
                FaceStep(BSplineSurface() as leaving, Refraction()) as last,
            ) if all(step.surface.kind == "B-spline" for step in path.steps):
                found = emitter.origins, emitter.samples, entrance, last, leaving
                return cls(*found, net, level, path.outline, path.front_z)
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
        return areas_of(self.outline, *self.lines)

    @property
    def splits(self) -> tuple[Array, Array]:
        """See `workbench.optics.light.BeamTracer`: origins one after the other along y."""
        return splits_side_by_side(*self.lines, len(self.origins.places))

    def patterns(self) -> Patterns | None:
        """Intensities of each origin over its flux; see `tabulated`.

        By the places at which light would cross the plane of `level`.
        """
        across, up = (
            Places(*((2 * part - 1) * r for part in line))
            for line, r in zip(self.lines, self.half_width, strict=True)
        )
        samples = None if self.corners.even else (across, up)
        return tabulated(self.origins, self.half_width, self.level, samples)


class FrontSamples:
    """A tensor grid of samples of the entrance face, with all that does not depend on the heights.

    Parameters
    ----------
    front : FrontGrid
        What is sampled.
    path : Path
        The path of the light.
    """

    note = Said("samples on the entrance face, shared by all origins of the light")

    def __init__(self, front: FrontGrid, path: Path) -> None:
        self._front, self._path = front, path
        given = front.net, front.level, front.lines, front.origins, path, front.patterns()
        self._face = LitFace(*given)

    def walk(self, heights: Mapping[str, Tensor]) -> Arrival:
        """Follow the light from the entrance face to the receiver; see `Path.walk`."""
        surface, interface, missed = self._front.entrance
        lit = self._face.light(heights[surface.name])
        passed = interface.turn(*lit)
        with torch.no_grad():
            lost = {name: part.sum(dtype=torch.float64) for name, part in passed.lost.items()}
            lost[missed] = 1 - lit.rays.flux.sum(dtype=torch.float64)
        return self._arrive(passed.rays, heights, lost)

    def _arrive(
        self, rays: RayBundle, heights: Mapping[str, Tensor], lost: dict[str, Tensor]
    ) -> Arrival:
        """From the entrance face through the exit face to the receiver."""
        _, interface, missed = self._front.exit
        meeting = self._front.leaving.meet_rectangle(rays, heights)
        room = self._room(rays.position, meeting.position)
        if not self._front.outline.whole:
            meeting = meeting._replace(met=meeting.met & (room >= 0))
        # Rays that do not come to the exit face leave at its side, but for those without a way.
        room = torch.where(meeting.met, room.clamp_min(0.0), torch.where(rays.alive, -1.0, 0.0))
        passed = interface.turn(rays, meeting)
        with torch.no_grad():
            more = {missed: torch.where(meeting.met, 0.0, rays.flux), **passed.lost}
            for name, part in more.items():
                lost[name] = lost.get(name, 0.0) + part.sum(dtype=torch.float64)
        return Arrival(*self._path.receiver.places(passed.rays), passed.rays, lost, room)

    def _room(self, entered: Vector, leaving: Vector) -> Tensor:
        """How far places on the exit face are within its rim; see `workbench.optics.rim`."""
        radius = self._radius(leaving)
        if self._front.outline.whole:
            return RIM - radius
        # Samples beside a curved outline stand for parts that it cuts: for these its rim is where
        # they are.
        return self._radius(entered).clamp_min(1.0) * RIM - radius

    def _radius(self, place: Vector) -> Tensor:
        """How far from the axis places are, as parts of the way to the rim."""
        (x, y, _), (r_x, r_y) = place, self._front.half_width
        if self._front.outline.whole:
            return torch.maximum((x / r_x).abs(), (y / r_y).abs())
        return ((x / r_x).square() + (y / r_y).square()).clamp_min(_TINY**2).sqrt()
