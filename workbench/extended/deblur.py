"""The light that, blurred, comes closest to a target.

Images are compared as `analysis.metrics.relative_l2` does, each divided by its sum. This
is the least of

    ‖v − t‖ / ‖t‖  over v = K u, u ≥ 0, Σ v = 1,

where light u may lie beside the receiver as far as its blur K reaches it, and Σ t = 1.

The alternating direction method of multipliers (Boyd et al. 2011, section 3) works on copies: of u,
which is not negative, and of v, which is near t on the receiver and free beside it. What is left
for u is then a least-squares problem without constraints, solved for each frequency by itself: K
mixes the few places in a pixel, so its normal matrix is the identity and one of rank one (Sherman
and Morrison). It needs a tenth of the steps of accelerated projected gradients. `certificate`
says how far the result is from the best at most, and when to stop.
"""

import math
from collections.abc import Generator, Iterator, Sequence
from typing import NamedTuple

import numpy as np

from workbench.arrays import AnyArray, Array
from workbench.extended.blur import Blur
from workbench.extended.blurring import Blurring
from workbench.extended.certificate import Certifier
from workbench.interruption import check_given_up
from workbench.watch import finished

# Weights of the copies of image and light, and over-relaxation. Where steps are many, that of light
# falls, every so many of them, from the first value to the last: 60 steps leave a letter in the sun
# 7.95 % off in place of 9.3 % with 0.003 throughout, and more of them end nearer to the best.
_IMAGE, _RELAXED = 0.1, 1.7
_LIGHT, _FALLING_LIGHT, _FALLS_EVERY = (0.003,), tuple(np.geomspace(0.02, 0.002, 13)), 10
# The search ends when the certificate is less than this part of the error below it, or this much.
_GAP, _NEGLIGIBLE = 0.03, 2e-4
# With light at more places in each pixel a step takes four times as long, and comes closer: it is
# for the last steps. A photograph in the sun is certified to 0.82 % by 100 and 50 steps of these
# kinds, to 0.66 % by 120 of the latter, which take longer.
_STEPS, _FINER_STEPS, _LOOK_EVERY = 150, 50, 75
# A photograph is certified to 0.96 % after 120 steps for spots, to 1.15 % after these.
_SPOT_STEPS = 375
SPOTS = 3
"""Places of spots along each axis of a pixel."""
# Light at more places in a pixel comes closer, but of large images, it would take all memory: so
# many places at most, on all pixels together.
_MOST_LIGHT = 6_000_000
# Steps for light that a lens is to make, and for what a source allows.
_SPREAD_STEPS = 80
# So many results are kept: a window's status, its check and its report ask for the same one.
_KEPT = 4
# Places from where less of the light falls on the receiver are left out of the search.
_LEAST_SHARE = 1e-4


class Deblurred(NamedTuple):
    """The light that comes closest to a target, and what no light can be below.

    Attributes
    ----------
    light : ndarray, shape (n_y + 2 m_y, n_x + 2 m_x)
        Flux of light before it is blurred, in each pixel and in as many about them as the margin
        of the blur; of all that, 1 falls on the receiver.
    image : ndarray, shape (n_y, n_x)
        Its blurred image, with the sum 1.
    error : float
        The error of this image: relative L2.
    bound : float
        The least error that an image of blurred light can have; certified.
    """

    light: Array
    image: Array
    error: float
    bound: float


def deblur(target: Array, blur: Blur) -> Deblurred:
    """Find the light that, blurred, comes closest to a target.

    Parameters
    ----------
    target : ndarray, shape (n_y, n_x)
        The wanted image in any scale, not negative and not dark.
    blur : Blur
        What the source makes of light.

    Returns
    -------
    Deblurred
        What was found. Of an ellipse, it is certified for light at the places in each pixel that
        `Blur.offsets` has with ``finer=2``, where it is sought too unless the image is large; of a
        rectangle, for light anywhere.

    Examples
    --------
    A pixel of light is out of reach for a source that blurs it over three by three, and a source
    that is no wider than a pixel can have it:

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


_kept: dict[tuple[object, ...], Deblurred] = {}


def deblurring(target: Array, blur: Blur) -> Generator[None, None, Deblurred]:
    """`deblur` step by step, each a small part of a second, so that one can leave it.

    The last results are kept and not sought again.
    """
    key = target.tobytes(), target.dtype.str, target.shape, blur
    found = _kept.get(key)
    if found is None:
        found = yield from _closest(target, blur)
        for old in list(_kept)[: len(_kept) + 1 - _KEPT]:
            _kept.pop(old, None)
        _kept[key] = found
    return found


def _closest(target: Array, blur: Blur) -> Generator[None, None, Deblurred]:
    """See `deblur`."""
    wanted = target / target.sum()
    if blur.within_a_pixel:
        m_x, m_y = blur.margin
        return Deblurred(np.pad(wanted, ((m_y, m_y), (m_x, m_x))), wanted, 0.0, 0.0)
    few, many = blur.kernels(), blur.kernels(finer=2)
    m_x, m_y = blur.margin
    grid = (target.shape[0] + 4 * m_y) * (target.shape[1] + 4 * m_x)
    levels, rows = [_Level(few, _STEPS)], len(blur.offsets()[1])
    if len(few) < len(many) <= _MOST_LIGHT / grid:
        levels = [_Level(few, _STEPS - _FINER_STEPS), _Level(many, _FINER_STEPS, rows)]
    return (yield from _certified(levels, Certifier(many, wanted), wanted))


def _certified(
    levels: "Sequence[_Level]", certifier: Certifier, wanted: Array
) -> Generator[None, None, Deblurred]:
    """Search until the result is close to what is certified, or as long as it is worth it."""
    size = float(np.linalg.norm(wanted))
    best, error, bound = None, np.inf, -1.0
    for step, search in enumerate(_search(levels, wanted, _FALLING_LIGHT), start=1):
        yield
        if step % _LOOK_EVERY:
            continue
        found = search.look()
        reached = float(np.linalg.norm(found.image - wanted)) / size
        if reached < error:
            best, error = found, reached
        bound = max(bound, certifier.bound(found.residual))
        if error - bound <= max(_GAP * error, _NEGLIGIBLE):
            break
    assert best is not None
    return Deblurred(best.light.sum(axis=0), best.image, error, bound)


def deblur_into_spots(target: Array, blur: Blur, width: float) -> Deblurred:
    """The light of spots of some width that, blurred, comes closest to a target.

    Parameters
    ----------
    target, blur
        As for `deblur`.
    width : float
        Light is even over squares of this width, pixels.

    Returns
    -------
    Deblurred
        What was found, certified for such squares about the middles of `SPOTS` × `SPOTS` parts of
        each pixel. Its light is that of the middles.
    """
    wanted = target / target.sum()
    kernels = blur.spread(SPOTS, SPOTS * width)
    levels = [_Level(kernels, _SPOT_STEPS)]
    return finished(_certified(levels, Certifier(kernels, wanted), wanted))


def error_allowed(target: Array, blur: Blur) -> float:
    """An error that blurred light can have; sooner than `deblur`, and hardly above its ``error``.

    Parameters
    ----------
    target, blur
        As for `deblur`.
    """
    return finished(error_allowing(target, blur))


def error_allowing(target: Array, blur: Blur) -> Generator[None, None, float]:
    """`error_allowed` step by step, as `deblurring`."""
    if blur.within_a_pixel:
        return 0.0
    wanted = target / target.sum()
    steps = _search([_Level(blur.kernels(), _SPREAD_STEPS)], wanted)
    search = next(steps)  # the same one after each step
    yield from (None for _ in steps)
    image = search.look().image
    return float(np.linalg.norm(image - wanted) / np.linalg.norm(wanted))


def spread_light(target: Array, blur: Blur, parts: int = 1) -> Array:
    """The light, spread evenly over each part of a pixel, that comes closest when it is blurred.

    A lens can make that: light at single places is as far out of its reach as sharp edges.

    Parameters
    ----------
    target : ndarray, shape (n_y, n_x)
        The wanted image in any scale, not negative and not dark.
    blur : Blur
        What the source makes of light.
    parts : int
        Into so many along each axis a pixel is cut.

    Returns
    -------
    ndarray, shape (parts (n_y + 2 m_y), parts (n_x + 2 m_x))
        Flux in each part of a pixel, otherwise as in `Deblurred`.
    """
    *_, search = _search([_Level(blur.spread(parts), _SPREAD_STEPS)], target / target.sum())
    light = search.look().light
    rows, columns = light.shape[1:]
    light = light.reshape(parts, parts, rows, columns).transpose(2, 0, 3, 1)
    return np.asarray(light.reshape(rows * parts, columns * parts))


class _Level(NamedTuple):
    """The blur of light at some places in a pixel, and so many steps of a search there.

    ``rows`` is the number of places along y of the level before, which has half as many.
    """

    kernels: Array
    steps: int
    rows: int = 1


class _Deblurred(NamedTuple):
    """Light of each place in a pixel, its image, and the image's copy less the target."""

    light: Array
    image: Array
    residual: Array


def _search(
    levels: "Sequence[_Level]", wanted: Array, weights: Sequence[float] = _LIGHT
) -> Iterator["_Search"]:
    """A search after each of its steps."""
    search, done = _Search(levels[0].kernels, wanted), 0
    for level in levels:
        if level is not levels[0]:
            search.refine(level.kernels, level.rows)
        for _ in range(level.steps):
            search.step(weights[min(done // _FALLS_EVERY, len(weights) - 1)])
            done += 1
            yield search


class _Search:
    """Comes closer to a target step by step.

    Parameters
    ----------
    kernels : ndarray, shape (places, 2 m_y + 1, 2 m_x + 1)
        The blur of light at each of some places in a pixel.
    wanted : ndarray, shape (n_y, n_x)
        The target; its sum is 1.
    """

    def __init__(self, kernels: Array, wanted: Array) -> None:
        self._wanted: AnyArray = wanted.astype(np.float32)
        self._look_at(kernels)
        self._image = self._blurring.on_grid(self._wanted)
        self._away_image = np.zeros_like(self._image)
        self._light = np.zeros((len(kernels), *self._image.shape), np.float32)
        self._away_light, self._weight = np.zeros_like(self._light), 0.0

    def _look_at(self, kernels: Array) -> None:
        """Choose the places of light."""
        shape = self._wanted.shape[0], self._wanted.shape[1]
        self._blurring = Blurring(kernels.astype(np.float32), shape)
        self._power = np.square(np.abs(self._blurring.kernels)).sum(axis=0)
        self._lit = self._blurring.back(np.ones_like(self._wanted)) > _LEAST_SHARE

    def refine(self, kernels: Array, rows: int) -> None:
        """Go on with twice as many places along x and y as those in some rows; after a step.

        Light is handed to those around it. How far its copy is away follows from that of the
        image, since light fitted both best.
        """
        light = self._light.reshape(rows, -1, *self._image.shape) / 4
        self._look_at(kernels)
        self._light = light.repeat(2, axis=0).repeat(2, axis=1).reshape(-1, *self._image.shape)
        self._away_light = -self._ratio * self._blurring.back_from(
            self._blurring.waves(self._away_image)
        )

    @property
    def _ratio(self) -> float:
        """Weight of the copy of the image over that of light."""
        return _IMAGE / (self._weight * math.sqrt(len(self._light)))

    def step(self, weight: float) -> None:
        """Come closer, with some weight of the copy of light."""
        check_given_up()
        if self._weight:
            self._away_light *= self._weight / weight  # it is scaled by the weight
        self._weight = weight
        blurring, k, ratio = self._blurring, self._blurring.kernels, self._ratio
        share = (ratio / (1 + ratio * self._power)).astype(np.float32)
        # Light that fits both copies best.
        wave = blurring.waves(self._light + self._away_light)
        blurred = sum(kernel * each for kernel, each in zip(k, wave, strict=True))
        off = share * (blurring.waves(self._image + self._away_image) - blurred)
        for each, kernel in zip(wave, k, strict=True):
            each += kernel.conj() * off
        blurred += self._power * off
        # Copies that keep to what each has to.
        self._away_image -= _RELAXED * blurring.images(blurred) + (1 - _RELAXED) * self._image
        self._image = image = -self._away_image
        on_receiver = (self._wanted + _IMAGE * image[blurring.seen]) / (1 + _IMAGE)
        image[blurring.seen] = on_receiver + (1 - on_receiver.sum()) / self._wanted.size
        self._away_image += image
        # One place after the other, here and above: what is made on the way stays in the cache.
        free = blurring.images(wave)
        places = zip(self._light, self._away_light, free, self._lit, strict=True)
        for light, away, found, lit in places:
            away -= _RELAXED * found + (1 - _RELAXED) * light
            np.maximum(-away, 0, out=light)
            light *= lit
            away += light

    def look(self) -> _Deblurred:
        """What is found up to now."""
        found = self._blurring.image(self._light)
        total = float(found.sum(dtype=np.float64))
        return _Deblurred(
            self._light[:, *self._blurring.places].astype(np.float64) / total,
            found.astype(np.float64) / total,
            (self._image[self._blurring.seen] - self._wanted).astype(np.float64),
        )
