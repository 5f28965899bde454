"""The brush: what it takes along, and where it ends."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench.design.brush import Stroke, bump
from workbench.geometry.surface import ControlNet


@pytest.fixture
def lens(make_scene):
    return make_scene().optic  # 12 × 10 points, base at 0.5, heights 0.2 to 0.8


@pytest.fixture
def flat():
    return np.full((12, 10), 0.5)


def test_the_bump_is_the_formula_and_nothing_beyond_the_radius(lens):
    net, radius = ControlNet.of(lens), 0.55
    block, weights = bump(net, (5, 0), radius)
    whole = np.zeros((12, 10))
    whole[block] = weights
    x, y = net.positions
    d = np.hypot(x[:, None] - x[5], y - y[0]) / radius
    np.testing.assert_allclose(whole, np.where(d < 1, (1 - d**2) ** 2, 0), atol=1e-15)
    assert whole[5, 0] == 1


@given(
    index=st.tuples(st.integers(0, 11), st.integers(0, 9)),
    by=st.floats(-5, 5),
    radius=st.floats(0, 3),
)
def test_heights_stay_in_their_range(index, by, radius):
    from workbench.scene import FlatBase, Lens

    lens = Lens(
        half_width=(1.0, 1.0),
        refractive_index=1.5,
        control_points=(12, 10),
        base=FlatBase(height=0.5),
        height_range=(-0.3, 0.3),
        min_thickness=0.3,
    )
    heights = Stroke(lens, "exit", np.full((12, 10), 0.5), None, index, radius).raised(by)
    assert heights.min() >= 0.3  # the minimal thickness ends before the height range
    assert heights.max() <= 0.8


def test_locked_points_stay(lens, flat):
    locked = np.zeros((12, 10), dtype=bool)
    locked[4:6] = True
    raised = Stroke(lens, "exit", flat, locked, (4, 4), 0.8).raised(0.2)
    np.testing.assert_array_equal(raised[locked], 0.5)
    assert raised[3, 4] > 0.55
    assert not Stroke(lens, "exit", flat, locked, (4, 4), 0.0).moves
    assert Stroke(lens, "exit", flat, locked, (3, 4), 0.0).moves
