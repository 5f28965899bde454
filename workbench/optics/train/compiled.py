"""A train traced by compiled loops: one tracer for all trains whose first freeform face is sampled.

What a scene does not need is left out by what is in the list: light along the axis needs no
directions before the first face, no sample searches for that face, and of a train that is a mirror
image of itself one half, or one of two origins, is traced. Nothing but depths on further faces is
kept for the way back: to trace a batch again costs less than memory.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
import torch
from torch import Tensor
from torch.autograd.function import once_differentiable

from workbench.arrays import AnyArray, Array
from workbench.geometry.frames import Frame
from workbench.geometry.surface import ControlNet
from workbench.optics.account import Account
from workbench.optics.halves import Halves
from workbench.optics.interfaces import Reflection, Refraction
from workbench.optics.kernels import threads
from workbench.optics.kernels.filtered import filtered
from workbench.optics.kernels.function import as_array, check_size, kind_of
from workbench.optics.kernels.grid import make_axis
from workbench.optics.light import Light, Nodes
from workbench.optics.path import Path
from workbench.optics.sampled import SampledTrain, is_even
from workbench.optics.samples import Corners
from workbench.optics.sources.origins import Origins
from workbench.optics.surfaces import BSplineSurface, Conic, Plane
from workbench.optics.train.elements import ABSORBED, MET_FLUX, STEEP_X, SUMS
from workbench.optics.train.faces import FurtherFaces, first_face
from workbench.optics.train.incident import NewtonSteps, incident_light, sample_lines
from workbench.optics.train.landing import landing_of
from workbench.optics.train.loops import back, land
from workbench.optics.train.numbers import Light as IncidentLight
from workbench.said import Said
from workbench.scene import Filter, Scene

# A scene whose trace compiles the loops.
_SMALL = {
    "format": "freeform-scene",
    "version": 3,
    "source": {"kind": "collimated"},
    "elements": [
        {
            "kind": "lens",
            "name": "lens",
            "half_width": [1.0, 1.0],
            "material": {"index": 1.5},
            "thickness": 0.5,
            "reflection": "schlick",
            "faces": [{"shape": "plane"}, {"shape": "bspline", "control_points": [4, 4]}],
        }
    ],
    "images": [
        {
            "receiver": {
                "kind": "plane",
                "position": [0.0, 0.0, 5.0],
                "half_width": [1.0, 1.0],
                "pixels": [2, 2],
            },
            "target": {"builtin": "tophat"},
        }
    ],
}
# Origins nearer to each other's mirror image than this part of their extent count as a pair.
_SAME = 1e-9


class CompiledTrain:
    """Samples of the first freeform face, followed to the receiver.

    Parameters
    ----------
    path : Path
        One that `matches`.
    mirrored : tuple[bool, bool]
        The promise that heights, elements and source are mirror images of themselves in x, in y:
        then of origins that are mirror images of each other one is traced, or of one origin on the
        axis one half of the samples.

    Attributes
    ----------
    mirrored : tuple[bool, bool]
        Along which axes the nodes are one half of all, and the others their mirror images.
    """

    name = "train"

    @staticmethod
    def matches(path: Path) -> bool:
        """Whether it traces what the reference makes of a path."""
        train = SampledTrain.of(path)
        if train is None:
            return False
        steps = (train.first, *train.rest)
        known = all(
            isinstance(step.surface, Plane | Conic)
            or (isinstance(step.surface, BSplineSurface) and step.surface.subdivisions is None)
            for step in steps
        )
        return known and all(isinstance(step.interface, Refraction | Reflection) for step in steps)

    def __init__(self, path: Path, mirrored: tuple[bool, bool] = (False, False)) -> None:
        train = SampledTrain.of(path)
        if train is None:
            raise TypeError("the first freeform face of this path is not sampled")
        self._path, self._even, kind = path, is_even(path), kind_of(path.dtype)
        mirrored = _kept(mirrored, train.changes)
        self._count, one = len(train.origins.flux), _on_axis(train.origins)
        self._halves = Halves.of(train.samples, mirrored if one else (False, False))
        origins, self.mirrored = train.origins, self._halves.mirrored
        if not one:
            origins, self.mirrored = halved(origins, mirrored)
        self._whole = train
        self._train = train = train._replace(
            origins=origins,
            glass=None if train.glass is None else train.glass._replace(origins=origins),
        )
        self._before = self._lost_before(path)
        self._rest = FurtherFaces(train, path.dtype)
        lines = sample_lines(train, self._halves, kind)
        bases = tuple(
            make_axis(train.net, axis, self._halves.first(line.part, axis), kind)
            for axis, line in enumerate(train.lines)
        )
        self._light = incident_light(train, path, self._halves, self._even, kind)
        self._first = first_face(train, self._even, kind)
        self._landing = landing_of(path.receiver, self._rest.to_receiver, kind)
        self._grid = bases, lines
        self._newton = NewtonSteps.of(train, path.dtype)
        columns, rows = (len(basis.place) for basis in bases)
        self._shape = self._light.origins * rows, columns
        self._bounds = threads.split(columns, self._shape[0] * columns)
        # Where rays met further faces of the last train: there the search begins.
        self._depths = np.full((len(train.rest), *self._shape), np.inf, kind)

    @property
    def notes(self) -> list[str]:
        """See `workbench.optics.light.BeamTracer`."""
        some, count = len(self._train.origins.flux), self._count
        if self._even:
            first = "collimated light: entrance refraction and intersection left out"
            return [Said(first), *self._halves.notes]
        if self._train.origins.infinite:
            one, more = (
                Said("1 direction of light"),
                Said("{count} directions of light", count=count),
            )
        else:
            one, more = Said("1 point of light"), Said("{count} points of light", count=count)
        notes = [more if count > 1 else one, self._train.note, *self._halves.notes]
        if some < count:
            notes.append(Said("mirror symmetry: {some} of them are traced", some=some))
        return notes

    @property
    def splits(self) -> tuple[Array, Array]:
        """See `workbench.optics.light.BeamTracer`."""
        return self._halves.splits(self._train.splits)

    def nodes(self, heights: Mapping[str, Tensor]) -> Nodes:
        """Trace the corners of cells of light; see `workbench.optics.light.BeamTracer`."""
        accounts: list[Account] = []
        above = []
        for surface in (self._train.surface, *self._rest.splines):
            check_size(heights[surface.name], surface.net)
            above.append((surface.own(heights) - surface.level).to(self._path.dtype))
        nodes, rims = _Trace.apply(self, accounts, *above)  # type: ignore[no-untyped-call]
        return Nodes(nodes, accounts[0], rims if self._train.rest else None)

    def image(self, heights: Mapping[str, Tensor], filter: Filter) -> Light:
        """Trace a lens; see `workbench.optics.light.Tracer`."""
        nodes, account, _ = self.nodes(heights)
        image, on_screen, beside = filtered(nodes, self._path.receiver.part.pixels, filter)
        for axis in (0, 1):
            if self.mirrored[axis]:
                image = image + image.flip(1 - axis)
        copies = 2 ** sum(self.mirrored)
        lost = dict(account.lost) | {"off_screen": copies * beside}
        return Light(image, Account(copies * on_screen, lost))

    def forward(
        self, heights: tuple[AnyArray, ...]
    ) -> tuple[AnyArray, AnyArray, Account, tuple[Any, ...]]:
        """Nodes, distances to rims, the account of a train, and what its way back takes."""
        first, *others = heights
        elements, table = self._rest.prepare(others)
        depths = self._depths.copy()  # the way back of a train may come after another one
        nodes, rims = np.empty((3, *self._shape), first.dtype), np.empty((0, 0), first.dtype)
        if len(depths):
            rims = np.empty(self._shape, first.dtype)
        sums = np.zeros((len(self._bounds) - 1, len(depths) + 1, SUMS))
        faces = (self._first, elements), self._landing, table, depths
        known = first, *self._grid, self._light_of(first), *faces
        self._run(lambda *span, part: land(*known, *span, nodes, rims, sums[part]))
        self._depths, self._rest.steepest = depths, sums[:, 1:, STEEP_X:].max(axis=0)
        return nodes, rims, self._account(2 ** sum(self.mirrored) * sums.sum(axis=0)), known

    def backward(
        self, heights: tuple[AnyArray, ...], known: tuple[Any, ...], *cotangents: AnyArray
    ) -> tuple[AnyArray, ...]:
        """Cotangents of the heights from those of nodes and rims of one of the mirror images."""
        first, *others = heights
        parts, table = len(self._bounds) - 1, known[-2]
        gradients, d_tables = np.zeros((parts, *first.shape)), np.zeros((parts, *table.shape))
        self._run(
            lambda *span, part: back(*known, *span, *cotangents, gradients[part], d_tables[part])
        )
        found = [gradients.sum(axis=0), *self._rest.cotangents(d_tables, others)]
        for axis in (0, 1):
            if self.mirrored[axis]:  # the other half would have given the mirror image of this
                found = [(each + np.flip(each, axis)) / 2 for each in found]
        return tuple(found)

    def _light_of(self, heights: AnyArray) -> IncidentLight:
        """The light for heights of the first face: how deep it is tells how long roots take."""
        light = self._light
        if self._newton is None:
            return light
        return light._replace(points=light.points._replace(steps=self._newton.steps(heights)))

    def _run(self, work: Callable[..., None]) -> None:
        bounds = self._bounds
        threads.run(lambda k: work(bounds[k], bounds[k + 1], part=k), len(bounds) - 1)

    def _lost_before(self, path: Path) -> dict[str, float]:
        """Flux that is lost before the first face, by its names in the account."""
        glass = self._train.glass
        if not self._even:  # of all origins, traced or not
            return {} if self._whole.glass is None else self._whole.glass.before()
        beside = path.emitter.beside
        if glass is None:
            return {self._train.first.missed: beside}
        entering = glass.law.at(1.0, 1.0)
        return {glass.step.missed: beside, glass.reflected: (1 - entering) * (1 - beside)}

    def _account(self, sums: AnyArray) -> Account:
        lost = dict(self._before)
        arriving = 1 - sum(lost.values())
        steps = (self._train.first, *self._train.rest)
        if self._even:  # its samples stand for all light that comes
            arriving = float(sums[0, ABSORBED] + sums[0, MET_FLUX])
        for step, (absorbed, met, passed, left, *_) in zip(steps, sums.tolist(), strict=True):
            parts = {step.missed: arriving - absorbed - met}
            match step.interface:
                case Reflection(absorbed=name, reflectance=reflectance):
                    parts |= {name: met - left} if reflectance < 1 else {}
                case Refraction(reflected=name, absorption=absorption):
                    parts |= {"total_reflection": met - passed, name: passed - left}
                    parts |= {"absorbed": absorbed} if absorption > 0 else {}
            for name, part in parts.items():
                lost[name] = lost.get(name, 0.0) + part
            arriving = left
        return Account(arriving, {"off_screen": 0.0} | lost)


class _Trace(torch.autograd.Function):
    @staticmethod
    def forward(
        ctx: Any, train: CompiledTrain, accounts: list[Account], *heights: Tensor
    ) -> tuple[Tensor, Tensor]:
        nodes, rims, account, known = train.forward(tuple(map(as_array, heights)))
        ctx.train, ctx.known = train, known
        ctx.save_for_backward(*heights)
        accounts.append(account)
        return torch.from_numpy(nodes), torch.from_numpy(rims)

    @staticmethod
    @once_differentiable
    def backward(ctx: Any, *cotangents: Tensor) -> tuple[Tensor | None, ...]:
        heights = tuple(map(as_array, ctx.saved_tensors))
        found = ctx.train.backward(heights, ctx.known, *map(as_array, cotangents))
        gradients = (torch.from_numpy(each.astype(heights[0].dtype)) for each in found)
        return None, None, *gradients


def _kept(mirrored: tuple[bool, bool], changes: Sequence[Frame]) -> tuple[bool, bool]:
    """The promise of mirror images, as far as tilted and shifted elements keep it."""
    x, y = (
        wanted and all(change.keeps_mirror_images(axis) for change in changes)
        for axis, wanted in enumerate(mirrored)
    )
    return x, y


def halved(origins: Origins, wanted: tuple[bool, bool]) -> tuple[Origins, tuple[bool, bool]]:
    """Origins of which mirror images give all, and along which axes they do.

    Parameters
    ----------
    origins : Origins
        All of them.
    wanted : tuple[bool, bool]
        Along which axes to leave mirror images out, if there are any.
    """
    kept, done = origins, [False, False]
    for axis in (0, 1):
        side = kept.places[:, axis]
        if wanted[axis] and (side != 0).any() and _paired(kept, axis):
            share = np.where(side == 0, 0.5, 1.0)
            some = side >= 0
            kept = kept._replace(places=kept.places[some], flux=(kept.flux * share)[some])
            done[axis] = True
    return kept, (done[0], done[1])


def _paired(origins: Origins, axis: int) -> bool:
    """Whether each origin has a mirror image of the same flux."""
    flipped = origins.places.copy()
    flipped[:, axis] *= -1
    size = np.ptp(origins.places, axis=0).max()
    orders = (np.lexsort(np.round(p / (_SAME * size)).T) for p in (origins.places, flipped))
    one, other = orders
    same = np.abs(origins.places[one] - flipped[other]).max() <= 2 * _SAME * size
    return bool(same) and np.allclose(origins.flux[one], origins.flux[other], rtol=1e-9)


def _on_axis(origins: Origins) -> bool:
    """Whether there is one origin, on the axis, whose light is its own mirror image."""
    return len(origins.flux) == 1 and not origins.places[0, :2].any() and origins.pattern is None


def compile_for(dtype: torch.dtype) -> None:
    """Compile the loops for a float type by tracing a few samples."""
    scene = Scene.from_data(_SMALL)
    path = Path.of(scene, ControlNet.of(scene.optic), dtype, samples=Corners(2, 2))
    heights = torch.full(scene.optic.net_shape, 0.5, dtype=torch.float64, requires_grad=True)
    with torch.enable_grad():  # whoever asks, the way back is compiled, too
        light = CompiledTrain(path).image({scene.optic.designed_face: heights}, scene.filter)
        light.flux.sum().backward()  # type: ignore[no-untyped-call]
