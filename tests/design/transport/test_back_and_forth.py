"""Maps whose answer is known."""

import numpy as np
import pytest

from workbench.design.transport.back_and_forth import Transport
from workbench.design.transport.push import mapped, push


def blob(cells, centre, width):
    x = np.arange(cells) + 0.5
    mass = np.exp(-((x[:, None] - centre[0]) ** 2 + (x - centre[1]) ** 2) / (2 * width**2))
    return mass / mass.sum()


@pytest.mark.parametrize("weights", [(1.0, 1.0), (0.5, 2.0)])
def test_a_blob_moves_as_a_whole(weights):
    source, target = blob(64, (26, 30), 4), blob(64, (38, 33), 4)
    to_0, to_1 = Transport(source, target, weights).map()
    here = np.arange(64.0)
    shift_0 = (source * (to_0 - here[:, None])).sum()
    shift_1 = (source * (to_1 - here)).sum()
    assert (shift_0, shift_1) == pytest.approx((12, 3), rel=0.05)
    for error in (to_0 - here[:, None] - 12, to_1 - here - 3):
        assert (source * np.abs(error)).sum() < 0.7  # of a cell


@pytest.mark.parametrize("target", ["pixel", "checkerboard", "line"])
def test_extreme_targets_get_finite_maps_into_the_light(target):
    wanted = np.zeros((32, 32))
    if target == "pixel":
        wanted[20, 9] = 1
    elif target == "line":
        wanted[:, 31] = 1
    else:
        wanted[::2, ::2] = wanted[1::2, 1::2] = 1
    to_0, to_1 = Transport(np.full((32, 32), 1 / 1024), wanted / wanted.sum(), (1.0, 1.0)).map()
    assert np.isfinite(to_0).all() and np.isfinite(to_1).all()
    if target == "pixel":
        assert np.hypot(to_0 - 20, to_1 - 9).mean() < 1.0
    if target == "line":
        assert np.abs(to_1 - 31).mean() < 1.0


def test_pushing_keeps_all_mass(rng):
    mass = rng.random((20, 31))
    pushed = push(mass, *mapped(3 * rng.normal(size=(20, 31)), 1.0, 2.0))
    assert pushed.sum() == pytest.approx(mass.sum(), rel=1e-12)
    assert pushed.min() >= 0


def test_the_way_back_is_the_inverse_of_the_map():
    cells = np.arange(32.0)
    light = np.exp(-(((cells - 12) / 10) ** 2))
    source, target = np.outer(light, light[::-1]), np.ones((32, 32))
    transport = Transport(source / source.sum(), target / target.sum(), (1.0, 1.0))
    (to_0, to_1), (from_0, from_1) = transport.map(), transport.back()
    near = np.rint([to_0[8:24, 8:24], to_1[8:24, 8:24]]).astype(int)
    off = from_0[*near] - cells[8:24, None], from_1[*near] - cells[8:24]
    assert np.hypot(*off).mean() < 0.5
