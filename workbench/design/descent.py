"""Descents along waves of a net by limited-memory BFGS, and when each ends.

Irradiance depends on the second derivatives of the face, so short waves of the same height change
it far more than long ones. A descent that treats all heights alike spends its steps on the short
ones; so a wave is made small in proportion to a power of its periods per lens.

Where the image is dark, light of a small part of the lens fills much of it. A wave of the face
changes its irradiance I in proportion to I^1.5, and a pixel there takes 1 / I of the face: without
a blur, the square of the error grows with the square of I. So waves are made larger where light
goes to dark places. A photograph of 960 x 960 control points is 0.97 % off after 13 steps without
this and 0.81 % with it, words of 480 x 480 end at 4.4 and 3.2 %.
"""

import math
from collections import deque
from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import islice
from typing import Generic, NamedTuple, Protocol, TypeVar

import numpy as np
import torch
from scipy.fft import dctn, idctn
from torch import Tensor

from workbench.arrays import AnyArray, Array
from workbench.design.images import AnyImage
from workbench.design.lens_state import Step
from workbench.design.snapshot import FLAT, LOWEST, SLOW, SMALL
from workbench.geometry.faces import NO_FACES
from workbench.messages import Message
from workbench.optics.account import UnbalancedAccount
from workbench.optics.kernels import threads

# A blur damps waves of which it is wider than this part of a period: a disc leaves 2 J₁(πf) / (πf)
# of a wave, which falls as 2 √(2/π) (πf)^-1.5 from here on.
_DAMPED = 0.435
# Waves of a net of more control points are computed in float32, in half of the time.
_MANY = 256**2
# Steps whose curvature L-BFGS remembers: as many as fit into this memory, but not fewer or more.
# *LED close by* ends at 4.8 % after 118 steps with 20 of them, at 3.2 % after 199 steps with 150.
_FEWEST, _MOST, _BYTES = 20, 150, 100e6
_ARMIJO = 1e-4
_MAX_TRIALS = 12
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


# Without a blur. Powers of 1, 1.25 and 1.5 leave 1.57, 1.54 and 1.69 % of a flame after 4 s; 5 more
# steps lower a photograph's error from 0.52 to 0.50 %.
_SHARP = (Descent(1.25, 0.08, 5e-4),)
# With an even blur, each step is one trace: 10 more steps lower a photograph in the sun from 1.88
# to 1.81 %. Short waves, which the blur damps, all of one size: 1.82 %, and 2.05 % by power alone.
_EVEN = (Descent(1.25, 0.0025, 1.5e-4),)
# With a blur that differs over the lens, long waves come first: two faces before *LED to a
# rectangle* are 2.7 % off after 129 steps, and after 251 steps of all waves.
_UNEVEN = (Descent(1.0, 0.03, 0.0, longest=0.25, above=0.15), Descent(1.0, 0.01, 0.0))


class Waves:
    """Cosine waves over a control net.

    `shape`: (n_u, n_v) of the net; `power`: waves are made small in proportion to this power of
    their periods per lens; `mirrored`: whether to leave out all waves that are not mirror images of
    themselves in u, in v; `blur_widths`: full widths of a blur of what the waves make along u and
    v, parts of the lens: the waves that it damps are all of one size; `longest`: part of the waves
    along each axis, the longest ones, that are left; `eases` (n_u, n_v): how much larger waves are
    at each control point; by default they are as large everywhere.
    """

    def __init__(
        self,
        shape: Sequence[int],
        power: float,
        mirrored: tuple[bool, bool],
        blur_widths: tuple[float, float] = (0.0, 0.0),
        longest: float = 1.0,
        eases: Array | None = None,
    ) -> None:
        self.shape = tuple(shape)
        self._workers = threads.workers(math.prod(shape))
        (along_u, along_v), (b_u, b_v) = (np.arange(count) / 2 for count in shape), blur_widths
        periods = 1 + along_u[:, None] ** 2 + along_v**2
        damped = 1 + ((b_u * along_u[:, None]) ** 2 + (b_v * along_v) ** 2) / _DAMPED**2
        squares = (periods / damped) ** -power  # of sizes
        for axis, count in enumerate(shape):
            np.moveaxis(squares, axis, 0)[math.ceil(longest * count) :] = 0.0
        self._mirrored_axes = [axis for axis in (0, 1) if mirrored[axis]]
        if mirrored[0]:
            squares[1::2] = 0.0
        if mirrored[1]:
            squares[:, 1::2] = 0.0
        # Amplitudes only say where a descent looks next.
        self._kind = np.float32 if squares.size > _MANY else np.float64
        self._sizes: AnyArray = np.sqrt(squares).astype(self._kind)
        self._roots: AnyArray | None = None
        if eases is not None:
            self._roots = np.sqrt(eases).astype(self._kind)

    def amplitudes(self, gradient: Tensor) -> Tensor:
        """Gradient with respect to the amplitudes of all waves, of that to the net (n_u, n_v)."""
        values = dctn(self._copied(gradient), norm="ortho", workers=self._workers)
        values *= self._sizes
        if self._roots is not None:
            values = idctn(values, norm="ortho", workers=self._workers, overwrite_x=True)
            values *= self._roots
        return torch.as_tensor(values)

    def change(self, amplitudes: Tensor) -> Tensor:
        """The change of the net that waves make, of their amplitudes; both of shape (n_u, n_v)."""
        values = self._copied(amplitudes)
        if self._roots is not None:
            values = dctn(values * self._roots, norm="ortho", workers=self._workers)
        values = idctn(values * self._sizes, norm="ortho", workers=self._workers, overwrite_x=True)
        return self.even(torch.as_tensor(values).to(amplitudes))

    def _copied(self, values: Tensor) -> AnyArray:
        return values.detach().cpu().numpy().astype(self._kind)

    def even(self, net: Tensor) -> Tensor:
        """The part of a net (n_u, n_v) that is a mirror image of itself, where waves have to be."""
        for axis in self._mirrored_axes:
            net = (net + net.flip(axis)) / 2
        return net


class FaceWaves:
    """Waves over the nets of several faces, whose values lie one after the other.

    `like` (n_u, n_v): A net of each face; `power`, `mirrored`, `blur_widths`, `longest`: see
    `Waves`; `eases` (n_u, n_v): those of each face that has some.
    """

    def __init__(
        self,
        like: Mapping[str, Tensor],
        power: float,
        mirrored: tuple[bool, bool],
        blur_widths: tuple[float, float] = (0.0, 0.0),
        longest: float = 1.0,
        eases: Mapping[str, Array] = NO_FACES,
    ) -> None:
        self._waves = {
            face: Waves(each.shape, power, mirrored, blur_widths, longest, eases.get(face))
            for face, each in like.items()
        }

    def values(self, nets: Mapping[str, Tensor]) -> Tensor:
        """The values of the net of each face one after the other, shape (points,)."""
        return torch.cat([nets[face].flatten() for face in self._waves])

    def nets(self, values: Tensor) -> dict[str, Tensor]:
        """The net of each face, shape (n_u, n_v), of all values: the inverse of `values`."""
        shapes = [each.shape for each in self._waves.values()]
        parts = torch.split(values, [math.prod(shape) for shape in shapes])
        views = (part.view(shape) for part, shape in zip(parts, shapes, strict=True))
        return dict(zip(self._waves, views, strict=True))

    def amplitudes(self, gradient: Tensor) -> Tensor:
        """See `Waves`; shape (points,) for all faces."""
        nets = self.nets(gradient)
        return self.values({face: w.amplitudes(nets[face]) for face, w in self._waves.items()})

    def change(self, amplitudes: Tensor) -> Tensor:
        """See `Waves`; shape (points,) for all faces."""
        nets = self.nets(amplitudes)
        return self.values({face: w.change(nets[face]) for face, w in self._waves.items()})

    def even(self, values: Tensor) -> Tensor:
        """See `Waves`; shape (points,) for all faces."""
        nets = self.nets(values)
        return self.values({face: each.even(nets[face]) for face, each in self._waves.items()})


class Coordinates(Protocol):
    """Coordinates a in which x = W a, and steps of one length are equally easy."""

    def amplitudes(self, gradient: Tensor) -> Tensor:
        """Wᵀ g of a gradient g with respect to x, shape (n,): that with respect to a."""

    def change(self, amplitudes: Tensor) -> Tensor:
        """W a, shape (n,)."""


class _Plain:
    def amplitudes(self, gradient: Tensor) -> Tensor:
        return gradient

    def change(self, amplitudes: Tensor) -> Tensor:
        return amplitudes


_PLAIN = _Plain()
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
    return int(min(max(_BYTES / (2 * torch.float64.itemsize * count), _FEWEST), _MOST))


def minimise(
    objective: Objective[Seen],
    x: Tensor,
    coordinates: Coordinates = _PLAIN,
    ends: tuple[Tensor, Tensor] | None = None,
) -> Iterator[tuple[Tensor, Evaluation[Seen]]]:
    """Descend from ``x`` until no step along the search direction goes further down.

    `objective`: takes a point, shape (n,), and returns an `Evaluation` with a value that is not
    negative; `x` (n,): where to begin; `coordinates`: in which a step is measured; by default x
    itself. `ends` (n,): least and largest value of each number; by default there are none. Yields
    the beginning, then each accepted point.

    Notes
    -----
    Two-loop recursion with backtracking (Nocedal & Wright, Numerical Optimization, 2006,
    algorithms 7.4 and 3.1). The very first step is Polyak's, value / |gradient|², the one that
    would reach 0 if the objective fell on at this rate: no length to be set by hand. With W Wᵀ as
    the first inverse of the Hessian the steps are those of a descent in other coordinates, without
    going there and back. Numbers at an end to which the objective falls are held there for a step;
    the others are followed along the path that is projected into the ends (Bertsekas, Projected
    Newton methods, 1982).
    """
    low, high = ends or (torch.full_like(x, -math.inf), torch.full_like(x, math.inf))
    pairs: deque[_Pair] = deque(maxlen=remembered(len(x)))
    x = x.clamp(low, high)
    here = objective(x)
    yield x, here
    while True:
        direction = _direction(pairs, here, coordinates, _free(x, here.gradient, low, high))
        if not torch.dot(here.gradient, direction).item() < 0:
            return
        step = 1.0
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
        gradient = here.gradient
        x, here = reached, there
        yield x, here  # before its gradient, which the last point does without
        turned = here.gradient - gradient
        product = torch.dot(moved, turned).item()
        if product > _LEAST_CURVATURE * (moved.norm() * turned.norm()).item():
            pairs.append(_Pair(moved, turned, product))


def _free(x: Tensor, gradient: Tensor, low: Tensor, high: Tensor) -> Tensor | None:
    """1 where a coordinate may change, 0 where it is held at an end; None where all may."""
    held = ((x <= low) & (gradient >= 0)) | ((x >= high) & (gradient <= 0))
    return (~held).to(x) if held.any() else None


def _direction(
    pairs: Sequence[_Pair], here: Evaluation[Seen], coordinates: Coordinates, free: Tensor | None
) -> Tensor:
    """Minus the inverse of the Hessian as the pairs know it, times the gradient.

    Both of the ``free`` numbers alone.
    """

    def amplitudes(gradient: Tensor) -> Tensor:
        return coordinates.amplitudes(gradient if free is None else free * gradient)

    def change(amplitudes: Tensor) -> Tensor:
        changed = coordinates.change(amplitudes).to(here.gradient)
        return changed if free is None else free * changed

    gradient = here.gradient
    if free is not None:
        pairs, gradient = list(_among(pairs, free)), free * gradient
    if not pairs:
        steepest = amplitudes(gradient)
        square = steepest.square().sum().clamp_min(1e-300)
        return change(steepest) * (-here.value / square)
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
