"""The best this program knows: transport of light first, then quasi-Newton on the exact image.

- A first lens comes from optimal transport (`workbench.design.transport`): all light on its way to
  the right part of the screen before the first iteration.
- L-BFGS follows, on the image of beams of light (`workbench.optics.beams`): without noise and
  without a filter, so that what it lowers is the true error. Changes of the net are cosine waves,
  the long ones made easy.
- It looks at few beams first, and at more of them as soon as these no longer tell the truth: a
  lens also learns what is wrong with its own image.
- The image reaches beyond the screen and is compared with all light that passes the lens, so
  that light beside the screen counts as an error.
"""

from collections.abc import Callable, Generator, Mapping, Sequence
from functools import partial
from typing import NamedTuple

import numpy as np
import numpy.typing as npt
import torch
from torch import Tensor

from workbench.design.heights import Freedom, Mask
from workbench.design.lbfgs import Evaluation, minimise
from workbench.design.levels import FINE, Level, images_of, levels_of
from workbench.design.loss import check_gradient
from workbench.design.room import Room
from workbench.design.second_face import with_gain
from workbench.design.several_images import AnyImage
from workbench.design.smoothness import Smoothness
from workbench.design.step import Step
from workbench.design.waves import FaceWaves
from workbench.geometry.faces import NO_LOCKS
from workbench.optics.plan import device_of
from workbench.scene import Scene

Array = npt.NDArray[np.float64]

# The most that a step may change a parameter. Far out tanh is flat: a height that one bold step
# brings there does not find back.
_MAX_STEP = 0.3
# Waves with more periods per lens than this are made small in proportion.
_CUT = 4.0
# A level ends when steps together make the image better by less than this part: five steps with so
# many beams, or more where each costs less.
_GAIN, _STEPS, _BEAMS, _MOST_STEPS = 0.05, 5, 768**2, 8
# The same of blurred light: what a blur hides is found by smaller steps. With the sun the first
# five make a letter's error 6 % less, the next fifteen another 3 %. With an LED close by, the
# example *Phone torch* is 10.6 % off after 36 steps where it was 11.0 % after 22, and *LED to a
# rectangle* 5.8 % where it was 6.8 %.
_BLURRED_GAIN = 0.01
# A coarse level ends as soon as its error differs from the true one by more than this part of it.
_TRUSTED = 0.15
# The finest image cannot tell smaller errors from its own.
_SMALLEST = 1e-3
_SMALL = f"converged: error below {100 * _SMALLEST:g} %"
_LOWEST = "converged: no step makes the image better"


class _Judged(NamedTuple):
    """A lens, its error in the image of its level, and its error in the finest image."""

    step: Step
    own: float
    error: float


def auto_steps(room: Room) -> Generator[Step, None, str]:
    """Evaluate lens after lens, at one level after the other; see `workbench.design.run.run`.

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
    smoothness = Smoothness.of(scene, target, device)
    before = room.begin
    heights = {face: torch.tensor(each, device=device) for face, each in before.items()}
    # All lenses are judged by the finest image, so that their losses can be compared.
    image_for = images_of(scene, target, heights, mirrored)
    judge = image_for(FINE)
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
        first = {face: room.limits[face].nearest(each) for face, each in room.first.items()}
        parameters = free.parameters(_joined(first, before, locked))
        image_for = images_of(scene, target, free.heights(parameters), mirrored)
        judge = image_for(FINE)
    steps = _descend(
        image_for,
        partial(_evaluated, judge=judge, free=free, smoothness=smoothness),
        parameters,
        FaceWaves(parameters, _CUT, mirrored, free.widths),
        levels_of(scene),
        scene.run.iterations + goes_on,
    )
    if goes_on:
        next(steps)  # has been shown
    elif len(room.limits) > 1 and not locked:
        steps = with_gain(steps, scene, target, auto_steps)
    return (yield from steps)


def _descend(
    image_for: Callable[[Level], AnyImage],
    evaluated: Callable[[AnyImage, Tensor, Mapping[str, Tensor]], Evaluation[_Judged]],
    parameters: Mapping[str, Tensor],
    waves: FaceWaves,
    path: Sequence[Level],
    left: int,
) -> Generator[Step, None, str]:
    """Minimise at one level after the other, for as many steps as are left.

    Returns
    -------
    str
        Why it ended of its own accord.
    """
    levels = iter(path)
    level = next(levels)
    image = image_for(level)

    def objective(x: Tensor) -> Evaluation[_Judged]:
        x = x.detach().requires_grad_()
        moved = {face: parameters[face] + each for face, each in waves.change(x).items()}
        return evaluated(image, x, moved)

    steps = minimise(objective, waves.nothing, _MAX_STEP, waves.longest)
    errors: list[float] = []  # squares of the lowest ones of this level
    for _ in range(left):
        try:
            _, found = next(steps)
        except StopIteration:
            return _LOWEST
        judged = found.seen
        yield judged.step
        errors.append(min([found.value, *errors[-1:]]))
        patience = min(max(_STEPS, round(_STEPS * _BEAMS / image.beams)), _MOST_STEPS)
        gain = _BLURRED_GAIN if image.blurred else _GAIN
        slow = len(errors) > patience and errors[-1] > (1 - gain) ** 2 * errors[-1 - patience]
        if judged.error < _SMALLEST:
            return _SMALL
        if level is FINE and slow:
            return f"converged: less than {100 * gain:g} % better in {patience} iterations"
        if slow or abs(judged.own - judged.error) > _TRUSTED * judged.error:
            level, errors = next(levels, FINE), []
            image = image_for(level)
            steps.send(True)  # what is known of the curvature stays good
    return _LOWEST


def _joined(
    first: Mapping[str, Array], before: Mapping[str, Array], locked: Mapping[str, Mask]
) -> dict[str, Array]:
    """A first lens, moved along z until it meets locked control points that stay as before.

    Light hardly minds how far a face is from the screen, but it is lost at a step in the face.
    """
    from scipy.ndimage import binary_dilation  # late: it takes long to import

    joined = dict(first)
    for face, mask in locked.items():
        rim = mask & binary_dilation(~mask)
        joined[face] = first[face] + (before[face] - first[face])[rim].mean()
    return joined


def _evaluated(
    image: AnyImage,
    x: Tensor,
    parameters: Mapping[str, Tensor],
    *,
    judge: AnyImage,
    free: Freedom,
    smoothness: Smoothness | None,
) -> Evaluation[_Judged]:
    """What a level minimises over x, from which parameters come, and what ``judge`` says of it."""
    heights = free.heights(parameters)
    error, step = image.compare(heights)
    value = error.square().sum()
    if smoothness is not None:
        penalty = smoothness.penalty(heights)
        value = value + penalty
    (gradient,) = torch.autograd.grad(value, [x])
    check_gradient(gradient)
    own = fine = error.detach().norm().item()
    if image is not judge:
        with torch.no_grad():
            error, step = judge.compare(heights)
        fine = error.norm().item()
    if smoothness is not None:
        step = smoothness.judged(step, penalty)
    return Evaluation(value.item(), gradient, _Judged(step, own, fine))


def _mirrored(
    scene: Scene,
    target: Array,
    start: Mapping[str, Array] | None,
    locked: Mapping[str, Mask] = NO_LOCKS,
) -> tuple[bool, bool]:
    """Whether target, source, receiver, first lens and locks are mirrored in x, in y."""
    nets: list[Array | Mask] = [*(start or {}).values(), *locked.values()]
    images = scene.images(target)
    receivers = (image.scene.receiver.mirrored for image in images)
    in_x, in_y = (all(each) for each in zip(scene.source.mirrored, *receivers, strict=True))
    targets = [image.target for image in images]
    return (
        in_x and all(_even(t, 1) for t in targets) and all(_even(net, 0) for net in nets),
        in_y and all(_even(t, 0) for t in targets) and all(_even(net, 1) for net in nets),
    )


def _even(values: Array | Mask, axis: int) -> bool:
    values = values.astype(np.float64)
    size = np.abs(values).max()
    return bool(np.abs(values - np.flip(values, axis)).max() <= 1e-9 * size)
