"""Deconvolution: the light that, blurred, is closest to a target.

Images are compared as in `analysis.metrics.relative_l2`, each divided by its sum. Minimised is

‖v − t‖ / ‖t‖ over v = K u, u ≥ 0, Σ v = 1,

where light u may lie beside the receiver as far as its blur K reaches it, and Σ t = 1.

The alternating direction method of multipliers (Boyd et al. 2011, section 3) works on copies: of u,
which is not negative, and of v, which is near t on the receiver and free beside it. The remaining
problem for u is unconstrained least squares, solved for each frequency separately: K mixes the few
positions in a pixel, so its normal matrix is the identity and one of rank one (Sherman and
Morrison). It needs a tenth of the steps of accelerated projected gradients. `certificate` bounds
the distance of the result from the optimum, and decides when to stop.
"""

import math
from collections.abc import Callable, Generator, Iterator, Sequence
from functools import lru_cache
from itertools import islice
from typing import NamedTuple, TypeVar, cast

import numpy as np

from workbench.arrays import AnyArray, Array
from workbench.extended.blur import Blur
from workbench.extended.blurring import Blurring, convolved, near
from workbench.extended.certificate import Certifier
from workbench.progress import check_given_up, finished

# Weights of the copies of image and light, and over-relaxation. In long searches the weight of
# light decreases: 60 steps reach an error of 7.95 % for a letter in the sun, 9.3 % with 0.003
# throughout, and more steps end closer to the optimum.
_IMAGE, _RELAXED = 0.1, 1.7
_LIGHT, _FALLING_LIGHT, _FALLS_EVERY = (0.003,), tuple(np.geomspace(0.04, 0.001, 10)), 10
# The search ends when the bound is below the error by less than this part, or this much.
_GAP, _NEGLIGIBLE = 0.03, 2e-4
# With light at more positions in each pixel a step takes four times as long and gets closer: it is
# used for the last steps. A photograph in the sun is certified to 10.66 % by 50, 30 and 15 steps
# with 4, 16 and 64 positions in each pixel; 100 with 16 and 50 with 64 take more than twice the
# time and are no closer. Steps of a search with one set of positions, and between two checks.
_FINENESS, _LEVELS = (0.5, 1, 2), (50, 30, 40)
_STEPS, _CHECK_EVERY = 150, 25
# A photograph is certified to 0.96 % after 120 steps for spots, to 1.15 % after these.
_SPOT_STEPS = 375
SPOTS = 3
"""Positions of spots along each axis of a pixel."""
# Most positions in all pixels together: light at more positions gets closer, but large images would
# exceed the memory.
_MOST_LIGHT = 6_000_000
# Steps for the light that a lens should make, and for the error that a source allows.
_SPREAD_STEPS = 80
# Cached results: status, check and report of a window need the same one.
_KEPT = 8
# Positions from which less of the light reaches the receiver are left out.
_LEAST_SHARE = 1e-4

T = TypeVar("T")


class Deblurred(NamedTuple):
    """The light that is closest to a target, and its lower bound."""

    # (n_y + 2 m_y, n_x + 2 m_x), flux of light before it is blurred, in pixels of the receiver and
    # of the blur's margin; a flux of 1 reaches the receiver.
    light: Array
    image: Array  # (n_y, n_x), its blurred image, with a sum of 1
    error: float  # relative L2 error of this image
    bound: float  # certified lower bound of the error of blurred light


def deblur(target: Array, blur: Blur) -> Deblurred:
    """Find the light that, blurred, is closest to a target (n_y, n_x), not negative nor dark.

    The bound of an ellipse is certified for light at the positions in each pixel that
    `Blur.offsets` has with ``finer=2``, which are also searched unless the image is large; that of
    a rectangle for light anywhere.

    Examples
    --------
    A pixel of light cannot be reached with a blur of three by three pixels, but with a blur of one:

    >>> import numpy as np
    >>> pixel = np.zeros((9, 9))
    >>> pixel[4, 4] = 1
    >>> found = deblur(pixel, Blur((3.0, 3.0)))
    >>> 0.85 < found.bound < found.error < 0.95
    True
    >>> deblur(pixel, Blur((1.0, 1.0))).bound
    0.0
    """
    return finished(deblurring(target, blur))


_kept: dict[tuple[object, ...], object] = {}


def deblurring(target: Array, blur: Blur) -> Generator[None, None, Deblurred]:
    """Run `deblur` in short steps, so that it can be cancelled; the last results are cached."""
    return (yield from _remembered("deblurred", target, blur, _closest))


def _remembered(
    what: str, target: Array, blur: Blur, steps: Callable[[Array, Blur], Generator[None, None, T]]
) -> Generator[None, None, T]:
    key = what, target.tobytes(), target.dtype.str, target.shape, blur
    found = _kept.get(key)
    if found is None:
        found = yield from steps(target, blur)
        for old in list(_kept)[: len(_kept) + 1 - _KEPT]:
            _kept.pop(old, None)
        _kept[key] = found
    return cast(T, found)


def _closest(target: Array, blur: Blur) -> Generator[None, None, Deblurred]:
    wanted = target / target.sum()
    if blur.within_a_pixel:
        m_x, m_y = blur.margin
        return Deblurred(np.pad(wanted, ((m_y, m_y), (m_x, m_x))), wanted, 0.0, 0.0)
    certifier = Certifier(blur.kernels(finer=_FINENESS[-1]), wanted)
    return (yield from _certified(_levels(blur, wanted.shape), certifier, wanted))


def _levels(blur: Blur, shape: tuple[int, ...]) -> list["_Level"]:
    """Searches with light at few positions in each pixel, then at more."""
    m_x, m_y = blur.margin
    most = max(_MOST_LIGHT / ((shape[0] + 4 * m_y) * (shape[1] + 4 * m_x)), 1)
    found: dict[tuple[int, int], Array] = {}
    for finer in _FINENESS:
        columns, rows = map(len, blur.offsets(finer))
        if rows * columns <= most or not found:
            found[rows, columns] = blur.kernels(finer)
    few, last = _LEVELS[: len(found) - 1], sum(_LEVELS[len(found) - 1 :])
    steps = (*few, last) if few else (_STEPS,)
    return [
        _Level(kernels, count, places)
        for (places, kernels), count in zip(found.items(), steps, strict=True)
    ]


def _certified(
    levels: "Sequence[_Level]", certifier: Certifier, wanted: Array
) -> Generator[None, None, Deblurred]:
    size = float(np.linalg.norm(wanted))
    best, error, bound = None, np.inf, -1.0
    left = sum(level.steps for level in levels)
    for search in _search(levels, wanted, _FALLING_LIGHT):
        yield
        left -= 1
        if left >= levels[-1].steps or left % _CHECK_EVERY:
            continue
        found = search.result()
        reached = float(np.linalg.norm(found.image - wanted)) / size
        if reached < error:
            best, error = found, reached
        bound = max(bound, certifier.bound(found.residual))
        if error - bound <= max(_GAP * error, _NEGLIGIBLE):
            break
    assert best is not None
    return Deblurred(best.light.sum(axis=0), best.image, error, bound)


def deblur_into_spots(target: Array, blur: Blur, width: float) -> Deblurred:
    """Find the light of square spots that, blurred, is closest to a target.

    ``width`` is that of the uniform squares, pixels. It is certified for squares about the middles
    of `SPOTS` × `SPOTS` parts of each pixel; the result's light is that of the middles.
    """
    wanted = target / target.sum()
    kernels = blur.spread(SPOTS, SPOTS * width)
    levels = [_Level(kernels, _SPOT_STEPS)]
    return finished(_certified(levels, Certifier(kernels, wanted), wanted))


def error_allowed(target: Array, blur: Blur) -> float:
    """An error that blurred light can reach: faster than `deblur`, slightly above its error."""
    return finished(error_allowing(target, blur))


def error_allowing(target: Array, blur: Blur) -> Generator[None, None, float]:
    """Compute `error_allowed` in short steps, as `deblurring`."""
    return (yield from _remembered("allowed", target, blur, _allowed))


def _allowed(target: Array, blur: Blur) -> Generator[None, None, float]:
    if blur.within_a_pixel:
        return 0.0
    wanted = target / target.sum()
    every = _search(_levels(blur, wanted.shape)[:2], wanted, _FALLING_LIGHT)
    steps = islice(every, _SPREAD_STEPS)
    search = next(steps)  # the same object after each step
    yield from (None for _ in steps)
    image = search.result().image
    return float(np.linalg.norm(image - wanted) / np.linalg.norm(wanted))


def spread_light(target: Array, kernels: Array) -> Array:
    """Return the light, uniform in each part of a pixel, that is closest when blurred.

    A lens can make that, unlike light at single points or with sharp edges. `target` (n_y, n_x);
    `kernels` (parts parts, 2 m_y + 1, 2 m_x + 1): of light in the parts of a pixel, row by row. It
    has the shape (parts (n_y + 2 m_y), parts (n_x + 2 m_x)), otherwise as in `Deblurred`.
    """
    share = target / target.sum()
    return _kept_light(share.tobytes(), share.shape, kernels.tobytes(), kernels.shape).copy()


@lru_cache(maxsize=4)  # a first design and both images of a run need the same one
def _kept_light(
    target: bytes, shape: tuple[int, ...], kernels: bytes, sizes: tuple[int, ...]
) -> Array:
    level = _Level(np.frombuffer(kernels).reshape(sizes), _SPREAD_STEPS)
    *_, search = _search([level], np.frombuffer(target).reshape(shape))
    light, parts = search.result().light, math.isqrt(sizes[0])
    rows, columns = light.shape[1:]
    light = light.reshape(parts, parts, rows, columns).transpose(2, 0, 3, 1)
    return np.asarray(light.reshape(rows * parts, columns * parts))


def wanted_light(target: Array, kernel: Array | None, margin: tuple[int, int]) -> Array:
    """Return the light wanted on a receiver and around it, (n_y + 2 m_y, n_x + 2 m_x).

    Blurred light that makes a bright border also falls beyond it. If that counted as an error,
    borders would be left dark. On the receiver it is the target (n_y, n_x); beside it, the light
    there of the light that, blurred, is closest to the target. What falls farther away is missing
    from a sum of 1. `kernel`: blur of uniform light in a pixel; None without one.

    Examples
    --------
    Half of the blur of a bright border falls beyond it:

    >>> import numpy as np
    >>> blurred = wanted_light(np.ones((40, 40)), Blur((5.0, 5.0)).spread()[0], (2, 2))
    >>> bool(blurred[0].sum() > 0)
    True
    >>> wanted_light(np.ones((40, 40)), None, (2, 2))[:2].sum().item()
    0.0
    """
    share, (n_y, n_x), (m_x, m_y) = target / target.sum(), target.shape, margin
    if kernel is None:
        return np.pad(share, ((m_y, m_y), (m_x, m_x)))
    light = spread_light(share, near(kernel[None], share.shape))
    wide = convolved(light, kernel).clip(min=0) / light.sum()
    top, left = ((w - n) // 2 for w, n in zip(wide.shape, share.shape, strict=True))
    wide = np.pad(wide, ((m_y, m_y), (m_x, m_x)))
    cut = wide[top : top + n_y + 2 * m_y, left : left + n_x + 2 * m_x]
    seen = slice(m_y, m_y + n_y), slice(m_x, m_x + n_x)
    cut[seen] = share * cut[seen].sum()
    return cut


class _Level(NamedTuple):
    """Kernels at some positions in a pixel, and the number of search steps with them."""

    kernels: Array
    steps: int
    places: tuple[int, int] = (1, 1)  # number of positions along y and x, if more levels follow


class _Deblurred(NamedTuple):
    """Light of each position in a pixel, its image, and the image's copy less the target."""

    light: Array
    image: Array
    residual: Array


def _search(
    levels: "Sequence[_Level]", wanted: Array, weights: Sequence[float] = _LIGHT
) -> Iterator["_Search"]:
    search, done, before = _Search(levels[0].kernels, wanted), 0, levels[0]
    for level in levels:
        if level is not before:
            search.refine(before, level)
        before = level
        for _ in range(level.steps):
            search.step(weights[min(done // _FALLS_EVERY, len(weights) - 1)])
            done += 1
            yield search


class _Search:
    def __init__(self, kernels: Array, wanted: Array) -> None:
        self._wanted: AnyArray = wanted.astype(np.float32)
        self._set_kernels(kernels)
        self._image = self._blurring.on_grid(self._wanted)
        self._dual_image = np.zeros_like(self._image)
        self._light = np.zeros((len(kernels), *self._image.shape), np.float32)
        self._dual_light, self._weight = np.zeros_like(self._light), 0.0

    def _set_kernels(self, kernels: Array) -> None:
        shape = self._wanted.shape[0], self._wanted.shape[1]
        self._blurring = Blurring(kernels.astype(np.float32), shape)
        self._power = np.square(np.abs(self._blurring.kernels)).sum(axis=0)
        self._lit = self._blurring.back(np.ones_like(self._wanted)) > _LEAST_SHARE

    def refine(self, before: _Level, level: _Level) -> None:
        """Continue with a multiple of the positions along x and y; after a step.

        Light is passed to the surrounding positions. The dual of its copy follows from that of the
        image, as light was the best fit of both.
        """
        light = self._light.reshape(*before.places, *self._image.shape)
        for axis, (new, old) in enumerate(zip(level.places, before.places, strict=True)):
            light = light.repeat(new // old, axis) / (new // old)
        self._set_kernels(level.kernels)
        self._light = light.reshape(-1, *self._image.shape)
        self._dual_light = -self._ratio * self._blurring.back_from(
            self._blurring.waves(self._dual_image)
        )

    @property
    def _ratio(self) -> float:
        return _IMAGE / (self._weight * math.sqrt(len(self._light)))

    def step(self, weight: float) -> None:
        check_given_up()
        if self._weight:
            self._dual_light *= self._weight / weight  # duals are scaled by the weight
        self._weight = weight
        blurring, k, ratio = self._blurring, self._blurring.kernels, self._ratio
        share = (ratio / (1 + ratio * self._power)).astype(np.float32)
        # Light that fits both copies best.
        wave = blurring.waves(self._light + self._dual_light)
        blurred = sum(kernel * each for kernel, each in zip(k, wave, strict=True))
        off = share * (blurring.waves(self._image + self._dual_image) - blurred)
        for each, kernel in zip(wave, k, strict=True):
            each += kernel.conj() * off
        blurred += self._power * off
        # Copies projected onto their constraints.
        self._dual_image -= _RELAXED * blurring.images(blurred) + (1 - _RELAXED) * self._image
        self._image = image = -self._dual_image
        on_receiver = (self._wanted + _IMAGE * image[blurring.seen]) / (1 + _IMAGE)
        image[blurring.seen] = on_receiver + (1 - on_receiver.sum()) / self._wanted.size
        self._dual_image += image
        # One position after the other, here and above: intermediate results stay in the cache.
        free = blurring.images(wave)
        places = zip(self._light, self._dual_light, free, self._lit, strict=True)
        for light, away, found, lit in places:
            away -= _RELAXED * found + (1 - _RELAXED) * light
            np.maximum(-away, 0, out=light)
            light *= lit
            away += light

    def result(self) -> _Deblurred:
        found = self._blurring.image(self._light)
        total = float(found.sum(dtype=np.float64))
        return _Deblurred(
            self._light[:, *self._blurring.places].astype(np.float64) / total,
            found.astype(np.float64) / total,
            (self._image[self._blurring.seen] - self._wanted).astype(np.float64),
        )
