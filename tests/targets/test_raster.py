"""Rasters averaged over the pixels of others."""

import pytest

from workbench.targets.raster import averaged


@pytest.mark.parametrize("shape", [(2, 3), (5, 7), (12, 9)])
def test_averaging_keeps_the_mean(rng, shape):
    image = rng.random((6, 9))
    found = averaged(image, shape)
    assert found.shape == shape
    assert found.mean() == pytest.approx(image.mean())
