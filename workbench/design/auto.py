"""The best this program knows: transport of light first, then quasi-Newton on the exact image.

- A first design comes from optimal transport (`workbench.design.transport`): all light on its way
  to the right part of the screen before the first iteration.
- L-BFGS follows, on the image of beams (`workbench.optics.images.beams`): without noise and
  without a filter, so that what it lowers is the true error. Changes of the net are cosine waves,
  the long ones made easy; near a source, long ones may come first (`workbench.design.descent`).
- All steps look at as many beams as the error of their image is worth. Steps by fewer beams cost as
  much (0.098 and 0.103 s for 256 × 256 pixels) and gain less.
- The image reaches beyond the screen and is compared with all light that passes the lens, so
  that light beside the screen counts as an error.
"""

import math
from collections.abc import Callable, Generator, Mapping, Sequence
from contextlib import closing
from functools import partial

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import Array, Mask
from workbench.design.bounds import Bounds, FreeHeights
from workbench.design.descent import Descent, Evaluation, descend, descents_of
from workbench.design.images import AnyImage
from workbench.design.lens_state import Step
from workbench.design.levels import eases_of, finest_image, judging_image
from workbench.design.loss import check_gradient, relative_error
from workbench.design.narrow import begin_within, times_fewer
from workbench.design.smoothness import Smoothness
from workbench.design.snapshot import GAINED, NO_IMAGE, OTHERWISE_WORSE
from workbench.design.waves import FaceWaves
from workbench.errors import RunFailed
from workbench.geometry.as_made import AsMade
from workbench.geometry.faces import NO_FACES, NO_LOCKS
from workbench.geometry.surface import freeform_nets
from workbench.messages import Message
from workbench.optics.plan import device_of, tensors_of
from workbench.progress import Followed, check_given_up, check_interruption
from workbench.scene import Scene

Steps = Generator[Step, None, str]

# After how many steps a lens in the light of few points is looked at in the light of others; again
# after twice as many each time. A run ends where its loss there has grown by the first factor, and
# is by the second one above that of the run. Two faces, one of ± 4 mm, before an LED end at 0.8 %
# after 80 steps so, and ended at 2.5 % after 261.
_FIRST_LOOK, _WORSE, _APART = 40, 1.1, 1.1
# Iterations of the exit face alone, for comparison: they cost a third of those of two faces.
_ITERATIONS = 15
# Error of a first design that is cut off at the ends of its range from which on the descent begins
# on coarser nets: a letter of 11.5 % ends at 2.0 %, and at 2.3 % so; a photograph of 26 % ends at
# 14 and 4.6 %.
_CUT_OFF = 0.18
# At how much less gain a slow descent ends. Two lenses, whose waves are not eased, end at 6.1 %
# after 90 steps, and at 11.0 % after 30 with the gain of one lens; a lens in 0.15 to 0.4 of the
# range that it needs ends 0.97 to 1.12 times as far off as after a long descent, and 1.03 to 1.25
# times with half of the gain.
_SLOWER = 4


def auto_steps(bounds: Bounds) -> Generator[Step, None, str]:
    """Evaluate lens after lens; see `workbench.design.run.run`.

    Returns why it ended of its own accord. Raises `RunFailed` if no light comes near the screen
    even from the first design by transport, or the loss or its gradient is not finite.
    """
    scene, target, locked = bounds.scene, bounds.target, bounds.locked
    device = device_of(scene)
    before = bounds.begin
    mirrored = _mirrored(scene, target, before, locked)
    smoothness = Smoothness.of(scene, target, device)
    heights = tensors_of(before, scene)
    image = finest_image(scene, target, heights, mirrored)
    step = image.step(heights)
    if smoothness is not None:
        step = smoothness.judged(step, smoothness.penalty(heights))
    yield step
    # Without light on the screen there is no gradient.
    goes_on = bounds.start is not None and step.state.account.on_screen > 0
    free = bounds.height_range(device, goes_on)
    far_off = False
    if goes_on or bounds.first is None:
        start = free.nearest(before)
    else:
        first = AsMade.of(scene).for_result(bounds.first)
        first = {face: bounds.limits[face].nearest(each) for face, each in first.items()}
        start = free.nearest(_joined(first, before, locked))
        image = finest_image(scene, target, start, mirrored)
        far_off = _far_off(bounds, image, start)
        if far_off:
            start = free.nearest(begin_within(bounds, _improved))
            image = finest_image(scene, target, start, mirrored)
    descents = descents_of(image)[-1 if goes_on else 0 :]
    most = scene.run.iterations + goes_on
    eases = eases_of(image, scene, target, start)
    # Steps go on to gain a little for long.
    several = len(scene.optics) > 1 and not image.blurred
    if far_off or several:
        descents = tuple(each._replace(gain=each.gain / _SLOWER) for each in descents)
    steps = _descended(image, start, free, mirrored, smoothness, descents, eases, most)
    if smoothness is None and image.blurred and not any(image.blur_widths):
        steps = _looked_at(steps, bounds)
    if goes_on:
        next(steps)  # has been shown
    elif (
        list(bounds.limits) == list(freeform_nets(scene.optic))
        and len(bounds.limits) > 1
        and not locked
    ):
        steps = with_gain(steps, bounds, auto_steps)
    return (yield from steps)


def _looked_at(steps: Steps, bounds: Bounds) -> Steps:
    """Pass on steps in the light of few points, until the lens is worse in the light of others."""
    next_look, least = _FIRST_LOOK, math.inf
    with closing(steps):
        followed = Followed(steps)
        for number, step in enumerate(followed, 1):
            if number < next_look:
                yield step
                continue
            next_look *= 2
            light = auto_judged(bounds.scene, bounds.target, step.state.heights)
            yield step._replace(judged=light)
            loss = step.state.loss if light is None else light.state.loss
            if loss > max(_WORSE * least, _APART * step.state.loss):
                return Message(OTHERWISE_WORSE)
            least = min(loss, least)
        return followed.result


def _far_off(bounds: Bounds, image: AnyImage, start: Mapping[str, Tensor]) -> bool:
    """Whether a first design that is cut off at the ends of its range sends much light astray."""
    if not bounds.too_narrow or times_fewer(bounds.scene.receiver.pixels) == 1:
        return False
    return relative_error(image.step(start).state, bounds.target) > _CUT_OFF


def _descended(
    image: AnyImage,
    start: Mapping[str, Tensor],
    free: FreeHeights,
    mirrored: tuple[bool, bool],
    smoothness: Smoothness | None,
    descents: Sequence[Descent],
    eases: Mapping[str, Array],
    most: int,
) -> Steps:
    """Steps of descents from a lens on."""
    return descend(
        image,
        partial(_evaluated, image, smoothness=smoothness),
        start,
        lambda descent: FaceWaves(
            start, descent.power, mirrored, image.blur_widths, descent.longest, eases
        ),
        descents,
        most,
        free.ends,
    )


def _improved(bounds: Bounds, most: int) -> Mapping[str, Array]:
    """Heights of a lens after ``most`` steps, however little some of them gain."""
    scene, target = bounds.scene, bounds.target
    device = device_of(scene)
    free, mirrored = bounds.height_range(device), _mirrored(scene, target, bounds.begin)
    start = free.nearest(bounds.begin)
    image = finest_image(scene, target, start, mirrored)
    smoothness = Smoothness.of(scene, target, device)
    descent = descents_of(image)[-1]._replace(gain=0.0, points=0.0)
    # Light has a long way to go: where it is at the start says little of where it will be dark.
    *_, last = _descended(image, start, free, mirrored, smoothness, [descent], NO_FACES, most)
    return last.state.heights


def auto_judged(scene: Scene, target: Array, heights: Mapping[str, Array]) -> Step | None:
    """The best lens of a run in the light of beams that it was not fitted to.

    `heights` (n_u, n_v): control heights of each freeform face. Returns the step to report; None
    where the run compared lenses by as many beams.
    """
    lens = tensors_of(heights, scene)
    image = judging_image(scene, target, lens, _mirrored(scene, target, heights))
    return None if image is None else image.step(lens)


def _joined(
    first: Mapping[str, Array], before: Mapping[str, Array], locked: Mapping[str, Mask]
) -> dict[str, Array]:
    """A first design, moved along z until it meets locked control points that stay as before.

    Light hardly minds how far a face is from the screen, but it is lost at a step in the face. A
    face that is locked as a whole is in the first design as it is.
    """
    joined = dict(first)
    for face, mask in locked.items():
        if mask.all():
            continue
        from scipy.ndimage import binary_dilation  # late: it takes a tenth of a second to import

        rim = mask & binary_dilation(~mask)
        joined[face] = first[face] + (before[face] - first[face])[rim].mean()
    return joined


def _evaluated(
    image: AnyImage,
    x: Tensor,
    heights: Mapping[str, Tensor],
    *,
    smoothness: Smoothness | None,
) -> Evaluation[Step]:
    """What a descent minimises over x, from which heights come."""
    error, step = image.compare(heights)
    value = error.square().sum()
    if smoothness is not None:
        penalty = smoothness.penalty(heights)
        value = value + penalty
        step = smoothness.judged(step, penalty)

    def differentiate() -> Tensor:
        check_given_up()  # the gradient takes twice the time of the image
        (gradient,) = torch.autograd.grad(value, [x])
        check_gradient(gradient)
        return gradient

    return Evaluation(value.item(), differentiate, step)


def _mirrored(
    scene: Scene,
    target: Array,
    heights: Mapping[str, Array],
    locked: Mapping[str, Mask] = NO_LOCKS,
) -> tuple[bool, bool]:
    """Whether target, source, receiver, control heights and locks are mirrored in x, in y."""
    nets: list[Array | Mask] = [*heights.values(), *locked.values()]
    images = scene.wanted(target)
    alone = scene.alone
    receivers = (receiver.mirrored for receiver in (*scene.receivers, *alone.receivers))
    sources = scene.entrance[0].mirrored, alone.source.mirrored
    in_x, in_y = (all(each) for each in zip(*sources, *receivers, strict=True))
    targets = [image.target for image in images]
    return (
        in_x and all(_even(t, 1) for t in targets) and all(_even(net, 0) for net in nets),
        in_y and all(_even(t, 0) for t in targets) and all(_even(net, 1) for net in nets),
    )


def _even(values: Array | Mask, axis: int) -> bool:
    values = values.astype(np.float64)
    size = np.abs(values).max()
    return bool(np.abs(values - np.flip(values, axis)).max() <= 1e-9 * size)


def with_gain(both: Steps, bounds: Bounds, steps: Callable[[Bounds], Steps]) -> Steps:
    """Pass on the steps of two faces, and say at the end how the exit face alone would do.

    `both`: steps from the first design of two faces on; `bounds`: theirs; `steps`: makes steps
    within bounds: that of the undesigned lens, then those from the first design on. Returns why
    ``both`` ended, and the errors of both after as many iterations.
    """
    losses: list[float] = []
    followed = Followed(both)
    for step in followed:
        losses.append(step.state.loss)
        yield step
    ended = followed.result
    losses = losses[: 1 + _ITERATIONS]
    alone: list[float] = []
    try:
        with closing(steps(bounds.alone())) as one:
            next(one)  # undesigned
            for step, _ in zip(one, losses, strict=False):
                check_interruption()
                alone.append(step.state.loss)
    except RunFailed:
        return Message(NO_IMAGE, ended=ended)
    if not alone or min(alone) == 0:
        return ended
    return Message(
        GAINED,
        ended=ended,
        iterations=len(losses) - 1,
        times=min(losses) / min(alone),
    )
