"""The best this program knows: transport of light first, then quasi-Newton from blunt to sharp.

- A first lens comes from optimal transport (`workbench.design.transport`): all light on its way to
  the right part of the screen before the first iteration.
- L-BFGS on a fixed, even set of rays follows; changes of the net are cosine waves, the long ones
  made easy.
- It looks through a blunt filter first and through sharper ones later, each with as many rays as
  it needs: a blunt one alone, with a fine net, lowers its own loss and raises the true error.
- The image reaches beyond the screen and is compared with all light that passes the lens, so
  that light beside the screen counts as an error.
- What is its own mirror image is traced in one half or quarter alone.
"""

from collections.abc import Callable, Generator, Sequence
from functools import partial
from itertools import islice

import numpy as np
import numpy.typing as npt
import torch
from scipy.ndimage import binary_dilation
from torch import Tensor

from workbench.design.heights import HeightRange, Mask
from workbench.design.lbfgs import Evaluation, Objective, minimise
from workbench.design.loss import check_gradient
from workbench.design.phases import PHASES, SHARPEST, Phase, image_of, reach_of
from workbench.design.room import Room
from workbench.design.smoothness import Smoothness
from workbench.design.step import Step
from workbench.design.waves import Waves
from workbench.design.wide_image import WideImage
from workbench.optics.plan import device_of
from workbench.scene import Scene

Array = npt.NDArray[np.float64]

# A lens to go on from is taken through all phases if its error is larger than this.
_ROUGH = 0.15
# The most that a step may change a parameter. Far out tanh is flat: a height that one bold step
# brings there does not find back.
_REACH = 0.3
# A phase ends when this many steps together lower the loss by less than this part.
_PATIENCE, _PROGRESS = 30, 0.01
_SLOW = f"converged: less than {100 * _PROGRESS:g} % better in {_PATIENCE} iterations"
_LOWEST = "converged: no step makes the image better"


def auto_steps(room: Room) -> Generator[Step, None, str]:
    """Evaluate lens after lens through all phases; see `workbench.design.run.run`.

    Returns
    -------
    str
        Why it ended of its own accord.

    Raises
    ------
    RunFailed
        If no light comes near the screen even from the first lens by transport, or the loss or its
        gradient is not finite.
    """
    scene, target, locked = room.scene, room.target, room.locked
    device = device_of(scene)
    mirrored = _mirrored(scene, target, room.start, locked)
    seen_by = partial(image_of, scene=scene, target=target, mirrored=mirrored, locked=locked)
    smoothness = Smoothness.of(scene, target, device)
    before = room.begin
    heights = {"exit": torch.tensor(before, device=device)}
    # All lenses are judged by the sharpest image, so that their losses can be compared.
    reach = reach_of(scene, heights)
    judge = seen_by(SHARPEST, reach=reach)
    step = judge.step(heights)
    if smoothness is not None:
        step = smoothness.judged(step, smoothness.penalty(heights))
    yield step
    free = room.height_range(device)
    # Nothing tells a lens to go on from where its light should go if none is on the screen.
    goes_on = room.start is not None and step.state.account.on_screen > 0
    if goes_on or room.first is None:
        parameters = free.parameters(before)
    else:
        parameters = free.parameters(_joined(room.limits.nearest(room.first), before, locked))
        reach = reach_of(scene, free.heights(parameters))
        judge = seen_by(SHARPEST, reach=reach)
    near = goes_on and judge.compare(heights)[0].norm() < _ROUGH
    steps = _descend(
        (SHARPEST,) if near else PHASES,
        lambda phase: judge if phase is SHARPEST else seen_by(phase, reach=reach),
        partial(_objective, judge=judge, free=free, smoothness=smoothness),
        parameters,
        mirrored,
        scene.run.iterations + goes_on,
    )
    if goes_on:
        next(steps)  # has been shown
    return (yield from steps)


def _descend(
    phases: Sequence[Phase],
    image_for: Callable[[Phase], WideImage],
    objective_of: Callable[[WideImage, Tensor, Waves], Objective[Step]],
    parameters: Tensor,
    mirrored: tuple[bool, bool],
    left: int,
) -> Generator[Step, None, str]:
    """Minimise through one phase after the other, for as many steps as are left.

    Returns
    -------
    str
        Why the last one ended of its own accord.
    """
    for phase in phases:
        image = image_for(phase)
        waves = Waves(parameters, phase.cut, mirrored)
        base, length = parameters, _longest_change(waves)
        steps = minimise(objective_of(image, base, waves), waves.nothing, _REACH, length)
        best: list[float] = []
        for x, found in islice(steps, phase.iterations(left)):
            parameters = base + waves.change(x)
            yield found.seen
            left -= 1
            best.append(min([found.value, *best[-1:]]))
            if len(best) > _PATIENCE and best[-1] > (1 - _PROGRESS) * best[-1 - _PATIENCE]:
                ended = _SLOW
                break
        else:
            ended = _LOWEST
    return ended


def _joined(first: Array, before: Array, locked: Mask | None) -> Array:
    """A first lens, moved along z until it meets locked control points that stay as before.

    Light hardly minds how far the face is from the screen, but it is lost at a step in the face.
    """
    if locked is None:
        return first
    rim = locked & binary_dilation(~locked)
    return np.asarray(first + (before - first)[rim].mean())


def _objective(
    image: WideImage,
    base: Tensor,
    waves: Waves,
    *,
    judge: WideImage,
    free: HeightRange,
    smoothness: Smoothness | None,
) -> Objective[Step]:
    """What a phase minimises over amplitudes of waves, with the step that ``judge`` tells."""

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
            step = judge.step(heights)
        if smoothness is not None:
            step = smoothness.judged(step, penalty)
        return Evaluation(value.item(), gradient, step)

    return objective


def _longest_change(waves: Waves) -> Callable[[Tensor], float]:
    return lambda amplitudes: waves.change(amplitudes).abs().max().item()


def _mirrored(
    scene: Scene, target: Array, start: Array | None, locked: Mask | None = None
) -> tuple[bool, bool]:
    """Whether target, source, first lens and locks are their own mirror images in x, in y."""
    nets = [net for net in (start, locked) if net is not None]
    in_x, in_y = scene.source.mirrored
    return in_x and _even(target, 1) and all(_even(net, 0) for net in nets), (
        in_y and _even(target, 0) and all(_even(net, 1) for net in nets)
    )


def _even(values: Array | Mask, axis: int) -> bool:
    values = values.astype(np.float64)
    size = np.abs(values).max()
    return bool(np.abs(values - np.flip(values, axis)).max() <= 1e-9 * size)
