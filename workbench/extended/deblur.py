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
from collections.abc import Callable, Generator, Iterator, Sequence
from itertools import count, islice
from typing import NamedTuple

import numpy as np

from workbench.arrays import Array
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
_STEPS, _LOOK_EVERY = 120, 60
# A photograph is certified to 0.96 % after as many steps for spots, to 1.15 % after these.
_SPOT_STEPS = 360
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
    finer = blur.kernels(finer=2)
    certifier = Certifier(finer, wanted)
    m_x, m_y = blur.margin
    grid = (target.shape[0] + 4 * m_y) * (target.shape[1] + 4 * m_x)
    kernels = finer if len(finer) * grid <= _MOST_LIGHT else blur.kernels()
    return (yield from _certified(kernels, certifier, wanted))


def _certified(
    kernels: Array, certifier: Certifier, wanted: Array, steps: int = _STEPS
) -> Generator[None, None, Deblurred]:
    """Search until the result is close to what is certified, or as long as it is worth it."""
    size = float(np.linalg.norm(wanted))
    search = _search(kernels.astype(np.float32), wanted.astype(np.float32), _FALLING_LIGHT)
    best, error, bound = None, np.inf, -1.0
    for step, look in enumerate(islice(search, steps)):
        yield
        if (step + 1) % _LOOK_EVERY:
            continue
        found = look()
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
    return finished(_certified(kernels, Certifier(kernels, wanted), wanted, _SPOT_STEPS))


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
    search = _search(blur.kernels().astype(np.float32), wanted.astype(np.float32))
    yield from (None for _ in islice(search, _SPREAD_STEPS - 1))
    image = next(search)().image
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
    wanted = (target / target.sum()).astype(np.float32)
    search = _search(blur.spread(parts).astype(np.float32), wanted)
    light = next(islice(search, _SPREAD_STEPS - 1, None))().light
    rows, columns = light.shape[1:]
    light = light.reshape(parts, parts, rows, columns).transpose(2, 0, 3, 1)
    return np.asarray(light.reshape(rows * parts, columns * parts))


class _Deblurred(NamedTuple):
    """Light of each place in a pixel, its image, and the image's copy less the target."""

    light: Array
    image: Array
    residual: Array


def _search(
    kernels: Array, wanted: Array, weights: Sequence[float] = _LIGHT
) -> Iterator[Callable[[], _Deblurred]]:
    """Come closer step by step; what is found up to now is made when it is asked for."""
    shape = wanted.shape[0], wanted.shape[1]
    blurring = Blurring(kernels, shape)
    k, seen = blurring.kernels, blurring.seen
    power = np.square(np.abs(k)).sum(axis=0)
    dark = blurring.back(np.ones_like(wanted)) <= _LEAST_SHARE
    image = blurring.on_grid(wanted)
    light = np.zeros(dark.shape, wanted.dtype)
    away_image, away_light = np.zeros_like(image), np.zeros_like(light)

    def look() -> _Deblurred:
        found = blurring.image(light)
        total = float(found.sum(dtype=np.float64))
        return _Deblurred(
            light[:, *blurring.places].astype(np.float64) / total,
            found.astype(np.float64) / total,
            (image[seen] - wanted).astype(np.float64),
        )

    for step in count():
        check_given_up()
        now, begins = divmod(step, _FALLS_EVERY)
        if begins == 0 and now < len(weights):
            weight = _IMAGE / (weights[now] * math.sqrt(len(kernels)))
            share = (weight / (1 + weight * power)).astype(wanted.dtype)
            away_light *= weights[max(now - 1, 0)] / weights[now]  # it is scaled by the weight
        # Light that fits both copies best.
        wave = blurring.waves(light + away_light)
        off = share * (blurring.waves(image + away_image) - (k * wave).sum(axis=0))
        wave += k.conj() * off
        blurred = blurring.images((k * wave).sum(axis=0))
        free = blurring.images(wave)
        # Copies that keep to what each has to.
        away_image -= _RELAXED * blurred + (1 - _RELAXED) * image
        image = -away_image
        on_receiver = (wanted + _IMAGE * image[seen]) / (1 + _IMAGE)
        image[seen] = on_receiver + (1 - on_receiver.sum()) / wanted.size
        away_image += image
        away_light -= _RELAXED * free + (1 - _RELAXED) * light
        light = np.maximum(-away_light, 0)
        light[dark] = 0
        away_light += light
        yield look
