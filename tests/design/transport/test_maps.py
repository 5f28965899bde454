"""Maps of optimal transport: envelopes, the way back, values between cells."""

import numpy as np
import pytest
from scipy.ndimage import map_coordinates

from workbench.design.transport.back_and_forth import Transport, c_transform, mapped, push
from workbench.design.transport.cells import between, whence


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


CELLS = 160


# Light of so much of each half, up to the middle of a cell, goes eight times as far as before.
_DARK, _STRETCH = 17 / CELLS, 8.0


@pytest.fixture
def own():
    """Numbers of cells along both axes."""
    return tuple(np.indices((CELLS, CELLS), np.float64))


def test_values_between_cells_are_linear_and_the_nearest_beyond_them(rng):
    values = rng.random((30, 41))
    at = rng.uniform(-4, 34, (150, 90)), rng.uniform(-4, 45, (150, 90))
    expected = map_coordinates(values, at, order=1, mode="nearest")
    assert between(values, at) == pytest.approx(expected, abs=1e-12)


def test_places_are_found_where_values_are_as_wanted(own, rng):
    x, y = own
    to = x + 6 * np.sin(y / 20) + 4 * np.sin(x / 10), y + 5 * np.sin(x / 30)
    wanted = rng.uniform(20, CELLS - 20, (2, 50, 70))
    at = whence(to, wanted, wanted)
    assert [between(each, at) for each in to] == pytest.approx(wanted, abs=2e-3)


WEIGHTS = pytest.mark.parametrize("weights", [(1.0, 1.0), (0.25, 4.0)])


@pytest.mark.parametrize("shape", [(7, 12), (2, 9), (16, 16)])
@WEIGHTS
def test_envelope_is_hardly_below_the_least_of_all_parabolas(rng, shape, weights):
    potential = 5 * rng.normal(size=shape)
    a, b = (np.arange(m, dtype=float) for m in shape)
    cost_0 = 0.5 * weights[0] * (a[:, None] - a) ** 2
    cost_1 = 0.5 * weights[1] * (b[:, None] - b) ** 2
    everything = cost_0[:, None, :, None] + cost_1[None, :, None, :] - potential
    below = everything.min(axis=(2, 3)) - c_transform(potential, *weights)
    assert below.min() > -1e-12
    assert below.max() < sum(weights)


@WEIGHTS
def test_envelope_of_a_smooth_potential_is_exact_between_places(weights):
    a, b = (np.arange(m, dtype=float) for m in (41, 50))
    bends, (mid_0, mid_1) = (0.4, 1.3), (20.3, 24.8)
    well = 0.5 * bends[0] * (a[:, None] - mid_0) ** 2 + 0.5 * bends[1] * (b - mid_1) ** 2
    # min over x of ½ w (x − y)² + ½ q (x − m)² is ½ w q / (w + q) (y − m)².
    q_0, q_1 = (w * q / (w + q) for w, q in zip(weights, bends, strict=True))
    expected = 0.5 * q_0 * (a[:, None] - mid_0) ** 2 + 0.5 * q_1 * (b - mid_1) ** 2
    assert c_transform(-well, *weights) == pytest.approx(expected, abs=1e-9)


@pytest.mark.parametrize(("fewest", "wave"), [(1, 0.01), (6, 0.005)])
def test_even_light_stays_even_where_cells_come_nearer_to_each_other(fewest, wave):
    """Uncut cells 0.9 apart make waves of more than the first part, cut ones of less than both."""
    cells = np.arange(100.0)
    x, y = np.meshgrid(0.9 * cells + 5, cells, indexing="ij")
    light = push(np.ones((100, 100)), x, y, fewest)
    assert light.sum() == pytest.approx(100**2)
    inner = light[10:90, 10:90] * 0.9
    off = np.abs(inner - 1).max()
    assert off > wave if fewest == 1 else off < wave
