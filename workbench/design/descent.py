"""Descents along waves of a net, one after the other, and when each has gained what it can."""

import math
from collections.abc import Callable, Generator, Mapping, Sequence
from itertools import islice
from typing import NamedTuple

import torch
from torch import Tensor

from workbench.design.endings import FLAT, LOWEST, SLOW, SMALL
from workbench.design.lbfgs import Evaluation, minimise
from workbench.design.several_images import AnyImage
from workbench.design.step import Step
from workbench.design.waves import FaceWaves
from workbench.optics.account import UnbalancedAccount
from workbench.said import Said

# The most that a step may change a parameter. Far out tanh is flat: a height that one bold step
# brings there does not find back.
_MAX_STEP = 0.3
# A run ends when steps together gain little: five steps with so many beams, or more where each
# costs less.
_STEPS, _BEAMS, _MOST_STEPS = 5, 768**2, 8


class Descent(NamedTuple):
    """How a run descends, by what the size of the source does to the image."""

    # Waves of the net are made small in proportion to this power of their periods; see `Waves`.
    power: float
    # It ends when steps together lower the error by less than this part of it, or by less than
    # these points.
    gain: float
    points: float
    longest: float = 1.0  # part of the waves along each axis, the longest ones, that change
    # It is left to the next one where the error is less than this from the beginning.
    above: float = 0.0


# Where nothing blurs the light, 0.50 % of a photograph's error is left after 24 steps where it was
# 0.52 % after 19. Nobody sees that.
_SHARP = (Descent(1.25, 0.05, 3e-4),)
# What a blur hides is found by smaller steps, and where it is even, a step takes a single trace. In
# the sun a letter is 5.58 % off after 20 steps and 5.53 % after 30, a photograph 1.88 and 1.81 %.
_EVEN = (Descent(1.25, 0.0025, 1.5e-4),)
# With an LED close by, the example *Phone torch* is 10.6 % off after 36 steps where it was 11.0 %
# after 22, and *LED to a rectangle* 5.8 % where it was 6.8 %. A first lens, made for light from one
# place, may be far from what such light needs. Long waves come first there, until they gain little:
# two faces before the LED then take half of the steps.
#
# | example | first lens | all waves | a quarter of them first |
# |---|---|---|---|
# | LED to a rectangle | 47.3 % | 6.2 %, 138 steps | 6.2 %, 160 steps |
# | the same, entrance face of -4 to 4 mm | 46.7 % | 4.8 %, 302 steps | 4.7 %, 151 steps |
# | the same, range automatic | 39.8 % | 2.6 %, 251 steps | 2.7 %, 129 steps |
# | LED close by | 21.7 % | 2.6 %, 158 steps | 2.8 %, 199 steps |
# | Phone torch | 18.6 % | 10.3 %, 43 steps | 10.3 %, 46 steps |
_UNEVEN = (Descent(1.0, 0.03, 0.0, longest=0.25, above=0.15), Descent(1.0, 0.01, 0.0))
# The image cannot tell smaller errors from its own.
_SMALLEST = 1e-3


def descents_of(image: AnyImage) -> tuple[Descent, ...]:
    """How a run descends, one after the other."""
    if not image.blurred:
        return _SHARP
    return _EVEN if any(image.blur_widths) else _UNEVEN


def descend(
    image: AnyImage,
    evaluated: Callable[[Tensor, Mapping[str, Tensor]], Evaluation[Step]],
    parameters: Mapping[str, Tensor],
    waves_of: Callable[[Descent], FaceWaves],
    descents: Sequence[Descent],
    left: int,
) -> Generator[Step, None, str]:
    """Minimise by one descent after the other, for as many steps as are left.

    `image`: by which lenses are compared; `evaluated`: evaluates all parameters, shape (points,),
    which it also gets as the net of each face; `parameters` (n_u, n_v): where to begin; `waves_of`:
    makes the waves of a descent; `descents`: at least one; `left`: the most steps. Yields that of
    the beginning, then those of all descents. Returns why the last descent ended of its own accord.
    Raises `UnbalancedAccount` if the light of the beginning does not add up. Of a later trial this
    makes its step shorter.
    """
    patience = min(max(_STEPS, round(_STEPS * _BEAMS / image.effort)), _MOST_STEPS)
    every = [waves_of(descent) for descent in descents]
    waves = every[-1]
    x = waves.values(parameters)

    begun = False

    def objective(x: Tensor) -> Evaluation[Step | None]:
        nonlocal begun
        x = x.detach().requires_grad_()
        try:
            found = evaluated(x, waves.nets(x))
        except UnbalancedAccount:  # the samples are too few for this trial: a shorter step is next
            if not begun:
                raise
            return Evaluation(math.inf, lambda: torch.zeros_like(x), None)
        begun = True
        return found

    for number, descent in enumerate(descents):
        found = minimise(objective, x, _MAX_STEP, every[number].eased)
        if number:
            next(found)  # has been shown
        errors: list[float] = []
        ended: str | None = None
        for here, there in islice(found, left):
            x, left = here, left - 1
            assert there.seen is not None  # no step ends where the account does not add up
            yield there.seen
            errors.append(math.sqrt(there.value))
            if errors[-1] < _SMALLEST:
                return Said(SMALL, error=100 * _SMALLEST)
            ended = _slow(errors, patience, descent)
            if ended or errors[0] < descent.above:
                break
    return ended or Said(LOWEST)


def _slow(errors: Sequence[float], patience: int, descent: Descent) -> Said | None:
    """That so many steps together gain little, if they do."""
    if len(errors) <= patience:
        return None
    lower = errors[-1 - patience] - errors[-1]
    if lower < descent.gain * errors[-1 - patience]:
        return Said(SLOW, gain=100 * descent.gain, patience=patience)
    if lower < descent.points:
        return Said(FLAT, points=100 * descent.points, patience=patience)
    return None
