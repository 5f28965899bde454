"""Time of loss and gradient, and accuracy of the image, by what a scene and a plan may choose."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np
import torch

from tests.benchmarks.comparison import Measured, Variant, compare, image_error
from workbench.analysis.benchmark.examples import BenchmarkTask, Notify, wavy
from workbench.analysis.validation import validate
from workbench.arrays import Array, Mask
from workbench.design.loss import paper_loss, share
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.plan import Plan, device_of
from workbench.optics.samples import Corners
from workbench.optics.sources import emitter_of
from workbench.scene import Scene

_SOURCES = {"collimated": "flame", "point": "flame-point", "grid": "flame-grid"}
_NEAR = {"torch": "phone-torch", "LED": "led-rectangle"}
_TRUE_RAYS = 16_000_000
_SECONDS = 10.0  # for each question


class Descent:
    """What one iteration of a design computes: image, loss, gradient.

    Parameters
    ----------
    example : BenchmarkTask
        Scene and target.
    heights : ndarray, shape (n_u, n_v)
        Control heights.
    dtype : torch.dtype
        Float type of the trace.
    threads : int, optional
        Threads to compute with; as many as usual by default.
    still : ndarray of bool, shape (n_u, n_v), optional
        Control points that do not move from one call to the next.
    plan_of : callable
        `Plan` or `BeamPlan`.
    **options
        Their options.
    """

    def __init__(
        self,
        example: BenchmarkTask,
        heights: Array,
        dtype: torch.dtype = torch.float32,
        threads: int | None = None,
        still: Mask | None = None,
        plan_of: Callable[..., Plan | BeamPlan] = Plan,
        **options: Any,
    ) -> None:
        device = device_of(example.scene)
        self._plan = plan_of(example.scene, dtype=dtype, **options)
        self._wanted = torch.as_tensor(share(example.target), dtype=dtype, device=device)
        # The lens moves a little from one call to the next, as it does in a design: the search for
        # intersections would otherwise begin where it ends.
        moved = heights.mean() + 0.98 * (heights - heights.mean())
        if still is not None:
            moved = np.where(still, heights, moved)
        self._lenses = [
            torch.tensor(each, device=device, requires_grad=True) for each in (heights, moved)
        ]
        self._threads = threads

    def __call__(self) -> tuple[Array, float, Array]:
        """Image (n_y, n_x), loss and gradient (n_u, n_v)."""
        usual = torch.get_num_threads()
        torch.set_num_threads(self._threads or usual)
        try:
            heights = self._lenses[0]
            flux = self._plan.trace({"lens.back": heights}).flux
            loss = paper_loss(flux, self._wanted)
            (gradient,) = torch.autograd.grad(loss, [heights])
            self._lenses.reverse()
        finally:
            torch.set_num_threads(usual)
        image = flux.detach().double().cpu().numpy()
        return image, loss.item(), gradient.double().cpu().numpy()


def rays_of(scene: Scene) -> int:
    """How many rays a scene traces."""
    x, y, _ = emitter_of(scene.source, scene.optic).rays(scene.run.seed).position
    return (x + y).numel()


def measurements(iterations: int | None, notify: Notify) -> Iterator[Measured]:
    """Answer all questions, one after the other."""
    for question, variants in _questions():
        notify(question, "")
        yield from compare(question, variants(), _SECONDS)


def _questions() -> Iterator[tuple[str, Callable[[], list[Variant]]]]:
    for kind, name in _SOURCES.items():
        tracers: dict[str, dict[str, Any]] = {"fused": {}, "reference": {"fused": False}}
        yield f"{kind}: tracer", partial(_plans, name, tracers)
    for kind, name in _SOURCES.items():
        types = {"float32": {"dtype": torch.float32}, "float64": {"dtype": torch.float64}}
        yield f"{kind}: float type", partial(_plans, name, types)
    for kind, name in _SOURCES.items():
        threads = sorted({1, torch.get_num_threads()})
        options: dict[str, dict[str, Any]] = {
            f"{n} thread{'s' * (n > 1)}": {"threads": n} for n in threads
        }
        yield f"{kind}: threads", partial(_plans, name, options)
    meshes: dict[str, dict[str, Any]] = {"exact": {}}
    meshes |= {f"mesh, {n} × {n}": {"source.intersection": _mesh(n)} for n in (1, 2, 4, 8)}
    yield "point: intersection", partial(_same_rays, "flame-point", meshes)
    counts: dict[str, list[Any]] = {
        "collimated": [[n, n] for n in (256, 512, 1024, 2048)],
        "point": [125_000, 500_000, 2_000_000],
    }
    for kind, numbers in counts.items():
        rays = {f"{_rays_text(each)} rays": {"source.rays": each} for each in numbers}
        samples = () if kind == "collimated" else (354, 707, 1414)
        yield f"{kind}: rays", partial(_images, _SOURCES[kind], rays, samples)
    filters = {f"{n} × {n} pixels": {"filter.size": n} for n in (3, 1, 5, 7, 11)}
    yield "collimated: filter", partial(_images, "flame", filters)
    if torch.cuda.is_available():
        large = {"source.rays": [2048, 2048]}
        for kind, change in {"collimated": large, "point": {}, "grid": {}}.items():
            devices = {each: {"run.device": each} | change for each in ("cpu", "cuda")}
            yield f"{kind}: device", partial(_same_rays, _SOURCES[kind], devices)
    for kind, name in _NEAR.items():
        yield f"{kind}: points of the source", partial(_points, name, (64, 16, 128))
    for kind in ("collimated", "point"):
        yield f"{kind}: control net", partial(_nets, _SOURCES[kind], (64, 32, 128, 256))


def _plans(name: str, options: Mapping[str, Mapping[str, Any]]) -> list[Variant]:
    """One scene, traced in several ways; the image of the first is the true one."""
    example = BenchmarkTask.of(name)
    heights = wavy(example.scene)
    descents = {label: Descent(example, heights, **each) for label, each in options.items()}
    return _judged(descents, rays_of(example.scene))


def _same_rays(name: str, changes: Mapping[str, Mapping[str, Any]]) -> list[Variant]:
    """One set of rays, traced in several scenes; the image of the first is the true one."""
    examples = {label: BenchmarkTask.of(name, changes=each) for label, each in changes.items()}
    descents = {label: Descent(each, wavy(each.scene)) for label, each in examples.items()}
    return _judged(descents, rays_of(next(iter(examples.values())).scene))


def _judged(descents: Mapping[str, Descent], rays: int) -> list[Variant]:
    images = {label: descent()[0] for label, descent in descents.items()}
    true = next(iter(images.values()))
    return [
        Variant(label, descent, rays, image_error(images[label], true))
        for label, descent in descents.items()
    ]


def _images(
    name: str, changes: Mapping[str, Mapping[str, Any]], samples: Sequence[int] = ()
) -> list[Variant]:
    """One lens, seen in several ways; the true image is an independent trace.

    The last ways look from so many samples of the exit face along each axis, not along rays.
    """
    examples = {label: BenchmarkTask.of(name, changes=each) for label, each in changes.items()}
    first = next(iter(examples.values()))
    heights = wavy(first.scene)
    true = validate(first.scene, first.target, {"lens.back": heights}, _TRUE_RAYS).irradiance
    ways = [
        (label, Descent(each, heights), rays_of(each.scene)) for label, each in examples.items()
    ]
    ways += [
        (f"{n} × {n} samples", Descent(first, heights, samples=(n, n)), n * n) for n in samples
    ]
    return [Variant(*way, image_error(way[1]()[0], true)) for way in ways]


def _nets(name: str, counts: Sequence[int]) -> list[Variant]:
    """The same rays through lenses of other control nets."""
    variants = []
    for count in counts:
        example = BenchmarkTask.of(name, changes={"lens.back.control_points": count})
        descent = Descent(example, wavy(example.scene))
        variants.append(Variant(f"{count} × {count} points", descent, rays_of(example.scene)))
    return variants


def _points(name: str, counts: Sequence[int]) -> list[Variant]:
    """A lens in the light of so many points of a source, each by 256 × 256 samples."""
    example = BenchmarkTask.of(name, changes={"images[0].receiver.pixels": 256})
    heights = wavy(example.scene)
    variants = []
    for count in counts:
        descent = Descent(example, heights, plan_of=BeamPlan, cells=Corners(255, 255, count))
        variants.append(Variant(f"{count} points", descent, count * 256**2))
    return variants


def _mesh(subdivisions: int) -> dict[str, Any]:
    return {"method": "mesh", "subdivisions": [subdivisions, subdivisions]}


def _rays_text(rays: Any) -> str:
    return f"{rays[0]} × {rays[1]}" if isinstance(rays, list) else f"{rays:,}"
