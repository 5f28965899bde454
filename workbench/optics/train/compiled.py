"""A train traced by compiled loops: one tracer for all trains.

What a scene does not need is left out by what is in the list: light along the axis needs no
directions before the first face, no sample searches for that face, fixed faces before the first
freeform one are passed once, and of a train that is a mirror image of itself one half, or one of
two origins, is traced. Nothing but depths on further faces is kept for the way back: to trace a
batch again costs less than memory.
"""

from collections.abc import Callable, Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np
import torch
from torch import Tensor
from torch.autograd.function import once_differentiable

from workbench.arrays import AnyArray, Array
from workbench.geometry.surface import ControlNet
from workbench.optics.account import Account
from workbench.optics.interfaces import Reflection, Refraction
from workbench.optics.kernels import as_array, check_size, threads
from workbench.optics.kernels.spread import Spread, add_up, make_canvases, make_spread, pad
from workbench.optics.light import Light, Nodes
from workbench.optics.path import Path
from workbench.optics.samples import Corners
from workbench.optics.surfaces import BSplineSurface
from workbench.optics.train.elements import ABSORBED, MET_FLUX, RUNS, STEEP_X, SUMS
from workbench.optics.train.entries import Last, entry_of, is_known
from workbench.optics.train.faces import FurtherFaces
from workbench.optics.train.landing import landing_of
from workbench.optics.train.loops import BESIDE, ON_RECEIVER, back, land
from workbench.scene import BoxFilter, Filter, Scene

SMALL: Mapping[str, Any] = {
    "format": "freeform-scene",
    "version": 3,
    "source": {
        "kind": "point",
        "position": [0.0, 0.0, -5.0],
        "rays": 16,
        "sampling": "random",  # Sobol sequences of scipy take half a second to import
    },
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
"""A scene whose trace compiles the loops."""


class CompiledTrain:
    """Rays followed from where they begin to the receiver.

    `path`: one that `matches`; `mirrored`: the promise that heights, elements and source are mirror
    images of themselves in x, in y: then of origins that are mirror images of each other one is
    traced, or of one origin on the axis one half of the samples. `mirrored`: along which axes the
    nodes are one half of all, and the others their mirror images.
    """

    name = "train"

    @staticmethod
    def matches(path: Path) -> bool:
        """Whether it traces what the reference makes of a path."""
        known = all(step.surface.compiled and step.interface.compiled for step in path.shaped)
        return known and path.receiver.compiled and is_known(path)

    def __init__(self, path: Path, mirrored: tuple[bool, bool] = (False, False)) -> None:
        self._path, self._entry = path, entry_of(path, mirrored)
        entry, self.mirrored = self._entry, self._entry.mirrored
        outline = None if entry.sampled is None else path.outline
        self._rest = FurtherFaces(entry.rest, entry.changes, entry.z, outline, path.dtype)
        surfaces = [step.surface for step in path.shaped]
        self._splines = [each for each in surfaces if isinstance(each, BSplineSurface)]
        self._landing = landing_of(path.receiver, self._rest.to_receiver, entry.kind)
        self._last: Last | None = None

    @property
    def notes(self) -> list[str]:
        """See `workbench.optics.light.BeamTracer`."""
        return self._entry.notes

    @property
    def splits(self) -> tuple[Array, Array]:
        """See `workbench.optics.light.BeamTracer`."""
        return self._entry.splits

    def nodes(self, heights: Mapping[str, Tensor]) -> Nodes:
        """Trace the corners of cells of light; see `workbench.optics.light.BeamTracer`."""
        accounts: list[Account] = []
        given = self, accounts, *self._above(heights)
        nodes, rims = _Nodes.apply(*given)  # type: ignore[no-untyped-call]
        return Nodes(nodes, accounts[0], rims if self._entry.rims else None)

    def image(self, heights: Mapping[str, Tensor], filter: Filter) -> Light:
        """Trace a lens; see `workbench.optics.light.Tracer`."""
        spread = make_spread(self._path.receiver.part.pixels, filter, self._entry.kind)
        accounts: list[Account] = []
        given = self, spread, accounts, *self._above(heights)
        image = _Image.apply(*given)  # type: ignore[no-untyped-call]
        for axis in (0, 1):
            if self.mirrored[axis]:
                image = image + image.flip(1 - axis)
        return Light(image, accounts[0])

    def _above(self, heights: Mapping[str, Tensor]) -> list[Tensor]:
        """Heights of the B-splines above their levels, in the float type of the trace."""
        for surface in self._splines:
            check_size(heights[surface.name], surface.net)
        own = ((surface.own(heights), surface.level) for surface in self._splines)
        return [(each - level).to(self._path.dtype) for each, level in own]

    def forward(self, heights: tuple[AnyArray, ...], spread: Spread | None) -> "_Traced":
        """Trace to the receiver; to an image, if there is a filter."""
        entry, kind = self._entry, self._entry.kind
        samples, first, depths, steepest = entry.start(heights[0], self._last)
        if steepest is not None:
            self._rest.steepest[0] = steepest
        elements, table = self._rest.prepare(heights[len(heights) - len(self._rest.splines) :])
        bounds, none = _bounds(depths), np.zeros((0, 0), kind)
        parts, shape = len(bounds) - 1, depths.shape[1:]
        nodes, canvases = np.empty((3, *shape), kind), np.zeros((parts, 0, 0))
        if spread is not None:
            nodes, canvases = np.empty((3, 0, 0), kind), make_canvases(spread, parts)
        rims = np.empty(shape, kind) if entry.rims and spread is None else none
        known = *samples, (first, elements), self._landing, table, depths, spread or _none(kind)
        sums = np.zeros((parts, len(depths) + 1, SUMS))

        def work(*span: int, part: int) -> None:
            land(*known, *span, nodes, rims, canvases[part], sums[part])

        _run(bounds, work)
        self._rest.steepest = sums[:, 1:, STEEP_X:RUNS].max(axis=0)
        total = sums.sum(axis=0)
        self._last = Last(depths, int(total[1:2, RUNS].sum()))
        account = self._account(2 ** sum(self.mirrored) * total, spread is not None)
        return _Traced(nodes, rims, canvases, account, known)

    def backward(
        self,
        heights: tuple[AnyArray, ...],
        known: tuple[Any, ...],
        nodes: AnyArray,
        rims: AnyArray,
        canvas: AnyArray,
    ) -> tuple[AnyArray, ...]:
        """Cotangents of the heights from those of what one of the mirror images gives."""
        sampled, depths = known[0], known[-2]
        bounds = _bounds(depths)
        parts = len(bounds) - 1
        gradients = np.zeros((parts, *sampled.shape))
        d_tables, touched = self._rest.no_cotangents(parts)

        def work(*span: int, part: int) -> None:
            found = gradients[part], d_tables[part], touched[part]
            back(*known, *span, nodes, rims, canvas, *found)

        _run(bounds, work)
        some = len(heights) - len(self._rest.splines)
        of_rest = self._rest.cotangents(d_tables, touched, heights[some:])
        found = [gradients.sum(axis=0)][:some] + of_rest
        for axis in (0, 1):
            if self.mirrored[axis]:  # the other half would have given the mirror image of this
                found = [(each + np.flip(each, axis)) / 2 for each in found]
        return tuple(found)

    def _account(self, sums: AnyArray, drawn: bool) -> Account:
        entry = self._entry
        lost = dict(entry.lost)
        arriving = 1 - sum(lost.values())
        steps, rows = list(entry.rest), sums[1:]
        if entry.sampled is not None:
            steps, rows = [entry.sampled, *steps], sums
        if entry.even:  # its samples stand for all light that comes
            arriving = float(sums[0, ABSORBED] + sums[0, MET_FLUX])
        for step, (absorbed, met, passed, left, *_) in zip(steps, rows.tolist(), strict=True):
            parts = {step.missed: arriving - absorbed - met}
            match step.interface:
                case Reflection(absorbed=name, reflectance=reflectance):
                    parts |= {name: met - left} if reflectance < 1 else {}
                case Refraction(reflected=name, total=None):
                    parts |= {name: met - left}
                case Refraction(reflected=name, total=str(total)) as medium:
                    parts |= {total: met - passed, name: passed - left}
                    parts |= {medium.absorbed: absorbed} if medium.absorption > 0 else {}
            for name, part in parts.items():
                lost[name] = lost.get(name, 0.0) + part
            arriving = left
        on_receiver, beside = sums[0, [ON_RECEIVER, BESIDE]].tolist() if drawn else (arriving, 0.0)
        return Account(on_receiver, lost | {"off_screen": beside})


class _Traced(NamedTuple):
    """What a trace gives, and what its way back takes."""

    nodes: AnyArray
    rims: AnyArray
    canvases: Array
    account: Account
    known: tuple[Any, ...]


class _Nodes(torch.autograd.Function):
    @staticmethod
    def forward(
        ctx: Any, train: CompiledTrain, accounts: list[Account], *heights: Tensor
    ) -> tuple[Tensor, Tensor]:
        traced = train.forward(tuple(map(as_array, heights)), None)
        ctx.train, ctx.known = train, traced.known
        ctx.save_for_backward(*heights)
        accounts.append(traced.account)
        return torch.from_numpy(traced.nodes), torch.from_numpy(traced.rims)

    @staticmethod
    @once_differentiable
    def backward(ctx: Any, *cotangents: Tensor) -> tuple[Tensor | None, ...]:
        nodes, rims = map(as_array, cotangents)
        return None, None, *_cotangents(ctx, nodes, rims, np.zeros((0, 0), nodes.dtype))


class _Image(torch.autograd.Function):
    @staticmethod
    def forward(
        ctx: Any, train: CompiledTrain, spread: Spread, accounts: list[Account], *heights: Tensor
    ) -> Tensor:
        traced = train.forward(tuple(map(as_array, heights)), spread)
        ctx.train, ctx.known, ctx.spread = train, traced.known, spread
        ctx.save_for_backward(*heights)
        accounts.append(traced.account)
        return torch.from_numpy(np.ascontiguousarray(add_up(spread, traced.canvases)))

    @staticmethod
    @once_differentiable
    def backward(ctx: Any, cotangent: Tensor) -> tuple[Tensor | None, ...]:
        canvas = pad(ctx.spread, as_array(cotangent))
        nodes, rims = np.zeros((3, 0, 0), canvas.dtype), np.zeros((0, 0), canvas.dtype)
        return None, None, None, *_cotangents(ctx, nodes, rims, canvas)


def _cotangents(ctx: Any, *of_light: AnyArray) -> Iterator[Tensor]:
    """Cotangents of heights in their float type; see `CompiledTrain.backward`."""
    heights = tuple(map(as_array, ctx.saved_tensors))
    for each in ctx.train.backward(heights, ctx.known, *of_light):
        yield torch.from_numpy(each.astype(heights[0].dtype))


def _none(kind: type[np.floating[Any]]) -> Spread:
    """The filter of no image."""
    return make_spread((1, 1), BoxFilter(), kind)


def _bounds(depths: AnyArray) -> list[int]:
    """Where the parts of the columns of rays begin that threads trace."""
    _, rows, columns = depths.shape
    return threads.split(columns, rows * columns)


def _run(bounds: list[int], work: Callable[..., None]) -> None:
    threads.run(lambda k: work(bounds[k], bounds[k + 1], part=k), len(bounds) - 1)


def compile_for(dtype: torch.dtype) -> None:
    """Compile the loops for a float type by tracing a few rays and a few samples."""
    scene = Scene.from_data({**SMALL})
    heights = torch.full(scene.optic.net_shape, 0.5, dtype=torch.float64, requires_grad=True)
    for samples in (None, Corners(2, 2)):
        path = Path.of(scene, ControlNet.of(scene.optic), dtype, samples=samples)
        with torch.enable_grad():  # whoever asks, the way back is compiled, too
            light = CompiledTrain(path).image({scene.optic.designed_face: heights}, scene.filter)
            light.flux.sum().backward()  # type: ignore[no-untyped-call]
