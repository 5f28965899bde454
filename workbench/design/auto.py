"""The best this program knows: transport of light first, then quasi-Newton from blunt to sharp.

- A first lens comes from optimal transport (`workbench.design.transport`): all light on its way to
  the right part of the screen before the first iteration.
- L-BFGS on a fixed, even set of rays follows; changes of the net are cosine waves, the long ones
  made easy.
- It looks through a blunt filter first and through sharper ones later, each with as many rays as
  it needs: a blunt one alone, with a fine net, lowers its own loss and raises the true error.
- The image reaches beyond the screen and is compared with all light that passes the lens, so
  that light beside the screen counts as an error and is called back.
- What is its own mirror image is traced in one half or quarter alone.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import islice

import numpy as np
import numpy.typing as npt
import torch
from scipy.ndimage import binary_dilation
from torch import Tensor

from workbench.design.heights import HeightRange, Mask
from workbench.design.lbfgs import Evaluation, Objective, minimise
from workbench.design.loss import check_gradient
from workbench.design.smoothness import Smoothness
from workbench.design.step import Step
from workbench.design.transport import transport_start
from workbench.design.waves import Waves
from workbench.design.wide_image import WideImage
from workbench.geometry.surface import ControlNet
from workbench.optics.plan import Plan, device_of
from workbench.scene import (
    CollimatedSource,
    GaussianFilter,
    GridSource,
    PointSource,
    Scene,
    Source,
)

Array = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Phase:
    """A part of the run; every stage of a scene goes through all of them.

    Attributes
    ----------
    alpha : float
        Sharpness of the filter over 3 × 3 pixels.
    rays : int
        Rays along an axis for each pixel along it.
    cut : float
        See `Waves`.
    most : int
        Iterations at most; the last phase takes all that are left.
    """

    alpha: float
    rays: int
    cut: float
    most: int


PHASES = (
    Phase(alpha=1.0, rays=3, cut=1.0, most=30),
    Phase(alpha=4.0, rays=4, cut=2.0, most=40),
    Phase(alpha=12.0, rays=6, cut=4.0, most=1_000_000),
)

# Rays along an axis for each control point along it, at least.
_RAYS_PER_CONTROL_POINT = 4
_MOST_RAYS = 4096
# What symmetry saves goes in part into rays, by this factor along each axis for each mirror: the
# smaller the error, the more of it is that of too few rays.
_MIRRORED_RAYS = 1.3
# Rays that tell how far the light of a lens reaches.
_FEW_RAYS = (256, 256)
# A lens to go on from is taken through all phases if its error is larger than this.
_ROUGH = 0.15
# The most that a step may change a parameter. Far out tanh is flat: a height that one bold step
# brings there does not find back.
_REACH = 0.3
# A phase ends when this many steps together lower the loss by less than this part.
_PATIENCE, _PROGRESS = 30, 0.01


def auto_steps(
    scene: Scene, target: Array, start: Array | None, locked: Mask | None = None
) -> Iterator[Step]:
    """Evaluate lens after lens through all phases; see `workbench.design.run.run`.

    Raises
    ------
    RunFailed
        If the loss or its gradient is not finite.
    """
    free = HeightRange.of(scene.lens, ControlNet.of(scene.lens), device_of(scene))
    free = free.keeping(locked, start)
    parameters = free.rest if start is None else free.parameters(start)
    mirrored = _mirrored(scene, target, start, locked)
    smoothness = Smoothness.of(scene, target, device_of(scene))
    phases: Sequence[Phase] = PHASES
    if start is None:
        undesigned = free.heights(parameters)
        image = _image(scene, target, PHASES[-1], mirrored, _reach(scene, undesigned), locked)
        step = image.compare(undesigned)[1]
        if smoothness is not None:
            step = smoothness.judged(step, smoothness.penalty(undesigned))
        yield step
        first = transport_start(scene, target)
        if first is not None:
            parameters = free.parameters(_joined(first, undesigned.cpu().numpy(), locked))
    heights = free.heights(parameters)
    # All lenses are judged by the sharpest image, so that their losses can be compared.
    reach = _reach(scene, heights)
    judge = _image(scene, target, PHASES[-1], mirrored, reach, locked)
    if start is not None and judge.compare(heights)[0].norm() < _ROUGH:
        phases = PHASES[-1:]
    # The very first lens is none of the iterations.
    left = scene.run.iterations + (start is not None)
    for phase in phases:
        last = phase is phases[-1]
        image = judge if last else _image(scene, target, phase, mirrored, reach, locked)
        waves = Waves(parameters, phase.cut, mirrored)
        base, length = parameters, _longest_change(waves)
        objective = _objective(image, judge, free, base, waves, smoothness)
        most = left if last else min(phase.most, math.ceil(left / 3))
        best: list[float] = []
        for x, found in islice(minimise(objective, waves.nothing, _REACH, length), most):
            parameters = base + waves.change(x)
            yield found.seen
            left -= 1
            best.append(min([found.value, *best[-1:]]))
            if len(best) > _PATIENCE and best[-1] > (1 - _PROGRESS) * best[-1 - _PATIENCE]:
                break


def _joined(first: Array, before: Array, locked: Mask | None) -> Array:
    """A first lens, moved along z until it meets locked control points that stay as before.

    Light hardly minds how far the face is from the screen, but it is lost at a step in the face.
    """
    if locked is None:
        return first
    rim = locked & binary_dilation(~locked)
    return np.asarray(first + (before - first)[rim].mean())


def judging_image(scene: Scene, target: Array, heights: Tensor) -> WideImage:
    """The image by which runs compare lenses, for those near one lens, symmetric or not."""
    return _image(scene, target, PHASES[-1], (False, False), _reach(scene, heights))


def _objective(
    image: WideImage,
    judge: WideImage,
    free: HeightRange,
    base: Tensor,
    waves: Waves,
    smoothness: Smoothness | None,
) -> Objective[Step]:
    def objective(x: Tensor) -> Evaluation[Step]:
        x = x.detach().requires_grad_()
        heights = free.heights(base + waves.change(x))
        error, step = image.compare(heights)
        value = error.square().sum()
        if smoothness is not None:
            penalty = smoothness.penalty(heights)
            value = value + penalty
        (gradient,) = torch.autograd.grad(value, [x])
        check_gradient(gradient)
        if image is not judge:
            with torch.no_grad():
                step = judge.compare(heights)[1]
        if smoothness is not None:
            step = smoothness.judged(step, penalty)
        return Evaluation(value.item(), gradient, step)

    return objective


def _longest_change(waves: Waves) -> Callable[[Tensor], float]:
    return lambda amplitudes: waves.change(amplitudes).abs().max().item()


def _image(
    scene: Scene,
    target: Array,
    phase: Phase,
    mirrored: tuple[bool, bool],
    reach: tuple[float, float],
    locked: Mask | None = None,
) -> WideImage:
    """The image as a phase sees it, wide enough for light that falls as far as ``reach``."""
    wanted = _samples(scene.source)
    rays = phase.rays * _MIRRORED_RAYS ** sum(mirrored)
    per_axis = [
        max(
            math.ceil(rays * pixels),
            _RAYS_PER_CONTROL_POINT * count,
            least if phase is PHASES[-1] else 0,
        )
        for pixels, count, least in zip(
            scene.screen.pixels, scene.lens.control_points, wanted, strict=True
        )
    ]
    # An even number can be halved by symmetry.
    m_x, m_y = (min(2 * math.ceil(count / 2), _MOST_RAYS) for count in per_axis)
    filter = GaussianFilter(alpha=phase.alpha)
    return WideImage(scene, target, filter, (m_x, m_y), mirrored, reach, locked)


def _reach(scene: Scene, heights: Tensor) -> tuple[float, float]:
    """How far from the axis the light of a lens falls."""
    return Plan(scene, samples=_FEW_RAYS).reach(heights)


def _samples(source: Source) -> tuple[int, int]:
    """Rays along each axis that a source asks for."""
    if isinstance(source, CollimatedSource):
        return source.rays
    count = source.rays * (math.prod(source.points) if isinstance(source, GridSource) else 1)
    return math.isqrt(count), math.isqrt(count)


def _mirrored(
    scene: Scene, target: Array, start: Array | None, locked: Mask | None = None
) -> tuple[bool, bool]:
    """Whether target, source, first lens and locks are their own mirror images in x, in y."""
    source = scene.source
    x, y = 0.0, 0.0
    if isinstance(source, PointSource):
        x, y, _ = source.position
    elif isinstance(source, GridSource):
        x, y, _ = source.center
    nets = [net for net in (start, locked) if net is not None]
    return x == 0 and _even(target, 1) and all(_even(net, 0) for net in nets), (
        y == 0 and _even(target, 0) and all(_even(net, 1) for net in nets)
    )


def _even(values: Array | Mask, axis: int) -> bool:
    values = values.astype(np.float64)
    size = np.abs(values).max()
    return bool(np.abs(values - np.flip(values, axis)).max() <= 1e-9 * size)
