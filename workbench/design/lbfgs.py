"""Limited-memory BFGS as a generator, one accepted step after the other."""

import math
from collections import deque
from collections.abc import Callable, Iterator
from typing import Generic, NamedTuple, TypeVar

import torch
from torch import Tensor

Seen = TypeVar("Seen")


class Evaluation(NamedTuple, Generic[Seen]):
    """Value and gradient at a point, and whatever else the objective saw there."""

    value: float
    gradient: Tensor
    seen: Seen


Objective = Callable[[Tensor], Evaluation[Seen]]

MEMORY = 20
"""Steps whose curvature is remembered."""
_ARMIJO = 1e-4
_MAX_TRIALS = 12


def minimise(
    objective: Objective[Seen],
    x: Tensor,
    max_step: float = math.inf,
    length: Callable[[Tensor], float] = lambda step: step.abs().max().item(),
) -> Iterator[tuple[Tensor, Evaluation[Seen]]]:
    """Descend from ``x`` until no step along the search direction goes further down.

    Parameters
    ----------
    objective : callable
        Takes a point, shape (n,), and returns an `Evaluation` with a value that is not negative.
    x : Tensor, shape (n,)
        Where to begin.
    max_step : float
        The greatest length of a step.
    length : callable
        Length of a step; by default the most by which it changes any coordinate.

    Yields
    ------
    tuple[Tensor, Evaluation]
        The beginning, then each accepted point.

    Notes
    -----
    Two-loop recursion with backtracking (Nocedal & Wright, Numerical Optimization, 2006,
    algorithms 7.4 and 3.1). The very first step is Polyak's, value / |gradient|², the one that
    would reach 0 if the objective fell on at this rate: no length to be set by hand.
    """
    pairs: deque[tuple[Tensor, Tensor]] = deque(maxlen=MEMORY)
    here = objective(x)
    while True:
        yield x, here
        direction = _direction(pairs, here)
        slope = torch.dot(here.gradient, direction).item()
        if not slope < 0:
            return
        step = min(1.0, max_step / length(direction))
        for _ in range(_MAX_TRIALS):
            there = objective(x + step * direction)
            if there.value <= here.value + _ARMIJO * step * slope:
                break
            # Minimum of the parabola through both values and the slope, kept within reason.
            excess = there.value - here.value - step * slope
            step *= min(max(-0.5 * step * slope / excess, 0.1), 0.5)
        else:
            if not pairs:
                return
            pairs.clear()  # the model of the curvature is stale: once more from the gradient
            continue
        moved, turned = step * direction, there.gradient - here.gradient
        if torch.dot(moved, turned) > 1e-10 * moved.norm() * turned.norm():
            pairs.append((moved, turned))
        x, here = x + moved, there


def _direction(pairs: deque[tuple[Tensor, Tensor]], here: Evaluation[Seen]) -> Tensor:
    """Minus the inverse of the Hessian as the pairs know it, times the gradient."""
    if not pairs:
        square = here.gradient.square().sum().clamp_min(1e-300)
        return here.gradient * (-here.value / square)
    q = here.gradient.clone()
    factors = []
    for moved, turned in reversed(pairs):
        factor = torch.dot(moved, q) / torch.dot(moved, turned)
        factors.append(factor)
        q -= factor * turned
    moved, turned = pairs[-1]
    q *= torch.dot(moved, turned) / turned.square().sum()
    for (moved, turned), factor in zip(pairs, reversed(factors), strict=True):
        q += (factor - torch.dot(turned, q) / torch.dot(moved, turned)) * moved
    return -q
