"""Descents along waves of a net by limited-memory BFGS, and when each ends."""

import math
from collections import deque
from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import islice
from typing import Generic, NamedTuple, TypeVar

import torch
from torch import Tensor

from workbench.design.images import AnyImage
from workbench.design.lens_state import Step
from workbench.design.snapshot import FLAT, LOWEST, SLOW, SMALL
from workbench.design.waves import FaceWaves, float_type
from workbench.messages import Message
from workbench.optics.account import UnbalancedAccount

# Steps whose curvature L-BFGS remembers: as many as fit into this memory, but not fewer or more.
# *LED close by* ends at 4.8 % after 118 steps with 20 of them, at 3.2 % after 199 steps with 150.
_FEWEST, _MOST, _BYTES = 20, 150, 100e6
_ARMIJO = 1e-4
_MAX_TRIALS = 12
# Steps are longer by this factor than the model of the curvature has them. After 15 steps of
# lengths 1, 1.25, 1.5 and 1.75 a photograph is 0.96, 0.94, 0.91 and 0.92 % off, a darker one 1.63,
# 1.55, 1.48 and 1.47 %.
_LONGER = 1.5
# A step whose curvature is a smaller part of the largest that it could be says nothing of it.
_LEAST_CURVATURE = 1e-10
# Steps that together have to gain something: five with so many beams, more where each costs less.
_STEPS, _BEAMS, _MOST_STEPS = 5, 768**2, 8
# Smaller errors are below the error of the image itself.
_SMALLEST = 1e-3


class Descent(NamedTuple):
    """How a run descends, by what the size of the source does to the image."""

    # Waves of the net are made small in proportion to this power of their periods; see `Waves`.
    power: float
    # It ends when steps together lower the error by less than this part of it, or by less than
    # these points.
    gain: float
    points: float
    longest: float = 1.0  # part of the waves along each axis, the longest ones, that change
    # The next descent takes over where the error is less than this from the beginning.
    above: float = 0.0


# Without a blur. Powers of 1.25, 1.5 and 2 leave 0.87, 0.87 and 0.88 % of a photograph after 24
# steps, and 3.17, 3.18 and 3.28 % of words. With a gain of 0.08 and 0.06 in place of 0.07 a
# portrait ends at 1.53 and 1.41 % after 25 and 32 steps.
_SHARP = (Descent(1.5, 0.07, 7e-4),)
# With an even blur, each step is one trace: 10 more steps lower a photograph in the sun from 1.88
# to 1.81 %. Short waves, which the blur damps, all of one size: 1.82 %, and 2.05 % by power alone.
_EVEN = (Descent(1.25, 0.0025, 1.5e-4),)
# Of light that the source blurs and that is drawn as rays. It gathers slowly in spots and lines
# narrower than the blur: a photograph in the sun is 1.067 times as far off as its lower bound after
# 30 steps, 1.063 times after 48, which is no longer worth their time.
_RAYS = (Descent(1.25, 0.003, 1e-4),)
# With a blur that differs over the lens, long waves come first: two faces before *LED to a
# rectangle* are 2.7 % off after 129 steps, and after 251 steps of all waves.
_UNEVEN = (Descent(1.0, 0.03, 0.0, longest=0.25, above=0.15), Descent(1.0, 0.01, 0.0))


Seen = TypeVar("Seen", covariant=True)


@dataclass(frozen=True)
class Evaluation(Generic[Seen]):
    """Value and gradient at a point."""

    value: float  # value of the objective
    # Return the gradient; called once, and not at all where no step begins.
    differentiate: Callable[[], Tensor]
    seen: Seen  # whatever else the objective saw

    @cached_property
    def gradient(self) -> Tensor:
        """Gradient of the objective, shape (n,)."""
        return self.differentiate()


Objective = Callable[[Tensor], Evaluation[Seen]]


class _Pair(NamedTuple):
    """A step, and what it did to the gradient."""

    # (n,), the step, and the difference of both gradients.
    moved: Tensor
    turned: Tensor
    product: float  # their scalar product


def remembered(count: int) -> int:
    """Number of steps whose curvature a descent along so many parameters remembers."""
    return int(min(max(_BYTES / (2 * float_type(count).itemsize * count), _FEWEST), _MOST))


def minimise(
    objective: Objective[Seen],
    x: Tensor,
    waves: FaceWaves,
    ends: tuple[Tensor, Tensor] | None = None,
) -> Iterator[tuple[Tensor, Evaluation[Seen]]]:
    """Descend from ``x`` until no step along the search direction goes further down.

    `objective`: takes a point, shape (n,), and returns an `Evaluation` with a value that is not
    negative; `x` (n,): where to begin; `waves`: by whose amplitudes a step is measured; `ends`
    (n,): least and largest value of each number; by default there are none. Yields the beginning,
    then each accepted point.

    Notes
    -----
    Two-loop recursion with backtracking (Nocedal & Wright, Numerical Optimization, 2006,
    algorithms 7.4 and 3.1). The very first step is Polyak's, value / |gradient|², the one that
    would reach 0 if the objective fell on at this rate: no length to be set by hand. With W Wᵀ as
    the first inverse of the Hessian the steps are those of a descent in amplitudes a of waves W a,
    without going there and back. Numbers at an end to which the objective falls are held there for
    a step; the others are followed along the path that is projected into the ends (Bertsekas,
    Projected Newton methods, 1982).
    """
    low, high = ends or (torch.full_like(x, -math.inf), torch.full_like(x, math.inf))
    pairs: deque[_Pair] = deque(maxlen=remembered(len(x)))
    kind = float_type(len(x))
    x = x.clamp(low, high)
    here = objective(x)
    yield x, here
    while True:
        free = _free(x, here.gradient, low, high)
        gradient = here.gradient.to(kind)
        direction = _direction(pairs, here.value, gradient, waves, free).to(x)
        if not torch.dot(here.gradient, direction).item() < 0:
            return
        step = _LONGER
        for _ in range(_MAX_TRIALS):
            reached = (x + step * direction).clamp(low, high)
            moved = reached - x
            there = objective(reached)
            # Not above 0, also where the ends have turned the way.
            slope = min(torch.dot(here.gradient, moved).item(), 0.0)
            if there.value <= here.value + _ARMIJO * slope:
                break
            # Minimum of the parabola through both values and the slope, kept within reason.
            curvature_part = there.value - here.value - slope
            step *= min(max(-0.5 * slope / curvature_part, 0.1), 0.5)
        else:
            if not pairs:
                return
            pairs.clear()  # the model of the curvature is stale: once more from the gradient
            continue
        former = here.gradient
        x, here = reached, there
        yield x, here  # before its gradient, which the last point does without
        moved, turned = moved.to(kind), (here.gradient - former).to(kind)
        product = torch.dot(moved, turned).item()
        if product > _LEAST_CURVATURE * (moved.norm() * turned.norm()).item():
            pairs.append(_Pair(moved, turned, product))


def _free(x: Tensor, gradient: Tensor, low: Tensor, high: Tensor) -> Tensor | None:
    """1 where a coordinate may change, 0 where it is held at an end; None where all may."""
    held = ((x <= low) & (gradient >= 0)) | ((x >= high) & (gradient <= 0))
    return (~held).to(float_type(len(x))) if held.any() else None


def _direction(
    pairs: Sequence[_Pair],
    value: float,
    gradient: Tensor,
    waves: FaceWaves,
    free: Tensor | None,
) -> Tensor:
    """Minus the inverse of the Hessian as the pairs know it, times the gradient.

    Both of the ``free`` numbers alone. `value`: of the objective.
    """

    def amplitudes(gradient: Tensor) -> Tensor:
        return waves.amplitudes(gradient if free is None else free * gradient)

    def change(amplitudes: Tensor) -> Tensor:
        changed = waves.change(amplitudes).to(gradient)
        return changed if free is None else free * changed

    if free is not None:
        pairs, gradient = list(_among(pairs, free)), free * gradient
    if not pairs:
        steepest = amplitudes(gradient)
        square = steepest.square().sum().clamp_min(1e-300)
        return change(steepest) * (-value / square)
    q = -gradient
    factors = []
    for moved, turned, product in reversed(pairs):
        factor = torch.dot(moved, q).item() / product
        factors.append(factor)
        q.sub_(turned, alpha=factor)
    _, turned, product = pairs[-1]
    q = change(amplitudes(q)).mul_(product / amplitudes(turned).square().sum().item())
    for (moved, turned, product), factor in zip(pairs, reversed(factors), strict=True):
        q.add_(moved, alpha=factor - torch.dot(turned, q).item() / product)
    return q


def _among(pairs: Sequence[_Pair], free: Tensor) -> Iterator[_Pair]:
    """Steps of the free coordinates alone, as far as they show a curvature."""
    for pair in pairs:
        moved = pair.moved * free
        product = torch.dot(moved, pair.turned).item()
        if product > _LEAST_CURVATURE * pair.product:
            yield _Pair(moved, pair.turned, product)


def descents_of(image: AnyImage) -> tuple[Descent, ...]:
    """How a run descends, one after the other."""
    if not image.blurred:
        return _SHARP
    if image.rays:
        return _RAYS
    return _EVEN if any(image.blur_widths) else _UNEVEN


def descend(
    image: AnyImage,
    evaluated: Callable[[Tensor, Mapping[str, Tensor]], Evaluation[Step]],
    heights: Mapping[str, Tensor],
    waves_of: Callable[[Descent], FaceWaves],
    descents: Sequence[Descent],
    left: int,
    ends: tuple[Mapping[str, Tensor], Mapping[str, Tensor]] | None = None,
) -> Generator[Step, None, str]:
    """Minimise by one descent after the other, for as many steps as are left.

    `image`: by which lenses are compared; `evaluated`: evaluates all heights, shape (points,),
    which it also gets as the net of each face; `heights` (n_u, n_v): where to begin; `waves_of`:
    makes the waves of a descent; `descents`: at least one; `left`: the most steps; `ends`
    (n_u, n_v): least and largest heights. Yields that of the beginning, then those of all descents.
    Returns why the last descent ended of its own accord. Raises `UnbalancedAccount` if the light of
    the beginning does not add up. Of a later trial this makes its step shorter.
    """
    patience = min(max(_STEPS, round(_STEPS * _BEAMS / image.effort)), _MOST_STEPS)
    every = [waves_of(descent) for descent in descents]
    waves = every[-1]
    x = waves.even(waves.values(heights))
    within = None if ends is None else (waves.values(ends[0]), waves.values(ends[1]))

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
        return replace(found, differentiate=lambda: waves.even(found.differentiate()))

    for number, descent in enumerate(descents):
        found = minimise(objective, x, every[number], within)
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
                return Message(SMALL, error=100 * _SMALLEST)
            ended = _slow(errors, patience, descent)
            if ended or errors[0] < descent.above:
                break
    return ended or Message(LOWEST)


def _slow(errors: Sequence[float], patience: int, descent: Descent) -> Message | None:
    """That so many steps together gain little, if they do."""
    if len(errors) <= patience:
        return None
    lower = errors[-1 - patience] - errors[-1]
    if lower < descent.gain * errors[-1 - patience]:
        return Message(SLOW, gain=100 * descent.gain, patience=patience)
    if lower < descent.points:
        return Message(FLAT, points=100 * descent.points, patience=patience)
    return None
