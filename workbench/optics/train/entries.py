"""Where rays of a compiled train begin: at samples of its first face, of its aperture, or drawn."""

from abc import ABC, abstractmethod
from typing import Any, NamedTuple

import numpy as np
import torch

from workbench.arrays import AnyArray, Array
from workbench.geometry.frames import Frame
from workbench.messages import Message
from workbench.optics.kernels import kind_of
from workbench.optics.kernels.grid import Axis, make_axis
from workbench.optics.kernels.intersection import order_of
from workbench.optics.kernels.patches import make_net
from workbench.optics.path import Path
from workbench.optics.rays import RayBundle
from workbench.optics.sampled import SampledTrain, is_even
from workbench.optics.samples import Corners
from workbench.optics.steps import FaceStep
from workbench.optics.surfaces import BSplineSurface
from workbench.optics.train.faces import first_face
from workbench.optics.train.first_face import NO_RAY
from workbench.optics.train.incident import (
    FaceSamples,
    Halves,
    NewtonSteps,
    given_light,
    halved,
    incident_light,
    is_on_axis,
    no_samples,
    sample_lines,
)
from workbench.optics.train.numbers import FirstFace, Light

# An interruption of the order of drawn rays costs about as much as sorting so many rays.
_INTERRUPTION = 2


class Start(NamedTuple):
    """What the loops take of the rays of a trace."""

    # Heights and basis functions of a face that is sampled, its samples, and the light.
    samples: tuple[AnyArray, tuple[Axis, ...], FaceSamples, Light]
    first: FirstFace  # that face
    # (elements, rows, columns), where the search for the faces begins; the trace changes it.
    depths: AnyArray
    steepest: AnyArray | None = None  # (2,), the most that slopes of given rays are


class Last(NamedTuple):
    """What the last trace says of where the search of the next one begins."""

    depths: AnyArray  # (elements, rows, columns), where rays met the faces
    # How many runs of rays there were whose search for the first of them began in one patch.
    runs: int


class Entry(ABC):
    """Where rays begin, and the faces that they search for.

    Attributes
    ----------
    sampled : FaceStep or None
        The face that is sampled; its heights come first.
    even : bool
        Whether its samples stand for all light that comes.
    rest : tuple of FaceStep
        The faces that rays search for.
    changes : list of Frame
        Changes of coordinates before each of them, and behind the last one.
    z : float
        Where positions before these faces are counted from.
    kind : type
        Float type of the loops.
    mirrored : tuple[bool, bool]
        Along which axes the rays are one half of all, and the others their mirror images.
    rims : bool
        Whether distances to the rims of the faces are wanted.
    lost : dict of str to float
        Flux of all light that is lost before, by its names in the account; from `start` on.
    """

    sampled: FaceStep | None = None
    even: bool = False
    rest: tuple[FaceStep, ...]
    changes: list[Frame]
    z: float
    kind: type[np.floating[Any]]
    mirrored: tuple[bool, bool] = False, False
    rims: bool = True
    lost: dict[str, float]

    @property
    @abstractmethod
    def notes(self) -> list[str]:
        """See `workbench.optics.light.BeamTracer`."""

    @property
    @abstractmethod
    def splits(self) -> tuple[Array, Array]:
        """See `workbench.optics.light.BeamTracer`."""

    @abstractmethod
    def start(self, heights: AnyArray, last: Last | None) -> Start:
        """The rays of a trace.

        Parameters
        ----------
        heights : ndarray, shape (n_u, n_v)
            Of the first freeform face, above its level.
        last : Last, optional
            The last trace, if there was one.
        """


def is_known(path: Path) -> bool:
    """Whether rays of a path can begin at its samples, or are drawn; and meet a freeform face."""
    drawn = bool(path.shaped) and not isinstance(path.emitter.samples, Corners)
    return drawn or SampledTrain.of(path) is not None


def entry_of(path: Path, mirrored: tuple[bool, bool]) -> Entry:
    """Where the rays of a path begin.

    `path`: one that `is_known`; `mirrored`: see `workbench.optics.train.compiled.CompiledTrain`.
    """
    train = SampledTrain.of(path)
    if train is None:
        return DrawnRays(path)
    if train.first is None:
        return SampledAperture(train, path, mirrored)
    return SampledFace(train, path, mirrored)


class _Sampled(Entry):
    """Samples, and which origins and which half of them are traced."""

    def __init__(self, train: SampledTrain, path: Path, mirrored: tuple[bool, bool]) -> None:
        self.sampled, self.rest, self.changes = train.first, train.rest, train.changes
        self.z, mirrored = train.surface.z, _kept(mirrored, train)
        self._count, one = len(train.origins.flux), is_on_axis(train.origins)
        self._halves = Halves.of(train.samples, mirrored if one else (False, False))
        origins, self.mirrored = train.origins, self._halves.mirrored
        if not one:
            origins, self.mirrored = halved(origins, mirrored)
        self._train, self.kind = train.of_origins(origins), kind_of(path.dtype)

    @property
    def notes(self) -> list[str]:
        """See `Entry`."""
        some, count = len(self._train.origins.flux), self._count
        if self._train.origins.infinite:
            one, more = (
                Message("1 direction of light"),
                Message("{count} directions of light", count=count),
            )
        else:
            one, more = Message("1 point of light"), Message("{count} points of light", count=count)
        notes = [more if count > 1 else one, self._train.note, *self._halves.notes]
        if some < count:
            notes.append(Message("mirror symmetry: {some} of them are traced", some=some))
        return notes

    @property
    def splits(self) -> tuple[Array, Array]:
        """See `Entry`."""
        return self._halves.splits(self._train.splits)


class SampledFace(_Sampled):
    """Samples of the first freeform face, behind a plane face or none; an `Entry`."""

    def __init__(self, train: SampledTrain, path: Path, mirrored: tuple[bool, bool]) -> None:
        super().__init__(train, path, mirrored)
        self.even, self.rims = is_even(train, path), bool(train.rest)
        self.lost = self._lost_before(train, path)
        train, kind = self._train, self.kind
        bases = tuple(
            make_axis(train.net, axis, self._halves.first(line.part, axis), kind)
            for axis, line in enumerate(train.lines)
        )
        self._grid = bases, sample_lines(train, self._halves, kind)
        self._light = incident_light(train, path, self._halves, self.even, kind)
        lift = 0.0 if train.glass is None else train.level - train.glass.z
        self._first = first_face(train.first, lift, self.even, kind)
        self._newton = NewtonSteps.of(train, path.dtype)

    @property
    def notes(self) -> list[str]:
        """See `Entry`."""
        if self.even:
            return [
                Message("collimated light: entrance refraction and intersection left out"),
                *self._halves.notes,
            ]
        return super().notes

    def start(self, heights: AnyArray, last: Last | None) -> Start:
        """See `Entry`."""
        light, (columns, rows) = self._light, (len(basis.place) for basis in self._grid[0])
        if self._newton is not None:  # the depth of the face decides how long roots take
            steps = self._newton.steps(heights)
            light = light._replace(points=light.points._replace(steps=steps))
        shape = len(self.rest), light.origins * rows, columns
        depths = np.full(shape, np.inf, self.kind) if last is None else last.depths.copy()
        return Start((heights, *self._grid, light), self._first, depths)

    def _lost_before(self, train: SampledTrain, path: Path) -> dict[str, float]:
        if not self.even:  # of all origins, traced or not
            return {} if train.glass is None else train.glass.before()
        beside = path.emitter.beside
        if train.glass is None:
            return {path.steps[0].missed: beside}
        entering = train.glass.law.at(1.0, 1.0)
        lost = {train.glass.step.missed: beside}
        return lost | {train.glass.reflected: (1 - entering) * (1 - beside)}


class SampledAperture(_Sampled):
    """Samples of the aperture, followed through fixed faces; an `Entry`."""

    def __init__(self, train: SampledTrain, path: Path, mirrored: tuple[bool, bool]) -> None:
        super().__init__(train, path, mirrored)
        train, halves, kind = self._train, self._halves, self.kind
        copies = 1 if any(halves.mirrored) else 2 ** sum(self.mirrored)
        followed = train.followed(copies)
        self.lost = followed.lost
        values = in_numbers(followed.rays, self.z)
        numbers = np.stack([halves.rows(part) for part in values])
        if any(halves.mirrored):
            counts = (len(line.part) for line in train.lines)
            across, up = (halves.weighted(np.ones(n), axis) for axis, n in enumerate(counts))
            numbers[5] *= np.where(numbers[5] >= 0, up[:, None] * across, 1.0)
        rims = halves.rows(followed.rim.numpy())
        self._light = given_light(numbers.astype(kind), rims.astype(kind))
        self._steepest = _steepest(numbers)
        self._first = first_face(None, 0.0, False, kind)

    def start(self, heights: AnyArray, last: Last | None) -> Start:
        """See `Entry`."""
        shape = len(self.rest), *self._light.given.rims.shape
        depths = np.full(shape, np.inf, self.kind) if last is None else last.depths.copy()
        start = (*no_samples(self.kind), self._light), self._first, depths
        return Start(*start, self._steepest)


class DrawnRays(Entry):
    """Rays that a source draws at random, followed to the first freeform face; an `Entry`.

    They are kept sorted by the patch of that face in which they met it in the last trace. When many
    have moved to other patches, they are sorted again.

    `path`: the path of the light.
    """

    rims = False

    def __init__(self, path: Path) -> None:
        surface = path.shaped[0].surface
        if not isinstance(surface, BSplineSurface):
            raise TypeError("the first freeform face of this path is no B-spline")
        self.rest, self.changes, self.z = path.shaped, path.changes, surface.z
        self._path, self.kind = path, kind_of(path.dtype)
        self._net = make_net(surface.net, self.kind)
        self._first = first_face(None, 0.0, False, self.kind)
        self._values = np.zeros((6, 0), self.kind)
        self._draw = -1
        self._fewest = self._interruptions = 0

    @property
    def notes(self) -> list[str]:
        """See `Entry`."""
        return []

    @property
    def splits(self) -> tuple[Array, Array]:
        """See `Entry`."""
        raise TypeError("drawn rays are no corners of cells")

    def start(self, heights: AnyArray, last: Last | None) -> Start:
        """See `Entry`."""
        if last is None or self._draw != self._path.draw:
            rays = in_numbers(self._path.begin(), self.z)
            self._values = rays.reshape(6, -1).astype(self.kind)
            self._draw = self._path.draw
            self.lost = {name: flux.item() for name, flux in self._path.lost.items()}
            depths = np.full((len(self.rest), 1, self._values.shape[1]), np.inf, self.kind)
            depths[0] = heights.mean()
            depths = self._sorted(depths)
        else:
            self._fewest = self._fewest or last.runs
            self._interruptions += max(last.runs - self._fewest, 0)
            often = self._interruptions * _INTERRUPTION > self._values.shape[1]
            depths = self._sorted(last.depths) if often else last.depths.copy()
        light = given_light(self._values[:, None], np.zeros((0, 0), self.kind))
        start = (*no_samples(self.kind), light), self._first, depths
        return Start(*start, self._steepest)

    def _sorted(self, depths: AnyArray) -> AnyArray:
        """Sort the rays by where they were at some depths of the first face; give all in order."""
        order = order_of(self._net, self._values, depths[0, 0])
        self._values = np.stack([part[order] for part in self._values])
        self._steepest = _steepest(self._values)
        self._fewest = self._interruptions = 0
        return np.ascontiguousarray(depths[:, :, order])


def in_numbers(rays: RayBundle, level: float) -> Array:
    """Rays in float64 as `workbench.optics.train.numbers.GivenRays` takes them, (6, ...).

    ``level`` is where they count z from.
    """
    (x, y, z), (d_x, d_y, d_z) = rays.position, rays.direction
    exists = rays.alive & (d_z > 0)
    steep = torch.where(exists, d_z, 1.0)
    slopes = (torch.where(exists, part / steep, 0.0) for part in (d_x, d_y))
    flux = torch.where(exists, rays.flux, NO_RAY)
    parts = (part.numpy() for part in (x, y, z - level, *slopes, flux))
    return np.stack(np.broadcast_arrays(*parts))


def _steepest(values: AnyArray) -> AnyArray:
    """The most that slopes of given rays are along x and y."""
    steepest: AnyArray = np.abs(values[3:5]).reshape(2, -1).max(axis=1, initial=0)
    return steepest


def _kept(mirrored: tuple[bool, bool], train: SampledTrain) -> tuple[bool, bool]:
    """The promise of mirror images, as far as tilted and shifted elements keep it."""
    changes = [*train.changes_before, *train.changes]
    x, y = (
        wanted and all(change.keeps_mirror_images(axis) for change in changes)
        for axis, wanted in enumerate(mirrored)
    )
    return x, y
