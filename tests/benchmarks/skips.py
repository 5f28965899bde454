"""What is saved by leaving out what a scene does not need: each with and without."""

from collections.abc import Callable, Iterator
from typing import Any

import torch

from tests.benchmarks.comparison import Measured, Variant, compare, image_error
from tests.benchmarks.kernels import Descent, rays_of
from workbench.analysis.benchmark.examples import BenchmarkTask, Notify, wavy
from workbench.design.levels import light_extent_of
from workbench.design.wide_image import WideImage
from workbench.optics.beam_plan import BeamPlan

_SECONDS = 10.0  # for each question


def measurements(iterations: int | None, notify: Notify) -> Iterator[Measured]:
    """Time every skip against doing what it leaves out, the skip first."""
    for question, variants in SKIPS.items():
        notify(question, "")
        yield from compare(question, variants(), _SECONDS)


def _entrance_and_search() -> list[Variant]:
    """Collimated light by its own path, and as the light of a point far away."""
    parallel = BenchmarkTask.of("flame")
    optic = parallel.scene.optic
    # Of the light in a cone around a square, 2/π meets the square.
    rays = round(rays_of(parallel.scene) * 3.1416 / 2)
    far = [0.0, 0.0, optic.front_z - 1e5 * max(optic.half_width)]
    source = {"kind": "point", "position": far, "rays": rays}
    point = BenchmarkTask.of("flame", changes={"source": source})
    return _pair(
        ("left out", Descent(parallel, wavy(parallel.scene))),
        ("a point far away", Descent(point, wavy(point.scene))),
        rays_of(parallel.scene),
    )


def _constants(name: str) -> list[Variant]:
    """What does not change in a run, computed once or for each trace."""
    example = BenchmarkTask.of(name)
    heights = wavy(example.scene)
    descent = Descent(example, heights)
    return [
        Variant("computed once", descent, rays_of(example.scene)),
        Variant("for each trace", lambda: Descent(example, heights)(), rays_of(example.scene)),
    ]


def _taps() -> list[Variant]:
    """A box filter, and one that spreads each ray."""
    box = BenchmarkTask.of("flame", changes={"filter": {"kind": "box"}})
    spread = BenchmarkTask.of("flame")
    return [
        Variant("box", Descent(box, wavy(box.scene)), rays_of(box.scene)),
        Variant("Gaussian, 3 × 3", Descent(spread, wavy(spread.scene)), rays_of(spread.scene)),
    ]


def _mirrored(*axes: bool) -> list[Variant]:
    """A scene that is its own mirror image, traced in part and whole."""
    example = BenchmarkTask.of("tophat")
    heights = wavy(example.scene)
    heights = (heights + heights[::-1]) / 2
    heights = (heights + heights[:, ::-1]) / 2
    beams: dict[str, Any] = {"plan_of": BeamPlan, "cells": example.scene.source.samples}
    return _pair(
        ("a part traced, the rest mirrored", Descent(example, heights, mirrored=axes, **beams)),
        ("all traced", Descent(example, heights, **beams)),
        rays_of(example.scene),
    )


def _pixels() -> list[Variant]:
    """The image of a run, as wide as its light falls and as wide as it could ever fall."""
    example = BenchmarkTask.of("flame")
    scene, heights = example.scene, torch.as_tensor(wavy(example.scene)).requires_grad_()

    def descent(light_extent: tuple[float, float]) -> Callable[[], object]:
        image = WideImage(scene, example.target, scene.source.samples, light_extent)

        def once() -> object:
            return torch.autograd.grad(
                image.compare({"exit": heights})[0].square().sum(), [heights]
            )

        return once

    beyond = tuple(4 * r for r in scene.receiver.half_extent)
    rays = rays_of(scene)
    return [
        Variant("left out", descent(light_extent_of(scene, {"exit": heights.detach()})), rays),
        Variant("all around the screen", descent((beyond[0], beyond[1])), rays),
    ]


def _pair(with_skip: tuple[str, Descent], without: tuple[str, Descent], rays: int) -> list[Variant]:
    true, *_ = without[1]()
    image, *_ = with_skip[1]()
    return [
        Variant(*with_skip, rays, image_error(image, true)),
        Variant(*without, rays),
    ]


SKIPS: dict[str, Callable[[], list[Variant]]] = {
    "collimated light: entrance face and intersection": _entrance_and_search,
    "collimated light: basis values and rays": lambda: _constants("flame"),
    "point source: rays up to the exit face": lambda: _constants("flame-point"),
    "box filter: ghost pixels and taps": _taps,
    "pixels that no light reaches": _pixels,
    "symmetric in x: one half": lambda: _mirrored(True, False),
    "symmetric in x and y: three quarters": lambda: _mirrored(True, True),
}
"""What is left out, and the two ways to compare."""
