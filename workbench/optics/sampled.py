"""Trains of which the first freeform face is sampled: rays begin there, none has to search for it.

On a tensor grid of samples height and slopes of the face are small matrix products, and all origins
of the light share them. What comes to a sample from before is in `workbench.optics.lit_face`, and
behind a plane entrance face in `workbench.optics.glass_face`. The compiled twin is
`workbench.optics.train.compiled`.
"""

import math
from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.geometry.frames import Frame
from workbench.geometry.outlines import Outline
from workbench.geometry.surface import ControlNet
from workbench.optics.arrival import Arrival
from workbench.optics.glass_face import Glass, GlassFace
from workbench.optics.interfaces import Refraction
from workbench.optics.intersection import RIM
from workbench.optics.lit_face import LitFace
from workbench.optics.path import Path
from workbench.optics.patterns import Patterns, tabulated
from workbench.optics.rays import RayBundle, Vector, seen
from workbench.optics.samples import Corners, Places, Samples, areas_of, places, splits_side_by_side
from workbench.optics.sources import CollimatedEmitter, PointEmitter
from workbench.optics.sources.origins import Origins
from workbench.optics.steps import FaceStep
from workbench.optics.surfaces import BSplineSurface, Plane
from workbench.said import Said

# No place is nearer to the axis, as a part of the way to the rim: the root has a slope.
_TINY = 1e-15


class SampledTrain(NamedTuple):
    """A train whose first freeform face is sampled, in coordinates of the scene.

    Attributes
    ----------
    origins : Origins
        Where the light comes from.
    samples : tuple[int, int] or Corners
        Middles of so many cells along x and y, or corners of cells.
    glass : Glass, optional
        A plane entrance face before the freeform one.
    first : FaceStep
        The face that is sampled.
    rest : tuple of FaceStep
        Those behind it.
    surface : BSplineSurface
        That of the first.
    changes : list of Frame
        Changes of coordinates before each of these and behind the last one.
    outline : Outline
        Of the first face, and of the aperture before it.
    front_z : float
        z of the scene where that is.
    datum : float
        z of the scene from which the path counts z.
    """

    origins: Origins
    samples: Samples
    glass: Glass | None
    first: FaceStep
    rest: tuple[FaceStep, ...]
    surface: BSplineSurface
    changes: list[Frame]
    outline: Outline
    front_z: float
    datum: float

    @classmethod
    def of(cls, path: Path) -> "SampledTrain | None":
        """Light of which samples are wanted, and a B-spline behind a plane face or none."""
        emitter, steps = path.emitter, path.steps
        samples = emitter.samples
        if samples is None or not (isinstance(samples, Corners) or _by_middles(path)):
            return None
        origins, glass = emitter.origins, None
        match steps[0]:
            case FaceStep(Plane(z=z), Refraction(law=law, reflected=name), _, None) if (
                len(steps) > 1
            ):
                one_distance = origins.infinite or np.ptp(origins.places[:, 2]) == 0
                surface = steps[1].surface
                if not (one_distance and isinstance(surface, BSplineSurface)):
                    return None
                shape = surface.net, surface.level, path.outline
                lines = places(samples, 0), places(samples, 1)
                crowded = None if _are_even(samples) else lines
                glass = Glass(origins, steps[0], name, law, z + path.datum, *shape, crowded)
                steps = steps[1:]
        surface = steps[0].surface
        if not isinstance(surface, BSplineSurface) or surface.subdivisions is not None:
            return None
        if steps[0].frame is not None:  # the source is in other coordinates
            return None
        given = origins, samples, glass, steps[0], steps[1:], surface, path.changes[1:]
        return cls(*given, path.outline, path.front_z, path.datum)

    @property
    def net(self) -> ControlNet:
        """Where the control heights of the first face sit."""
        return self.surface.net

    @property
    def half_width(self) -> tuple[float, float]:
        """Of the first face, scene units."""
        return self.net.half_width

    @property
    def level(self) -> float:
        """Z of the scene that heights of the first face are counted from."""
        return self.surface.level

    @property
    def lines(self) -> tuple[Places, Places]:
        """Samples along x and y, and what each stands for, as parts of the way across."""
        return places(self.samples, 0), places(self.samples, 1)

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
        lines = None if _are_even(self.samples) else (across, up)
        return tabulated(self.origins, self.half_width, self.level, lines)

    @property
    def note(self) -> Said:
        """What is special about it, in words."""
        if self.glass is not None:
            return Said("samples on the exit face, shared by all origins of the light")
        if isinstance(self.first.interface, Refraction):
            return Said("samples on the entrance face, shared by all origins of the light")
        return Said("samples on the mirror, shared by all origins of the light")


def is_even(path: Path) -> bool:
    """Whether light along the axis meets one freeform face, so that a walk needs no search."""
    return _even(path) and len(path.shaped) == 1


def _by_middles(path: Path) -> bool:
    """Whether samples in the middles of cells are those of the first freeform face."""
    return isinstance(path.emitter, CollimatedEmitter | PointEmitter)


def _are_even(samples: Samples) -> bool:
    return not isinstance(samples, Corners) or samples.even


def _even(path: Path) -> bool:
    return isinstance(path.emitter, CollimatedEmitter)


class SampledWalk:
    """The walk from samples of the first freeform face, in torch: the reference.

    Parameters
    ----------
    train : SampledTrain
        What is sampled.
    path : Path
        The path of the light.
    """

    def __init__(self, train: SampledTrain, path: Path) -> None:
        self._train, self._path = train, path
        self._face: GlassFace | LitFace
        if train.glass is not None:
            self._before = train.glass.before()
            self._face = GlassFace(train.glass, train.lines, path)
        else:
            self._before = {}
            given = train.net, train.level, train.lines, train.origins, path, train.patterns()
            self._face = LitFace(*given)

    def walk(self, heights: Mapping[str, Tensor]) -> Arrival:
        """Follow the light from the samples to the receiver; see `Path.walk`."""
        train = self._train
        lit = self._face.light(train.surface.own(heights))
        passed = train.first.interface.turn(*lit)
        with torch.no_grad():
            lost = {name: part.sum(dtype=torch.float64) for name, part in passed.lost.items()}
            for name, before in self._before.items():
                lost[name] = lit.rays.flux.new_tensor(before, dtype=torch.float64)
            # What came and did not meet the face; with the error of the sum over samples.
            met = lit.rays.flux.sum(dtype=torch.float64)
            missed = 1 - sum(self._before.values()) - met
            lost[train.first.missed] = lost.get(train.first.missed, 0.0) + missed
        rays, rim = passed.rays, None
        for number, (step, change) in enumerate(zip(train.rest, train.changes[:-1], strict=True)):
            begin = lit.meeting.position if number == 0 else None
            rays, rim, more = self._pass(step, seen(rays, change), heights, rim, begin)
            for name, part in more.items():
                lost[name] = lost.get(name, 0.0) + part.sum(dtype=torch.float64)
        rays = seen(rays, train.changes[-1])
        return Arrival(*self._path.receiver.places(rays), rays, lost, rim)

    def _pass(
        self,
        step: FaceStep,
        rays: RayBundle,
        heights: Mapping[str, Tensor],
        rim: Tensor | None,
        begin: Vector | None,
    ) -> tuple[RayBundle, Tensor, dict[str, Tensor]]:
        """Rays behind a further face, their distance to the rims so far, and losses by name.

        Parameters
        ----------
        step, rays, heights
            The face, and the rays before it.
        rim : Tensor, optional
            The distance before.
        begin : tuple of three Tensor, optional
            Samples, if this is the next face behind them.
        """
        first, outline = self._train.outline, step.surface.outline
        meeting = step.surface.meet_unbounded(rays, heights)
        own = RIM - _radius(outline, meeting.position)
        if begin is not None and not first.whole:
            # Samples beside a curved outline stand for parts that it cuts: for these its rim is
            # where they are.
            beyond = _radius(first, begin).clamp_min(1.0) - 1.0
            own = own + beyond * beyond_rim(first, outline)
        meeting = meeting._replace(met=meeting.met & (own >= 0))
        # Rays that do not come to the face leave at the side, but for those without a way.
        own = torch.where(meeting.met, own.clamp_min(0.0), torch.where(rays.alive, -1.0, 0.0))
        passed = step.interface.turn(rays, meeting)
        missed = torch.where(meeting.met, 0.0, rays.flux)
        lost = {step.missed: missed.detach(), **passed.lost}
        return passed.rays, own if rim is None else torch.minimum(own, rim), lost


def beyond_rim(first: Outline, outline: Outline) -> float:
    """Distance from the axis, as a part of that of an outline, over the same of the first one."""
    return RIM * math.sqrt(math.prod(first.half_width) / math.prod(outline.half_width))


def _radius(outline: Outline, place: Vector) -> Tensor:
    """Distance from the axis as a part of that of the rim."""
    (x, y, _), (r_x, r_y) = place, outline.half_width
    if outline.whole:
        return torch.maximum((x / r_x).abs(), (y / r_y).abs())
    return ((x / r_x).square() + (y / r_y).square()).clamp_min(_TINY**2).sqrt()
