import math

import numpy as np
import pytest

from workbench.analysis import metrics
from workbench.analysis.metrics import Quality


@pytest.fixture
def target(rng):
    """A disc with a soft edge on black."""
    y, x = np.mgrid[-1:1:24j, -1:1:32j]
    return (1.2 - 2 * np.hypot(x, y)).clip(0, 0.6)


class TestEqualImages:
    def test_every_figure_is_the_best(self, target):
        found = Quality.of(3 * target, target)  # the scale plays no part
        assert metrics.relative_l2(3 * target, target) < 1e-15
        assert found.psnr is None or found.psnr > 250
        assert found.ssim == pytest.approx(1, abs=1e-12)
        assert found.correlation == pytest.approx(1, abs=1e-12)
        assert found.uniformity == pytest.approx(1, abs=1e-12)
        assert found.contrast == 1


def test_relative_l2_by_hand():
    target, image = np.array([[0.0, 2.0]]), np.array([[1.0, 1.0]])
    assert metrics.relative_l2(image, target) == pytest.approx(math.sqrt(0.5))
    assert metrics.relative_l2(np.zeros((1, 2)), target) == 1  # no light at all


class TestSsim:
    def test_window_by_hand(self, rng):
        image, target = rng.random((30, 30)), rng.random((30, 30))
        a, b = image / image.sum(), target / target.sum()
        a, b = a / b.max(), b / b.max()
        here = np.arange(-5, 6)
        window = np.exp(-(here[:, None] ** 2 + here[None, :] ** 2) / (2 * 1.5**2))
        window /= window.sum()
        scores = []
        padded = [np.pad(each, 5, mode="symmetric") for each in (a, b)]
        for row in range(30):
            for column in range(30):
                p, q = (each[row : row + 11, column : column + 11] for each in padded)
                mean_p, mean_q = (window * p).sum(), (window * q).sum()
                var_p, var_q = (
                    (window * p * p).sum() - mean_p**2,
                    (window * q * q).sum() - mean_q**2,
                )
                cov = (window * p * q).sum() - mean_p * mean_q
                luminance = (2 * mean_p * mean_q + 1e-4) / (mean_p**2 + mean_q**2 + 1e-4)
                scores.append(luminance * (2 * cov + 9e-4) / (var_p + var_q + 9e-4))
        assert metrics.ssim(image, target) == pytest.approx(np.mean(scores), rel=1e-10)


def test_correlation(target, rng):
    image = rng.random(target.shape)
    expected = np.corrcoef(image.ravel(), target.ravel())[0, 1]
    assert metrics.correlation(image, target) == pytest.approx(expected, abs=1e-12)
    assert metrics.correlation(np.full(target.shape, 0.3), target) is None


class TestRegions:
    TARGET = np.array([[1.0, 1.0, 0.5, 0.3, 0.0, 0.0]])

    def test_uniformity_is_relative_to_the_target(self):
        image = np.array([[2.0, 1.0, 1.0, 9.0, 9.0, 9.0]])  # ratios 2, 1, 2 where it is lit
        assert metrics.uniformity(image, self.TARGET) == pytest.approx(1 / (5 / 3))
