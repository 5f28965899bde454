"""The least error of blurred light: against exact solutions, and what has to hold of any bound."""

from typing import NamedTuple

import numpy as np
import pytest
from scipy.ndimage import gaussian_filter
from scipy.optimize import nnls

from workbench.analysis.metrics import relative_l2
from workbench.extended.blur import Blur
from workbench.extended.blurring import Blurring
from workbench.extended.certificate import Certifier
from workbench.extended.deblur import deblur, spread_light, wanted_light


def letters(n_y: int, n_x: int) -> np.ndarray:
    """A small target with edges, that is not its own mirror image."""
    target = np.full((n_y, n_x), 0.05)
    target[2:-2, 2:5] = 1
    target[2:5, 2:-3] = 0.7
    return target


def images_of_places(blur: Blur, shape: tuple[int, int], finer: int = 1) -> np.ndarray:
    """Images of light at all places, summed directly and normalised; shape (pixels, places)."""
    (n_y, n_x), (m_x, m_y) = shape, blur.margin
    found = []
    for kernel in blur.kernels(finer):
        for row in range(-m_y, n_y + m_y):
            for column in range(-m_x, n_x + m_x):
                wide = np.zeros((n_y + 4 * m_y, n_x + 4 * m_x))
                r, c = row + m_y, column + m_x
                wide[r : r + 2 * m_y + 1, c : c + 2 * m_x + 1] = kernel
                image = wide[2 * m_y : 2 * m_y + n_y, 2 * m_x : 2 * m_x + n_x]
                if image.sum() > 1e-6:
                    found.append((image / image.sum()).ravel())
    return np.array(found).T


def least_error(images: np.ndarray, target: np.ndarray) -> float:
    """The exact least error: a mean of images is sought, by an active-set method.

    Shares of a mean have a sum of 1. Distances to the target scale with the shares, so the best
    ones have the same ratios whatever their sum is, and a soft condition on it is enough.
    """
    wanted = target.ravel() / target.sum()
    matrix = np.vstack([images - wanted[:, None], np.ones(images.shape[1])])
    parts, _ = nnls(matrix, np.append(np.zeros_like(wanted), 1.0))
    parts /= parts.sum()
    off = images @ parts - wanted
    # No image is nearer to the target along the rest of the way: it is the least.
    assert (off @ (images - wanted[:, None])).min() >= (1 - 1e-4) * off @ off
    return float(np.linalg.norm(off) / np.linalg.norm(wanted))


class Disc(NamedTuple):
    """A small task with a disc, and its exact least errors with light at places in each pixel."""

    target: np.ndarray
    blur: Blur
    least: float
    least_of_finer: float


@pytest.fixture(scope="module")
def disc() -> Disc:
    target, blur = letters(9, 8), Blur((3.4, 3.4), "ellipse")
    errors = (least_error(images_of_places(blur, target.shape, finer), target) for finer in (1, 2))
    return Disc(target, blur, *errors)


@pytest.mark.parametrize(
    "blur", [Blur((3.0, 3.0)), Blur((2.5, 3.0)), Blur((4.0, 3.0), points=(3, 2))]
)
def test_bound_is_just_below_the_exact_least_error(blur):
    target = letters(12, 10)
    exact = least_error(images_of_places(blur, target.shape), target)
    found = deblur(target, blur)
    assert 0.95 * exact < found.bound <= exact + 1e-9
    assert 0.9999 * exact <= found.error < 1.01 * exact


def test_certificate_of_any_image_is_below_the_exact_least_error(rng):
    target = letters(12, 10)
    blur = Blur((3.0, 3.0))
    exact = least_error(images_of_places(blur, target.shape), target)
    certifier = Certifier(blur.kernels(), target / target.sum())
    for _ in range(20):
        image = gaussian_filter(rng.normal(size=target.shape), 1)
        assert certifier.bound(image) <= exact + 1e-9


def test_blur_by_frequencies_is_the_direct_sum(rng):
    blur = Blur((3.4, 2.2), "ellipse")
    kernels, shape = blur.kernels(), (7, 9)
    blurring = Blurring(kernels, shape)
    light = np.zeros((len(kernels), *blurring.grid))
    places = light[:, *blurring.places]
    places[:] = rng.random(places.shape)
    direct = np.zeros((7 + 4 * blur.margin[1], 9 + 4 * blur.margin[0]))
    _, rows, columns = kernels.shape
    for kernel, lit in zip(kernels, places, strict=True):
        for (row, column), flux in np.ndenumerate(lit):
            direct[row : row + rows, column : column + columns] += flux * kernel
    np.testing.assert_allclose(blurring.image(light), direct[blurring.seen], atol=1e-12)
    image = rng.random(shape)
    np.testing.assert_allclose(
        (blurring.image(light) * image).sum(), (light * blurring.back(image)).sum()
    )


def test_image_found_is_that_of_the_light_found():
    target = letters(24, 20)
    blur = Blur((4.0, 4.0))
    found = deblur(target, blur)
    assert found.image.sum() == pytest.approx(1)
    assert (found.light >= 0).all()
    assert relative_l2(found.image, target) == pytest.approx(found.error, rel=1e-5)
    blurring = Blurring(blur.kernels(), target.shape)
    light = np.zeros((1, *blurring.grid))
    light[0][blurring.places] = found.light
    np.testing.assert_allclose(blurring.image(light), found.image, atol=1e-7)


def test_light_in_parts_of_pixels_comes_nearer_than_light_spread_over_whole_ones():
    from scipy.signal import fftconvolve  # late: it takes long to import

    target = np.zeros((24, 30))
    target[6:15, 8:22] = 1
    blur, errors = Blur((5.0, 5.0), "ellipse"), []
    for parts in (1, 3):
        light = spread_light(target, blur.spread(parts))
        (m_x, m_y), (n_y, n_x) = blur.margin, target.shape
        assert light.shape == (parts * (n_y + 2 * m_y), parts * (n_x + 2 * m_x))
        kernels = blur.spread(parts).reshape(parts, parts, *blur.spread().shape[1:])
        image = sum(
            fftconvolve(light[i::parts, j::parts], kernels[i, j], mode="valid")
            for i in range(parts)
            for j in range(parts)
        )
        errors.append(np.linalg.norm(image / image.sum() - target / target.sum()))
    assert errors[1] < 0.95 * errors[0]


def test_light_without_a_size_is_wanted_on_the_receiver_alone(rng):
    target = rng.random((12, 10))
    wanted = wanted_light(target, None, (3, 2))
    assert wanted.shape == (16, 16)
    np.testing.assert_allclose(wanted[2:-2, 3:-3], target / target.sum())
    assert wanted[:2].sum() == 0


@pytest.mark.parametrize("margin", [(1, 1), (3, 3), (9, 7)])
def test_a_blurred_bright_border_wants_light_beyond_it(margin):
    wanted = wanted_light(np.ones((40, 30)), Blur((5.0, 5.0), "ellipse").spread()[0], margin)
    m_x, m_y = margin
    inside = wanted[m_y:-m_y, m_x:-m_x]
    # Light lies within 3 pixels of the receiver, and is blurred by 3 pixels more.
    assert 0.85 < wanted.sum() <= 1 + 1e-9
    assert margin != (9, 7) or wanted.sum() == pytest.approx(1)
    assert np.ptp(inside) < 1e-12  # on the receiver it is the target
    assert 0.02 < 1 - inside.sum() < 0.3
    beyond = wanted[m_y - 1, m_x:-m_x]  # the first row above the receiver
    assert 0 < beyond.mean() < inside.mean()
