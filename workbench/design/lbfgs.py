"""Limited-memory BFGS as a generator, one accepted step after the other."""

import math
from collections import deque
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Generic, NamedTuple, TypeVar

import torch
from torch import Tensor

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

# Steps whose curvature is remembered: as many as fit into some memory, but not fewer or more. Most
# runs end before they make a difference. The example *LED close by* ends at 4.8 % after 118 steps
# with 20 of them, and at 3.2 % after 199 steps with 150.
_FEWEST, _MOST, _BYTES = 20, 150, 100e6
_ARMIJO = 1e-4
_MAX_TRIALS = 12


class _Pair(NamedTuple):
    """A step, and what it did to the gradient."""

    # (n,), the step, and the difference of both gradients.
    moved: Tensor
    turned: Tensor
    product: float  # their scalar product


def remembered(count: int) -> int:
    """Number of steps whose curvature a descent along so many parameters remembers."""
    return int(min(max(_BYTES / (2 * torch.float64.itemsize * count), _FEWEST), _MOST))


def minimise(
    objective: Objective[Seen],
    x: Tensor,
    max_step: float = math.inf,
    eased: Callable[[Tensor], Tensor] = lambda gradient: gradient,
) -> Iterator[tuple[Tensor, Evaluation[Seen]]]:
    """Descend from ``x`` until no step along the search direction goes further down.

    `objective`: takes a point, shape (n,), and returns an `Evaluation` with a value that is not
    negative; `x` (n,): where to begin; `max_step`: the most by which a step changes any coordinate;
    `eased`: takes a gradient, and gives the direction in which the objective falls most steeply by
    the measure in which steps are equally easy: linear, symmetric and positive. By default the
    gradient itself. Yields the beginning, then each accepted point.

    Notes
    -----
    Two-loop recursion with backtracking (Nocedal & Wright, Numerical Optimization, 2006,
    algorithms 7.4 and 3.1). The very first step is Polyak's, value / |gradient|², the one that
    would reach 0 if the objective fell on at this rate: no length to be set by hand. With ``eased``
    the steps are those of a descent in other coordinates, without going there and back: of
    amplitudes a of a change W a, if it is W Wᵀ.
    """
    pairs: deque[_Pair] = deque(maxlen=remembered(len(x)))
    here = objective(x)
    yield x, here
    while True:
        direction = _direction(pairs, here, eased)
        slope = torch.dot(here.gradient, direction).item()
        if not slope < 0:
            return
        step = min(1.0, max_step / direction.abs().max().item())
        for _ in range(_MAX_TRIALS):
            there = objective(x + step * direction)
            if there.value <= here.value + _ARMIJO * step * slope:
                break
            # Minimum of the parabola through both values and the slope, kept within reason.
            curvature_part = there.value - here.value - step * slope
            step *= min(max(-0.5 * step * slope / curvature_part, 0.1), 0.5)
        else:
            if not pairs:
                return
            pairs.clear()  # the model of the curvature is stale: once more from the gradient
            continue
        moved, gradient = step * direction, here.gradient
        x, here = x + moved, there
        yield x, here  # before its gradient, which the last point does without
        turned = here.gradient - gradient
        product = torch.dot(moved, turned).item()
        if product > 1e-10 * (moved.norm() * turned.norm()).item():
            pairs.append(_Pair(moved, turned, product))


def _direction(
    pairs: deque[_Pair], here: Evaluation[Seen], eased: Callable[[Tensor], Tensor]
) -> Tensor:
    """Minus the inverse of the Hessian as the pairs know it, times the gradient."""
    if not pairs:
        steepest = eased(here.gradient)
        square = torch.dot(here.gradient, steepest).clamp_min(1e-300)
        return steepest * (-here.value / square)
    q = -here.gradient
    factors = []
    for moved, turned, product in reversed(pairs):
        factor = torch.dot(moved, q).item() / product
        factors.append(factor)
        q.sub_(turned, alpha=factor)
    _, turned, product = pairs[-1]
    q = eased(q) * (product / torch.dot(turned, eased(turned)))
    for (moved, turned, product), factor in zip(pairs, reversed(factors), strict=True):
        q.add_(moved, alpha=factor - torch.dot(turned, q).item() / product)
    return q
