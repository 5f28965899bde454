"""Trains of which the first freeform face is sampled: rays begin there, none has to search for it.

On a tensor grid of samples height and slopes of the face are small matrix products, and all origins
of the light share them. What comes to a sample from before is in `workbench.optics.lit_face`, and
behind a plane entrance face in `workbench.optics.glass_face`. Where other fixed faces come first,
the aperture before them is sampled instead; see `workbench.optics.fixed_faces`. The compiled twin
is `workbench.optics.train.compiled`.
"""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.geometry.frames import Frame
from workbench.geometry.outlines import Outline
from workbench.geometry.surface import ControlNet
from workbench.messages import Message
from workbench.optics.fixed_faces import (
    EvenDirections,
    Followed,
    follow,
    pass_face,
    through_aperture,
)
from workbench.optics.glass_face import Glass, GlassFace
from workbench.optics.interfaces import Refraction, TransmittanceLaw
from workbench.optics.lit_face import LitFace
from workbench.optics.path import Path
from workbench.optics.rays import Arrival, Vector, seen
from workbench.optics.samples import Corners, Places, Samples, areas_of, places, splits_side_by_side
from workbench.optics.sources import CollimatedEmitter, DirectionEmitter, PointEmitter
from workbench.optics.sources.origins import Origins
from workbench.optics.sources.patterns import Patterns, tabulated
from workbench.optics.steps import FaceStep
from workbench.optics.surfaces import BSplineSurface, Plane


class SampledTrain(NamedTuple):
    """A train whose first freeform face, or whose aperture, is sampled."""

    origins: Origins  # where the light comes from, in coordinates of the source
    samples: Samples  # middles of so many cells along x and y, or corners of cells
    glass: Glass | None  # A plane entrance face before the freeform one
    before: tuple[FaceStep, ...]  # other fixed faces before the first freeform one
    # The freeform face that is sampled; None where the aperture is, which its light passes before
    # other fixed faces, or before a face that is tilted.
    first: FaceStep | None
    # Those that rays search for, from the first freeform face or from behind it on.
    rest: tuple[FaceStep, ...]
    surface: BSplineSurface  # that of the first freeform face
    # Changes of coordinates before each of the fixed faces and behind the last; the same of those
    # that rays search for.
    changes_before: list[Frame]
    changes: list[Frame]
    outline: Outline  # of the aperture; of a sampled face, too
    front_z: float  # z of the source where that is
    datum: float  # z of the source from which the path counts z
    # Samples of an aperture that are even in directions; None where they are in places.
    directions: EvenDirections | None = None

    @classmethod
    def of(cls, path: Path) -> "SampledTrain | None":
        """Light of which samples are wanted, and a B-spline as the first freeform face."""
        emitter, fixed = path.emitter, path.fixed
        samples = emitter.samples
        if samples is None or not path.shaped:
            return None
        if not (isinstance(samples, Corners) or _by_middles(path)):
            return None
        (first, *rest), origins = path.shaped, emitter.origins
        surface, glass = first.surface, None
        if not isinstance(surface, BSplineSurface) or not surface.compiled:
            return None
        match fixed:
            case (
                FaceStep(
                    Plane(z=z), Refraction(law=TransmittanceLaw() as law, reflected=name), _, None
                ),
            ) if first.frame is None and _alike(origins):
                net, level = surface.net, surface.level
                lines = None if _are_even(samples) else (places(samples, 0), places(samples, 1))
                front = fixed[0], name, law, z + path.datum
                glass = Glass(origins, *front, net, level, path.outline, lines)
                fixed = ()
        faces, aperture = (first, tuple(rest), surface), (path.outline, path.front_z, path.datum)
        train = cls(origins, samples, glass, (), *faces, [], path.changes[1:], *aperture)
        if fixed or first.frame is not None:  # the source is in other coordinates
            before, changes = path.changes_before, path.changes
            train = train._replace(before=fixed, first=None, rest=path.shaped)
            train = train._replace(changes_before=before, changes=changes)
            points = not origins.infinite and origins.pattern is None
            if points and len(origins.places) > 1:
                near = origins._replace(places=origins.places - [0.0, 0.0, path.datum])
                way = path.front_z - path.datum, fixed, before, surface.z
                train = train._replace(directions=EvenDirections.of(near, path.outline, *way))
        return train

    @property
    def net(self) -> ControlNet:
        """Where the control heights of the first face sit."""
        return self.surface.net

    @property
    def half_width(self) -> tuple[float, float]:
        """Of what is sampled, scene units."""
        return self.outline.half_width if self.first is None else self.net.half_width

    @property
    def level(self) -> float:
        """Z of the scene that heights of the first freeform face are counted from."""
        return self.surface.level

    @property
    def lines(self) -> tuple[Places, Places]:
        """Samples along x and y, and what each stands for, as parts of the way across."""
        samples = self.samples
        if self.directions is not None and isinstance(samples, Corners):
            samples = Corners(*samples[:5])  # crowds are of places
        return places(samples, 0), places(samples, 1)

    @property
    def areas(self) -> Array:
        """Area of what each sample stands for, as seen along the axis, shape (m_x, m_y)."""
        return areas_of(self.outline, *self.lines)

    @property
    def splits(self) -> tuple[Array, Array]:
        """See `workbench.optics.light.BeamTracer`: origins one after the other along y."""
        return splits_side_by_side(*self.lines, len(self.origins.places))

    def of_origins(self, origins: Origins) -> "SampledTrain":
        """The train with other origins of the light."""
        glass = self.glass and self.glass._replace(origins=origins)
        return self._replace(origins=origins, glass=glass)

    def followed(self, copies: int = 1) -> Followed:
        """The light of samples of the aperture, behind the fixed faces ``before``.

        `copies`: how many mirror images of the origins make all light.
        """
        given, rim = (self.origins, self.lines, self.outline, self.front_z), None
        if self.directions is not None:
            rays, rim = self.directions.rays(*given)
        else:
            rays = through_aperture(*given)
        x, y, z = rays.position
        rays = rays._replace(position=(x, y, z - self.datum))
        aperture = self.outline, (*self.before, *self.rest)[0].missed
        return follow(rays, self.before, self.changes_before, aperture, copies, rim)

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
    def note(self) -> Message:
        """What is special about it, in words."""
        if self.first is None:
            return Message("samples of the aperture, followed through fixed faces once")
        if self.glass is not None:
            return Message("samples on the exit face, shared by all origins of the light")
        if isinstance(self.first.interface, Refraction):
            return Message("samples on the entrance face, shared by all origins of the light")
        return Message("samples on the mirror, shared by all origins of the light")


def is_even(train: SampledTrain, path: Path) -> bool:
    """Whether light along the axis meets one freeform face, so that a walk needs no search."""
    straight = isinstance(path.emitter, CollimatedEmitter) and train.first is not None
    return straight and not train.rest


def _by_middles(path: Path) -> bool:
    """Whether samples in the middles of cells are those of the first freeform face."""
    return isinstance(path.emitter, CollimatedEmitter | DirectionEmitter | PointEmitter)


def _are_even(samples: Samples) -> bool:
    return not isinstance(samples, Corners) or samples.even


def _alike(origins: Origins) -> bool:
    """Whether light of all origins comes from one distance along the axis, if from any."""
    return origins.infinite or bool(np.ptp(origins.places[:, 2]) == 0)


class SampledWalk:
    """The walk from samples of the first freeform face, in torch: the reference.

    `train`: what is sampled; `path`: the path of the light.
    """

    def __init__(self, train: SampledTrain, path: Path) -> None:
        self._train, self._path, self._before = train, path, dict[str, float]()
        self._face: GlassFace | LitFace | None = None
        if train.first is None:
            followed = train.followed()
            self._rays = followed.rays.to(path.device, path.dtype)
            self._rim = followed.rim.to(path.device, path.dtype)
            self._before = followed.lost
        elif train.glass is not None:
            self._before = train.glass.before()
            self._face = GlassFace(train.glass, train.lines, path)
        else:
            given = train.net, train.level, train.lines, train.origins, path, train.patterns()
            self._face = LitFace(*given)

    def walk(self, heights: Mapping[str, Tensor]) -> Arrival:
        """Follow the light from the samples to the receiver; see `Path.walk`."""
        train, sums = self._train, dict[str, Tensor | float](self._before)
        begin: tuple[Vector, Outline] | None = None
        rim: Tensor | None = None
        if self._face is None or train.first is None:
            rays, rim = self._rays, self._rim
        else:
            lit = self._face.light(train.surface.own(heights))
            passed = train.first.interface.turn(*lit)
            # What came and did not meet the face; with the error of the sum over samples.
            met = lit.rays.flux.detach().sum(dtype=torch.float64)
            missed = 1 - sum(self._before.values()) - met
            _add(sums, {train.first.missed: missed, **passed.lost})
            rays, begin = passed.rays, (lit.meeting.position, train.outline)
        for step, change in zip(train.rest, train.changes[:-1], strict=True):
            rays, rim, lost = pass_face(step, seen(rays, change), heights, rim, begin)
            begin = None
            _add(sums, lost)
        rays = seen(rays, train.changes[-1])
        zero = rays.flux.new_zeros((), dtype=torch.float64)
        account = {name: zero + part for name, part in sums.items()}
        return Arrival(*self._path.receiver.places(rays), rays, account, rim)


def _add(sums: dict[str, Tensor | float], lost: Mapping[str, Tensor]) -> None:
    for name, part in lost.items():
        sums[name] = sums.get(name, 0.0) + part.detach().sum(dtype=torch.float64)
