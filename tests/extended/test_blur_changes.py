"""Changes of a blur over pixels: exact, and without light of their own."""

from dataclasses import replace

import numpy as np
import pytest

from workbench.extended.blur import Blur, changes_at

THIRDS = (np.arange(3) + 0.5) / 3 - 0.5
BLURS = [Blur((5.93, 5.2), "ellipse"), Blur((3.3, 7.1)), Blur((1.4, 2.6), "ellipse")]


def wider(blur, factor_x, factor_y):
    x, y = blur.widths
    return replace(blur, widths=(factor_x * x, factor_y * y))


@pytest.mark.parametrize("blur", BLURS)
def test_changes_by_width_are_those_of_the_exact_kernels(blur):
    changes, step = changes_at(blur, THIRDS), 1e-4
    for change, (x, y) in zip(changes, [(step, 0), (0, step)], strict=False):
        ahead, back = (wider(blur, 1 + s * x, 1 + s * y).at(THIRDS) for s in (1, -1))
        np.testing.assert_allclose(change, (ahead - back) / (2 * step), atol=1e-6)


def sheared(blur, correlation):
    """The kernel of a blur whose x moves with y, from many thin rows of it."""
    (m_x, m_y), (r_x, r_y) = blur.margin, np.array(blur.widths) / 2
    v = (np.arange(20000) + 0.5) / 10000 - 1
    half = np.sqrt(1 - v**2) if blur.shape == "ellipse" else np.ones_like(v)
    edges = (np.arange(-m_x - 0.5, m_x + 1) / r_x)[:, None] - correlation * v
    parts = np.diff(edges.clip(-half, half), axis=0)
    row = np.round(r_y * v).astype(int) + m_y
    kernel = np.stack([np.bincount(row, part, 2 * m_y + 1) for part in parts], axis=1)
    return kernel / half.sum() / 2


@pytest.mark.parametrize("blur", BLURS)
def test_leaning_light_is_that_of_sheared_outlines(blur):
    (leaning,), step = changes_at(blur, np.zeros(1))[2], 1e-4
    turned = replace(blur, widths=blur.widths[::-1])
    by_y, by_x = (
        (sheared(each, step) - sheared(each, -step)) / (2 * step) for each in (blur, turned)
    )
    np.testing.assert_allclose(leaning, (by_y + by_x.T) / 2, atol=1e-3 * np.abs(leaning).max())
